#include "PeerScenes.h"

#include "vtkVersionMacros.h"

namespace flatblock::testing
{
void PrintTo(const PeerScene& scene, std::ostream* stream)
{
  *stream << scene.Name;
}

std::vector<PeerScene> GetPeerScenes()
{
  std::vector<PeerScene> all = GetPeerScenesOfBlending();
  for (const auto& more : { GetPeerScenesOfData(), GetPeerScenesOfViews() })
  {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::vector<LeftOutScene> GetLeftOutScenes()
{
  return
  {
    { "FourComponentsMinIP", "the peer draws the largest values of several components" },
      { "MapperRectilinearGrid", "an error names vtkResampleToImage" },
      { "MultiVolume*", "volumes that overlap are drawn one after the other; vtkMultiVolume takes "
                        "vtkGPUVolumeRayCastMapper only" },
      { "DepthPeelingTransVol", "volumes do not peel: they come after translucent geometry" },
      { "RenderDepthToImage*, RenderDepthToTexture, RenderToTexture, VolumeDepthPass",
        "RenderToImage, in this suite; textures stay the mapper's own" },
      { "MapperSSAO", "vtkSSAOPass takes depths that volumes do not write" },
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
      { "MapperShadows", "this VTK has no global illumination" },
#endif
      { "UserShader*, SurfaceProbe*, JitteringCustom", "VTK's own shaders or noise" },
      { "FourComponentsCompositeStreaming, TextureStreaming*", "VTK's partitions: blocks do this" },
      { "MapperBenchmark", "flatblock-bench" },
      { "VolumePicking", "Selection and Picker, in this suite" },
  };
}
} // namespace flatblock::testing
