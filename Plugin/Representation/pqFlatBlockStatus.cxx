#include "pqFlatBlockStatus.h"

#include "pqActiveObjects.h"
#include "pqProxyWidget.h"
#include "pqView.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

pqFlatBlockStatus::pqFlatBlockStatus(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, parent), Text(new QLabel(this)), Progress(new QProgressBar(this))
{
  this->Text->setObjectName("FlatBlockStatus");
  this->Text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addWidget(this->Text);
  this->Progress->setObjectName("FlatBlockProgress");
  this->Progress->setFormat("%p % of the visible blocks as fine as wanted");
  lines->addWidget(this->Progress);
  vtkSMProperty* profiling = group->GetProperty("FlatBlockProfiling");
  if (auto* box =
        profiling ? pqProxyWidget::createWidgetForProperty(profiling, proxy, this) : nullptr)
  {
    this->connect(box, SIGNAL(changeAvailable()), SIGNAL(changeAvailable()));
    this->connect(box, SIGNAL(changeFinished()), SIGNAL(changeFinished()));
    lines->addWidget(box);
  }
  this->pqFlatBlockStatus::setView(pqActiveObjects::instance().activeView());
  this->refresh();
}

pqFlatBlockStatus::~pqFlatBlockStatus() = default;

void pqFlatBlockStatus::setView(pqView* view)
{
  this->Superclass::setView(view);
  if (this->WatchedView != view)
  {
    if (this->WatchedView)
    {
      this->disconnect(this->WatchedView, nullptr, this, nullptr);
    }
    this->WatchedView = view;
    if (view)
    {
      this->connect(view, SIGNAL(endRender()), SLOT(refresh()));
    }
  }
}

void pqFlatBlockStatus::refresh()
{
  vtkSMProperty* status = this->proxy()->GetProperty("FlatBlockStatus");
  vtkSMProperty* progress = this->proxy()->GetProperty("FlatBlockProgress");
  if (status && progress)
  {
    this->proxy()->UpdatePropertyInformation(status);
    this->proxy()->UpdatePropertyInformation(progress);
    this->Text->setText(vtkSMPropertyHelper(status).GetAsString());
    this->Progress->setValue(vtkSMPropertyHelper(progress).GetAsInt());
  }
}
