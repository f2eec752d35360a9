// The ray of a fragment: from where it enters the box, or the eye, to where it leaves the box, or
// meets opaque geometry.

uniform vec4 in_Eye;             // perspective: (-eye, 1); parallel: (direction of sight, 0)
uniform vec3 in_LastSample;      // far corner of the box
uniform mat3 in_SampleToSteps;   // directions in samples to lengths in steps of the ray
uniform vec4 in_SampleToClipZ;   // rows of the matrix from samples to clip coordinates
uniform vec4 in_SampleToClipW;
uniform sampler2D in_SceneDepth; // of the opaque geometry, over the viewport
uniform ivec2 in_ViewportOrigin;

in vec3 boxPosition;
in vec2 boxClip; // z and w of boxPosition in clip coordinates

// Position after t steps: origin + t * direction. The origin lies on the far side of the box, so
// that distances stay small and exact however far the eye is.
struct Ray
{
  vec3 origin;
  vec3 direction;
  float begin;
  float end;
};

// Replaces components so small that dividing by them could overflow.
vec3 withoutZeros(vec3 v)
{
  float least = 1e-7 * max(abs(v.x), max(abs(v.y), abs(v.z)));
  return mix(v, vec3(least), lessThan(abs(v), vec3(least)));
}

Ray rayThroughBox()
{
  vec3 sight = boxPosition * in_Eye.w + in_Eye.xyz;
  float sightLength = length(in_SampleToSteps * sight);

  Ray ray;
  ray.origin = boxPosition;
  ray.direction = withoutZeros(sight / sightLength);
  vec3 toNearCorner = -ray.origin / ray.direction;
  vec3 toFarCorner = (in_LastSample - ray.origin) / ray.direction;
  vec3 entries = min(toNearCorner, toFarCorner);
  vec3 exits = max(toNearCorner, toFarCorner);
  ray.begin = max(entries.x, max(entries.y, entries.z));
  ray.end = min(exits.x, min(exits.y, exits.z));
  if (in_Eye.w > 0.0)
  {
    ray.begin = max(ray.begin, -sightLength);
  }
  return ray;
}

// Distance along the ray to where its normalized device depth is `depth`: a plane in samples.
float distanceToDepth(Ray ray, float depth)
{
  float atOrigin = boxClip.x - depth * boxClip.y;
  float slope = dot(in_SampleToClipZ.xyz - depth * in_SampleToClipW.xyz, ray.direction);
  return -atOrigin / slope;
}

void clipToScene(inout Ray ray)
{
  ray.begin = max(ray.begin, distanceToDepth(ray, -1.0));
  float depth = texelFetch(in_SceneDepth, ivec2(gl_FragCoord.xy) - in_ViewportOrigin, 0).r;
  if (depth < 1.0)
  {
    ray.end = min(ray.end, distanceToDepth(ray, 2.0 * depth - 1.0));
  }
}
