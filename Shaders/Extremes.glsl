// The largest or the smallest value along a ray, and what the transfer function makes of it.

#ifdef FLATBLOCK_MINIMUM
const float Sign = -1.0;
#else
const float Sign = 1.0;
#endif

struct Gathered
{
  float extreme; // times the sign
};

const float Nothing = -1e30;

Gathered nothingGathered()
{
  return Gathered(Nothing);
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

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
