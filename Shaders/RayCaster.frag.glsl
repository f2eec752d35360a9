//VTK::System::Dec
//VTK::Output::Dec
//FlatBlock::Defines

// One ray through the flat blocks: that of the fragment, if it meets their box at all. Positions are
// in sample coordinates; distances along the ray are counted in steps, which are equally long in the
// data set's own unit of length, whatever the spacing and the direction.

//FlatBlock::Counting
//FlatBlock::Ray
//FlatBlock::Clipping
//FlatBlock::AdaptiveImage
//FlatBlock::Blocks
//FlatBlock::Walk
//FlatBlock::TransferTable
//FlatBlock::Classification
//FlatBlock::Shading

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
  bool isLost; // what is at the front, in the brick, is not known: the ray leapt
  Brick brick;
#ifdef FLATBLOCK_SHADING
  Light light;
#endif
#ifdef FLATBLOCK_COUNTING
  int samples;
#endif
#ifdef FLATBLOCK_SAMPLE_LIMIT
  bool isCutOff;
#endif
};

Gathered nothingGathered()
{
  Gathered gathered;
  gathered.color = vec4(0.0);
#ifdef FLATBLOCK_COUNTING
  gathered.samples = 0;
#endif
#ifdef FLATBLOCK_SAMPLE_LIMIT
  gathered.isCutOff = false;
#endif
  return gathered;
}

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

// A part of a ray within one brick.
struct Stretch
{
  float entry;
  float exit;
  bool isVaried; // else only the piece that began before it is gathered,
  bool isMatter; // and that only where something is seen
  bool isToEnd;  // up to the exit, else to the last point before
};

bool hasPoint(Gathered gathered, Stretch stretch)
{
  return gathered.next < stretch.exit || (stretch.isToEnd && gathered.at < stretch.exit);
}

bool mustBeFound(Gathered gathered, Stretch stretch)
{
  return gathered.isLost && (stretch.isVaried || stretch.isMatter);
}

bool goesOn(Gathered gathered, Stretch stretch)
{
  return !isAtEnd(gathered) && !gathered.isLost && hasPoint(gathered, stretch) &&
    (stretch.isVaried || gathered.at < stretch.entry);
}

// Point after point. A piece whose error is too large is split.
void gather(inout Gathered gathered, Ray ray, vec3 origin, Brick brick, Stretch stretch)
{
  const float LeastPart = 1.0 / 1024.0;
  while (mustBeFound(gathered, stretch))
  {
    gathered.front = pointAt(gathered.brick, origin + gathered.at * ray.direction);
    gathered.isLost = false;
#ifdef FLATBLOCK_COUNTING
    ++gathered.samples;
#endif
  }
#ifdef FLATBLOCK_SHADING
  vec3 view = -normalize(in_SampleToWorld * ray.direction);
#endif
  float target = stretch.exit;
  while (goesOn(gathered, stretch))
  {
#ifdef FLATBLOCK_COUNTING
    ++gathered.samples;
#endif
#ifdef FLATBLOCK_SAMPLE_LIMIT
    gathered.isCutOff = gathered.samples > in_MaximumNumberOfSamples;
    if (gathered.isCutOff)
    {
      break;
    }
#endif
    target = min(target, min(gathered.next, stretch.exit));
    Point back = pointAt(brick, origin + target * ray.direction);
    float advance = target - gathered.at;
    Piece piece = pieceWithoutHoles(gathered.front, back, advance * ray.unit * in_StepLength);
    // Far along a ray a part may be too small to be told from nothing: then the piece is taken as it is.
    float nearer = gathered.at + smallerPart(piece.error) * advance;
    bool isDivisible = advance > LeastPart && nearer > gathered.at && nearer < target;
    if (piece.error > 1.0 && isDivisible)
    {
      target = nearer;
    }
    else
    {
#ifdef FLATBLOCK_SHADING
      vec3 middle = origin + 0.5 * (gathered.at + target) * ray.direction;
      shade(piece.color, gathered.light, 1.0 - gathered.color.a, brick, middle, view);
#endif
      gathered.color = composite(gathered.color, piece.color);
      gathered.front = back;
      gathered.at = target;
      float following = (floor(gathered.next / brick.step) + 1.0) * brick.step;
      gathered.next = target >= gathered.next ? following : gathered.next;
      target = stretch.exit;
    }
  }
}

