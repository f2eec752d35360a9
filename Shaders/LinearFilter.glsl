// Values between samples: trilinear.

Texel texelOf(Brick brick, vec3 position)
{
  return texelAt(brick, inAtlas(brick, position));
}

#ifdef FLATBLOCK_DERIVATIVES
const bool HasCorners = false; // of 4 x 4 x 4 texels
const bool IsCentral = true;   // differences, which are as wide as two texels are apart

// What four texels along an axis add to the value between the middle two, `a` of the way, and to its
// derivatives: central differences as far as the texels are apart.
mat3x4 weightsBetween(float a)
{
  return mat3x4(vec4(0.0, 1.0 - a, a, 0.0),
    0.5 * vec4(a - 1.0, -a, 1.0 - a, a),
    vec4(1.0 - a, 3.0 * a - 2.0, 1.0 - 3.0 * a, a));
}
#endif
