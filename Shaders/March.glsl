// The march of a ray from brick to brick.

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

// Over what looks all the same, or cannot change what was gathered. Loops that end after one turn are
// passed by where no ray of a group of pixels enters them, other than what is conditional.
void leap(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
#if defined(FLATBLOCK_SKIPPING) || defined(FLATBLOCK_EXTREMES)
  float last;
  if (canLeap(progress, brick, stretch, last))
  {
    bool isMatter = stretch.isMatter;
    while (isMatter)
    {
      gatherMatter(gathered, progress, origin + progress.at * ray.direction,
        (last - progress.at) * ray.unit * in_StepLength);
      isMatter = false;
    }
    leapTo(progress, last, brick);
  }
#endif
}

// Points lie on a lattice of steps that begins where the ray begins, whatever blocks they fall into;
// a coarser block has every second one, and so on. So neither block borders nor levels leave a
// trace, nor does a leap: it ends at the last point of the lattice before what varies. Only where a
// block that is not there begins or ends is there a point at its border.
void march(inout Gathered gathered, inout Progress progress, Ray ray)
{
  float phase = phaseOfRay();
  vec3 origin = ray.origin + (ray.begin - phase) * ray.direction;
  float end = ray.end - ray.begin + phase;
  Walk walk = enterCubes(ray);
  ivec3 block = blockOf(walk);
  Brick brick = fetchBrick(block);
  bool wasResident = false;

  progress.front = noPoint();
  progress.at = phase;
  progress.next = phase;
  progress.isLost = true;
  progress.brick = brick;
  beginPart(gathered);
  Stretch stretch;
  stretch.entry = phase;
  bool isInside = ray.begin < ray.end;
  while (isInside && !isAtEnd(gathered, progress))
  {
    if (brick.resident)
    {
      float first = ceil(stretch.entry / brick.step) * brick.step;
      if (!wasResident)
      {
        progress.isLost = true;
        progress.brick = brick;
        progress.at = stretch.entry;
        progress.next = first + brick.step;
      }
      progress.next = min(progress.next, first > progress.at ? first : first + brick.step);
    }
    stretch.isVaried = !walk.isPlain && canChange(gathered, brick);
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
      gather(gathered, progress, ray, origin, brick, stretch);
      leap(gathered, progress, ray, origin, brick, stretch);
    }
    wasResident = brick.resident;
    brick = beyond;
    stretch.entry = stretch.exit;
  }
}

// Part after part, where the ray is cut into some.
void marchThroughParts(inout Gathered gathered, inout Progress progress, Ray ray)
{
#ifdef FLATBLOCK_CROPPING
  Cropping cropping = cropRay(ray);
  Ray part = ray;
  while (part.begin < ray.end && !isAtEnd(gathered, progress))
  {
    findShown(cropping, part, ray.end);
    march(gathered, progress, part);
    part.begin = part.end;
  }
#else
  march(gathered, progress, ray);
#endif
}

vec4 colorAlong(Ray ray, inout Progress progress)
{
  Gathered gathered = nothingGathered();
  marchThroughParts(gathered, progress, ray);
  return colorOf(gathered);
}
