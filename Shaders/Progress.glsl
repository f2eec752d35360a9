// How far a ray has come, whatever it gathers on its way.

#ifdef FLATBLOCK_SAMPLE_LIMIT
uniform int in_MaximumNumberOfSamples;
#endif

// Where the ray first met something, for selections and images of depths.
#ifdef FLATBLOCK_SEEN
const float Seen = 3.0 / 255.0; // opacity
vec3 seenAt;
#endif

void see(vec3 position)
{
#ifdef FLATBLOCK_SEEN
  seenAt = position;
#endif
}

struct Progress
{
  Point front; // where the ray has been gathered up to
  float at;    // its distance
  float next;  // distance of the next point of the lattice
  bool isLost; // what is at the front, in the brick, is not known: the ray leapt
  Brick brick; // that the front lies in
#ifdef FLATBLOCK_COUNTING
  int samples;
#endif
  bool isCutOff; // there were too many
};

Progress noProgress()
{
  Progress progress;
#ifdef FLATBLOCK_COUNTING
  progress.samples = 0;
#endif
  progress.isCutOff = false;
  return progress;
}

void countSample(inout Progress progress)
{
#ifdef FLATBLOCK_COUNTING
  ++progress.samples;
#endif
#ifdef FLATBLOCK_SAMPLE_LIMIT
  progress.isCutOff = progress.samples > in_MaximumNumberOfSamples;
#endif
}

// A part of a ray within one brick.
struct Stretch
{
  float entry;
  float exit;
  bool isVaried; // else only the piece that began before it is gathered,
  bool isMatter; // and that only where something is seen
  bool isToEnd;  // up to the exit, else to the last point before
};

bool hasPoint(Progress progress, Stretch stretch)
{
  return progress.next < stretch.exit || (stretch.isToEnd && progress.at < stretch.exit);
}

bool mustBeFound(Progress progress, Stretch stretch)
{
  return progress.isLost && (stretch.isVaried || stretch.isMatter);
}

bool goesOn(Progress progress, Stretch stretch)
{
  return !progress.isCutOff && !progress.isLost && hasPoint(progress, stretch) &&
    (stretch.isVaried || progress.at < stretch.entry);
}

void findFront(inout Progress progress, Ray ray, vec3 origin)
{
  progress.front = pointAt(progress.brick, origin + progress.at * ray.direction);
  progress.isLost = false;
  countSample(progress);
}

void moveTo(inout Progress progress, Point point, float at, Brick brick)
{
  progress.front = point;
  progress.at = at;
  float following = (floor(progress.next / brick.step) + 1.0) * brick.step;
  progress.next = at >= progress.next ? following : progress.next;
}

// The piece from the front to the next point begins in the brick before, and ends in this one. What is
// within it is of the one that it lies in.
Brick brickAt(Progress progress, Brick brick, vec3 position)
{
  vec3 from = position - brick.first;
  float end = float(in_CellsPerBlock);
  if (any(lessThan(from, vec3(0.0))) || any(greaterThan(from, vec3(end))))
  {
    return progress.brick;
  }
  return brick;
}

// At the end of a stretch.
void keepBrick(inout Progress progress, Brick brick, Stretch stretch)
{
  if (progress.at >= stretch.entry)
  {
    progress.brick = brick;
  }
}

// To the last point of what looks all the same.
bool canLeap(Progress progress, Brick brick, Stretch stretch, out float last)
{
  last = max(progress.next, (ceil(stretch.exit / brick.step) - 1.0) * brick.step);
  last = stretch.isToEnd ? stretch.exit : last;
  return !stretch.isVaried && hasPoint(progress, stretch) && last > progress.at;
}

void leapTo(inout Progress progress, float at, Brick brick)
{
  progress.at = at;
  progress.next = at + brick.step; // the lattice has one, or the ray ends here
  progress.isLost = true;
  progress.brick = brick;
}
