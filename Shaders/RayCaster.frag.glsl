//VTK::System::Dec
//VTK::Output::Dec
//FlatBlock::Defines

// One ray through the flat blocks: that of the fragment, if it meets their box at all. Positions are
// in sample coordinates; distances along the ray are counted in steps, which are equally long in the
// data set's own unit of length, whatever the spacing and the direction.

//FlatBlock::Ray
//FlatBlock::Blocks
//FlatBlock::TransferTable
//FlatBlock::Classification

uniform float in_EnoughOpacity; // a ray that has gathered this much ends
uniform float in_StepLength;    // in the smallest spacing
#ifdef FLATBLOCK_SAMPLE_LIMIT
uniform int in_MaximumNumberOfSamples;
#endif

struct Gathered
{
  vec4 color;  // multiplied by opacity, and opacity
  Point front; // where the ray has been gathered up to
  float at;    // its distance
  float next;  // distance of the next point of the lattice
#ifdef FLATBLOCK_SAMPLE_LIMIT
  int samples;
  bool isCutOff;
#endif
};

// Where the first point of a ray lies between two of the lattice, from 0 to 1.
float phaseOfRay()
{
#ifdef FLATBLOCK_JITTERING
  // Interleaved gradient noise (Jimenez 2014).
  return fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
#else
  return 0.0;
#endif
}

bool isAtEnd(Gathered gathered)
{
#ifdef FLATBLOCK_SAMPLE_LIMIT
  if (gathered.isCutOff)
  {
    return true;
  }
#endif
  return gathered.color.a >= in_EnoughOpacity;
}

// Where one end of a piece lies in a hole, the other one's half is drawn.
Piece pieceWithoutHoles(Point front, Point back, float length)
{
#ifdef FLATBLOCK_HOLES
  if (front.isHole && back.isHole)
  {
    return Piece(vec4(0.0), 0.0);
  }
  if (front.isHole)
  {
    return pieceBetween(back, back, 0.5 * length);
  }
  if (back.isHole)
  {
    return pieceBetween(front, front, 0.5 * length);
  }
#endif
  return pieceBetween(front, back, length);
}

// Gathers what lies in a brick, up to where the ray leaves it: up to the last point before, or also
// the border where the ray comes to its end there. A piece whose error is too large is split.
void gather(inout Gathered gathered, Ray ray, vec3 origin, Brick brick, float exit, bool endsThere)
{
  const float LeastPart = 1.0 / 1024.0;
  float target = exit;
  while (!isAtEnd(gathered) && (gathered.next < exit || (endsThere && gathered.at < exit)))
  {
#ifdef FLATBLOCK_SAMPLE_LIMIT
    gathered.isCutOff = ++gathered.samples > in_MaximumNumberOfSamples;
    if (gathered.isCutOff)
    {
      break;
    }
#endif
    target = min(target, min(gathered.next, exit));
    Point back = pointAt(brick, origin + target * ray.direction);
    float advance = target - gathered.at;
    Piece piece =
      pieceWithoutHoles(gathered.front, back, max(advance, 0.0) * ray.unit * in_StepLength);
    // Far along a ray a part may be too small to be told from nothing: then the piece is taken as it is.
    float nearer = gathered.at + smallerPart(piece.error) * advance;
    bool isDivisible = advance > LeastPart && nearer > gathered.at && nearer < target;
    if (piece.error > 1.0 && isDivisible)
    {
      target = nearer;
    }
    else
    {
      gathered.color = composite(gathered.color, piece.color);
      gathered.front = back;
      gathered.at = target;
      gathered.next += target >= gathered.next ? brick.step : 0.0;
      target = exit;
    }
  }
}

// Points lie on a lattice of steps that begins where the ray begins, whatever blocks they fall into;
// a coarser block has every second one, and so on. So neither block borders nor levels leave a
// trace. Only where a transparent block begins or ends is there a point at its border.
Gathered march(Ray ray)
{
  float phase = phaseOfRay();
  vec3 origin = ray.origin + (ray.begin - phase) * ray.direction;
  float end = ray.end - ray.begin + phase;
  BlockWalk walk = enterBlocks(ray);
  Brick brick = fetchBrick(walk.block);
  bool wasResident = false;

  Gathered gathered;
  gathered.color = vec4(0.0);
  gathered.at = phase;
#ifdef FLATBLOCK_SAMPLE_LIMIT
  gathered.samples = 1;
  gathered.isCutOff = false;
#endif
  float entry = phase;
  float lastStep = brick.step;
  while (!isAtEnd(gathered))
  {
    if (brick.resident)
    {
      if (!wasResident)
      {
        gathered.front = pointAt(brick, origin + entry * ray.direction);
        gathered.at = entry;
        lastStep = brick.step;
      }
      float step = min(brick.step, lastStep);
      gathered.next = ceil(entry / step) * step;
      gathered.next += gathered.next > gathered.at ? 0.0 : step;
    }
    float exit = min(distanceToBorder(walk) - ray.begin + phase, end);
    Brick beyond = brick;
    beyond.resident = false;
    bool goesOn = exit < end && crossBorder(walk);
    if (goesOn)
    {
      beyond = fetchBrick(walk.block);
    }
    if (brick.resident)
    {
      gather(gathered, ray, origin, brick, exit, !beyond.resident);
    }
    if (!goesOn)
    {
      break;
    }
    wasResident = brick.resident;
    lastStep = brick.step;
    brick = beyond;
    entry = exit;
  }
  return gathered;
}

void main()
{
  Ray ray = rayThroughBox();
  clipToScene(ray);
  if (ray.begin >= ray.end)
  {
    discard;
  }
  Gathered gathered = march(ray);
#ifdef FLATBLOCK_SAMPLE_LIMIT
  gl_FragData[1] = vec4(gathered.isCutOff ? 1.0 : 0.0);
#else
  if (gathered.color.a <= 0.0)
  {
    discard;
  }
#endif
  gl_FragData[0] = gathered.color;
}
