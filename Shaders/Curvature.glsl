// Curvature of the surfaces of equal value, from the volume's derivatives, with normals that point to
// where values fall: so a dense ball is convex, and convex is positive. Lengths are in the smallest
// spacing.

uniform mat3 in_SlopeToLength;      // gradients from samples to lengths
uniform float in_SteadySlope;       // and bend, of which half may be rounding of the samples
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

// From 0, for what rounding alone may have made of nothing, to 1.
float trustIn(float slope)
{
  float noise = in_SteadySlope * in_SteadySlope;
  return slope * slope * slope * slope / (slope * slope * slope * slope + noise * noise);
}

// Two directions in the plane across a normal (Duff et al., Building an Orthonormal Basis, Revisited,
// Journal of Computer Graphics Techniques 2017).
mat2x3 acrossNormal(vec3 n)
{
  float side = n.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (side + n.z);
  float b = n.x * n.y * a;
  return mat2x3(vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x),
    vec3(b, side + n.y * n.y * a, -n.y));
}

// Mean and Gaussian curvature are half of the trace, and the determinant, of the shape operator, the
// Hessian on the tangent plane over the slope (Kindlmann, Whitaker, Tasdizen and Moeller,
// Curvature-Based Transfer Functions, 2003, sec. 3); principal ones are their mean and what they are
// apart. That is mean^2 - Gauss under a root, but as a sum of squares: so it is never negative, and
// balls are round to all digits. Where the gradient vanishes all fade to 0.
Curvature curvatureOf(Derivatives d)
{
  Curvature c;
  vec3 gradient = in_SlopeToLength * d.gradient;
  mat3 ofSamples = mat3(d.bend.x, d.twist.z, d.twist.y, d.twist.z, d.bend.y, d.twist.x, d.twist.y,
    d.twist.x, d.bend.z);
  c.hessian = in_SlopeToLength * ofSamples * transpose(in_SlopeToLength);
  c.slope = length(gradient);
  c.normal = -gradient / max(c.slope, 1e-30);
  c.trust = d.isWhole ? trustIn(c.slope) : 0.0;
  mat2x3 across = acrossNormal(c.normal);
  mat2x3 bent = c.hessian * across;
  vec3 shape = -c.trust / max(c.slope, 1e-30) *
    vec3(dot(across[0], bent[0]), dot(across[1], bent[1]), dot(across[0], bent[1]));
  c.mean = 0.5 * (shape.x + shape.y);
  c.gauss = shape.x * shape.y - shape.z * shape.z;
  float apart = length(vec2(0.5 * (shape.x - shape.y), shape.z));
  c.first = c.mean + apart;
  c.second = c.mean - apart;
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
// It does not tell how small curvatures are, so it fades where these are rounding.
float shapeIndex(Curvature c)
{
  float bend = totalCurvature(c) * c.slope;
  float angle = atan(2.0 * c.mean, max(c.first - c.second, 1e-30));
  return trustIn(bend) * c.trust * 0.6366197724 * angle;
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
  float outline = 1.0 - smoothstep(0.8, 1.2, abs(facing) / max(edge, 1e-6));
  return edge > 1e-6 ? outline * c.trust : 0.0;
}
#endif
