//VTK::System::Dec
//VTK::Output::Dec
//FlatBlock::Defines

// One ray through the flat blocks. The fragment lies on a face of the box where rays leave it.
// Positions are in sample coordinates; distances along the ray are counted in steps, which are
// equally long in the data set's own unit of length, whatever the spacing and the direction.

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

// Adds the segment up to a point. Where one of its ends lies in a hole, the other one's half is drawn.
void gather(inout Gathered gathered, Point back, float at, float unit)
{
#ifdef FLATBLOCK_SAMPLE_LIMIT
  gathered.isCutOff = ++gathered.samples > in_MaximumNumberOfSamples;
  if (gathered.isCutOff)
  {
    return;
  }
#endif
  Point front = gathered.front;
  float length = max(at - gathered.at, 0.0) * unit * in_StepLength;
  gathered.front = back;
  gathered.at = at;
#ifdef FLATBLOCK_HOLES
  if (front.isHole && back.isHole)
  {
    return;
  }
  if (front.isHole || back.isHole)
  {
    length *= 0.5;
    if (front.isHole)
    {
      front = back;
    }
    back = front;
  }
#endif
  gathered.color = composite(gathered.color, segmentBetween(front, back, length));
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

  Gathered gathered;
  gathered.color = vec4(0.0);
  gathered.at = phase;
#ifdef FLATBLOCK_SAMPLE_LIMIT
  gathered.samples = 1;
  gathered.isCutOff = false;
#endif
  if (brick.resident)
  {
    gathered.front = pointAt(brick, origin + phase * ray.direction);
  }
  float next = brick.step;
  while (true)
  {
    float exit = min(distanceToBorder(walk) - ray.begin + phase, end);
    if (brick.resident)
    {
      for (; next < exit && !isAtEnd(gathered); next += brick.step)
      {
        gather(gathered, pointAt(brick, origin + next * ray.direction), next, ray.unit);
      }
    }
    Brick beyond = brick;
    beyond.resident = false;
    if (exit < end && crossBorder(walk))
    {
      beyond = fetchBrick(walk.block);
    }
    else
    {
      end = exit;
    }
    if (brick.resident && !beyond.resident && !isAtEnd(gathered))
    {
      gather(gathered, pointAt(brick, origin + exit * ray.direction), exit, ray.unit);
    }
    if (exit >= end || isAtEnd(gathered))
    {
      return gathered;
    }
    if (beyond.resident)
    {
      float step = brick.resident ? min(brick.step, beyond.step) : beyond.step;
      if (!brick.resident)
      {
        gathered.front = pointAt(beyond, origin + exit * ray.direction);
        gathered.at = exit;
      }
      next = ceil(exit / step) * step;
      next += next > gathered.at ? 0.0 : step;
    }
    brick = beyond;
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
