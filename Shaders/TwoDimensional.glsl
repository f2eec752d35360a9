// Classification by a value and the magnitude of the gradient there: colour and extinction.

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position);
  float across = positionInTable(texel) / in_LastEntry;
  Point point;
  point.matter = lookUpGradient(across, 0, gradientAt(brick, position));
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}
