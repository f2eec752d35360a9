// What of a ray is cut off by clipping planes, and by vtkVolumeMapper's cropping regions.

#ifdef FLATBLOCK_CLIPPING_PLANES
uniform vec4 in_ClippingPlanes[FLATBLOCK_CLIPPING_PLANES]; // in samples; what is below 0 is cut off

void clipToPlanes(inout Ray ray)
{
  for (int i = 0; i < FLATBLOCK_CLIPPING_PLANES; ++i)
  {
    float atOrigin = dot(in_ClippingPlanes[i].xyz, ray.origin) + in_ClippingPlanes[i].w;
    float slope = dot(in_ClippingPlanes[i].xyz, ray.direction);
    float crossing = -atOrigin / slope;
    ray.begin = slope > 0.0 ? max(ray.begin, crossing) : ray.begin;
    ray.end = slope < 0.0 ? min(ray.end, crossing) : ray.end;
    ray.end = slope == 0.0 && atOrigin < 0.0 ? ray.begin : ray.end;
  }
}
#endif

#ifdef FLATBLOCK_CROPPING
uniform vec3 in_CroppingNormals[3]; // of the planes of an axis, in samples,
uniform vec3 in_CroppingLow;        // and what is added to be above 0 on the far side of the lower
uniform vec3 in_CroppingHigh;       // plane of each axis, and of the higher
uniform int in_CroppingFlags;       // a bit a region

// A ray through the regions.
struct Cropping
{
  vec3 atOrigin; // along the normals
  vec3 slope;
  vec3 toLow;    // distances to the planes
  vec3 toHigh;
};

Cropping cropRay(Ray ray)
{
  mat3 normals = mat3(in_CroppingNormals[0], in_CroppingNormals[1], in_CroppingNormals[2]);
  Cropping cropping;
  cropping.atOrigin = ray.origin * normals;
  cropping.slope = withoutZeros(ray.direction * normals);
  cropping.toLow = -(cropping.atOrigin + in_CroppingLow) / cropping.slope;
  cropping.toHigh = -(cropping.atOrigin + in_CroppingHigh) / cropping.slope;
  return cropping;
}

// Distance to the next plane after this one, at most to the end.
float nextPlane(Cropping cropping, float at, float end)
{
  vec3 low = mix(cropping.toLow, vec3(end), lessThanEqual(cropping.toLow, vec3(at)));
  vec3 high = mix(cropping.toHigh, vec3(end), lessThanEqual(cropping.toHigh, vec3(at)));
  vec3 nearest = min(low, high);
  return min(end, min(nearest.x, min(nearest.y, nearest.z)));
}

bool isShown(Cropping cropping, float distance)
{
  vec3 position = cropping.atOrigin + distance * cropping.slope;
  ivec3 region = ivec3(greaterThan(position + in_CroppingLow, vec3(0.0))) +
    ivec3(greaterThan(position + in_CroppingHigh, vec3(0.0)));
  return (in_CroppingFlags >> (region.x + 3 * region.y + 9 * region.z) & 1) == 1;
}

// The next part of a ray that is shown, from here on; empty where there is none.
void findShown(Cropping cropping, inout Ray part, float end)
{
  float next = nextPlane(cropping, part.begin, end);
  while (part.begin < end && !isShown(cropping, 0.5 * (part.begin + next)))
  {
    part.begin = next;
    next = nextPlane(cropping, next, end);
  }
  part.end = part.begin;
  while (part.end < end && isShown(cropping, 0.5 * (part.end + next)))
  {
    part.end = next;
    next = nextPlane(cropping, next, end);
  }
}
#endif
