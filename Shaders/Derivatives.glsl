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

// A texel in the middle is taken from all others, so that small differences keep their digits, and
// what is constant has none.
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
  Derivatives found = Derivatives(vec3(0.0), vec3(0.0), vec3(0.0), true);
  for (int z = 0; z < 4; ++z)
  {
    vec3 valueOfPlane = vec3(0.0); // value, slope and bend along x
    vec2 slopeOfPlane = vec2(0.0); // slope along y of the first two
    float bendOfPlane = 0.0;
    for (int y = 0; y < 4; ++y)
    {
      vec4 texels;
      for (int x = 0; x < 4; ++x)
      {
        texels[x] = valueOf(fetchTexel(brick, first + ivec3(x, y, z)));
      }
#ifdef FLATBLOCK_HOLES
      found.isWhole = found.isWhole && !isHole(texels);
      texels = mix(texels, vec4(middle), greaterThan(abs(texels), vec4(2.0)));
#endif
      vec3 row = (texels - middle) * alongX;
      valueOfPlane += alongY[0][y] * row;
      slopeOfPlane += alongY[1][y] * row.xy;
      bendOfPlane += alongY[2][y] * row.x;
    }
    found.gradient += vec3(alongZ[0][z] * vec2(valueOfPlane.y, slopeOfPlane.x), alongZ[1][z] * valueOfPlane.x);
    found.bend += vec3(alongZ[0][z] * vec2(valueOfPlane.z, bendOfPlane), alongZ[2][z] * valueOfPlane.x);
    found.twist += vec3(alongZ[1][z] * vec2(slopeOfPlane.x, valueOfPlane.y), alongZ[0][z] * slopeOfPlane.y);
  }
  return found;
}

Derivatives derivativesAt(Brick brick, vec3 position)
{
  vec3 inBlock =
    clamp(position, brick.first, min(brick.first + float(in_CellsPerBlock), in_LastSample));
  vec3 middle = middleOfDifferences(brick, inBlock);
  vec3 share;
  ivec3 cell = cellOf(brick, middle, share);
  Derivatives found = derivativesFrom(brick, cell, share);
  float scale = brick.scale;
  found.gradient *= scale;
  found.bend *= scale * scale;
  found.twist *= scale * scale;
  vec3 beyond = inBlock - middle;
  found.gradient += found.bend * beyond + found.twist.zxy * beyond.yzx + found.twist.yzx * beyond.zxy;
  return found;
}
