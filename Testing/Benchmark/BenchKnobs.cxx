#include "BenchPoint.h"

namespace flatblock::benchmarks
{
namespace
{
struct Value
{
  std::string Name;
  std::function<void(Setting&)> Apply;
};

struct Knob
{
  std::string Name;
  std::vector<Value> Values;
  bool IsWholeWhenQuick = false;
};

std::vector<Value> Steps(int classification)
{
  std::vector<Value> values;
  for (const char* step : { "4", "2", "1.41", "1.19", "1", "0.84", "0.71", "0.5", "0.25" })
  {
    values.push_back({ step, [classification, step](Setting& s)
      {
        s.Mapper->SetClassification(classification);
        s.Mapper->SetSampleDistance(std::stod(step) * s.Shown.Voxel);
      } });
  }
  return values;
}

// A share of what the samples of the volume take, with what lies beside them.
void LimitMemory(Setting& setting, int part)
{
  setting.Mapper->SetMaxMemoryInBytes(setting.BytesBeside + setting.BytesOfVolume / part);
}

Value MemoryPart(int part)
{
  return { "1/" + std::to_string(part), [part](Setting& s) { LimitMemory(s, part); } };
}

// What an eighth of the memory shows, by how levels are chosen and what they are chosen for.
Value Eighth(const char* name, int criterion, int blockSize, int bits)
{
  return { name, [criterion, blockSize, bits](Setting& s)
    {
      LimitMemory(s, 8);
      s.Mapper->SetSelectionCriterion(criterion);
      s.Mapper->SetBlockSize(blockSize);
      s.Mapper->SetAtlasPrecision(bits);
    } };
}

Value ImageStep(const char* pixels)
{
  return { pixels, [pixels](Setting& s) { s.Mapper->SetImageSampleDistance(std::stod(pixels)); } };
}

Value Block(int side)
{
  return { std::to_string(side), [side](Setting& s) { s.Mapper->SetBlockSize(side); } };
}

Value Threshold(const char* opacity)
{
  return { opacity,
    [opacity](Setting& s) { s.Mapper->SetEarlyTerminationThreshold(std::stod(opacity)); } };
}

std::vector<Value> Samples(int classification)
{
  std::vector<Value> values;
  for (int count : { 40, 60, 80, 120 })
  {
    values.push_back({ std::to_string(count), [classification, count](Setting& s)
      {
        s.Mapper->SetClassification(classification);
        s.Mapper->SetSampleDistance(GetStepForSamples(s.Shown, count));
      } });
  }
  return values;
}

// A filter shows only where there are coarse bricks.
Value CoarseBy(const char* name, int filter)
{
  return { name, [filter](Setting& s)
    {
      LimitMemory(s, 8);
      s.Mapper->SetLevelFilter(filter);
    } };
}

Value Adaptive(const char* name, bool isOn)
{
  return { name, [isOn](Setting& s)
    {
      LimitMemory(s, 8);
      s.Mapper->SetAdaptiveSampling(isOn);
    } };
}

double GetSpan(const Setting& s)
{
  double range[2];
  vtkImageData::SafeDownCast(s.Shown.Shown.Mapper->GetInputDataObject(0, 0))->GetScalarRange(range);
  return range[1] - range[0];
}

Value Tolerance(const char* name, double share)
{
  return { name, [share](Setting& s) { s.Mapper->SetVariationTolerance(share * GetSpan(s)); } };
}

Value Precision(const char* name, int bits)
{
  return { name, [bits](Setting& s) { s.Mapper->SetAtlasPrecision(bits); } };
}

Value Skip(const char* name, int skipping)
{
  return { name, [skipping](Setting& s) { s.Mapper->SetSkipping(skipping); } };
}

Value Light(const char* threshold)
{
  return { threshold,
    [threshold](Setting& s) { s.Mapper->SetShadingOpacityThreshold(std::stod(threshold)); } };
}

// Of interactive frames.
Value Refined(const char* tolerance)
{
  return { tolerance, [tolerance](Setting& s)
    {
      s.Mapper->AdaptiveImageSamplingOn();
      s.Mapper->SetImageSamplingTolerance(std::stod(tolerance));
      s.IsInteractive = true;
    } };
}

Value Quality(const char* name, void (vtkFlatBlockVolumeMapper::*set)())
{
  return { name, [set](Setting& s) { (s.Mapper->*set)(); } };
}

// What an interactive frame of the automatic quality may come to.
Value Automatic(const char* factor)
{
  return { factor, [factor](Setting& s)
    {
      s.Mapper->SetQualityToAccurate();
      s.Mapper->SetImageSampleDistance(std::stod(factor));
      s.Mapper->SetSampleDistanceInVoxels(0.25 * std::stod(factor));
    } };
}

// One line a knob; each value begins from the mapper's defaults.
std::vector<Knob> MakeKnobs()
{
  using Ours = vtkFlatBlockVolumeMapper;
  return {
    { "SampleDistance.PreIntegrated", Steps(Ours::PRE_INTEGRATED), true },
    { "SampleDistance.PostInterpolation", Steps(Ours::POST_INTERPOLATION), true },
    { "SampleDistance.PreInterpolation", Steps(Ours::PRE_INTERPOLATION) },
    { "Memory", { MemoryPart(1), MemoryPart(2), MemoryPart(4), MemoryPart(8), MemoryPart(16) } },
    { "EighthOfMemory",
      { Eighth("distance", Ours::DISTANCE, 33, 0), Eighth("distortion", Ours::DISTORTION, 33, 0),
        Eighth("both", Ours::DISTORTION_AND_DISTANCE, 33, 0),
        Eighth("distortion.17", Ours::DISTORTION, 17, 0),
        Eighth("distortion.8bit", Ours::DISTORTION, 33, 8),
        Eighth("distortion.17.8bit", Ours::DISTORTION, 17, 8) } },
    { "ImageSampleDistance", { ImageStep("0.5"), ImageStep("1"), ImageStep("2"), ImageStep("4") } },
    { "BlockSize", { Block(17), Block(33), Block(65) } },
    { "LevelFilter", { CoarseBy("Subsample", Ours::SUBSAMPLE), CoarseBy("Tent", Ours::TENT) } },
    { "EarlyTermination", { { "default", [](Setting&) {} }, Threshold("0.9"), Threshold("1"),
                            Threshold("0.95"), Threshold("0.99") } },
    { "AdaptiveSampling", { Adaptive("on", true), Adaptive("off", false) } },
    { "Jittering",
      { { "on", [](Setting& s) { s.Mapper->UseJitteringOn(); } }, { "off", [](Setting&) {} } } },
    { "Skipping", { Skip("nothing", Ours::SKIP_NOTHING), Skip("blocks", Ours::SKIP_BLOCKS),
                    Skip("cells", Ours::SKIP_CELLS) } },
    { "HomogeneousLeaps", { { "off", [](Setting& s) { s.Mapper->HomogeneousLeapsOff(); } },
                            { "on", [](Setting& s) { s.Mapper->HomogeneousLeapsOn(); } } } },
    { "VariationTolerance", { Tolerance("0", 0.0), Tolerance("1/256", 1.0 / 256.0),
                              Tolerance("1/64", 1.0 / 64.0), Tolerance("1/16", 1.0 / 16.0) } },
    { "AtlasPrecision",
      { Precision("native", 0), Precision("8", 8), Precision("4", 4), Precision("1", 1) } },
    { "ShadingOpacityThreshold", { Light("0"), Light("0.001"), Light("0.01") } },
    { "AdaptiveImageSampling", { Refined("0.01"), Refined("0.05") } },
    { "Quality", { Quality("Interactive", &Ours::SetQualityToInteractive),
                   Quality("Balanced", &Ours::SetQualityToBalanced),
                   Quality("Accurate", &Ours::SetQualityToAccurate),
                   Quality("Reference", &Ours::SetQualityToReference) } },
    { "Quality.Automatic", { Automatic("2"), Automatic("4"), Automatic("8") } },
    { "SamplesPerRay.PreIntegrated", Samples(Ours::PRE_INTEGRATED) },
    { "SamplesPerRay.PostInterpolation", Samples(Ours::POST_INTERPOLATION) },
  };
}
} // namespace

std::vector<Point> ListOwnPoints(bool isQuick)
{
  std::vector<Point> points;
  for (const Knob& knob : MakeKnobs())
  {
    for (std::size_t i = 0; i < knob.Values.size(); i += isQuick && !knob.IsWholeWhenQuick ? 2 : 1)
    {
      points.push_back(
        { "vtkFlatBlockVolumeMapper", knob.Name, knob.Values[i].Name, knob.Values[i].Apply, {} });
    }
  }
  return points;
}
} // namespace flatblock::benchmarks
