// Gradients of the volume: central differences as far as the brick's samples are apart, which the
// bricks' aprons hold.

#ifdef FLATBLOCK_GRADIENT_TABLE
uniform sampler2D in_GradientTable; // y: magnitudes
uniform vec3 in_GradientToTable;    // scale an axis: to magnitudes from 0 to 1
#endif

#ifdef FLATBLOCK_HOLES
// Where a value is none, the one in the middle stands for it.
void passHole(inout float value, inout float reach, float middle)
{
  bool isNone = isHole(abs(value));
  value = isNone ? middle : value;
  reach = isNone ? 0.0 : reach;
}
#endif

// In texels a sample; one-sided at the volume's faces.
vec3 gradientAt(Brick brick, vec3 position)
{
  vec3 middle =
    clamp(position, brick.first, min(brick.first + float(in_CellsPerBlock), in_LastSample));
  vec3 below = middle - max(middle - 1.0 / brick.scale, 0.0);
  vec3 above = min(middle + 1.0 / brick.scale, in_LastSample) - middle;
  vec3 at = inAtlas(brick, middle);
  vec3 before = at - below * brick.scale * in_AtlasTexel;
  vec3 behind = at + above * brick.scale * in_AtlasTexel;
  vec3 low = vec3(texelAt(brick, vec3(before.x, at.yz)),
    texelAt(brick, vec3(at.x, before.y, at.z)), texelAt(brick, vec3(at.xy, before.z)));
  vec3 high = vec3(texelAt(brick, vec3(behind.x, at.yz)),
    texelAt(brick, vec3(at.x, behind.y, at.z)), texelAt(brick, vec3(at.xy, behind.z)));
#ifdef FLATBLOCK_HOLES
  float value = texelAt(brick, at);
  passHole(low.x, below.x, value);
  passHole(low.y, below.y, value);
  passHole(low.z, below.z, value);
  passHole(high.x, above.x, value);
  passHole(high.y, above.y, value);
  passHole(high.z, above.z, value);
#endif
  return (high - low) / max(below + above, 1e-3);
}

#ifdef FLATBLOCK_GRADIENT_TABLE
// Beyond 1 it is as at 1.
vec4 lookUpGradient(float across, vec3 gradient)
{
  countFetches(1);
  vec2 last = vec2(textureSize(in_GradientTable, 0) - 1);
  vec2 position = clamp(vec2(across, length(gradient * in_GradientToTable)), 0.0, 1.0);
  return textureLod(in_GradientTable, (position * last + 0.5) / (last + 1.0), 0.0);
}
#endif
