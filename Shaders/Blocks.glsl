// The blocks, and where a block's brick lies in the atlas.

uniform sampler3D in_Atlas;
uniform usampler2D in_BlockIndex; // xyz: first texel of the brick, w: its level, or NotResident
uniform int in_Blocks[3];         // blocks an axis
uniform int in_CellsPerBlock;
uniform vec3 in_AtlasTexel;       // 1 / texels an axis
uniform float in_AdaptiveSampling; // 1: the step doubles a level, 0: it is the same everywhere

#if defined(FLATBLOCK_BRICK_RANGES) || defined(FLATBLOCK_EXTREMES)
#define FLATBLOCK_HAS_RANGES
uniform sampler2D in_BrickRanges; // of a block's texels: lowest, and from there to the highest
#endif

#ifdef FLATBLOCK_COMPONENTS
#define Texel vec4
const int TexelComponents = FLATBLOCK_COMPONENTS;
#else
#define Texel float
const int TexelComponents = 1;
#endif

float valueOf(float texel)
{
  return texel;
}

float valueOf(vec4 texel)
{
  return texel.r;
}

Texel firstOf(vec4 values)
{
#ifdef FLATBLOCK_COMPONENTS
  return values;
#else
  return values.r;
#endif
}

const uint NotResident = 65535u;

#ifdef FLATBLOCK_APRON
const float Apron = 1.0; // samples around a brick
#else
const float Apron = 0.0;
#endif

struct Brick
{
  bool resident;
  vec3 origin; // first texel within the apron
  vec3 first;  // first sample
  float scale; // texels a sample
  float step;  // between two points of a ray
  int side;    // texels
  vec3 low;    // first and last texel in the atlas, with the apron
  vec3 high;
#ifdef FLATBLOCK_HAS_RANGES
  vec2 range;
#endif
};

Brick fetchBrick(ivec3 block)
{
  int number = block.x + in_Blocks[0] * (block.y + in_Blocks[1] * block.z);
  int width = textureSize(in_BlockIndex, 0).x;
  countFetches(1);
  uvec4 entry = texelFetch(in_BlockIndex, ivec2(number % width, number / width), 0);
  Brick brick;
  brick.resident = entry.w != NotResident;
  brick.origin = vec3(entry.xyz);
  brick.first = vec3(block * in_CellsPerBlock);
  float stride = float(1 << min(int(entry.w), 16));
  brick.scale = 1.0 / stride;
  brick.step = mix(1.0, stride, in_AdaptiveSampling);
  brick.side = (in_CellsPerBlock >> int(entry.w)) + 1;
  brick.low = (brick.origin + 0.5 - Apron) * in_AtlasTexel;
  brick.high = (brick.origin + float(in_CellsPerBlock) * brick.scale + 0.5 + Apron) * in_AtlasTexel;
#ifdef FLATBLOCK_HAS_RANGES
  countFetches(1);
  brick.range = texelFetch(in_BrickRanges, ivec2(number % width, number / width), 0).rg;
#endif
  return brick;
}

// In texels of the brick, 0 being the centre of the first one.
vec3 inBrick(Brick brick, vec3 position)
{
  return clamp((position - brick.first) * brick.scale, 0.0, float(brick.side - 1));
}

// A texel of the atlas, as if all bricks had one scale.
float valueOfTexel(Brick brick, float texel)
{
#ifdef FLATBLOCK_BRICK_RANGES
  return brick.range.x + brick.range.y * texel;
#else
  return texel;
#endif
}

// Within the brick and its apron, in texture coordinates.
vec3 inAtlas(Brick brick, vec3 position)
{
  vec3 at = (brick.origin + (position - brick.first) * brick.scale + 0.5) * in_AtlasTexel;
  return clamp(at, brick.low, brick.high);
}

Texel texelAt(Brick brick, vec3 at)
{
  countFetches(1);
#ifdef FLATBLOCK_COMPONENTS
  return textureLod(in_Atlas, at, 0.0);
#else
  return valueOfTexel(brick, textureLod(in_Atlas, at, 0.0).r);
#endif
}

// By its place in the atlas.
Texel fetchTexel(Brick brick, ivec3 at)
{
  countFetches(1);
#ifdef FLATBLOCK_COMPONENTS
  return texelFetch(in_Atlas, at, 0);
#else
  return valueOfTexel(brick, texelFetch(in_Atlas, at, 0).r);
#endif
}

// The cell between 8 texels that a position lies in, by the first one, and how far along it.
ivec3 cellOf(Brick brick, vec3 position, out vec3 share)
{
  vec3 at = inBrick(brick, position);
  vec3 cell = clamp(floor(at), 0.0, max(float(brick.side - 2), 0.0));
  share = at - cell;
  return ivec3(cell);
}
