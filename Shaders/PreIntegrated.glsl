// Pre-integrated classification: between two points values are taken as linear, and the matter that
// they run through is integrated (Roettger, Kraus and Ertl 2000), with all that it absorbs itself.
//
// Sums over the table from its beginning give the optical depth and the mean colour between any two
// positions, for any length. What they don't give is the order of the colours: a piece of a segment is
// split until that makes no difference. Only matter of notable optical depth asks for it, and such a
// ray ends soon.

// Texels of an entry beside itself: extinction and colour times extinction, summed up to it, as a sum
// of two floats; then sums of how the slopes of colour and extinction change, and of how the colour
// changes, and the first interval from there on that is not transparent.
const int Sum = 1;
const int RestOfSum = 2;
const int Variation = 3;

const float Tolerance = 9e-5; // of a piece, as a share of its opacity

struct Point
{
  float position;
  float interval;
  vec4 low; // entries at the interval's ends
  vec4 high;
  vec4 matter;
#ifdef FLATBLOCK_HOLES
  bool isHole;
#endif
};

Point pointAtPosition(float position)
{
  Point point;
  point.position = position;
  point.interval = intervalOf(position);
  point.low = entryOfTable(int(point.interval));
  point.high = entryOfTable(int(point.interval) + 1);
  point.matter = mix(point.low, point.high, position - point.interval);
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

// Colour times extinction, and extinction, integrated over matter that varies linearly.
vec4 linearIntegral(vec4 begin, vec4 end, float length)
{
  vec3 color = begin.rgb * (2.0 * begin.a + end.a) + end.rgb * (begin.a + 2.0 * end.a);
  return length * vec4(color / 6.0, 0.5 * (begin.a + end.a));
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
    : 0.5 * opacity + (1.0 - opacity) - opacity / depth;
}

struct Piece
{
  vec4 color;  // multiplied by opacity, and opacity
  float error; // as a share of the opacity, at most, in multiples of the tolerance
};

vec4 tableTexel(float entry, int texel)
{
  return texelFetch(in_TransferTable, int(entry) * in_TexelsPerEntry + texel);
}

// Integral between two positions in different intervals, counted in entries. Everything is added: what
// is small beside other parts of the table keeps its digits.
vec4 integralBetween(Point lower, Point upper)
{
  vec4 sum = linearIntegral(lower.matter, lower.high, lower.interval + 1.0 - lower.position) +
    linearIntegral(upper.low, upper.matter, upper.position - upper.interval);
  float first = lower.interval + 1.0;
  if (upper.interval > first)
  {
    sum += (tableTexel(upper.interval, Sum) - tableTexel(first, Sum)) +
      (tableTexel(upper.interval, RestOfSum) - tableTexel(first, RestOfSum));
  }
  return sum;
}

// How far the colour may be from one that varies linearly with optical depth where extinction does.
float unevennessBetween(Point lower, Point upper, float last, float changed, float extinction)
{
  vec3 variation =
    tableTexel(last, Variation).xyz - tableTexel(lower.interval, Variation).xyz;
  float total = variation.z + largest(abs(lower.high.rgb - lower.low.rgb));
  float bend = variation.x + changed * variation.y / extinction;
  return min(total, 0.25 * (upper.position - lower.position) * bend);
}

Piece pieceBetween(Point front, Point back, float length, float lengthPerEntry)
{
  bool isRising = front.position <= back.position;
  Point lower = front;
  Point upper = back;
  if (!isRising)
  {
    lower = back;
    upper = front;
  }
  // Of the upper point's interval there is nothing where it lies at its beginning.
  float last = upper.position > upper.interval ? upper.interval : upper.interval - 1.0;
  bool isWithin = last <= lower.interval;
  vec4 integral = isWithin ? linearIntegral(front.matter, back.matter, length)
                           : lengthPerEntry * integralBetween(lower, upper);
  float depth = integral.a;
  if (depth <= 0.0)
  {
    return Piece(vec4(0.0), 0.0);
  }
  vec3 change = front.matter.rgb - back.matter.rgb;
  float changed = largest(abs(change));
  float slope = (back.matter.a - front.matter.a) / max(front.matter.a + back.matter.a, 1e-30);
  float opacity = opacityOfDepth(depth);
  float skew = skewOfDepth(depth, opacity) * (1.0 - 0.2 * slope * slope);
  Piece piece;
  piece.color = vec4(integral.rgb * (opacity / depth) + change * skew, opacity);
  piece.error = min(depth * depth / 360.0, 0.34) * changed * abs(slope) / Tolerance;
  if (!isWithin && 0.25 * depth > Tolerance)
  {
    piece.error += min(0.25 * depth, 1.0) / Tolerance *
      unevennessBetween(lower, upper, last, changed,
        depth / max(length, 1e-30) );
  }
  return piece;
}

// Where a piece that is not even enough ends instead: within an interval, or at the end of one.
float shortened(Point front, float end, float error)
{
  float share = clamp(0.9 * inversesqrt(error), 0.05, 0.5);
  float position = mix(front.position, end, share);
  bool isRising = front.position < end;
  float border = front.interval + (isRising ? 1.0 : 0.0);
  bool isWithin = isRising ? position <= border : position >= border;
  bool borderIsAhead = isRising ? border > front.position && border < end
                                : border < front.position && border > end;
  return isWithin && borderIsAhead ? border : position;
}

vec4 segmentBetween(Point front, Point back, float length)
{
  const int MostPieces = 16384;
  const float Enough = 1.0 - 1e-5;
  float lengthPerEntry =
    front.position == back.position ? 0.0 : length / abs(back.position - front.position);
  vec4 sum = vec4(0.0);
  Point end = back;
  float pieceLength = length;
  for (int i = 0; i < MostPieces && sum.a < Enough; ++i)
  {
    Piece piece = pieceBetween(front, end, pieceLength, lengthPerEntry);
    float position = piece.error > 1.0 ? shortened(front, end.position, piece.error) : end.position;
    if (position != end.position && position != front.position)
    {
      end = pointAtPosition(position);
    }
    else
    {
      sum = composite(sum, piece.color);
      if (end.position == back.position)
      {
        break;
      }
      front = end;
      end = back;
    }
    pieceLength = lengthPerEntry * abs(end.position - front.position);
  }
  return sum;
}
