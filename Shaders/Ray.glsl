// The ray of a fragment: from where it enters the box, or the eye, to where it leaves the box, or
// meets opaque geometry.

uniform vec4 in_Eye;             // xyz, and 1 where there is one: in perspective
uniform mat3 in_PixelToOrigin;   // (x, y, 1), normalized device coordinates, to a point of the ray
uniform mat3 in_PixelToSight;    // and to its direction, in samples
uniform vec3 in_LastSample;      // far corner of the box
uniform mat3 in_SampleToSteps;   // directions in samples to lengths in steps of the ray
uniform float in_StepLength;     // in the smallest spacing
uniform vec4 in_NearPlane;       // nothing before it is drawn
uniform float in_DepthOfCenter;  // normalized device depth of the middle of the box
uniform vec4 in_SampleToDepth;   // rows of the matrix from samples to clip coordinates: z, less w at
uniform vec4 in_SampleToClipW;   // the depth of the middle, so that little cancels; and w
uniform sampler2D in_SceneDepth; // of the opaque geometry, over the viewport
uniform ivec2 in_ViewportOrigin;
uniform vec2 in_ViewportSize;
uniform vec2 in_PixelsPerRay;
#if defined(FLATBLOCK_RAY_START) || defined(FLATBLOCK_GRADIENT)
uniform mat3 in_SampleToWorld;
#endif
#ifdef FLATBLOCK_RAY_START
uniform float in_RayStart; // in world units from the eye, or in parallel projection the near plane
#endif

// A step below this many samples brings nothing new: texture units filter to 1/256 of a texel.
const float LeastAdvance = 1.0 / 256.0;

// Position after t steps: origin + t * direction. The origin is the eye, or where that is far away
// lies near the middle of the box, so that distances stay small and exact.
struct Ray
{
  vec3 origin;
  vec3 direction;
  vec3 inverse; // of the direction
  float begin;
  float end;
  float unit; // lengths of the step that was asked for in one step
};

// From the origin of a ray back to the eye.
float distanceToEye(Ray ray)
{
  return length(in_SampleToSteps * (ray.origin - in_Eye.xyz)) / ray.unit;
}

// Replaces components so small that dividing by them could overflow.
vec3 withoutZeros(vec3 v)
{
  float least = 1e-7 * max(abs(v.x), max(abs(v.y), abs(v.z)));
  return mix(v, vec3(least), lessThan(abs(v), vec3(least)));
}

vec2 pixelOfRay()
{
  return (gl_FragCoord.xy - vec2(in_ViewportOrigin)) * in_PixelsPerRay;
}

Ray rayThroughBox()
{
  vec3 screen = vec3(2.0 * pixelOfRay() / in_ViewportSize - 1.0, 1.0);
  vec3 sight = in_PixelToSight * screen;
  vec3 direction = sight / length(in_SampleToSteps * sight);
  float advance = max(abs(direction.x), max(abs(direction.y), abs(direction.z)));

  Ray ray;
  ray.unit = max(1.0, LeastAdvance / advance);
  ray.origin = in_PixelToOrigin * screen;
  ray.direction = withoutZeros(direction * ray.unit);
  ray.inverse = 1.0 / ray.direction;
  vec3 toNearCorner = -ray.origin / ray.direction;
  vec3 toFarCorner = (in_LastSample - ray.origin) / ray.direction;
  vec3 entries = min(toNearCorner, toFarCorner);
  vec3 exits = max(toNearCorner, toFarCorner);
  ray.begin = max(entries.x, max(entries.y, entries.z));
  ray.end = min(exits.x, min(exits.y, exits.z));
  if (in_Eye.w > 0.0)
  {
    ray.begin = max(ray.begin, -distanceToEye(ray));
  }
  return ray;
}

// Distance along the ray to where its normalized device depth is `depth`: a plane in samples.
float distanceToDepth(Ray ray, float depth)
{
  float fromCenter = depth - in_DepthOfCenter;
  float atOrigin = dot(in_SampleToDepth.xyz, ray.origin) + in_SampleToDepth.w -
    fromCenter * (dot(in_SampleToClipW.xyz, ray.origin) + in_SampleToClipW.w);
  float slope = dot(in_SampleToDepth.xyz - fromCenter * in_SampleToClipW.xyz, ray.direction);
  return -atOrigin / slope;
}

// Normalized device depth of a point.
float depthOf(vec3 position)
{
  return in_DepthOfCenter + (dot(in_SampleToDepth.xyz, position) + in_SampleToDepth.w) /
    (dot(in_SampleToClipW.xyz, position) + in_SampleToClipW.w);
}

void clipToScene(inout Ray ray)
{
  float toNearPlane = -(dot(in_NearPlane.xyz, ray.origin) + in_NearPlane.w) /
    dot(in_NearPlane.xyz, ray.direction);
  float start = toNearPlane;
#ifdef FLATBLOCK_RAY_START
  float toEye = in_Eye.w > 0.0 ? -distanceToEye(ray) : toNearPlane;
  start = max(start, toEye + in_RayStart / length(in_SampleToWorld * ray.direction));
#endif
  ray.begin = max(ray.begin, start);
  float depth = texelFetch(in_SceneDepth, ivec2(floor(pixelOfRay())), 0).r;
  if (depth < 1.0)
  {
    ray.end = min(ray.end, distanceToDepth(ray, 2.0 * depth - 1.0));
  }
}
