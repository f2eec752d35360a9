// Classification by a value and the magnitude of the gradient there, or by the values of two arrays:
// colour and extinction.

#ifdef FLATBLOCK_SECOND_ARRAY
uniform vec2 in_SecondToTable; // scale and offset, of a texel: over its range, from 0 to 1
#endif

Point pointAt(Brick brick, vec3 position)
{
  Texel texel = texelOf(brick, position);
#ifdef FLATBLOCK_SECOND_ARRAY
  float across = positionInTable(texel.r) / in_LastEntry;
  vec4 matter = lookUp(across, texel.g * in_SecondToTable.x + in_SecondToTable.y);
#else
  float across = positionInTable(texel) / in_LastEntry;
  vec4 matter = lookUpGradient(across, 0, gradientAt(brick, position));
#endif
  Point point;
  point.matter = matter;
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}
