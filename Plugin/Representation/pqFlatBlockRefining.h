/**
 * @class   pqFlatBlockRefining
 * @brief   lets views of Flat-block Volumes render until all blocks have the level that is wanted
 *
 * A still takes one step, and the next one comes when nothing else is to be done: so that the
 * program answers in between. Stops while one moves the camera; animations that play draw each
 * frame wholly.
 */

#ifndef pqFlatBlockRefining_h
#define pqFlatBlockRefining_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkWeakPointer.h"

#include <QObject>

class pqServerManagerModelItem;
class pqView;
class vtkEventQtSlotConnect;

class pqFlatBlockRefining : public QObject
{
  Q_OBJECT

public:
  explicit pqFlatBlockRefining(QObject* parent = nullptr);
  ~pqFlatBlockRefining() override;

  void startup();
  void shutdown();

private Q_SLOTS:
  void watchItem(pqServerManagerModelItem* item);
  void setRefining();
  void goOn();
  void interact(vtkObject* interactor, unsigned long event);
  void beginPlay();
  void endPlay();

private:
  Q_DISABLE_COPY(pqFlatBlockRefining)

  void watchInteractor(pqView* view);

  vtkNew<vtkEventQtSlotConnect> Events;
  bool IsPlaying = false;
  vtkWeakPointer<vtkObject> Moving; // the interactor of a view whose camera is being moved
};

#endif
