// The scenes of VTK's own tests, by both mappers in one process.
#include "Metrics.h"
#include "PeerScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>

using namespace flatblock::testing;

namespace
{
Picture ToPicture(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  Picture picture(static_cast<std::size_t>(size[0]) * size[1]);
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer()) + 3 * i;
    picture[i] = { pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0, 1.0 };
  }
  return picture;
}

// Median, in milliseconds, of a frame that is there already.
template <typename Draw>
double TimeFrame(const Draw& draw)
{
  std::array<double, 5> times;
  for (double& time : times)
  {
    const auto start = std::chrono::steady_clock::now();
    draw();
    const std::chrono::duration<double, std::milli> taken =
      std::chrono::steady_clock::now() - start;
    time = taken.count();
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// Rows of a table, where one is asked for.
void Write(Scene& scene, const PeerScene& peer, double psnr, double ssim)
{
  if (const char* file = std::getenv("FLATBLOCK_PEER_SCENES"))
  {
    const double ours = TimeFrame([&] { scene.Draw(); });
    const double theirs = TimeFrame([&] { scene.DrawWithPeer(); });
    std::ofstream(file, std::ios::app)
      << "covered\t" << peer.Name << "\t" << psnr << "\t" << ssim << "\t" << ours << "\t" << theirs
      << "\t" << peer.Remark << "\n";
  }
}
} // namespace

class PeerScenes : public testing::TestWithParam<PeerScene>
{
};

TEST_P(PeerScenes, LookAlike)
{
  const PeerScene& peer = GetParam();
  Scene scene;
  peer.Set(scene);
  const auto ours = scene.Draw();
  EXPECT_TRUE(ShowsSomething(ours));
  const auto theirs = scene.DrawWithPeer();
  const double psnr = PSNR(ours, theirs);
  const double ssim =
    StructuralSimilarity(ToPicture(ours), ToPicture(theirs), scene.Window->GetSize()[0]);
  std::cout << peer.Name << ": " << psnr << " dB, structural similarity " << ssim << "\n";
  EXPECT_GE(psnr, peer.LeastPSNR);
  EXPECT_GE(ssim, peer.LeastSSIM);
  Write(scene, peer, psnr, ssim);
}

INSTANTIATE_TEST_SUITE_P(OfVTK, PeerScenes, testing::ValuesIn(GetPeerScenes()),
  [](const testing::TestParamInfo<PeerScene>& info) { return info.param.Name; });

TEST(PeerScenesLeftOut, AreListed)
{
  const char* file = std::getenv("FLATBLOCK_PEER_SCENES");
  for (const LeftOutScene& scene : GetLeftOutScenes())
  {
    EXPECT_FALSE(scene.Reason.empty());
    if (file)
    {
      std::ofstream(file, std::ios::app)
        << "left out\t" << scene.Names << "\t" << scene.Reason << "\n";
    }
  }
}
