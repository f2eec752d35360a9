// Surfaces where the volume has one of some values.

uniform float in_EnoughOpacity;                      // a ray that has gathered this much ends
uniform float in_IsoValues[FLATBLOCK_ISOSURFACES]; // as positions in the table, rising

struct Gathered
{
  vec4 color; // multiplied by opacity, and opacity
};

Gathered nothingGathered()
{
  return Gathered(vec4(0.0));
}

void beginPart(inout Gathered gathered) {}

void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length) {}

vec4 colorOf(Gathered gathered)
{
  return gathered.color;
}

bool isAtEnd(Gathered gathered, Progress progress)
{
  return progress.isCutOff || gathered.color.a >= in_EnoughOpacity;
}

bool canChange(Gathered gathered, Brick brick)
{
  return true;
}

// Distance to the crossing of a value in a piece: bisected, and linear in what is left.
float findCrossing(Progress progress, Ray ray, vec3 origin, Brick brick, float isoValue, vec2 ends,
  vec2 values)
{
  const int Bisections = 6;
  for (int i = 0; i < Bisections; ++i)
  {
    float middle = 0.5 * (ends.x + ends.y);
    vec3 position = origin + middle * ray.direction;
    float value = pointAt(brickAt(progress, brick, position), position).value;
    bool isBehind = (value < isoValue) == (values.x < isoValue);
    ends = isBehind ? vec2(middle, ends.y) : vec2(ends.x, middle);
    values = isBehind ? vec2(value, values.y) : vec2(values.x, value);
  }
  return mix(ends.x, ends.y, clamp((isoValue - values.x) / (values.y - values.x), 0.0, 1.0));
}

vec4 surfaceAt(Brick brick, float isoValue, vec3 position)
{
  vec4 color = surfaceOf(isoValue);
#ifdef FLATBLOCK_CURVED
  Derivatives derivatives = derivativesAt(brick, position);
  Curvature curvature = curvatureOf(derivatives);
  vec3 gradient = derivatives.gradient;
#elif defined(FLATBLOCK_SHADING)
  vec3 gradient = gradientAt(brick, position);
#endif
#ifdef FLATBLOCK_CURVATURE
  vec4 ofCurvature = lookUpCurvature(curvature);
  color = vec4(ofCurvature.rgb, 1.0) * color.a;
#ifdef FLATBLOCK_CURVATURE_OPACITY
  color *= ofCurvature.a;
#endif
#endif
#ifdef FLATBLOCK_SHADING
  Light light = lightOn(gradient, position, 0);
  color.rgb = lit(color, light);
#endif
#ifdef FLATBLOCK_SILHOUETTES
  color.rgb = mix(color.rgb, in_SilhouetteColor * color.a, silhouetteAt(curvature));
#endif
  return color;
}

// All that are crossed between the front and a point, in the order in which the ray meets them.
void cross(inout Gathered gathered, Progress progress, Ray ray, vec3 origin, Brick brick,
  Point back, float target)
{
  vec2 ends = vec2(progress.at, target);
  vec2 values = vec2(progress.front.value, back.value);
  for (int i = 0; i < FLATBLOCK_ISOSURFACES; ++i)
  {
    float isoValue = in_IsoValues[values.x < values.y ? i : FLATBLOCK_ISOSURFACES - 1 - i];
    bool isCrossed = (values.x < isoValue) != (values.y < isoValue);
    while (isCrossed)
    {
      float at = findCrossing(progress, ray, origin, brick, isoValue, ends, values);
      vec3 position = origin + at * ray.direction;
      vec4 surface = surfaceAt(brickAt(progress, brick, position), isoValue, position);
      if (gathered.color.a <= 0.0)
      {
        see(position);
      }
      gathered.color = composite(gathered.color, surface);
      isCrossed = false;
    }
  }
}

void gather(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
  while (mustBeFound(progress, stretch))
  {
    findFront(progress, ray, origin);
  }
  while (goesOn(progress, stretch) && gathered.color.a < in_EnoughOpacity)
  {
    float target = min(progress.next, stretch.exit);
    Point back = pointAt(brick, origin + target * ray.direction);
    if (hasValue(progress.front) && hasValue(back))
    {
      cross(gathered, progress, ray, origin, brick, back, target);
    }
    moveTo(progress, back, target, brick);
    countSample(progress);
  }
  keepBrick(progress, brick, stretch);
}
