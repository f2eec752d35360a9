#include "Relocation.h"

#include <cstdlib>
#include <deque>

namespace flatblock
{
namespace
{
class Relocator
{
public:
  Relocator(const AtlasAllocator& from, const std::vector<BrickPlace>& fromPlaces,
    const AtlasAllocator& to, const std::vector<BrickPlace>& toPlaces)
    : From(from), To(to), FromPlaces(fromPlaces), ToPlaces(toPlaces)
  {
  }

  Relocation Run(const std::vector<std::uint8_t>& stays)
  {
    this->FindMovers(stays);
    this->FindObstacles();
    std::deque<int> ready;
    for (int mover = 0; mover < static_cast<int>(this->Movers.size()); ++mover)
    {
      if (this->Movers[mover].Obstacles == 0)
      {
        ready.push_back(mover);
      }
    }
    // Where all that are left wait for each other in circles, the first of them gives way.
    for (int first = 0; first < static_cast<int>(this->Movers.size()); ++first)
    {
      while (!ready.empty())
      {
        const int mover = ready.front();
        ready.pop_front();
        this->Result.Moves.push_back(this->GetMove(this->Movers[mover].Block));
        this->Leave(mover, ready);
      }
      if (!this->Movers[first].HasLeft)
      {
        this->Result.Dropped.push_back(this->Movers[first].Block);
        this->Leave(first, ready);
        this->Movers[first].Obstacles = -1; // it will not move
      }
    }
    return this->Result;
  }

private:
  struct Mover
  {
    std::int64_t Block;
    int Obstacles = 0;        // that have to leave first
    std::vector<int> Waiting; // for this one to leave
    bool HasLeft = false;
  };

  BoxMove GetMove(std::int64_t block) const
  {
    const int side = this->From.GetShape().GetSide(this->From.GetLevel(this->FromPlaces[block]));
    return { this->From.GetOrigin(this->FromPlaces[block]),
      this->To.GetOrigin(this->ToPlaces[block]), { side, side, side } };
  }

  // A brick may overlap its own new place only if it is shifted along z.
  static bool CanMove(const BoxMove& move)
  {
    const int side = move.Size[0];
    const int x = std::abs(move.From[0] - move.To[0]);
    const int y = std::abs(move.From[1] - move.To[1]);
    const int z = std::abs(move.From[2] - move.To[2]);
    return x >= side || y >= side || z >= side || (x == 0 && y == 0);
  }

  void FindMovers(const std::vector<std::uint8_t>& stays)
  {
    this->MoverAt.resize(this->From.GetNumberOfSlabs());
    for (std::size_t i = 0; i < stays.size(); ++i)
    {
      const auto block = static_cast<std::int64_t>(i);
      if (!stays[i])
      {
        continue;
      }
      const BoxMove move = this->GetMove(block);
      if (move.From == move.To)
      {
        continue;
      }
      if (!CanMove(move))
      {
        this->Result.Dropped.push_back(block);
        continue;
      }
      const BrickPlace& place = this->FromPlaces[i];
      auto& slab = this->MoverAt[place.Slab];
      slab.resize(this->From.GetShape().GetBricksPerSlab(this->From.GetLevel(place)), -1);
      slab[place.Brick] = static_cast<int>(this->Movers.size());
      this->Movers.push_back({ block, 0, {} });
    }
  }

  void FindObstacles()
  {
    for (int mover = 0; mover < static_cast<int>(this->Movers.size()); ++mover)
    {
      const BoxMove move = this->GetMove(this->Movers[mover].Block);
      for (const BrickPlace& place : this->From.FindPlaces(move.To, move.Size))
      {
        const auto& slab = this->MoverAt[place.Slab];
        const int obstacle = slab.empty() ? -1 : slab[place.Brick];
        if (obstacle >= 0 && obstacle != mover)
        {
          ++this->Movers[mover].Obstacles;
          this->Movers[obstacle].Waiting.push_back(mover);
        }
      }
    }
  }

  void Leave(int mover, std::deque<int>& ready)
  {
    this->Movers[mover].HasLeft = true;
    for (const int waiting : this->Movers[mover].Waiting)
    {
      if (--this->Movers[waiting].Obstacles == 0)
      {
        ready.push_back(waiting);
      }
    }
  }

  const AtlasAllocator& From;
  const AtlasAllocator& To;
  const std::vector<BrickPlace>& FromPlaces;
  const std::vector<BrickPlace>& ToPlaces;
  std::vector<Mover> Movers;
  std::vector<std::vector<int>> MoverAt; // by slab and brick
  Relocation Result;
};
} // namespace

Relocation Relocate(const AtlasAllocator& from, const std::vector<BrickPlace>& fromPlaces,
  const AtlasAllocator& to, const std::vector<BrickPlace>& toPlaces,
  const std::vector<std::uint8_t>& stays)
{
  return Relocator(from, fromPlaces, to, toPlaces).Run(stays);
}
} // namespace flatblock
