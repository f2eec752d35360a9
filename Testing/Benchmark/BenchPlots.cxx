#include "BenchPlots.h"

#include "BenchChart.h"
#include "BenchStrip.h"

#include "vtkPlotPoints.h"

#include <cctype>

namespace flatblock::benchmarks
{
namespace
{
using Along = double (*)(const Record&);

struct Look
{
  const char* Mapper;
  std::array<unsigned char, 3> Color;
  int Marker;
};

constexpr Look Looks[] = {
  { "vtkFlatBlockVolumeMapper", { 30, 100, 200 }, vtkPlotPoints::CIRCLE },
  { "vtkGPUVolumeRayCastMapper", { 210, 60, 40 }, vtkPlotPoints::SQUARE },
  { "vtkSmartVolumeMapper", { 240, 150, 20 }, vtkPlotPoints::DIAMOND },
  { "vtkMultiBlockVolumeMapper", { 130, 60, 160 }, vtkPlotPoints::PLUS },
};

double GetTime(const Record& record)
{
  return record.Milliseconds;
}

double GetMebibytes(const Record& record)
{
  return record.Bytes / (1 << 20);
}

// What no logarithm can be taken of is left out; a picture without error is at the least.
Series MakeSeries(const std::string& name, const Look& look, const Selected& records, Along along)
{
  Series series{ name, look.Color, look.Marker, false, {} };
  for (const Record* record : records)
  {
    if (along(*record) > 0.0 && std::isfinite(record->Error.RootMeanSquare))
    {
      series.Points.emplace_back(along(*record), std::max(1e-9, record->Error.RootMeanSquare));
    }
  }
  return series;
}

std::vector<Series> MakeMapperSeries(const Selected& records, Along along)
{
  std::vector<Series> all;
  for (const Look& look : Looks)
  {
    Selected some;
    std::copy_if(records.begin(), records.end(), std::back_inserter(some),
      [&look](const Record* record) { return record->Mapper == look.Mapper; });
    all.push_back(MakeSeries(look.Mapper, look, some, along));
  }
  all.erase(std::remove_if(
              all.begin(), all.end(), [](const Series& series) { return series.Points.empty(); }),
    all.end());
  return all;
}

Series MakeFront(const char* name, const Look& look, const Selected& records)
{
  Series series = MakeSeries(name, look, GetFront(records), GetTime);
  series.IsLine = true;
  series.Marker = vtkPlotPoints::NONE;
  return series;
}

// A front of one point is no line.
Chart ChartTimes(const std::string& scene, const Selected& records)
{
  auto all = MakeMapperSeries(records, GetTime);
  for (const auto& front : { MakeFront("front of ours", Looks[0], SelectSide(records, true)),
         MakeFront("front of VTK's", Looks[1], SelectSide(records, false)) })
  {
    if (front.Points.size() > 1)
    {
      all.push_back(front);
    }
  }
  return { scene + ": error by time", "ms a frame", "RMSE against the reference", all };
}

// As many as can be looked at, the first and the last among them.
Selected Thin(const Selected& front, std::size_t most)
{
  Selected some;
  const std::size_t count = std::min(most, front.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    some.push_back(front[count > 1 ? i * (front.size() - 1) / (count - 1) : 0]);
  }
  return some;
}

std::string ToFileName(const std::string& scene)
{
  std::string name;
  for (char c : scene)
  {
    name += std::isalnum(static_cast<unsigned char>(c))
              ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
              : '-';
  }
  return name;
}
} // namespace

ScenePlots DrawPlots(const std::string& scene, const Selected& records, const std::string& folder)
{
  const std::string name = ToFileName(scene);
  ScenePlots plots{ name + "-error-time.png", "", name + "-front.png" };
  DrawChart(ChartTimes(scene, records), folder + "/" + plots.ErrorByTime);
  const auto memory = MakeMapperSeries(records, GetMebibytes);
  if (!memory.empty())
  {
    plots.ErrorByMemory = name + "-error-memory.png";
    DrawChart({ scene + ": error by memory", "MiB on the graphics card",
                "RMSE against the reference", memory },
      folder + "/" + plots.ErrorByMemory);
  }
  DrawStrip(Thin(GetFront(records), 6), folder + "/" + plots.Strip);
  return plots;
}
} // namespace flatblock::benchmarks
