#include "pqFlatBlockFunction.h"

#include "pqTransferFunctionWidget.h"
#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtkSMTransferFunctionProxy.h"

#include <QComboBox>
#include <QVBoxLayout>

#include <vector>

namespace
{
// As the property of a proxy has them.
std::vector<double> GetPoints(vtkObjectBase* function)
{
  std::vector<double> points;
  if (auto* color = vtkColorTransferFunction::SafeDownCast(function))
  {
    for (int i = 0; i < color->GetSize(); ++i)
    {
      double node[6];
      color->GetNodeValue(i, node);
      points.insert(points.end(), node, node + 4);
    }
  }
  if (auto* opacity = vtkPiecewiseFunction::SafeDownCast(function))
  {
    for (int i = 0; i < opacity->GetSize(); ++i)
    {
      double node[4];
      opacity->GetNodeValue(i, node);
      points.insert(points.end(), node, node + 4);
    }
  }
  return points;
}
} // namespace

pqFlatBlockFunction::pqFlatBlockFunction(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent), Editor(new pqTransferFunctionWidget(this))
{
  this->setProperty(property);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  vtkSMProxy* function = this->GetFunction();
  vtkObjectBase* object = function ? function->GetClientSideObject() : nullptr;
  auto* color = vtkColorTransferFunction::SafeDownCast(object);
  auto* opacity = vtkPiecewiseFunction::SafeDownCast(object);
  if (color)
  {
    auto* presets = new QComboBox(this);
    presets->addItem("Choose a preset ...");
    auto* all = vtkSMTransferFunctionPresets::GetInstance();
    for (unsigned int i = 0; i < all->GetNumberOfPresets(); ++i)
    {
      presets->addItem(QString::fromStdString(all->GetPresetName(i)));
    }
    presets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->addWidget(presets);
    this->connect(
      presets, SIGNAL(textActivated(const QString&)), SLOT(choosePreset(const QString&)));
  }
  this->Editor->setMinimumHeight(80);
  this->Editor->initialize(color, color != nullptr, opacity, opacity != nullptr);
  box->addWidget(this->Editor);
  this->connect(this->Editor, SIGNAL(controlPointsModified()), SLOT(pushPoints()));
}

pqFlatBlockFunction::~pqFlatBlockFunction() = default;

vtkSMProxy* pqFlatBlockFunction::GetFunction()
{
  return vtkSMPropertyHelper(this->property()).GetAsProxy();
}

void pqFlatBlockFunction::choosePreset(const QString& name)
{
  if (vtkSMTransferFunctionProxy::ApplyPreset(this->GetFunction(), name.toUtf8().data(), true))
  {
    this->Editor->render();
    Q_EMIT this->changeAvailable();
    Q_EMIT this->changeFinished();
  }
}

void pqFlatBlockFunction::pushPoints()
{
  vtkSMProxy* function = this->GetFunction();
  const std::vector<double> points = GetPoints(function->GetClientSideObject());
  vtkSMProperty* property = function->GetProperty("RGBPoints");
  property = property ? property : function->GetProperty("Points");
  vtkSMPropertyHelper(property).Set(points.data(), static_cast<unsigned int>(points.size()));
  function->UpdateVTKObjects();
  Q_EMIT this->changeAvailable();
  Q_EMIT this->changeFinished();
}
