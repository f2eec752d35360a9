#include "pqFlatBlockShading.h"

#include "pqPropertiesPanel.h"
#include "pqPropertyWidgetDecorator.h"
#include "pqProxyWidget.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cstring>

namespace
{
struct Stock
{
  const char* Name;
  bool IsAdvanced;
};

constexpr int LabelWidth = 110; // pixels

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
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(pqPropertiesPanel::suggestedVerticalSpacing());
  for (const Stock& stock : Shared)
  {
    this->addRow(proxy->GetProperty(stock.Name), stock.IsAdvanced);
  }
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    vtkSMProperty* property = group->GetProperty(i);
    this->addRow(property, std::strcmp(property->GetPanelVisibility(), "advanced") == 0);
  }
  this->hideRows();
}

pqFlatBlockShading::~pqFlatBlockShading() = default;

void pqFlatBlockShading::addRow(vtkSMProperty* property, bool isAdvanced)
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
  auto* line = new QWidget(this);
  auto* sides = new QHBoxLayout(line);
  sides->setContentsMargins(0, 0, 0, 0);
  sides->setSpacing(pqPropertiesPanel::suggestedHorizontalSpacing());
  if (widget->showLabel())
  {
    auto* label = new QLabel(property->GetXMLLabel(), line);
    label->setToolTip(widget->toolTip());
    label->setWordWrap(true);
    label->setFixedWidth(LabelWidth);
    sides->addWidget(label);
  }
  sides->addWidget(widget, 1);
  this->layout()->addWidget(line);
  this->Rows.append({ line, widget, isAdvanced });
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
    const bool isShown = (this->ShowsAdvanced || !row.IsAdvanced) &&
                         std::all_of(decorators.begin(), decorators.end(),
                           [this](pqPropertyWidgetDecorator* decorator)
                           { return !decorator || decorator->canShowWidget(this->ShowsAdvanced); });
    row.Line->setVisible(isShown);
  }
}
