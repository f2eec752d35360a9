// Light that the volume itself scatters, and how much of it arrives through the volume: as
// vtkGPUVolumeRayCastMapper blends it with that of surfaces, by how little surface there is.

uniform mat3 in_WorldToSamples;        // directions
uniform float in_ScatteringReach;      // of absorption, where the box is 1 long along each axis
uniform float in_ScatteringBlending;   // 0: surfaces alone, 2: the volume alone
uniform float in_ScatteringAnisotropy; // -1: back to the light, 1: on
uniform vec3 in_ScatteredAmbient;
uniform vec3 in_GradientToSurface;     // scale an axis: to shares of the table over two samples

const float DarkDepth = 8.0;  // beyond it nothing arrives
const float LeastStep = 1e-3; // so that every step leads on

float opacityOfStep; // of the matter that light falls on

float extinctionAt(Brick brick, vec3 position)
{
  Texel texel = texelOf(brick, position);
#ifdef FLATBLOCK_HOLES
  if (isHole(texel))
  {
    return 0.0;
  }
#endif
  // Between entries of the table it hardly varies, for what is summed up.
  float extinction = entryOfTable(int(positionInTable(valueOf(texel)) + 0.5)).a;
#ifdef FLATBLOCK_GRADIENT_OPACITY
  extinction *= lookUpGradient(0.0, 0, gradientAt(brick, position)).r;
#endif
  return extinction;
}

// A way to a light, in steps of rays.
Ray rayToLight(vec3 position, vec3 direction, float farthest)
{
  Ray ray;
  ray.origin = position;
  ray.direction = in_WorldToSamples * direction;
  float stepsInWorld = length(in_SampleToSteps * ray.direction);
  ray.direction /= stepsInWorld;
  ray.unit = 1.0;
  ray.inverse = 1.0 / withoutZeros(ray.direction);
  vec3 exits = max(-position * ray.inverse, (in_LastSample - position) * ray.inverse);
  float reach = in_ScatteringReach / length(ray.direction / in_LastSample);
  ray.begin = 0.0;
  ray.end = min(min(exits.x, min(exits.y, exits.z)), min(farthest * stepsInWorld, reach));
#ifdef FLATBLOCK_CLIPPING_PLANES
  clipToPlanes(ray);
#endif
  return ray;
}

// The block of a position, and the distance to where a ray leaves it.
ivec3 blockAround(vec3 position, Ray ray, out float exit)
{
  ivec3 last = ivec3(in_Blocks[0], in_Blocks[1], in_Blocks[2]) - 1;
  ivec3 block = clamp(ivec3(floor(position / float(in_CellsPerBlock))), ivec3(0), last);
  vec3 low = vec3(block * in_CellsPerBlock);
  vec3 exits = max((low - ray.origin) * ray.inverse,
    (low + float(in_CellsPerBlock) - ray.origin) * ray.inverse);
  exit = min(exits.x, min(exits.y, exits.z));
  return block;
}

// Of the next step, as far as the exit.
float depthOfStep(Brick brick, Ray ray, float exit, inout float at)
{
  float length = clamp(exit - at, 0.0, brick.step);
  float depth = length * extinctionAt(brick, ray.origin + (at + 0.5 * length) * ray.direction);
  at += length;
  return depth;
}

// What of a light, a direction of length 1 in world coordinates, arrives at a position. Blocks
// without a brick are passed by at once.
float transmittance(vec3 position, vec3 direction, float farthest)
{
  Ray ray = rayToLight(position, direction, farthest);
#ifdef FLATBLOCK_CROPPING
  Cropping cropping = cropRay(ray);
#endif
  float depth = 0.0;
  float at = ray.begin;
  while (at < ray.end && depth * in_StepLength < DarkDepth)
  {
    float exit;
    Brick brick = fetchBrick(blockAround(ray.origin + at * ray.direction, ray, exit));
    exit = min(exit, ray.end);
    bool isFull = brick.resident;
#ifdef FLATBLOCK_CROPPING
    exit = nextPlane(cropping, at, exit);
    isFull = isFull && isShown(cropping, 0.5 * (at + exit));
#endif
    exit = max(exit, at + LeastStep);
    while (isFull && at < exit && depth * in_StepLength < DarkDepth)
    {
      // Two a turn: software renderers end a shader after some ten thousand turns of its loops.
      depth += depthOfStep(brick, ray, exit, at);
      depth += depthOfStep(brick, ray, exit, at);
    }
    at = max(at, exit);
  }
  return exp(-depth * in_StepLength);
}

// Henyey and Greenstein (1941), over that of light scattered the same to everywhere.
float phaseOf(float cosine)
{
  float g = in_ScatteringAnisotropy;
  float d = max(1.0 + g * g - 2.0 * g * cosine, 1e-6);
  return (1.0 - g * g) / (d * sqrt(d));
}

// The share of light that the volume scatters, and no surface: less at steep gradients of dense matter.
float scatteredShare(vec3 gradient)
{
  float b = in_ScatteringBlending;
  float evenness = exp(-b * length(gradient * in_GradientToSurface) * opacityOfStep);
  return b < 1.0 ? b * evenness : (2.0 - b) * evenness + b - 1.0;
}
