// A point that is not classified: the volume's value, as a position in the table.

struct Point
{
  float value;
#if defined(FLATBLOCK_HOLES) || defined(FLATBLOCK_MASK)
  bool isHole;
#endif
};

Point noPoint()
{
  Point point;
  point.value = 0.0;
#if defined(FLATBLOCK_HOLES) || defined(FLATBLOCK_MASK)
  point.isHole = true;
#endif
  return point;
}

bool hasValue(Point point)
{
#if defined(FLATBLOCK_HOLES) || defined(FLATBLOCK_MASK)
  return !point.isHole;
#else
  return true;
#endif
}

Point pointAt(Brick brick, vec3 position)
{
  Texel texel = texelOf(brick, position);
  Point point;
  point.value = positionInTable(valueOf(texel));
#if defined(FLATBLOCK_MASK)
  point.isHole = isHole(texel) || labelAt(brick, position) == 0;
#elif defined(FLATBLOCK_HOLES)
  point.isHole = isHole(texel);
#endif
  return point;
}

// Opacity is that of the function, whatever the length.
vec4 surfaceOf(float value)
{
  return layerOf(matterAtPosition(value), 1.0);
}

// Over the whole range, from 0 to 1.
float shareOfRange(Point point, int component)
{
  return point.value / in_LastEntry;
}

float opacityAt(Point point, int component)
{
  return surfaceOf(point.value).a;
}
