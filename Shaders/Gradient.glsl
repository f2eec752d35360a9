// Gradients of the volume: central differences as far as the brick's samples are apart, which the
// bricks' aprons hold.

#ifdef FLATBLOCK_GRADIENT_TABLE
uniform sampler2D in_GradientTable; // y: magnitudes
#endif
#ifdef FLATBLOCK_GRADIENT_MAGNITUDE
uniform vec3 in_GradientToTable;    // scale an axis: to magnitudes from 0 to 1,
uniform float in_GradientUnits[TexelComponents]; // and for each component
#endif

// Where a difference begins and ends along each axis: one-sided at the volume's faces.
struct Stencil
{
  vec3 at;     // in the atlas
  vec3 before;
  vec3 behind;
  vec3 below;  // in samples
  vec3 above;
};

Stencil stencilAt(Brick brick, vec3 position)
{
  vec3 middle =
    clamp(position, brick.first, min(brick.first + float(in_CellsPerBlock), in_LastSample));
  Stencil stencil;
  stencil.below = middle - max(middle - 1.0 / brick.scale, 0.0);
  stencil.above = min(middle + 1.0 / brick.scale, in_LastSample) - middle;
  stencil.at = inAtlas(brick, middle);
  stencil.before = stencil.at - stencil.below * brick.scale * in_AtlasTexel;
  stencil.behind = stencil.at + stencil.above * brick.scale * in_AtlasTexel;
  return stencil;
}

#ifdef FLATBLOCK_HOLES
// Where a value is none, the one in the middle stands for it.
void passHole(inout Texel value, inout float reach, Texel middle)
{
  bool isNone = isHole(value);
  value = isNone ? middle : value;
  reach = isNone ? 0.0 : reach;
}
#endif

struct Differences
{
  Texel x; // in texels a sample
  Texel y;
  Texel z;
};

// A texel, or the opacity of its value over a unit of length.
Texel differedAt(bool ofOpacity, Brick brick, vec3 at)
{
  Texel texel = texelAt(brick, at);
#ifdef FLATBLOCK_HOLES
  ofOpacity = ofOpacity && !isHole(texel);
#endif
#ifdef FLATBLOCK_NORMAL_FROM_OPACITY
  if (ofOpacity)
  {
    texel = Texel(opacityOfDepth(matterAtPosition(positionInTable(valueOf(texel))).a));
  }
#endif
  return texel;
}

Differences differencesOf(bool ofOpacity, Brick brick, vec3 position)
{
  Stencil s = stencilAt(brick, position);
  Differences low = Differences(differedAt(ofOpacity, brick, vec3(s.before.x, s.at.yz)),
    differedAt(ofOpacity, brick, vec3(s.at.x, s.before.y, s.at.z)), differedAt(ofOpacity, brick, vec3(s.at.xy, s.before.z)));
  Differences high = Differences(differedAt(ofOpacity, brick, vec3(s.behind.x, s.at.yz)),
    differedAt(ofOpacity, brick, vec3(s.at.x, s.behind.y, s.at.z)), differedAt(ofOpacity, brick, vec3(s.at.xy, s.behind.z)));
#ifdef FLATBLOCK_HOLES
  Texel value = differedAt(ofOpacity, brick, s.at);
  passHole(low.x, s.below.x, value);
  passHole(low.y, s.below.y, value);
  passHole(low.z, s.below.z, value);
  passHole(high.x, s.above.x, value);
  passHole(high.y, s.above.y, value);
  passHole(high.z, s.above.z, value);
#endif
  vec3 reach = max(s.below + s.above, 1e-3);
  return Differences((high.x - low.x) / reach.x, (high.y - low.y) / reach.y,
    (high.z - low.z) / reach.z);
}

Differences differencesAt(Brick brick, vec3 position)
{
  return differencesOf(false, brick, position);
}

#if defined(FLATBLOCK_VALUE_FIRST) || !defined(FLATBLOCK_COMPONENTS)
vec3 gradientAt(Brick brick, vec3 position)
{
#ifdef FLATBLOCK_SPLINE
  return derivativesAt(brick, position).gradient;
#else
  Differences differences = differencesAt(brick, position);
  return vec3(valueOf(differences.x), valueOf(differences.y), valueOf(differences.z));
#endif
}

// That is perpendicular to what light falls on.
vec3 gradientOfSurface(Brick brick, vec3 position)
{
#ifdef FLATBLOCK_NORMAL_FROM_OPACITY
  Differences differences = differencesOf(true, brick, position);
  return vec3(valueOf(differences.x), valueOf(differences.y), valueOf(differences.z));
#else
  return gradientAt(brick, position);
#endif
}
#endif

#ifdef FLATBLOCK_GRADIENT_MAGNITUDE
float magnitudeOf(vec3 gradient, int component)
{
  return in_GradientUnits[component] * length(gradient * in_GradientToTable);
}
#endif

#ifdef FLATBLOCK_GRADIENT_TABLE
// Both from 0 to 1, and beyond as at the end.
vec4 lookUp(float across, float up)
{
  countFetches(1);
  vec2 last = vec2(textureSize(in_GradientTable, 0) - 1);
  vec2 position = clamp(vec2(across, up), 0.0, 1.0);
  return textureLod(in_GradientTable, (position * last + 0.5) / (last + 1.0), 0.0);
}

vec4 lookUpGradient(float across, int component, vec3 gradient)
{
  return lookUp(across, magnitudeOf(gradient, component));
}
#endif
