#include "pqFlatBlockRefining.h"

#include "pqAnimationScene.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMViewProxy.h"

#include <QPointer>
#include <QTimer>

namespace
{
const char* const TypeName = "Flat-block Volume";

bool IsShown(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  vtkSMProperty* type = proxy->GetProperty("Representation");
  return representation->isVisible() && type && proxy->GetProperty("FlatBlockConverged") &&
         QString(vtkSMPropertyHelper(type).GetAsString()) == TypeName;
}

bool IsConverged(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  vtkSMProperty* converged = proxy->GetProperty("FlatBlockConverged");
  proxy->UpdatePropertyInformation(converged);
  return vtkSMPropertyHelper(converged).GetAsInt() != 0;
}

void SetProgressive(pqRepresentation* representation, bool isProgressive)
{
  vtkSMProxy* proxy = representation->getProxy();
  vtkSMProperty* progressive = proxy->GetProperty("FlatBlockProgressive");
  if (progressive && vtkSMPropertyHelper(progressive).GetAsInt() != (isProgressive ? 1 : 0))
  {
    BEGIN_UNDO_EXCLUDE();
    vtkSMPropertyHelper(progressive).Set(isProgressive ? 1 : 0);
    proxy->UpdateVTKObjects();
    END_UNDO_EXCLUDE();
  }
}
} // namespace

pqFlatBlockRefining::pqFlatBlockRefining(QObject* parent) : QObject(parent) {}
pqFlatBlockRefining::~pqFlatBlockRefining() = default;

void pqFlatBlockRefining::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, SIGNAL(itemAdded(pqServerManagerModelItem*)),
    SLOT(watchItem(pqServerManagerModelItem*)));
  for (pqServerManagerModelItem* item : model->findItems<pqServerManagerModelItem*>())
  {
    this->watchItem(item);
  }
}

void pqFlatBlockRefining::shutdown()
{
  this->disconnect();
}

void pqFlatBlockRefining::watchItem(pqServerManagerModelItem* item)
{
  if (auto* view = qobject_cast<pqRenderView*>(item))
  {
    this->connect(view, SIGNAL(beginRender()), SLOT(setRefining()));
    this->connect(view, SIGNAL(endRender()), SLOT(goOn()));
  }
  if (auto* scene = qobject_cast<pqAnimationScene*>(item))
  {
    this->connect(scene, SIGNAL(beginPlay()), SLOT(beginPlay()));
    this->connect(scene, SIGNAL(endPlay()), SLOT(endPlay()));
  }
}

void pqFlatBlockRefining::setRefining()
{
  auto* view = qobject_cast<pqView*>(this->sender());
  this->watchInteractor(view);
  for (pqRepresentation* representation : view->getRepresentations())
  {
    if (IsShown(representation))
    {
      SetProgressive(representation, !this->IsPlaying);
    }
  }
}

// When nothing else is to be done.
void pqFlatBlockRefining::goOn()
{
  QPointer<pqView> view = qobject_cast<pqView*>(this->sender());
  if (this->IsPlaying || this->Moving)
  {
    return;
  }
  for (pqRepresentation* representation : view->getRepresentations())
  {
    if (IsShown(representation) && !IsConverged(representation))
    {
      QTimer::singleShot(1, this,
        [this, view]
        {
          if (view && !this->Moving && !this->IsPlaying)
          {
            view->render();
          }
        });
      return;
    }
  }
}

// A view has one once it is shown.
void pqFlatBlockRefining::watchInteractor(pqView* view)
{
  vtkRenderWindowInteractor* interactor = view->getViewProxy()->GetInteractor();
  const char* const slot = SLOT(interact(vtkObject*, unsigned long));
  for (const unsigned long event :
    { vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent })
  {
    if (interactor)
    {
      this->Events->Disconnect(interactor, event, this, slot);
      this->Events->Connect(interactor, event, this, slot);
    }
  }
}

void pqFlatBlockRefining::interact(vtkObject* interactor, unsigned long event)
{
  this->Moving = event == vtkCommand::StartInteractionEvent ? interactor : nullptr;
}

void pqFlatBlockRefining::beginPlay()
{
  this->IsPlaying = true;
}

void pqFlatBlockRefining::endPlay()
{
  this->IsPlaying = false;
}
