// Blinn and Phong's light on gradients of the volume: central differences as far as the brick's
// samples are apart, which the bricks' aprons hold.

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

#ifdef FLATBLOCK_HOLES
// Where a value is none, the one in the middle stands for it.
void passHole(inout float value, inout float reach, float middle)
{
  bool isNone = isHole(abs(value));
  value = isNone ? middle : value;
  reach = isNone ? 0.0 : reach;
}
#endif

// In texels a sample; one-sided at the volume's faces.
vec3 gradientAt(Brick brick, vec3 position)
{
  vec3 middle =
    clamp(position, brick.first, min(brick.first + float(in_CellsPerBlock), in_LastSample));
  vec3 below = middle - max(middle - 1.0 / brick.scale, 0.0);
  vec3 above = min(middle + 1.0 / brick.scale, in_LastSample) - middle;
  vec3 at = inAtlas(brick, middle);
  vec3 before = at - below * brick.scale * in_AtlasTexel;
  vec3 behind = at + above * brick.scale * in_AtlasTexel;
  vec3 low = vec3(texelAt(brick, vec3(before.x, at.yz)),
    texelAt(brick, vec3(at.x, before.y, at.z)), texelAt(brick, vec3(at.xy, before.z)));
  vec3 high = vec3(texelAt(brick, vec3(behind.x, at.yz)),
    texelAt(brick, vec3(at.x, behind.y, at.z)), texelAt(brick, vec3(at.xy, behind.z)));
#ifdef FLATBLOCK_HOLES
  float value = texelAt(brick, at);
  passHole(low.x, below.x, value);
  passHole(low.y, below.y, value);
  passHole(low.z, below.z, value);
  passHole(high.x, above.x, value);
  passHole(high.y, above.y, value);
  passHole(high.z, above.z, value);
#endif
  return (high - low) / max(below + above, 1e-3);
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

void shade(inout vec4 color, inout Light light, float share, Brick brick, vec3 position, vec3 view)
{
  if (share * color.a > in_ShadingOpacityThreshold)
  {
    light = lightOn(gradientAt(brick, position), view);
  }
  color.rgb = color.rgb * light.reflected + color.a * light.specular;
}
