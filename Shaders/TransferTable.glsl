// The transfer function: colour and extinction, at equal distances over the volume's values and
// linear in between. Positions in it are counted in entries; extinction is that of the length of the
// smallest spacing, and lengths are counted in it.

uniform samplerBuffer in_TransferTable; // some texels for each entry, the first one is the entry
uniform int in_TexelsPerEntry;
uniform float in_LastEntry;
uniform vec2 in_TexelToTable; // scale and offset: texel of the atlas to position

// Colour, not multiplied by anything, and extinction, of an entry.
vec4 entryOfTable(int entry)
{
  countFetches(1);
  return texelFetch(in_TransferTable, entry * in_TexelsPerEntry);
}

float positionInTable(float texel)
{
  return clamp(texel * in_TexelToTable.x + in_TexelToTable.y, 0.0, in_LastEntry);
}

// The interval of the table that a position lies in, by its first entry.
float intervalOf(float position)
{
  return min(floor(position), in_LastEntry - 1.0);
}

vec4 matterAtPosition(float position)
{
  float interval = intervalOf(position);
  return mix(entryOfTable(int(interval)), entryOfTable(int(interval) + 1), position - interval);
}

// 1 - exp(-depth), without cancellation.
float opacityOfDepth(float depth)
{
  return depth < 0.03 ? depth * (1.0 - depth * (0.5 - depth * (1.0 / 6.0 - depth / 24.0)))
                      : 1.0 - exp(-depth);
}

// Colour, multiplied by opacity, and opacity of matter that is the same over a length.
vec4 layerOf(vec4 matter, float length)
{
  float opacity = opacityOfDepth(matter.a * length);
  return vec4(matter.rgb * opacity, opacity);
}

vec4 composite(vec4 front, vec4 back)
{
  return front + (1.0 - front.a) * back;
}

// A piece of a ray between two points.
struct Piece
{
  vec4 color;  // multiplied by opacity, and opacity
  float error; // at most, as a share of the opacity, in multiples of what is tolerated
};

// The part of a piece that is tried next where its error is too large.
float smallerPart(float error)
{
  return clamp(0.9 * inversesqrt(error), 0.05, 0.5);
}

// Cells of which a corner is not finite are holes; their texels lie far beyond 1, and so does
// whatever is interpolated from them.
bool isHole(float texel)
{
  return abs(texel) > 2.0;
}

bool isHole(vec4 texels)
{
  return any(greaterThan(abs(texels), vec4(2.0)));
}
