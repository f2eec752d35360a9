// Blinn and Phong's light on gradients of the volume: central differences as far as the brick's
// samples are apart. A neighbouring brick is looked up where one reaches into it.

const int MostLights = 6;

uniform mat3 in_GradientToWorld;
uniform int in_Lights;
uniform vec3 in_LightDirection[MostLights]; // to the light, in world coordinates; 0: a headlight
uniform vec3 in_LightDiffuse[MostLights];   // with the material's
uniform vec3 in_LightSpecular[MostLights];
uniform vec3 in_Ambient;
uniform float in_SpecularPower;
uniform bool in_TwoSidedLighting;
uniform float in_ShadingOpacityThreshold; // of what is seen, below which a piece keeps the last light

struct Light
{
  vec3 reflected; // factors for colours,
  vec3 specular;  // and what is added to them, for full opacity
};

// A value beyond the brick's border. Where no brick has it, it is extrapolated by a parabola.
float valueAround(Brick brick, vec3 middle, inout vec3 position)
{
  position = clamp(position, vec3(0.0), in_LastSample);
  ivec3 last = ivec3(in_Blocks[0], in_Blocks[1], in_Blocks[2]) - 1;
  Brick there = fetchBrick(clamp(ivec3(floor(position / float(in_CellsPerBlock))), ivec3(0), last));
  float texel = texelOf(there, position);
  while (!there.resident)
  {
    vec3 back = middle - position;
    texel = 3.0 * (texelOf(brick, middle) - texelOf(brick, middle + back)) +
      texelOf(brick, middle + 2.0 * back);
    there.resident = true;
  }
#ifdef FLATBLOCK_HOLES
  if (isHole(abs(texel)))
  {
    position = middle;
    texel = texelOf(brick, middle);
  }
#endif
  return texel;
}

// In texels a sample. What lies beyond the brick is looked up one after the other: most rays of a
// group of pixels have nothing there, and the loop is passed by where none has.
vec3 gradientAt(Brick brick, vec3 position)
{
  float reach = 1.0 / brick.scale;
  vec3 first = brick.first;
  vec3 last = min(brick.first + float(in_CellsPerBlock), in_LastSample);
  vec3 middle = clamp(position, first, last);
  vec3 x = vec3(reach, 0.0, 0.0);
  vec3 y = vec3(0.0, reach, 0.0);
  vec3 z = vec3(0.0, 0.0, reach);
  vec3 low = vec3(
    texelOf(brick, middle - x), texelOf(brick, middle - y), texelOf(brick, middle - z));
  vec3 high = vec3(
    texelOf(brick, middle + x), texelOf(brick, middle + y), texelOf(brick, middle + z));
  vec3 lengths = vec3(2.0 * reach);
  vec3 isBefore = vec3(lessThan(middle - reach, first));
  vec3 isBehind = vec3(greaterThan(middle + reach, last));
#ifdef FLATBLOCK_HOLES
  isBefore = vec3(1.0);
  isBehind = vec3(1.0);
#endif
  while (dot(isBefore + isBehind, vec3(1.0)) > 0.0)
  {
    bool isLow = dot(isBefore, vec3(1.0)) > 0.0;
    vec3 sides = isLow ? isBefore : isBehind;
    vec3 axis = sides.x > 0.0 ? vec3(1.0, 0.0, 0.0)
                              : (sides.y > 0.0 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    vec3 there = middle + axis * (isLow ? -reach : reach);
    float value = valueAround(brick, middle, there);
    low = isLow ? mix(low, vec3(value), axis) : low;
    high = isLow ? high : mix(high, vec3(value), axis);
    lengths += axis * (abs(dot(there - middle, axis)) - reach);
    isBefore -= isLow ? axis : vec3(0.0);
    isBehind -= isLow ? vec3(0.0) : axis;
  }
  return (high - low) / max(lengths, 1e-3);
}

Light lightOn(vec3 gradient, vec3 view)
{
  vec3 normal = -(in_GradientToWorld * gradient);
  normal /= max(length(normal), 1e-30);
  Light light = Light(in_Ambient, vec3(0.0));
  for (int i = 0; i < in_Lights; ++i)
  {
    vec3 direction = in_LightDirection[i];
    direction = dot(direction, direction) > 0.0 ? direction : view;
    float facing = dot(normal, direction);
    float shining = dot(normal, normalize(direction + view + 1e-12));
    facing = max(in_TwoSidedLighting ? abs(facing) : facing, 0.0);
    shining = max(in_TwoSidedLighting ? abs(shining) : shining, 1e-6);
    light.reflected += facing * in_LightDiffuse[i];
    light.specular += pow(shining, in_SpecularPower) * in_LightSpecular[i];
  }
  return light;
}

// The light before there is any: that on a surface seen from in front.
Light firstLight()
{
  Light light = Light(in_Ambient, vec3(0.0));
  for (int i = 0; i < in_Lights; ++i)
  {
    light.reflected += in_LightDiffuse[i];
  }
  return light;
}

// A loop is passed by where no pixel of a group enters it, other than what is conditional.
void shade(inout vec4 color, inout Light light, float share, Brick brick, vec3 position, vec3 view)
{
  bool counts = share * color.a > in_ShadingOpacityThreshold;
  while (counts)
  {
    light = lightOn(gradientAt(brick, position), view);
    counts = false;
  }
  color.rgb = color.rgb * light.reflected + color.a * light.specular;
}
