// Pre-interpolative classification: the samples at the corners of a cell are classified, then their
// colours, weighted by extinction, and their extinctions are interpolated (Wittenbrink, Malzbender and
// Goss 1998).

Point pointAt(Brick brick, vec3 position)
{
  vec3 share;
  ivec3 first = ivec3(brick.origin) + cellOf(brick, position, share);
  Point point;
#ifdef FLATBLOCK_HOLES
  point.isHole = false;
#endif
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    vec3 weights = mix(1.0 - share, share, vec3(offset));
    float value = fetchTexel(brick, first + offset);
    vec4 matter = matterAtPosition(positionInTable(value));
#ifdef FLATBLOCK_HOLES
    point.isHole = point.isHole || isHole(value);
#endif
    sum += weights.x * weights.y * weights.z * vec4(matter.rgb * matter.a, matter.a);
  }
  point.matter = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a) : vec4(0.0);
  return point;
}
