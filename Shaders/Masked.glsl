// Classification of values under a mask: the second component, of the nearest sample. It is the number
// of the table that a value is looked up in, or nothing is seen where it is 0.

uniform int in_EntriesPerTable;
uniform float in_LowestLabel; // of the mask
#ifdef FLATBLOCK_LABELS
uniform float in_MaskBlendFactor; // 0: the first table alone counts, 1: that of the label
#endif

int labelAt(Brick brick, vec3 position)
{
  countFetches(1);
  ivec3 texel = ivec3(brick.origin + floor(inBrick(brick, position) + 0.5));
  return int(texelFetch(in_Atlas, texel, 0).g * 255.0 + in_LowestLabel + 0.5);
}

vec4 matterIn(int table, float position)
{
  float interval = intervalOf(position);
  int entry = table * in_EntriesPerTable + int(interval);
  return mix(entryOfTable(entry), entryOfTable(entry + 1), position - interval);
}

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position).r;
  float value = positionInTable(texel);
  int label = labelAt(brick, position);
  Point point;
  point.matter = matterIn(0, value);
#ifdef FLATBLOCK_LABELS
  point.matter = mix(point.matter, matterIn(label, value), label > 0 ? in_MaskBlendFactor : 0.0);
#else
  point.matter = label > 0 ? point.matter : vec4(0.0);
#endif
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}
