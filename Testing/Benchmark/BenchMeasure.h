/// What is measured of a point in a scene.
#pragma once

#include "AccuracyMeasures.h"
#include "BenchPoint.h"

namespace flatblock::benchmarks
{
struct Record
{
  std::string Scene;
  std::string Mapper;
  std::string Knob;
  std::string Value;
  double Milliseconds = 0.0;   ///< median of five frames after one
  double Bytes = -1.0;         ///< on the graphics card; negative where the mapper doesn't say
  double SamplesPerRay = -1.0; ///< negative where the mapper doesn't count them, as the next
  double FetchesPerRay = -1.0;
  Errors Error = {};
  int Width = 0;
  std::vector<unsigned char> Pixels = {}; ///< RGB, rows from below

  bool IsOurs() const { return this->Mapper == "vtkFlatBlockVolumeMapper"; }
  std::string GetName() const { return this->Mapper + "/" + this->Knob + "=" + this->Value; }
  double GetPSNR() const { return this->Error.PeakSignalToNoise; }
};

/// Of those frames that took turns, medians in milliseconds.
struct Duel
{
  double First = 0.0;
  double Second = 0.0;
};

class Bench
{
public:
  explicit Bench(Subject& subject);

  /// @throws std::runtime_error that says why the mapper draws nothing here
  Record Measure(const Point& point);

  Duel TimeInTurns(const Point& first, const Point& second);

private:
  Subject& Shown;
  vtkTypeInt64 BytesBeside = 0;
  vtkTypeInt64 BytesOfVolume = 0;
};
} // namespace flatblock::benchmarks
