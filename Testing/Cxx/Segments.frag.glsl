//VTK::System::Dec
//VTK::Output::Dec
#define FLATBLOCK_LONG_SUMS

// A segment a pixel: from the position of its column to that of its row.

struct Brick
{
  bool resident;
};

float texelOf(Brick brick, vec3 position)
{
  return 0.0;
}

//FlatBlock::TransferTable
//FlatBlock::Classification

uniform sampler2D in_Positions; // one row: of columns, the other: of rows
uniform float in_Length;

// Values are linear from the front to the back; pieces are split as along a ray.
vec4 segmentBetween(float front, float back)
{
  const float LeastPart = 1.0 / 65536.0;
  Point begin = pointAtPosition(front);
  float at = 0.0;
  float target = 1.0;
  vec4 sum = vec4(0.0);
  while (at < 1.0)
  {
    Point end = pointAtPosition(target < 1.0 ? mix(front, back, target) : back);
    Piece piece = pieceBetween(begin, end, (target - at) * in_Length);
    if (piece.error > 1.0 && target - at > LeastPart && end.position != begin.position)
    {
      target = at + smallerPart(piece.error) * (target - at);
    }
    else
    {
      sum = composite(sum, piece.color);
      begin = end;
      at = sum.a > 1.0 - 1e-5 ? 1.0 : target;
      target = 1.0;
    }
  }
  return sum;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = segmentBetween(texelFetch(in_Positions, ivec2(pixel.x, 0), 0).r,
    texelFetch(in_Positions, ivec2(pixel.y, 1), 0).r);
}
