// A point of several components that is not classified: their texels.

struct Point
{
  vec4 value;
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point noPoint()
{
  Point point;
  point.value = vec4(0.0);
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
  Point point;
  point.value = texelOf(brick, position);
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(point.value);
#endif
  return point;
}

const int LastComponent = FLATBLOCK_COMPONENTS - 1;

// Over the whole range, from 0 to 1.
float shareOfRange(Point point, int component)
{
  vec2 toTable = in_TexelsToTables[component];
  float position = point.value[component] * toTable.x + toTable.y;
  return clamp(position / in_LastEntries[component], 0.0, 1.0);
}

// That of the function, whatever the length.
float opacityAt(Point point, int component)
{
  return opacityOfDepth(matterOf(component, point.value[component]).a);
}
