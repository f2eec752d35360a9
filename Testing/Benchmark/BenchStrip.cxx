#include "BenchStrip.h"

#include "BenchCanvas.h"
#include "BenchText.h"

#include "vtkContext2D.h"
#include "vtkContextItem.h"
#include "vtkObjectFactory.h"
#include "vtkTextProperty.h"

namespace flatblock::benchmarks
{
namespace
{
constexpr int Shown = 230;
constexpr int Gap = 10;
constexpr int Line = 18;
constexpr int Lines = 5;

vtkSmartPointer<vtkImageData> ToImage(const Record& record)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(record.Width, static_cast<int>(record.Pixels.size()) / 3 / record.Width, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(record.Pixels.begin(), record.Pixels.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()));
  return image;
}

std::vector<std::string> GetWords(const Record& record)
{
  return { record.Mapper, record.Knob + " = " + record.Value,
    Fixed(record.Milliseconds, 1) + " ms, " + Fixed(record.Error.PeakSignalToNoise, 1) + " dB",
    "RMSE " + Significant(record.Error.RootMeanSquare, 2) + ", SSIM " +
      Fixed(record.Error.Similarity, 4),
    "largest CIELUV " + Fixed(record.Error.Color, 1) };
}

class Strip : public vtkContextItem
{
public:
  static Strip* New();
  vtkTypeMacro(Strip, vtkContextItem);

  bool Paint(vtkContext2D* painter) override
  {
    painter->GetTextProp()->SetFontSize(12);
    painter->GetTextProp()->SetColor(0.0, 0.0, 0.0);
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
    for (std::size_t i = 0; i < this->Records.size(); ++i)
    {
      const auto x = static_cast<float>(Gap + int(i) * (Shown + Gap));
      painter->DrawImage(vtkRectf(x, Gap + Lines * Line, Shown, Shown), ToImage(*this->Records[i]));
      int row = Lines;
      for (const std::string& words : GetWords(*this->Records[i]))
      {
        painter->DrawString(x, static_cast<float>(--row * Line + Gap / 2), words.c_str());
      }
    }
    return true;
  }

  Selected Records;
};
vtkStandardNewMacro(Strip);
} // namespace

void DrawStrip(const Selected& records, const std::string& file)
{
  vtkNew<Strip> strip;
  strip->Records = records;
  DrawToPNG(
    strip, { Gap + int(records.size()) * (Shown + Gap), Shown + 2 * Gap + Lines * Line }, file);
}
} // namespace flatblock::benchmarks
