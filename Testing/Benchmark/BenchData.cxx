#include "BenchData.h"

#include "BenchText.h"

#include <fstream>
#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
struct Field
{
  const char* Name;
  double Value;
};

std::vector<Field> GetNumbers(const Record& record)
{
  return { { "milliseconds", record.Milliseconds }, { "bytes", record.Bytes },
    { "samples_per_ray", record.SamplesPerRay }, { "fetches_per_ray", record.FetchesPerRay },
    { "rmse", record.Error.RootMeanSquare }, { "psnr_db", record.Error.PeakSignalToNoise },
    { "ssim", record.Error.Similarity }, { "largest_cieluv", record.Error.Color } };
}

std::string Text(const char* name, const std::string& value)
{
  return QuoteJSON(name) + ": " + QuoteJSON(value);
}

std::string Number(const char* name, double value)
{
  return QuoteJSON(name) + ": " + Exact(value, "null");
}

std::string ToJSON(const Record& record)
{
  std::string json = "{ " + Text("scene", record.Scene) + ", " + Text("mapper", record.Mapper) +
                     ", " + Text("knob", record.Knob) + ", " + Text("value", record.Value);
  for (const Field& field : GetNumbers(record))
  {
    json += ", " + Number(field.Name, field.Value);
  }
  return json + " }";
}

std::string ToJSON(const EqualError& equal)
{
  return "{ " + Text("scene", equal.Scene) + ", " + Text("peer", equal.Peer) + ", " +
         Text("ours", equal.Ours) + ", " + Number("peer_psnr_db", equal.PeerPSNR) + ", " +
         Number("our_psnr_db", equal.OurPSNR) + ", " +
         Number("peer_milliseconds", equal.Times.First) + ", " +
         Number("our_milliseconds", equal.Times.Second) + ", " + Number("ratio", equal.GetRatio()) +
         " }";
}

std::string ToJSON(const SceneNotes& scene)
{
  return "{ " + Text("name", scene.Name) + ", " + Text("description", scene.Description) + " }";
}

std::string ToJSON(const std::string& text)
{
  return QuoteJSON(text);
}

template <typename Items>
std::string List(const char* name, const Items& items)
{
  std::string json = "  " + QuoteJSON(name) + ": [";
  const char* separator = "\n    ";
  for (const auto& item : items)
  {
    json += separator + ToJSON(item);
    separator = ",\n    ";
  }
  return json + "\n  ]";
}

std::string ToJSON(const BenchOptions& options)
{
  return "{ " + Text("command", options.Command) + ", " + Text("input", options.Input) + ", " +
         Text("filter", options.Filter) + ", " + Number("size", options.Size) + ", " +
         Number("window", options.Window) + ", " + Number("seed", options.Seed) +
         ", \"quick\": " + (options.IsQuick ? "true" : "false") + " }";
}

std::string ToJSON(const Results& results)
{
  return "{\n  " + Text("date", results.Date) + ",\n  \"machine\": { " +
         Text("processor", results.Processor) + ", " + Text("opengl", results.OpenGL) +
         " },\n  \"options\": " + ToJSON(results.Options) + ",\n" + List("scenes", results.Scenes) +
         ",\n" + List("records", results.Records) + ",\n" + List("equal_error", results.Equal) +
         ",\n" + List("left_out", results.LeftOut) + "\n}\n";
}

// One row a record; what does not change by row comes last.
std::string ToCSV(const Results& results)
{
  std::string csv = "scene,mapper,knob,value";
  for (const Field& field : GetNumbers({}))
  {
    csv += std::string(",") + field.Name;
  }
  csv += ",seed,size,window,date,processor,opengl\n";
  const BenchOptions& options = results.Options;
  for (const Record& record : results.Records)
  {
    csv += QuoteCSV(record.Scene) + "," + record.Mapper + "," + record.Knob + "," + record.Value;
    for (const Field& field : GetNumbers(record))
    {
      csv += "," + Exact(field.Value, "");
    }
    csv += "," + std::to_string(options.Seed) + "," + std::to_string(options.Size) + "," +
           std::to_string(options.Window) + "," + results.Date + "," + QuoteCSV(results.Processor) +
           "," + QuoteCSV(results.OpenGL) + "\n";
  }
  return csv;
}

void Write(const std::string& file, const std::string& text)
{
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
}
} // namespace

void WriteData(const Results& results, const std::string& folder)
{
  Write(folder + "/results.json", ToJSON(results));
  Write(folder + "/results.csv", ToCSV(results));
}
} // namespace flatblock::benchmarks