// Over what looks all the same, in one piece, to the last point. Loops that end after one turn are
// passed by where no ray of a group of pixels enters them, other than what is conditional.
void leap(inout Gathered gathered, Ray ray, Brick brick, Stretch stretch)
{
#ifdef FLATBLOCK_SKIPPING
  float last = max(gathered.next, (ceil(stretch.exit / brick.step) - 1.0) * brick.step);
  last = stretch.isToEnd ? stretch.exit : last;
  if (!stretch.isVaried && hasPoint(gathered, stretch) && last > gathered.at)
  {
    bool isMatter = stretch.isMatter;
    while (isMatter)
    {
      vec4 layer =
        layerOf(gathered.front.matter, (last - gathered.at) * ray.unit * in_StepLength);
#ifdef FLATBLOCK_SHADING
      layer.rgb = layer.rgb * gathered.light.reflected + layer.a * gathered.light.specular;
#endif
      gathered.color = composite(gathered.color, layer);
      isMatter = false;
    }
    gathered.at = last;
    gathered.next = last + brick.step; // the lattice has one, or the ray ends here
    gathered.isLost = true;
    gathered.brick = brick;
  }
#endif
}

// Points lie on a lattice of steps that begins where the ray begins, whatever blocks they fall into;
// a coarser block has every second one, and so on. So neither block borders nor levels leave a
// trace, nor does a leap: it ends at the last point of the lattice before what varies. Only where a
// block that is not there begins or ends is there a point at its border.
void march(inout Gathered gathered, Ray ray)
{
  float phase = phaseOfRay();
  vec3 origin = ray.origin + (ray.begin - phase) * ray.direction;
  float end = ray.end - ray.begin + phase;
  Walk walk = enterCubes(ray);
  ivec3 block = blockOf(walk);
  Brick brick = fetchBrick(block);
  bool wasResident = false;

  gathered.front = noPoint();
  gathered.at = phase;
  gathered.next = phase;
  gathered.isLost = true;
  gathered.brick = brick;
#ifdef FLATBLOCK_SHADING
  gathered.light = firstLight();
#endif
  Stretch stretch;
  stretch.entry = phase;
  bool isInside = ray.begin < ray.end;
  while (isInside && !isAtEnd(gathered))
  {
    if (brick.resident)
    {
      float first = ceil(stretch.entry / brick.step) * brick.step;
      if (!wasResident)
      {
        gathered.isLost = true;
        gathered.brick = brick;
        gathered.at = stretch.entry;
        gathered.next = first + brick.step;
      }
      gathered.next = min(gathered.next, first > gathered.at ? first : first + brick.step);
    }
    stretch.isVaried = !walk.isPlain;
    stretch.isMatter = walk.isMatter;
    bool isRun = true; // through what is as transparent, of this block or of those without a brick
    while (isRun)
    {
      vec3 borders = distancesToBorders(walk, ray);
      stretch.exit = min(nearestOf(borders) - ray.begin + phase, end);
      isInside = stretch.exit < end && crossBorder(walk, ray, borders);
      bool isSame = blockOf(walk) == block || (walk.isHidden && !brick.resident);
      isRun = isInside && isSame && !stretch.isVaried && !stretch.isMatter && walk.isPlain &&
        !walk.isMatter;
    }
    Brick beyond = brick;
    bool isOther = isInside && blockOf(walk) != block;
    beyond.resident = isInside && brick.resident;
    while (isOther)
    {
      block = blockOf(walk);
      beyond = fetchBrick(block);
      isOther = false;
    }
    if (brick.resident)
    {
      stretch.isToEnd = !beyond.resident;
      gather(gathered, ray, origin, brick, stretch);
      leap(gathered, ray, brick, stretch);
    }
    wasResident = brick.resident;
    brick = beyond;
    stretch.entry = stretch.exit;
  }
}

// Part after part, where the ray is cut into some.
void marchThroughParts(inout Gathered gathered, Ray ray)
{
#ifdef FLATBLOCK_CROPPING
  Cropping cropping = cropRay(ray);
  Ray part = ray;
  while (part.begin < ray.end && !isAtEnd(gathered))
  {
    findShown(cropping, part, ray.end);
    march(gathered, part);
    part.begin = part.end;
  }
#else
  march(gathered, ray);
#endif
}

void main()
{
  Ray ray = rayThroughBox();
  clipToScene(ray);
#ifdef FLATBLOCK_CLIPPING_PLANES
  clipToPlanes(ray);
#endif
  if (ray.begin >= ray.end)
  {
    discard;
  }
#ifdef FLATBLOCK_ADAPTIVE_IMAGE
  vec4 between;
  bool isBetween = isBetweenRays(between);
  ray.end = isBetween ? ray.begin : ray.end;
#endif
  Gathered gathered = nothingGathered();
  marchThroughParts(gathered, ray);
#ifdef FLATBLOCK_ADAPTIVE_IMAGE
  gathered.color = isBetween ? between : gathered.color;
#endif
#ifdef FLATBLOCK_COUNTING
  float samples = float(gathered.samples);
#ifdef FLATBLOCK_SAMPLE_LIMIT
  samples = gathered.isCutOff ? -samples : samples;
#endif
  gl_FragData[1] = vec4(samples, float(fetches), 0.0, 0.0);
#else
  if (gathered.color.a <= 0.0)
  {
    discard;
  }
#endif
  gl_FragData[0] = gathered.color;
}
