// A point that is classified by itself: what is found there stands for half of the pieces that meet in
// it.

struct Point
{
  vec4 matter;
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point noPoint()
{
  Point point;
  point.matter = vec4(0.0);
#ifdef FLATBLOCK_HOLES
  point.isHole = true;
#endif
  return point;
}

Piece pieceBetween(Point front, Point back, float length)
{
  return Piece(
    composite(layerOf(front.matter, 0.5 * length), layerOf(back.matter, 0.5 * length)), 0.0);
}
