// Pre-integrated classification: between two points values are taken as linear, and the matter that
// they run through is integrated (Roettger, Kraus and Ertl 2000), with all that it absorbs itself.
//
// Sums over the table from its beginning give the optical depth and the mean colour between any two
// positions, for any length. What they don't give is the order of the colours: so a piece tells how
// much that could matter, and is split where it is too much. Only matter of notable optical depth
// asks for it, and such a ray ends soon.

// Texels of an entry beside itself: extinction and colour times extinction, summed up to it, as a sum
// of two floats; and how colour and extinction vary.
const int Sum = 1;
const int RestOfSum = 2;
const int Variation = 3;

const float Tolerance = 1.2e-4; // of a piece, as a share of its opacity
const float Tiny = 1e-30;       // so that nothing is divided by 0

struct Point
{
  float position;
  float interval; // of the table, by its first entry
  vec4 matter;
  vec4 before; // integrals over the parts of the interval before the position, and behind it
  vec4 behind;
  vec4 sum;
#ifdef FLATBLOCK_LONG_SUMS
  vec4 rest;
#endif
  vec4 variation; // slopes of colour, of extinction, colour: changes up to here, the last one also
                  // without that of the interval
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point noPoint()
{
  Point point;
  point.position = 0.0;
  point.interval = 0.0;
  point.matter = vec4(0.0);
  point.before = vec4(0.0);
  point.behind = vec4(0.0);
  point.sum = vec4(0.0);
#ifdef FLATBLOCK_LONG_SUMS
  point.rest = vec4(0.0);
#endif
  point.variation = vec4(0.0);
#ifdef FLATBLOCK_HOLES
  point.isHole = true;
#endif
  return point;
}

// Colour times extinction, and extinction, integrated over matter that varies linearly.
vec4 linearIntegral(vec4 begin, vec4 end, float length)
{
  vec3 color = begin.rgb * (2.0 * begin.a + end.a) + end.rgb * (begin.a + 2.0 * end.a);
  return length * vec4(color / 6.0, 0.5 * (begin.a + end.a));
}

Point pointAtPosition(float position)
{
  float interval = intervalOf(position);
  int texel = int(interval) * in_TexelsPerEntry;
  countFetches(4);
  vec4 low = texelFetch(in_TransferTable, texel);
  vec4 high = texelFetch(in_TransferTable, texel + in_TexelsPerEntry);
  float share = position - interval;
  Point point;
  point.position = position;
  point.interval = interval;
  point.matter = mix(low, high, share);
  point.before = linearIntegral(low, point.matter, share);
  point.behind = linearIntegral(point.matter, high, 1.0 - share);
  point.sum = texelFetch(in_TransferTable, texel + Sum);
#ifdef FLATBLOCK_LONG_SUMS
  point.rest = texelFetch(in_TransferTable, texel + RestOfSum);
#endif
  point.variation = texelFetch(in_TransferTable, texel + Variation);
#ifdef FLATBLOCK_HOLES
  point.isHole = false;
#endif
  return point;
}

Point pointAt(Brick brick, vec3 position)
{
  float texel = texelOf(brick, position);
  Point point = pointAtPosition(positionInTable(texel));
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texel);
#endif
  return point;
}

float largest(vec3 v)
{
  return max(v.r, max(v.g, v.b));
}

// integral from 0 to depth of (1/2 - u / depth) exp(-u) du: by how much more the colour in front
// counts than the one at the back, where it varies linearly with the optical depth u.
float skewOfDepth(float depth, float opacity)
{
  return depth < 0.3
    ? depth * depth * (1.0 / 12.0 - depth * (1.0 / 24.0 - depth * (1.0 / 80.0 - depth / 360.0)))
    : 1.0 - 0.5 * opacity - opacity / depth;
}

// Integral over the table between two positions in different intervals, low before high.
vec4 integralBetween(Point low, Point high)
{
  vec4 integral = low.behind + high.before;
  if (high.interval > low.interval + 1.0)
  {
#ifdef FLATBLOCK_LONG_SUMS
    // From the next entry: what is small beside the interval keeps its digits.
    int texel = (int(low.interval) + 1) * in_TexelsPerEntry;
    integral += (high.sum - texelFetch(in_TransferTable, texel + Sum)) +
      (high.rest - texelFetch(in_TransferTable, texel + RestOfSum));
#else
    integral += high.sum - low.sum - (low.before + low.behind);
#endif
  }
  return integral;
}

// How far the colour may be from one that varies linearly with optical depth where extinction does.
float unevennessBetween(Point low, Point high, float changed, float extinction)
{
  float total =
    (high.position > high.interval ? high.variation.z : high.variation.w) - low.variation.w;
  vec4 bend = high.variation - low.variation;
  return min(
    total, 0.25 * (high.position - low.position) * (bend.x + changed * bend.y / extinction));
}

Piece pieceBetween(Point front, Point back, float length)
{
  bool isWithin = front.interval == back.interval;
  bool isRising = front.position < back.position;
  float lengthPerEntry = length / max(abs(back.position - front.position), Tiny);
  vec4 integral = linearIntegral(front.matter, back.matter, length);
  if (!isWithin)
  {
    integral = lengthPerEntry *
      (isRising ? integralBetween(front, back) : integralBetween(back, front));
  }
  float depth = max(integral.a, Tiny);
  float opacity = opacityOfDepth(max(integral.a, 0.0)); // 0 where nothing is seen
  vec3 change = front.matter.rgb - back.matter.rgb;
  float changed = largest(abs(change));
  float slope = (back.matter.a - front.matter.a) / max(front.matter.a + back.matter.a, Tiny);
  Piece piece;
  piece.color.rgb = integral.rgb * (opacity / depth) +
    change * (skewOfDepth(depth, opacity) * (1.0 - 0.2 * slope * slope));
  piece.color.a = opacity;
  piece.error = min(depth * depth / 360.0, 0.34) * changed * abs(slope);
  if (!isWithin)
  {
    float extinction = max(depth / max(length, Tiny), Tiny);
    piece.error += min(0.25 * depth, 1.0) *
      (isRising ? unevennessBetween(front, back, changed, extinction)
                : unevennessBetween(back, front, changed, extinction));
  }
  piece.error /= Tolerance;
  return piece;
}
