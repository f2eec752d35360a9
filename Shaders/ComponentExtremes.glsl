// The largest or the smallest values along a ray, and what the transfer functions make of them: of each
// independent component, weighted; or of the point where opacity has its extreme.

#ifdef FLATBLOCK_MINIMUM
const float Sign = -1.0;
#else
const float Sign = 1.0;
#endif

struct Gathered
{
  vec4 extremes; // times the sign
};

const float Nothing = -1e30;

Gathered nothingGathered()
{
  return Gathered(vec4(Nothing));
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

vec4 colorOf(Gathered gathered)
{
  if (gathered.extremes.x <= Nothing)
  {
    return vec4(0.0);
  }
  vec4 texels = Sign * gathered.extremes;
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
  if (values[LastComponent] > gathered.extremes[LastComponent])
  {
    see(position);
#ifndef FLATBLOCK_INDEPENDENT
    gathered.extremes = values;
#endif
  }
#ifdef FLATBLOCK_INDEPENDENT
  gathered.extremes = max(gathered.extremes, values);
#endif
}

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
