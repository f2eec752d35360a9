/// All that a run finds out.
#pragma once

#include "BenchMeasure.h"
#include "BenchOptions.h"

#include <utility>

namespace flatblock::benchmarks
{
/// The fastest of our points that is as close as a peer's, and both times in turns.
struct EqualError
{
  std::string Scene;
  std::string Peer;
  std::string Ours; ///< empty where none is as close
  double PeerPSNR = 0.0;
  double OurPSNR = 0.0;
  Duel Times = {}; ///< peer, ours

  double GetRatio() const { return this->Times.First / this->Times.Second; }
};

struct SceneNotes
{
  std::string Name;
  std::string Description;
};

struct Results
{
  BenchOptions Options;
  std::string Date;
  std::string Processor;
  std::string OpenGL; ///< renderer and version
  std::vector<SceneNotes> Scenes;
  std::vector<Record> Records;
  std::vector<EqualError> Equal;
  std::vector<std::string> LeftOut; ///< points, and why
};
} // namespace flatblock::benchmarks
