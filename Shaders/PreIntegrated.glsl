// Pre-integrated classification: between two points values are taken as linear, and the matter that
// they run through is integrated (Roettger, Kraus and Ertl 2000), with all that it absorbs itself.
//
// Sums over the table from its beginning give the optical depth and the mean colour between any two
// positions, for any length. What they don't give is the order of the colours: a piece of a segment is
// split until that makes no difference. Only matter of notable optical depth asks for it, and such a
// ray ends soon.

// Rows of the table beside the entries: extinction and colour times extinction, summed up to an
// entry, as a sum of two floats; and how much colour, its slope, and extinction vary up to there.
const int SumRow = 1;
const int RestRow = 2;
const int VariationRow = 3;

const float Tolerance = 2e-4; // of a piece, as a share of its opacity

struct Point
{
  float position;
  float interval;
  vec4 low; // entries at the interval's ends
  vec4 high;
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

vec4 matterOf(Point point)
{
  return mix(point.low, point.high, point.position - point.interval);
}

// Colour times extinction, and extinction, integrated over matter that varies linearly.
vec4 linearIntegral(vec4 begin, vec4 end, float length)
{
  vec3 color = begin.rgb * (2.0 * begin.a + end.a) + end.rgb * (begin.a + 2.0 * end.a);
  return length * vec4(color / 6.0, 0.5 * (begin.a + end.a));
}

// The same between two positions in different intervals, lower.position < upper.position, counted in
// entries. Everything is added: what is small beside other parts of the table keeps its digits.
vec4 integralBetween(Point lower, Point upper)
{
  vec4 sum = linearIntegral(matterOf(lower), lower.high, lower.interval + 1.0 - lower.position) +
    linearIntegral(upper.low, matterOf(upper), upper.position - upper.interval);
  int first = int(lower.interval) + 1;
  int last = int(upper.interval);
  if (last > first)
  {
    sum += (texelFetch(in_TransferTable, ivec2(last, SumRow), 0) -
             texelFetch(in_TransferTable, ivec2(first, SumRow), 0)) +
      (texelFetch(in_TransferTable, ivec2(last, RestRow), 0) -
        texelFetch(in_TransferTable, ivec2(first, RestRow), 0));
  }
  return sum;
}

float largest(vec3 v)
{
  return max(v.r, max(v.g, v.b));
}

// How far the colour may be from one that varies linearly with optical depth.
float unevennessWithin(vec4 begin, vec4 end)
{
  return 0.25 * largest(abs(begin.rgb - end.rgb)) * abs(begin.a - end.a) / (begin.a + end.a);
}

float unevennessBetween(Point lower, Point upper, float last, vec3 colorChange, float depth)
{
  vec3 variation = texelFetch(in_TransferTable, ivec2(last, VariationRow), 0).xyz -
    texelFetch(in_TransferTable, ivec2(lower.interval, VariationRow), 0).xyz;
  variation.x += largest(abs(lower.high.rgb - lower.low.rgb));
  variation.z += abs(lower.high.a - lower.low.a);
  float quarter = 0.25 * (upper.position - lower.position);
  float warp = min(quarter * variation.z / depth, 1.0) * largest(abs(colorChange));
  return min(variation.x, quarter * variation.y + warp);
}

// integral from 0 to depth of (1/2 - u / depth) exp(-u) du: by how much more the colour in front
// counts than the one at the back.
float skewOfDepth(float depth, float opacity)
{
  return depth < 0.3
    ? depth * depth * (1.0 / 12.0 - depth * (1.0 / 24.0 - depth * (1.0 / 80.0 - depth / 360.0)))
    : 0.5 * opacity + exp(-depth) - opacity / depth;
}

struct Piece
{
  vec4 color;  // multiplied by opacity, and opacity
  float error; // as a share of the opacity, at most, in multiples of the tolerance
};

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
  vec4 begin = matterOf(front);
  vec4 end = matterOf(back);
  vec4 integral = isWithin ? linearIntegral(begin, end, length)
                           : lengthPerEntry * integralBetween(lower, upper);
  float depth = integral.a;
  if (depth <= 0.0)
  {
    return Piece(vec4(0.0), 0.0);
  }
  vec3 change = begin.rgb - end.rgb;
  float opacity = opacityOfDepth(depth);
  Piece piece;
  piece.color = vec4(
    integral.rgb * (opacity / depth) + change * skewOfDepth(depth, opacity), opacity);
  piece.error = min(0.25 * depth, 1.0) / Tolerance;
  if (piece.error > 1.0)
  {
    piece.error *= isWithin
      ? unevennessWithin(begin, end)
      : unevennessBetween(lower, upper, last, change, depth / lengthPerEntry);
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
