// Values along a ray, weighted by their opacity: their mean, or their integral.

#ifdef FLATBLOCK_AVERAGE
uniform vec2 in_AverageRange; // what lies beyond does not count
#else
uniform float in_OpacityUnits; // lengths that opacity is meant over, in a smallest spacing
#endif

struct Gathered
{
  float sum;
  float length; // that it was taken over
  vec2 front;   // what a length adds to both
};

Gathered nothingGathered()
{
  return Gathered(0.0, 0.0, vec2(0.0));
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

bool hasAny(Gathered gathered)
{
#ifdef FLATBLOCK_AVERAGE
  return gathered.length > 0.0;
#else
  return gathered.sum > 0.0;
#endif
}

vec4 colorOf(Gathered gathered)
{
#ifdef FLATBLOCK_SEEN
  if (!hasAny(gathered))
  {
    return vec4(0.0);
  }
#endif
#ifdef FLATBLOCK_AVERAGE
  float gray = gathered.sum / max(gathered.length, 1e-30);
  return gathered.length > 0.0 ? vec4(vec3(clamp(gray, 0.0, 1.0)), 1.0) : vec4(0.0);
#else
  return vec4(vec3(clamp(gathered.sum * in_OpacityUnits, 0.0, 1.0)), 1.0);
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

bool counts(Point point)
{
#ifdef FLATBLOCK_AVERAGE
  return hasValue(point) && point.value >= in_AverageRange.x && point.value <= in_AverageRange.y;
#else
  return hasValue(point);
#endif
}

vec2 shareOf(Point point)
{
  float share = surfaceOf(point.value).a * point.value / in_LastEntry;
  return counts(point) ? vec2(share, 1.0) : vec2(0.0);
}

void gather(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
  while (mustBeFound(progress, stretch))
  {
    findFront(progress, ray, origin);
    gathered.front = shareOf(progress.front);
  }
  // A point stands for half of the pieces that meet in it.
  while (goesOn(progress, stretch))
  {
    float target = min(progress.next, stretch.exit);
    float length = 0.5 * (target - progress.at) * ray.unit * in_StepLength;
    moveTo(progress, pointAt(brick, origin + target * ray.direction), target, brick);
    vec2 back = shareOf(progress.front);
    bool isFirst = !hasAny(gathered);
    gathered.sum += length * (gathered.front.x + back.x);
    gathered.length += length * (gathered.front.y + back.y);
    if (isFirst && hasAny(gathered))
    {
      see(origin + target * ray.direction);
    }
    gathered.front = back;
    countSample(progress);
  }
}
