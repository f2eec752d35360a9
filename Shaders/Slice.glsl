// What a plane shows of the volume.

uniform vec4 in_Slice; // in samples; 0 on the plane

bool isOnSlice(Ray ray, float at)
{
  const float Rounding = 1e-3; // planes that touch the volume's faces show them
#ifdef FLATBLOCK_CROPPING
  bool isUncropped = isShown(cropRay(ray), at);
#else
  const bool isUncropped = true;
#endif
  return at >= ray.begin - Rounding && at <= ray.end + Rounding && isUncropped;
}

vec4 colorAlong(Ray ray, inout Progress progress)
{
  float atOrigin = dot(in_Slice.xyz, ray.origin) + in_Slice.w;
  float at = -atOrigin / dot(in_Slice.xyz, ray.direction);
  if (!isOnSlice(ray, at))
  {
    return vec4(0.0);
  }
  vec3 position = clamp(ray.origin + at * ray.direction, vec3(0.0), in_LastSample);
  ivec3 block = ivec3(floor(position / float(in_CellsPerBlock)));
  Brick brick = fetchBrick(
    clamp(block, ivec3(0), ivec3(in_Blocks[0], in_Blocks[1], in_Blocks[2]) - 1));
  see(position);
  countSample(progress);
  Point point = pointAt(brick, position);
  return brick.resident && hasValue(point) ? surfaceOf(point.value) : vec4(0.0);
}
