// Classification of values under a mask: its label is the number of the table that a value is looked up
// in, or nothing is seen where it is 0.

uniform int in_EntriesPerTable;
#ifdef FLATBLOCK_LABELS
uniform float in_MaskBlendFactor; // 0: the first table alone counts, 1: that of the label
#endif

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
