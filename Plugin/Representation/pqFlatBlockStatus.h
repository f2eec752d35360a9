/**
 * @class   pqFlatBlockStatus
 * @brief   shows what the last frame of a Flat-block Volume was made of
 */

#ifndef pqFlatBlockStatus_h
#define pqFlatBlockStatus_h

#include "pqPropertyWidget.h"

#include <QPointer>

class QLabel;
class QProgressBar;
class pqView;
class vtkSMPropertyGroup;

class pqFlatBlockStatus : public pqPropertyWidget
{
  Q_OBJECT
  using Superclass = pqPropertyWidget;

public:
  pqFlatBlockStatus(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqFlatBlockStatus() override;

  void setView(pqView* view) override;

private Q_SLOTS:
  void refresh();

private:
  Q_DISABLE_COPY(pqFlatBlockStatus)

  QLabel* Text;
  QProgressBar* Progress;
  QPointer<pqView> WatchedView;
};

#endif
