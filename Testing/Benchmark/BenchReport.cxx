#include "BenchReport.h"

#include "BenchPlots.h"
#include "BenchTables.h"

namespace flatblock::benchmarks
{
namespace
{
void Introduce(Document& document, const Results& results)
{
  const BenchOptions& options = results.Options;
  document.push_back({ Block::Title, "Time, memory and error of volume mappers" });
  document.push_back(
    { Block::Text, results.Date + "; " + results.Processor + "; " + results.OpenGL +
                     "; volumes of " + std::to_string(options.Size) + " samples a side, seed " +
                     std::to_string(options.Seed) + "." });
  document.push_back({ Block::Code, options.Command });
  document.push_back({ Block::Text,
    "A time is the median of five frames of a window of " + std::to_string(options.Window) +
      " pixels a side, after one that does not count. Errors are those of 32-bit floats over black "
      "against a ray caster on the CPU in double precision, on every fourth pixel of every fourth "
      "row: RMSE of red, green and blue from 0 to 1, PSNR to a peak of 1, SSIM, and the largest "
      "difference in CIELUV, where black and white are 100 apart. Bytes are those that the mapper "
      "reports of the graphics card." });
  document.push_back({ Block::Text,
    "Each point sets one knob; the rest is the mapper's default, with a step of half a voxel and "
    "memory for all bricks. Steps are in voxels, memory is the share of what its samples take, and "
    "SamplesPerRay is the number of steps along the box's diagonal. vtkSmartVolumeMapper's low "
    "resolution is its own resampling of "
    "the volume, drawn by its GPU mode; vtkMultiBlockVolumeMapper sets neither steps nor a limit "
    "of memory, and is given blocks." });
}

// Tables without a row but the head say nothing.
void AddTable(Document& document, const char* title, const char* words, const Block& table)
{
  if (table.Rows.size() > 1)
  {
    document.push_back({ Block::Section, title });
    document.push_back({ Block::Text, words });
    document.push_back(table);
  }
}

void AddScene(
  Document& document, const SceneNotes& scene, const Results& results, const std::string& folder)
{
  const Selected records = SelectScene(results.Records, scene.Name);
  if (records.empty())
  {
    return;
  }
  const ScenePlots plots = DrawPlots(scene.Name, records, folder);
  document.push_back({ Block::Section, scene.Name });
  document.push_back({ Block::Text, scene.Description + "." });
  document.push_back(
    { Block::Picture, scene.Name + ": error against time", {}, plots.ErrorByTime });
  if (!plots.ErrorByMemory.empty())
  {
    document.push_back(
      { Block::Picture, scene.Name + ": error against memory", {}, plots.ErrorByMemory });
  }
  document.push_back(
    { Block::Picture, scene.Name + ": pictures along the front", {}, plots.Strip });
  document.push_back(TabulateRecords(records));
}

void AddClassics(Document& document, const Results& results)
{
  AddTable(document, "Frames a second by samples",
    "Frames a second where the box's diagonal has so many steps.", TabulateRates(results.Records));
  AddTable(document, "Early termination", "As it is by default, and with a threshold of 1.",
    TabulateTermination(results.Records));
  AddTable(document, "Samples and time", "Of mappers that count their samples.",
    TabulateSamples(results.Records));
}

void AddLeftOut(Document& document, const Results& results)
{
  Block table{ Block::Table, "", { { "what was not measured, and why" } } };
  for (const std::string& words : results.LeftOut)
  {
    table.Rows.push_back({ words });
  }
  AddTable(
    document, "Left out", "Points and scenes that this machine or this VTK can't draw.", table);
}
} // namespace

void WriteReport(const Results& results, const std::string& folder)
{
  Document document;
  Introduce(document, results);
  AddTable(document, "The same error",
    "For each point of a peer the fastest of ours whose PSNR is at most 0.5 dB below; frames of "
    "both take turns, and the ratio is that of the medians: above 1, ours is faster.",
    TabulateEqualErrors(results.Equal));
  AddClassics(document, results);
  for (const SceneNotes& scene : results.Scenes)
  {
    AddScene(document, scene, results, folder);
  }
  AddLeftOut(document, results);
  WriteMarkdown(document, folder + "/report.md");
  WriteHTML(document, folder + "/report.html");
}
} // namespace flatblock::benchmarks
