// The largest or the smallest value along a ray, and what the transfer function makes of it. Of several
// components those of each independent one, weighted; or of the point where opacity has its extreme.

#ifdef FLATBLOCK_MINIMUM
const float Sign = -1.0;
#else
const float Sign = 1.0;
#endif

struct Gathered
{
#ifdef FLATBLOCK_MANY_VALUES
  vec4 extreme; // times the sign
#else
  float extreme;
#endif
};

const float Nothing = -1e30;

Gathered nothingGathered()
{
#ifdef FLATBLOCK_MANY_VALUES
  return Gathered(vec4(Nothing));
#else
  return Gathered(Nothing);
#endif
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

#ifdef FLATBLOCK_MANY_VALUES
vec4 colorOf(Gathered gathered)
{
  if (gathered.extreme.x <= Nothing)
  {
    return vec4(0.0);
  }
  vec4 texels = Sign * gathered.extreme;
#ifdef FLATBLOCK_INDEPENDENT
  vec4 sum = vec4(0.0);
  for (int i = 0; i < FLATBLOCK_COMPONENTS; ++i)
  {
    sum += max(in_Weights[i], 0.0) * layerOf(matterOf(i, texels[i]), 1.0);
  }
  return sum;
#else
  return layerOf(matterOfDependent(texels), 1.0);
#endif
}

bool isAtEnd(Gathered gathered, Progress progress)
{
  return progress.isCutOff;
}

bool canChange(Gathered gathered, Brick brick)
{
  return true;
}

void take(inout Gathered gathered, Point point, vec3 position)
{
  if (!hasValue(point))
  {
    return;
  }
  vec4 values = Sign * point.value;
  if (values[LastComponent] > gathered.extreme[LastComponent])
  {
    see(position);
#ifndef FLATBLOCK_INDEPENDENT
    gathered.extreme = values;
#endif
  }
#ifdef FLATBLOCK_INDEPENDENT
  gathered.extreme = max(gathered.extreme, values);
#endif
}
#else
vec4 colorOf(Gathered gathered)
{
  return gathered.extreme > Nothing ? surfaceOf(Sign * gathered.extreme) : vec4(0.0);
}

// Nothing goes beyond the end of the table.
bool isAtEnd(Gathered gathered, Progress progress)
{
  return progress.isCutOff || gathered.extreme >= (Sign > 0.0 ? in_LastEntry : 0.0);
}

// A block with nothing beyond what was found is passed by.
bool canChange(Gathered gathered, Brick brick)
{
  float farthest = brick.range.x + (Sign > 0.0 ? brick.range.y : 0.0);
  return Sign * positionInTable(farthest) > gathered.extreme;
}

void take(inout Gathered gathered, Point point, vec3 position)
{
  if (hasValue(point) && Sign * point.value > gathered.extreme)
  {
    see(position);
  }
  gathered.extreme = hasValue(point) ? max(gathered.extreme, Sign * point.value) : gathered.extreme;
}
#endif

void gather(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
  while (mustBeFound(progress, stretch))
  {
    findFront(progress, ray, origin);
    take(gathered, progress.front, origin + progress.at * ray.direction);
  }
  while (goesOn(progress, stretch))
  {
    float target = min(progress.next, stretch.exit);
    vec3 position = origin + target * ray.direction;
    moveTo(progress, pointAt(brick, position), target, brick);
    take(gathered, progress.front, position);
    countSample(progress);
  }
}
