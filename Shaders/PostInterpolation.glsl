// Post-interpolative classification: values are interpolated, then classified. What is found at a
// point stands for half of the pieces that meet there.

struct Point
{
  vec4 matter;
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position);
  Point point;
  point.matter = matterAtPosition(positionInTable(texel));
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}

Piece pieceBetween(Point front, Point back, float length)
{
  return Piece(
    composite(layerOf(front.matter, 0.5 * length), layerOf(back.matter, 0.5 * length)), 0.0);
}
