#include "BenchSelection.h"

#include <regex>
#include <stdexcept>

namespace flatblock::benchmarks
{
std::vector<SelectedScene> SelectScenes(const BenchOptions& options)
{
  const std::regex filter(options.Filter, std::regex::icase);
  std::vector<Point> points = ListOwnPoints(options.IsQuick);
  for (const Point& peer : ListPeerPoints(options.IsQuick))
  {
    points.push_back(peer);
  }
  std::vector<SelectedScene> selected;
  for (const BenchScene& scene : ListScenes(options))
  {
    SelectedScene one{ scene, {} };
    std::copy_if(points.begin(), points.end(), std::back_inserter(one.Points),
      [&](const Point& point)
      { return std::regex_search(scene.Name + "/" + point.GetName(), filter); });
    if (!one.Points.empty())
    {
      selected.push_back(one);
    }
  }
  if (selected.empty())
  {
    throw std::runtime_error(
      "--filter: '" + options.Filter + "' matches no point; --list names them.");
  }
  return selected;
}
} // namespace flatblock::benchmarks
