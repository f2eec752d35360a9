// Values along a ray, weighted by their opacity: their mean, or their integral. Of several components
// these add up by their weights.

#ifdef FLATBLOCK_AVERAGE
uniform vec2 in_AverageRanges[TexelComponents]; // over all values; what lies beyond does not count
#else
uniform float in_OpacityUnits; // lengths that opacity is meant over, in a smallest spacing
#endif

struct Gathered
{
  Texel sum;
  Texel length;      // that it was taken over
  Texel frontShare;  // what a length adds to both
  Texel frontCounts;
};

Gathered nothingGathered()
{
  return Gathered(Texel(0.0), Texel(0.0), Texel(0.0), Texel(0.0));
}

#ifdef FLATBLOCK_INDEPENDENT
const int SummedComponents = FLATBLOCK_COMPONENTS;
#else
const int SummedComponents = 1;
#endif

float weighted(vec4 values)
{
#ifdef FLATBLOCK_INDEPENDENT
  float sum = 0.0;
  for (int i = 0; i < FLATBLOCK_COMPONENTS; ++i)
  {
    sum += in_Weights[i] * values[i];
  }
  return sum;
#else
  return values.x;
#endif
}

float weighted(float value)
{
  return value;
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

bool hasAny(Gathered gathered)
{
#ifdef FLATBLOCK_AVERAGE
  return weighted(gathered.length) > 0.0;
#else
  return weighted(gathered.sum) > 0.0;
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
  float gray = weighted(gathered.sum / max(gathered.length, Texel(1e-30)));
  return hasAny(gathered) ? vec4(vec3(clamp(gray, 0.0, 1.0)), 1.0) : vec4(0.0);
#else
  return vec4(vec3(clamp(weighted(gathered.sum) * in_OpacityUnits, 0.0, 1.0)), 1.0);
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

bool counts(float value, int component)
{
#ifdef FLATBLOCK_AVERAGE
  return value >= in_AverageRanges[component].x && value <= in_AverageRanges[component].y;
#else
  return true;
#endif
}

void weighPoint(Point point, out Texel share, out Texel counted)
{
  vec4 shares = vec4(0.0);
  vec4 numbers = vec4(0.0);
  for (int i = 0; i < SummedComponents; ++i)
  {
    float value = shareOfRange(point, i);
    if (hasValue(point) && counts(value, i))
    {
      shares[i] = opacityAt(point, i) * value;
      numbers[i] = 1.0;
    }
  }
  share = firstOf(shares);
  counted = firstOf(numbers);
}

void findFirst(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin)
{
  findFront(progress, ray, origin);
  weighPoint(progress.front, gathered.frontShare, gathered.frontCounts);
}

void gather(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
  while (mustBeFound(progress, stretch))
  {
    findFirst(gathered, progress, ray, origin);
  }
  // A point stands for half of the pieces that meet in it.
  while (goesOn(progress, stretch))
  {
    float target = min(progress.next, stretch.exit);
    float length = 0.5 * (target - progress.at) * ray.unit * in_StepLength;
    moveTo(progress, pointAt(brick, origin + target * ray.direction), target, brick);
    Texel share;
    Texel counted;
    weighPoint(progress.front, share, counted);
    bool isFirst = !hasAny(gathered);
    gathered.sum += length * (gathered.frontShare + share);
    gathered.length += length * (gathered.frontCounts + counted);
    if (isFirst && hasAny(gathered))
    {
      see(origin + target * ray.direction);
    }
    gathered.frontShare = share;
    gathered.frontCounts = counted;
    countSample(progress);
  }
}
