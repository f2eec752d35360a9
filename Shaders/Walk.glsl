// The walk of a ray from cube to cube of cells: blocks, or what the map of leaps has.

#ifdef FLATBLOCK_SKIPPING
uniform usampler3D in_SkipMap; // see lookAround()
uniform int in_Cubes[3];       // an axis
uniform int in_CellsPerCube;
uniform int in_CubesPerBlock;  // along a side, as a power of two
#endif

// Kinds of cubes.
const int Varying = 0;
const int Constant = 2;
const int Hidden = 3;

struct Walk
{
  ivec3 cube;
  ivec3 first;   // of the cubes around it that are of its kind, a box that the ray leaves at once
  ivec3 last;
  bool isPlain;  // what is in them looks all the same,
  bool isMatter; // and is not transparent
  bool isHidden; // no brick holds it
};

int cellsPerCube()
{
#ifdef FLATBLOCK_SKIPPING
  return in_CellsPerCube;
#else
  return in_CellsPerBlock;
#endif
}

ivec3 cubesAnAxis()
{
#ifdef FLATBLOCK_SKIPPING
  return ivec3(in_Cubes[0], in_Cubes[1], in_Cubes[2]);
#else
  return ivec3(in_Blocks[0], in_Blocks[1], in_Blocks[2]);
#endif
}

ivec3 blockOf(Walk walk)
{
#ifdef FLATBLOCK_SKIPPING
  return walk.cube >> in_CubesPerBlock;
#else
  return walk.cube;
#endif
}

// A texel of the map: the kind of its cube, and how far that reaches: in cubes, within the block, but
// for blocks without a brick, which are counted as a whole.
void lookAround(inout Walk walk)
{
  walk.first = walk.cube;
  walk.last = walk.cube;
#ifdef FLATBLOCK_SKIPPING
  countFetches(1);
  int texel = int(texelFetch(in_SkipMap, walk.cube, 0).r);
  int kind = texel >> 6;
  ivec3 around = ivec3((texel & 63) - 1);
  ivec3 block = blockOf(walk);
  walk.isHidden = kind == Hidden;
  ivec3 firstBlock = walk.isHidden ? block - around : block;
  ivec3 lastBlock = walk.isHidden ? block + around : block;
  ivec3 first = firstBlock << in_CubesPerBlock;
  ivec3 last = ((lastBlock + 1) << in_CubesPerBlock) - 1;
  walk.first = walk.isHidden ? first : max(walk.cube - around, first);
  walk.last = walk.isHidden ? last : min(walk.cube + around, last);
  walk.isPlain = kind != Varying;
  walk.isMatter = kind == Constant;
#endif
}

Walk enterCubes(Ray ray)
{
  vec3 entry = ray.origin + ray.begin * ray.direction;
  Walk walk = Walk(ivec3(0), ivec3(0), ivec3(0), false, false, false);
  walk.cube = clamp(ivec3(floor(entry / float(cellsPerCube()))), ivec3(0), cubesAnAxis() - 1);
  lookAround(walk);
  return walk;
}

// Distances along the ray to where it leaves the cubes around, for each axis.
vec3 distancesToBorders(Walk walk, Ray ray)
{
  vec3 borders = mix(vec3(walk.first), vec3(walk.last + 1), step(0.0, ray.direction));
  return (borders * float(cellsPerCube()) - ray.origin) * ray.inverse;
}

float nearestOf(vec3 distances)
{
  return min(distances.x, min(distances.y, distances.z));
}

// Steps over the nearest border; false where the grid ends. Along its axis that is exact; along the
// others the ray is where it is, within the box.
bool crossBorder(inout Walk walk, Ray ray, vec3 borders)
{
  float nearest = nearestOf(borders);
  vec3 position = (ray.origin + nearest * ray.direction) / float(cellsPerCube());
  vec3 inside = clamp(floor(position), vec3(walk.first), vec3(walk.last));
  vec3 beyond = mix(vec3(walk.first - 1), vec3(walk.last + 1), step(0.0, ray.direction));
  vec3 cube = mix(inside, beyond, step(borders, vec3(nearest)));
  walk.cube = ivec3(clamp(cube, vec3(0.0), vec3(cubesAnAxis() - 1)));
  lookAround(walk);
  return vec3(walk.cube) == cube;
}
