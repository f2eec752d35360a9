// The walk from block to block, and where a block's brick lies in the atlas.

uniform sampler3D in_Atlas;
uniform usampler2D in_BlockIndex; // xyz: first texel of the brick, w: its level, or NotResident
uniform int in_Blocks[3];         // blocks an axis
uniform int in_CellsPerBlock;
uniform vec3 in_AtlasTexel;       // 1 / texels an axis
uniform float in_AdaptiveSampling; // 1: the step doubles a level, 0: it is the same everywhere

const uint NotResident = 65535u;

struct BlockWalk
{
  ivec3 block;
  ivec3 stride;    // -1 or 1
  vec3 borders;    // distance along the ray to the next border of each axis
  vec3 blockWidth; // distance along the ray between two borders of each axis
};

struct Brick
{
  bool resident;
  vec3 origin; // first texel
  vec3 first;  // first sample
  float scale; // texels a sample
  float step;  // between two points of a ray
  int side;    // texels
  vec3 low;    // first and last texel, in the atlas
  vec3 high;
};

ivec3 blocksAnAxis()
{
  return ivec3(in_Blocks[0], in_Blocks[1], in_Blocks[2]);
}

BlockWalk enterBlocks(Ray ray)
{
  float cells = float(in_CellsPerBlock);
  vec3 entry = ray.origin + ray.begin * ray.direction;
  BlockWalk walk;
  walk.block = clamp(ivec3(floor(entry / cells)), ivec3(0), blocksAnAxis() - 1);
  walk.stride = ivec3(sign(ray.direction));
  walk.blockWidth = cells / abs(ray.direction);
  vec3 next = vec3(walk.block + max(walk.stride, 0)) * cells;
  walk.borders = (next - ray.origin) / ray.direction;
  return walk;
}

float distanceToBorder(BlockWalk walk)
{
  return min(walk.borders.x, min(walk.borders.y, walk.borders.z));
}

// Steps into the next block; false where the grid ends.
bool crossBorder(inout BlockWalk walk)
{
  vec3 b = walk.borders;
  int axis = b.x <= b.y && b.x <= b.z ? 0 : (b.y <= b.z ? 1 : 2);
  walk.block[axis] += walk.stride[axis];
  walk.borders[axis] += walk.blockWidth[axis];
  return walk.block[axis] >= 0 && walk.block[axis] < in_Blocks[axis];
}

Brick fetchBrick(ivec3 block)
{
  int number = block.x + in_Blocks[0] * (block.y + in_Blocks[1] * block.z);
  int width = textureSize(in_BlockIndex, 0).x;
  uvec4 entry = texelFetch(in_BlockIndex, ivec2(number % width, number / width), 0);
  Brick brick;
  brick.resident = entry.w != NotResident;
  brick.origin = vec3(entry.xyz);
  brick.first = vec3(block * in_CellsPerBlock);
  brick.scale = exp2(-float(entry.w));
  brick.step = mix(1.0, exp2(float(entry.w)), in_AdaptiveSampling);
  brick.side = (in_CellsPerBlock >> int(entry.w)) + 1;
  brick.low = (brick.origin + 0.5) * in_AtlasTexel;
  brick.high = (brick.origin + float(in_CellsPerBlock) * brick.scale + 0.5) * in_AtlasTexel;
  return brick;
}

// In texels of the brick, 0 being the centre of the first one.
vec3 inBrick(Brick brick, vec3 position)
{
  return clamp((position - brick.first) * brick.scale, 0.0, float(brick.side - 1));
}

float texelOf(Brick brick, vec3 position)
{
  vec3 at = (brick.origin + (position - brick.first) * brick.scale + 0.5) * in_AtlasTexel;
  return textureLod(in_Atlas, clamp(at, brick.low, brick.high), 0.0).r;
}
