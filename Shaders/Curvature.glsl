// Curvature of the surfaces of equal value, from the volume's derivatives, with normals that point to
// where values fall: so a dense ball is convex, and convex is positive. Lengths are in the smallest
// spacing.

uniform mat3 in_SlopeToLength;      // gradients from samples to lengths
uniform float in_SteadyGradient;    // below it a gradient may be the rounding of the texels
#ifdef FLATBLOCK_CURVATURE
uniform sampler2D in_CurvatureTable; // colour, and share of the opacity
uniform vec2 in_CurvatureToTable;   // scale and offset to positions from 0 to 1
uniform vec2 in_CurvatureEnds;      // of what is looked up there
#endif
#ifdef FLATBLOCK_SILHOUETTES
uniform float in_SilhouetteWidth;
uniform vec3 in_SilhouetteColor;

vec3 sight; // from the eye, along the ray
#endif

struct Curvature
{
  vec3 normal;
  float slope;    // length of the gradient
  float trust;    // from 0, where there is none to speak of, to 1
  mat3 hessian;
  float mean;
  float gauss;
  float first;    // the larger principal curvature,
  float second;   // and the smaller one
};

// Mean and Gaussian curvature of an implicit surface in closed form (Goldman 2005, eq. 4.1 and 4.2,
// for normals against the gradient), and what follows from them. Where the gradient vanishes they
// fade to 0.
Curvature curvatureOf(Derivatives d)
{
  Curvature c;
  vec3 gradient = in_SlopeToLength * d.gradient;
  mat3 ofSamples = mat3(d.bend.x, d.twist.z, d.twist.y, d.twist.z, d.bend.y, d.twist.x, d.twist.y,
    d.twist.x, d.bend.z);
  c.hessian = in_SlopeToLength * ofSamples * transpose(in_SlopeToLength);
  c.slope = length(gradient);
  c.normal = -gradient / max(c.slope, 1e-30);
  float squared = dot(gradient, gradient);
  c.trust = d.isWhole ? squared / (squared + in_SteadyGradient * in_SteadyGradient) : 0.0;
  float perSlope = c.trust / max(c.slope, 1e-30);
  mat3 shape = -perSlope * c.hessian;
  vec3 n = c.normal;
  vec3 x = shape[0];
  vec3 y = shape[1];
  vec3 z = shape[2];
  float trace = x.x + y.y + z.z;
  c.mean = 0.5 * (trace - dot(n, shape * n));
  c.gauss = dot(n, mat3(cross(y, z), cross(z, x), cross(x, y)) * n);
  float root = sqrt(max(c.mean * c.mean - c.gauss, 0.0));
  c.first = c.mean + root;
  c.second = c.mean - root;
  return c;
}

#ifdef FLATBLOCK_CURVATURE
float firstPrincipal(Curvature c)
{
  return c.first;
}

float secondPrincipal(Curvature c)
{
  return c.second;
}

float meanCurvature(Curvature c)
{
  return c.mean;
}

float gaussianCurvature(Curvature c)
{
  return c.gauss;
}

float totalCurvature(Curvature c)
{
  return length(vec2(c.first, c.second));
}

float largestMagnitude(Curvature c)
{
  return c.mean < 0.0 ? c.second : c.first;
}

// Koenderink and van Doorn 1992: 1 on a ball, 0.5 on a ridge, 0 on a symmetric saddle, -1 in a cup.
float shapeIndex(Curvature c)
{
  float difference = c.first - c.second;
  bool isFlat = c.mean == 0.0 && difference == 0.0;
  return isFlat ? 0.0 : c.trust * 0.6366197724 * atan(2.0 * c.mean, difference);
}

float curvedness(Curvature c)
{
  return sqrt(0.5) * totalCurvature(c);
}

// By how much a surface bends more one way than the other: 1/radius of a tube, negative for a groove,
// and 0 for planes, balls and symmetric saddles.
float lineFeature(Curvature c)
{
  return c.mean < 0.0 ? c.second + abs(c.first) : c.first - abs(c.second);
}

// Colour, and share of the opacity.
vec4 lookUpCurvature(Curvature c)
{
  countFetches(1);
  float value = FLATBLOCK_CURVATURE(c) * in_CurvatureToTable.x + in_CurvatureToTable.y;
  float last = float(textureSize(in_CurvatureTable, 0).x - 1);
  float position = clamp(value, in_CurvatureEnds.x, in_CurvatureEnds.y);
  return textureLod(in_CurvatureTable, vec2((position * last + 0.5) / (last + 1.0), 0.5), 0.0);
}
#endif

#ifdef FLATBLOCK_SILHOUETTES
// How much of a point is outline: where the surface turns away within the width, by its curvature
// along the view (Kindlmann, Whitaker, Tasdizen and Moeller 2003, sec. 4.2).
float silhouetteAt(Curvature c)
{
  float facing = dot(c.normal, sight);
  vec3 along = sight - facing * c.normal;
  float bend = abs(dot(along, c.hessian * along)) * c.trust /
    max(c.slope * dot(along, along), 1e-30);
  float across = min(in_SilhouetteWidth * bend, 1.0);
  float edge = sqrt(across * (2.0 - across));
  return 1.0 - smoothstep(0.8, 1.2, abs(facing) / max(edge, 1e-6));
}
#endif
