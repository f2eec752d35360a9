//VTK::System::Dec
//VTK::Output::Dec

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

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Point front = pointAtPosition(texelFetch(in_Positions, ivec2(pixel.x, 0), 0).r);
  Point back = pointAtPosition(texelFetch(in_Positions, ivec2(pixel.y, 1), 0).r);
  gl_FragData[0] = segmentBetween(front, back, in_Length);
}
