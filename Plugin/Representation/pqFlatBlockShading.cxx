#include "pqFlatBlockShading.h"

#include "pqPropertyWidgetDecorator.h"
#include "pqProxyWidget.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>
#include <cstring>

namespace
{
struct Stock
{
  const char* Name;
  bool IsAdvanced;
};

constexpr Stock Shared[] = { { "Shade", false }, { "VolumetricScatteringBlending", false },
  { "GlobalIlluminationReach", false }, { "VolumeAnisotropy", true }, { "BlendMode", false },
  { "IsosurfaceValues", false }, { "SliceFunction", false }, { "ScalarOpacityUnitDistance", true },
  { "UseSeparateOpacityArray", true }, { "OpacityArrayName", true }, { "OpacityComponent", true },
  { "UseTransfer2D", true }, { "UseGradientForTransfer2D", true }, { "ColorArray2Name", true },
  { "ColorArray2Component", true }, { "UseCropping", false }, { "CroppingOrigin", true },
  { "CroppingScale", true } };
} // namespace

pqFlatBlockShading::pqFlatBlockShading(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, parent)
{
  this->setShowLabel(false);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  for (const Stock& stock : Shared)
  {
    this->addRow(proxy->GetProperty(stock.Name), stock.IsAdvanced, form);
  }
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    vtkSMProperty* property = group->GetProperty(i);
    this->addRow(property, std::strcmp(property->GetPanelVisibility(), "advanced") == 0, form);
  }
  this->hideRows();
}

pqFlatBlockShading::~pqFlatBlockShading() = default;

void pqFlatBlockShading::addRow(vtkSMProperty* property, bool isAdvanced, QFormLayout* form)
{
  pqPropertyWidget* widget =
    property ? pqProxyWidget::createWidgetForProperty(property, this->proxy(), this) : nullptr;
  if (!widget)
  {
    return;
  }
  this->connect(widget, SIGNAL(changeAvailable()), SIGNAL(changeAvailable()));
  this->connect(widget, SIGNAL(changeFinished()), SIGNAL(changeFinished()));
  for (pqPropertyWidgetDecorator* decorator : widget->decorators())
  {
    this->connect(decorator, SIGNAL(visibilityChanged()), SLOT(hideRows()));
  }
  auto* label = new QLabel(property->GetXMLLabel(), this);
  label->setToolTip(widget->toolTip());
  label->setWordWrap(true);
  form->addRow(widget->showLabel() ? label : nullptr, widget);
  label->setVisible(widget->showLabel());
  this->Rows.append({ widget->showLabel() ? label : nullptr, widget, isAdvanced });
}

void pqFlatBlockShading::apply()
{
  std::for_each(this->Rows.begin(), this->Rows.end(), [](const Row& row) { row.Widget->apply(); });
  this->Superclass::apply();
}

void pqFlatBlockShading::reset()
{
  std::for_each(this->Rows.begin(), this->Rows.end(), [](const Row& row) { row.Widget->reset(); });
  this->Superclass::reset();
}

void pqFlatBlockShading::setView(pqView* view)
{
  for (const Row& row : this->Rows)
  {
    row.Widget->setView(view);
  }
  this->Superclass::setView(view);
}

void pqFlatBlockShading::updateWidget(bool showsAdvanced)
{
  this->ShowsAdvanced = showsAdvanced;
  this->hideRows();
  this->Superclass::updateWidget(showsAdvanced);
}

void pqFlatBlockShading::hideRows()
{
  for (const Row& row : this->Rows)
  {
    const auto& decorators = row.Widget->decorators();
    const bool isShown =
      (this->ShowsAdvanced || !row.IsAdvanced) &&
      std::all_of(decorators.begin(), decorators.end(),
        [this](pqPropertyWidgetDecorator* decorator)
        { return !decorator || decorator->canShowWidget(this->ShowsAdvanced); });
    row.Widget->setVisible(isShown);
    if (row.Label)
    {
      row.Label->setVisible(isShown);
    }
  }
}
