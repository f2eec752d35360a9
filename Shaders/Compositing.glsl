// Colours composited from front to back, piece after piece.

uniform float in_EnoughOpacity; // a ray that has gathered this much ends

struct Gathered
{
  vec4 color; // multiplied by opacity, and opacity
#if defined(FLATBLOCK_MODULATED) && defined(FLATBLOCK_SHADING)
  Light light;
#endif
};

Gathered nothingGathered()
{
  Gathered gathered;
  gathered.color = vec4(0.0);
  return gathered;
}

void beginPart(inout Gathered gathered)
{
#if defined(FLATBLOCK_MODULATED) && defined(FLATBLOCK_SHADING)
  gathered.light = firstLight();
#endif
}

vec4 colorOf(Gathered gathered)
{
  return gathered.color;
}

bool isAtEnd(Gathered gathered, Progress progress)
{
  return progress.isCutOff || gathered.color.a >= in_EnoughOpacity;
}

bool canChange(Gathered gathered, Brick brick)
{
  return true;
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

#if defined(FLATBLOCK_GRADIENT_OPACITY) || defined(FLATBLOCK_CURVATURE_OPACITY)
// What matter that is `share` times as dense lets be seen.
vec4 thinned(vec4 color, float share)
{
  float depth = color.a < 1e-3 ? color.a * (1.0 + 0.5 * color.a) : -log(max(1.0 - color.a, 1e-30));
  float opacity = opacityOfDepth(depth * share);
  return vec4(color.rgb * (opacity / max(color.a, 1e-30)), opacity);
}
#endif

#ifdef FLATBLOCK_MODULATED
// What the derivatives in a piece do to it, which is as many steps long.
void modulate(
  inout Gathered gathered, inout vec4 color, Brick brick, vec3 position, float steps)
{
#ifdef FLATBLOCK_SCATTERING
  opacityOfStep = 1.0 - pow(1.0 - color.a, 1.0 / steps);
#endif
#ifdef FLATBLOCK_CURVED
  Derivatives derivatives = derivativesAt(brick, position);
  Curvature curvature = curvatureOf(derivatives);
  vec3 gradient = derivatives.gradient;
#elif defined(FLATBLOCK_GRADIENT_OPACITY)
  vec3 gradient = gradientAt(brick, position);
#endif
#ifdef FLATBLOCK_GRADIENT_OPACITY
  color = thinned(color, lookUpGradient(0.0, 0, gradient).r);
#endif
#ifdef FLATBLOCK_CURVATURE
  vec4 ofCurvature = lookUpCurvature(curvature);
  color.rgb = ofCurvature.rgb * color.a;
#ifdef FLATBLOCK_CURVATURE_OPACITY
  color = thinned(color, ofCurvature.a);
#endif
#endif
#ifdef FLATBLOCK_SHADING
#if defined(FLATBLOCK_CURVED) || defined(FLATBLOCK_GRADIENT_OPACITY)
#ifdef FLATBLOCK_NORMAL_FROM_OPACITY
  gradient = gradientOfSurface(brick, position);
#endif
  gathered.light = lightOn(gradient, position, 0);
#else
  if ((1.0 - gathered.color.a) * color.a > in_ShadingOpacityThreshold)
  {
    gathered.light = lightOn(gradientOfSurface(brick, position), position, 0);
  }
#endif
  color.rgb = lit(color, gathered.light);
#endif
#ifdef FLATBLOCK_SILHOUETTES
  color.rgb = mix(color.rgb, in_SilhouetteColor * color.a, silhouetteAt(curvature));
#endif
}
#endif

void addColor(inout Gathered gathered, vec4 color, vec3 position)
{
#ifdef FLATBLOCK_SEEN
  if (gathered.color.a < Seen)
  {
    see(position);
  }
#endif
  gathered.color = composite(gathered.color, color);
}

// Whether a piece shows anything, and its derivatives are asked for.
bool isSeen(Piece piece)
{
#if defined(FLATBLOCK_MODULATED) && !defined(FLATBLOCK_EAGER_DERIVATIVES)
  return piece.color.a > 0.0;
#else
  return true;
#endif
}

// From point to point to a piece that is seen; false where there is none, or none yet. A piece whose
// error is too large is split. Those that are not seen are passed by in a loop of their own, so that
// the rays of a group ask for derivatives together.
bool findPiece(inout Progress progress, Ray ray, vec3 origin, Brick brick, Stretch stretch,
  inout float target, out Point back, out Piece piece)
{
  const float LeastPart = 1.0 / 1024.0;
  bool isFound = false;
#ifdef FLATBLOCK_MODULATED
  while (!isFound && goesOn(progress, stretch))
#endif
  {
    countSample(progress);
    target = min(target, min(progress.next, stretch.exit));
    back = pointAt(brick, origin + target * ray.direction);
    float advance = target - progress.at;
    piece = pieceWithoutHoles(progress.front, back, advance * ray.unit * in_StepLength);
    // Far along a ray a part may be too small to be told from nothing: then the piece is taken as it is.
    float nearer = progress.at + smallerPart(piece.error) * advance;
    bool isDivisible = advance > LeastPart && nearer > progress.at && nearer < target;
    if (piece.error > 1.0 && isDivisible)
    {
      target = nearer;
    }
    else if (isSeen(piece))
    {
      isFound = !progress.isCutOff;
    }
    else
    {
      moveTo(progress, back, target, brick);
      target = stretch.exit;
    }
  }
  return isFound;
}

void gather(inout Gathered gathered, inout Progress progress, Ray ray, vec3 origin, Brick brick,
  Stretch stretch)
{
  while (mustBeFound(progress, stretch))
  {
    findFront(progress, ray, origin);
  }
  float target = stretch.exit;
  while (goesOn(progress, stretch) && gathered.color.a < in_EnoughOpacity)
  {
    Point back;
    Piece piece;
    if (findPiece(progress, ray, origin, brick, stretch, target, back, piece))
    {
#ifdef FLATBLOCK_MODULATED
      vec3 middle = origin + 0.5 * (progress.at + target) * ray.direction;
      modulate(gathered, piece.color, brickAt(progress, brick, middle), middle,
        (target - progress.at) * ray.unit);
#endif
      addColor(gathered, piece.color, origin + target * ray.direction);
      moveTo(progress, back, target, brick);
      target = stretch.exit;
    }
  }
#ifdef FLATBLOCK_MODULATED
  keepBrick(progress, brick, stretch);
#endif
}

// What looks all the same up to the next point, in one piece.
void gatherMatter(inout Gathered gathered, Progress progress, vec3 position, float length)
{
  vec4 layer = layerOf(progress.front.matter, length);
#if defined(FLATBLOCK_MODULATED) && defined(FLATBLOCK_SHADING)
  layer.rgb = lit(layer, gathered.light);
#endif
  addColor(gathered, layer, position);
}
