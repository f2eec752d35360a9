// Values between samples: a uniform tricubic B-spline, of which the texels are the coefficients (Sigg
// and Hadwiger, Fast Third-Order Texture Filtering, GPU Gems 2, 2005).

// What four texels along an axis add to the value between the middle two, `a` of the way.
vec4 weightsOfValue(float a)
{
  float b = 1.0 - a;
  return vec4(b * b * b, 4.0 - 3.0 * a * a * (2.0 - a), 4.0 - 3.0 * b * b * (2.0 - b), a * a * a) /
    6.0;
}

// Where the texture unit finds the sums of the first two and of the last two texels, in texels from the
// first one of the cell; and the weight of the first sum.
vec3 placesOfPairs(float a)
{
  vec4 weights = weightsOfValue(a);
  float low = weights.x + weights.y;
  return vec3(weights.y / low - 1.0, weights.w / (weights.z + weights.w) + 1.0, low);
}

Texel rowOf(Brick brick, vec3 x, float y, float z)
{
  return mix(texelAt(brick, vec3(x.y, y, z)), texelAt(brick, vec3(x.x, y, z)), x.z);
}

// From 8 fetches, which the texture unit interpolates between two texels along each axis.
Texel texelOf(Brick brick, vec3 position)
{
  vec3 share;
  vec3 first = brick.origin + vec3(cellOf(brick, position, share)) + 0.5;
  vec3 x = placesOfPairs(share.x);
  vec3 y = placesOfPairs(share.y);
  vec3 z = placesOfPairs(share.z);
  x.xy = (first.x + x.xy) * in_AtlasTexel.x;
  y.xy = (first.y + y.xy) * in_AtlasTexel.y;
  z.xy = (first.z + z.xy) * in_AtlasTexel.z;
  Texel low = mix(rowOf(brick, x, y.y, z.x), rowOf(brick, x, y.x, z.x), y.z);
  Texel high = mix(rowOf(brick, x, y.y, z.y), rowOf(brick, x, y.x, z.y), y.z);
  return mix(high, low, z.z);
}

#ifdef FLATBLOCK_DERIVATIVES
const bool HasCorners = true; // of 4 x 4 x 4 texels
const bool IsCentral = false; // differences, but derivatives

mat3x4 weightsBetween(float a)
{
  float b = 1.0 - a;
  return mat3x4(weightsOfValue(a),
    0.5 * vec4(-b * b, a * (3.0 * a - 4.0), b * (4.0 - 3.0 * b), a * a),
    vec4(b, 3.0 * a - 2.0, 1.0 - 3.0 * a, a));
}
#endif
