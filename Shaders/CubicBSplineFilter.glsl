// Values between samples: a uniform tricubic B-spline, of which the texels are the coefficients (Sigg
// and Hadwiger, Fast Third-Order Texture Filtering, GPU Gems 2, 2005).

// What four texels along an axis add to the value between the middle two, `a` of the way.
vec4 weightsOfValue(float a)
{
  float b = 1.0 - a;
  return vec4(b * b * b, 4.0 - 3.0 * a * a * (2.0 - a), 4.0 - 3.0 * b * b * (2.0 - b), a * a * a) /
    6.0;
}

// From 8 fetches, which the texture unit interpolates between two texels along each axis.
Texel texelOf(Brick brick, vec3 position)
{
  vec3 share;
  vec3 first = brick.origin + vec3(cellOf(brick, position, share)) + 0.5;
  vec3 low;
  vec3 high;
  vec3 lowShare;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec4 weights = weightsOfValue(share[axis]);
    lowShare[axis] = weights.x + weights.y;
    low[axis] = weights.y / lowShare[axis] - 1.0;
    high[axis] = weights.w / (weights.z + weights.w) + 1.0;
  }
  low = (first + low) * in_AtlasTexel;
  high = (first + high) * in_AtlasTexel;
  Texel rows[4];
  for (int row = 0; row < 4; ++row)
  {
    float y = (row & 1) == 0 ? low.y : high.y;
    float z = row < 2 ? low.z : high.z;
    rows[row] =
      mix(texelAt(brick, vec3(high.x, y, z)), texelAt(brick, vec3(low.x, y, z)), lowShare.x);
  }
  return mix(mix(rows[3], rows[2], lowShare.y), mix(rows[1], rows[0], lowShare.y), lowShare.z);
}

#ifdef FLATBLOCK_DERIVATIVES
mat3x4 weightsBetween(float a)
{
  float b = 1.0 - a;
  return mat3x4(weightsOfValue(a),
    0.5 * vec4(-b * b, a * (3.0 * a - 4.0), b * (4.0 - 3.0 * b), a * a),
    vec4(b, 3.0 * a - 2.0, 1.0 - 3.0 * a, a));
}

vec3 middleOfDifferences(Brick brick, vec3 position)
{
  return clamp(position, vec3(0.0), in_LastSample);
}
#endif
