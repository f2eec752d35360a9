/**
 * @class   pqFlatBlockFunction
 * @brief   edits colors or opacity over a range that is not that of the data
 *
 * Of colors also lets one choose among the presets.
 */

#ifndef pqFlatBlockFunction_h
#define pqFlatBlockFunction_h

#include "pqPropertyWidget.h"

class pqTransferFunctionWidget;

class pqFlatBlockFunction : public pqPropertyWidget
{
  Q_OBJECT
  using Superclass = pqPropertyWidget;

public:
  pqFlatBlockFunction(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqFlatBlockFunction() override;

private Q_SLOTS:
  void choosePreset(const QString& name);
  void pushPoints();

private:
  Q_DISABLE_COPY(pqFlatBlockFunction)

  vtkSMProxy* GetFunction();

  pqTransferFunctionWidget* Editor;
};

#endif
