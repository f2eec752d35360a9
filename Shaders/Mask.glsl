// A mask: the second component, of the nearest sample.

uniform float in_LowestLabel;

int labelAt(Brick brick, vec3 position)
{
  countFetches(1);
  ivec3 texel = ivec3(brick.origin + floor(inBrick(brick, position) + 0.5));
  return int(texelFetch(in_Atlas, texel, 0).g * 255.0 + in_LowestLabel + 0.5);
}
