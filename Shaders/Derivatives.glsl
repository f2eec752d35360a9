// First and second derivatives of the volume from one gather of 4 x 4 x 4 texels: along each axis the
// value, its slope and its bend are sums of the same four, weighted as the filter says. Texels are
// read as they are, since what texture units interpolate is too coarse for second differences.

struct Derivatives
{
  vec3 gradient; // in texels a sample
  vec3 bend;     // second derivatives xx, yy, zz
  vec3 twist;    // and yz, xz, xy
  bool isWhole;  // no hole takes part
};

// Weighted sums over some of the texels.
struct Moments
{
  vec3 values; // value, slope and bend along x,
  vec2 slopes; // slope along y of the first two,
  float bend;  // and bend along y
  bool isWhole;
};

// A texel in the middle is taken from all others, so that small differences keep their digits, and
// what is constant has none. Where there is no value it stands for it.
float differenceAt(Brick brick, ivec3 at, float middle, inout bool isWhole)
{
  float texel = valueOf(fetchTexel(brick, at));
#ifdef FLATBLOCK_HOLES
  isWhole = isWhole && !isHole(texel);
  texel = isHole(texel) ? middle : texel;
#endif
  return texel - middle;
}

// One at the edge of the 4 x 4 has the corners, which some filters have no weight for.
vec3 rowAt(
  Brick brick, ivec3 first, mat3x4 alongX, float middle, bool isAtEdge, inout bool isWhole)
{
  vec4 texels = vec4(0.0);
  if (HasCorners || !isAtEdge)
  {
    texels.x = differenceAt(brick, first, middle, isWhole);
    texels.w = differenceAt(brick, first + ivec3(3, 0, 0), middle, isWhole);
  }
  texels.y = differenceAt(brick, first + ivec3(1, 0, 0), middle, isWhole);
  texels.z = differenceAt(brick, first + ivec3(2, 0, 0), middle, isWhole);
  return texels * alongX;
}

// Written out and not as loops: some drivers end a shader that turns too often.
Moments planeAt(
  Brick brick, ivec3 first, mat3x4 alongX, mat3x4 alongY, float middle, bool isOuter)
{
  Moments found;
  found.isWhole = true;
  vec3 a = rowAt(brick, first, alongX, middle, isOuter, found.isWhole);
  vec3 b = rowAt(brick, first + ivec3(0, 1, 0), alongX, middle, false, found.isWhole);
  vec3 c = rowAt(brick, first + ivec3(0, 2, 0), alongX, middle, false, found.isWhole);
  vec3 d = rowAt(brick, first + ivec3(0, 3, 0), alongX, middle, isOuter, found.isWhole);
  found.values = mat4x3(a, b, c, d) * alongY[0];
  found.slopes = mat4x2(a.xy, b.xy, c.xy, d.xy) * alongY[1];
  found.bend = dot(vec4(a.x, b.x, c.x, d.x), alongY[2]);
  return found;
}

Derivatives derivativesFrom(Brick brick, ivec3 cell, vec3 share)
{
  ivec3 first = ivec3(brick.origin) + cell - 1;
  mat3x4 alongX = weightsBetween(share.x);
  mat3x4 alongY = weightsBetween(share.y);
  mat3x4 alongZ = weightsBetween(share.z);
  float middle = valueOf(fetchTexel(brick, first + 1));
#ifdef FLATBLOCK_HOLES
  middle = isHole(middle) ? 0.0 : middle;
#endif
  Moments a = planeAt(brick, first, alongX, alongY, middle, true);
  Moments b = planeAt(brick, first + ivec3(0, 0, 1), alongX, alongY, middle, false);
  Moments c = planeAt(brick, first + ivec3(0, 0, 2), alongX, alongY, middle, false);
  Moments d = planeAt(brick, first + ivec3(0, 0, 3), alongX, alongY, middle, true);
  vec3 values = mat4x3(a.values, b.values, c.values, d.values) * alongZ[0];
  vec2 slopes = mat4x2(a.slopes, b.slopes, c.slopes, d.slopes) * alongZ[0];
  float bend = dot(vec4(a.bend, b.bend, c.bend, d.bend), alongZ[0]);
  vec3 slopesOfZ = mat4x3(vec3(a.values.xy, a.slopes.x), vec3(b.values.xy, b.slopes.x),
    vec3(c.values.xy, c.slopes.x), vec3(d.values.xy, d.slopes.x)) * alongZ[1];
  float bendOfZ = dot(vec4(a.values.x, b.values.x, c.values.x, d.values.x), alongZ[2]);
  return Derivatives(vec3(values.y, slopes.x, slopesOfZ.x), vec3(values.z, bend, bendOfZ),
    vec3(slopesOfZ.z, slopesOfZ.y, slopes.y), a.isWhole && b.isWhole && c.isWhole && d.isWhole);
}

// Derivatives need a sample on both sides, as far away as the brick's samples are apart, or else as the
// volume reaches.
vec3 reachOf(Brick brick)
{
  return min(vec3(1.0 / brick.scale), 0.5 * in_LastSample);
}

// Near the volume's faces those of the nearest place that has them are taken, with what the gradient
// changes by from there on.
Derivatives derivativesAt(Brick brick, vec3 position)
{
  vec3 inBlock =
    clamp(position, brick.first, min(brick.first + float(in_CellsPerBlock), in_LastSample));
  vec3 reach = reachOf(brick);
  vec3 middle = clamp(inBlock, reach, in_LastSample - reach);
  vec3 share;
  ivec3 cell = cellOf(brick, middle, share);
  Derivatives found = derivativesFrom(brick, cell, share);
  float scale = brick.scale;
  vec3 slopes = IsCentral ? 1.0 / max(reach, 1e-3) : vec3(scale);
  found.gradient *= slopes;
  found.bend *= scale * scale;
  found.twist *= slopes.yzx * slopes.zxy;
  vec3 beyond = inBlock - middle;
  found.gradient += found.bend * beyond + found.twist.zxy * beyond.yzx + found.twist.yzx * beyond.zxy;
  return found;
}
