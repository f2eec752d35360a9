// A point that is not classified: the volume's value, as a position in the table.

struct Point
{
  float value;
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point noPoint()
{
  Point point;
  point.value = 0.0;
#ifdef FLATBLOCK_HOLES
  point.isHole = true;
#endif
  return point;
}

bool hasValue(Point point)
{
#ifdef FLATBLOCK_HOLES
  return !point.isHole;
#else
  return true;
#endif
}

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position);
  Point point;
  point.value = positionInTable(texel);
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}

// Opacity is that of the function, whatever the length.
vec4 surfaceOf(float value)
{
  return layerOf(matterAtPosition(value), 1.0);
}
