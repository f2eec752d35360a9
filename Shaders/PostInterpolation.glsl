// Post-interpolative classification: values are interpolated, then classified.

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position);
  Point point;
  point.matter = matterAtPosition(positionInTable(texel));
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}
