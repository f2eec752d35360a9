/// What VTK tests its own ray caster with, as scenes of generated data that both mappers draw.
#pragma once

#include "Rendering.h"

#include <ostream>
#include <string>
#include <vector>

namespace flatblock::testing
{
struct PeerScene
{
  std::string Name; ///< of VTK's test, without TestGPURayCast
  double LeastPSNR; ///< of the two pictures, in dB
  double LeastSSIM; ///< their structural similarity
  void (*Set)(Scene&);
  std::string Remark; ///< why they are no more alike
};

void PrintTo(const PeerScene& scene, std::ostream* stream);

std::vector<PeerScene> GetPeerScenesOfBlending(); ///< and of what else lies in the way of rays
std::vector<PeerScene> GetPeerScenesOfData();
std::vector<PeerScene> GetPeerScenesOfViews(); ///< cameras, lights, clipping, sampling
std::vector<PeerScene> GetPeerScenes();

struct LeftOutScene
{
  std::string Names;
  std::string Reason;
};

std::vector<LeftOutScene> GetLeftOutScenes();
} // namespace flatblock::testing
