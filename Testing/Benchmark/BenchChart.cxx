#include "BenchChart.h"

#include "BenchCanvas.h"
#include "BenchText.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotLine.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace flatblock::benchmarks
{
namespace
{
void AddSeries(vtkChartXY* chart, const Series& series)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(series.Name.c_str());
  for (const auto& [along, up] : series.Points)
  {
    x->InsertNextValue(std::log10(along));
    y->InsertNextValue(std::log10(up));
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  auto* plot =
    vtkPlotPoints::SafeDownCast(chart->AddPlot(series.IsLine ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  plot->SetColor(series.Color[0], series.Color[1], series.Color[2], 255);
  plot->SetMarkerStyle(series.Marker);
  plot->SetMarkerSize(series.IsLine ? 13.0F : 9.0F);
  plot->SetWidth(series.IsLine ? 2.0F : 1.0F);
}

// From 1, 2 and 5 of each decade; the powers of ten alone where they are many.
void AddTicks(vtkAxis* axis, double low, double high)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  const bool isWide = high - low > 3.0;
  for (int decade = int(std::floor(low)); decade <= int(std::ceil(high)); ++decade)
  {
    for (double digit : { 1.0, 2.0, 5.0 })
    {
      const double at = decade + std::log10(digit);
      if (at >= low && at <= high && (digit == 1.0 || !isWide))
      {
        positions->InsertNextValue(at);
        labels->InsertNextValue(Significant(digit * std::pow(10.0, decade), 3));
      }
    }
  }
  axis->SetCustomTickPositions(positions, labels);
}

// The data with a margin, and at least three quarters of a decade.
void SetRange(vtkAxis* axis, double low, double high, double above)
{
  const double missing = std::max(0.0, 0.75 - (high - low));
  low -= 0.5 * missing;
  high += 0.5 * missing;
  const double margin = 0.06 * (high - low);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low - margin, high + margin + above * (high - low));
  AddTicks(axis, low - margin, high + margin + above * (high - low));
}

void SetAxis(vtkChartXY* chart, int position, const Chart& data)
{
  const bool isVertical = position == vtkAxis::LEFT;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Series& series : data.AllSeries)
  {
    for (const auto& point : series.Points)
    {
      const double at = std::log10(isVertical ? point.second : point.first);
      low = std::min(low, at);
      high = std::max(high, at);
    }
  }
  vtkAxis* axis = chart->GetAxis(position);
  axis->SetTitle(isVertical ? data.VerticalAxis : data.HorizontalAxis);
  axis->GetTitleProperties()->SetFontSize(15);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(13);
  axis->GetGridPen()->SetColor(225, 225, 225);
  // Room for the legend.
  SetRange(axis, low, high, isVertical ? 0.05 * double(data.AllSeries.size()) : 0.0);
}
} // namespace

void DrawChart(const Chart& data, const std::string& file)
{
  vtkNew<vtkChartXY> chart;
  for (const Series& series : data.AllSeries)
  {
    if (!series.Points.empty())
    {
      AddSeries(chart, series);
    }
  }
  chart->SetTitle(data.Title);
  chart->GetTitleProperties()->SetFontSize(17);
  SetAxis(chart, vtkAxis::LEFT, data);
  SetAxis(chart, vtkAxis::BOTTOM, data);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(13);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  DrawToPNG(chart, { 960, 620 }, file);
}
} // namespace flatblock::benchmarks
