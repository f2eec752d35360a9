/**
 * @class   pqFlatBlockShading
 * @brief   the stock volume's properties of shading, blending and cropping, and more of them
 *
 * Flat-block Volume shares them with Volume, whose own group hides itself where another
 * representation is shown.
 */

#ifndef pqFlatBlockShading_h
#define pqFlatBlockShading_h

#include "pqPropertyWidget.h"

#include <QList>

class vtkSMPropertyGroup;

class pqFlatBlockShading : public pqPropertyWidget
{
  Q_OBJECT
  using Superclass = pqPropertyWidget;

public:
  pqFlatBlockShading(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqFlatBlockShading() override;

  void apply() override;
  void reset() override;
  void setView(pqView* view) override;
  void updateWidget(bool showsAdvanced) override;

private Q_SLOTS:
  void hideRows();

private:
  Q_DISABLE_COPY(pqFlatBlockShading)

  struct Row
  {
    QWidget* Line = nullptr; // label and widget
    pqPropertyWidget* Widget = nullptr;
    bool IsAdvanced = false;
  };

  void addRow(vtkSMProperty* property, bool isAdvanced);

  QList<Row> Rows;
  bool ShowsAdvanced = false;
};

#endif
