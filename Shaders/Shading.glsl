// Blinn and Phong's light on gradients of the volume.

const int MostLights = 6;

uniform mat3 in_GradientToWorld;
uniform int in_Lights;
uniform vec3 in_LightDirection[MostLights]; // to the light, in world coordinates; 0: a headlight
#ifdef FLATBLOCK_POSITIONAL_LIGHTS
uniform vec4 in_LightPosition[MostLights]; // from the first sample, in world coordinates; w 0: far away
uniform vec3 in_LightAttenuation[MostLights]; // constant, linear, quadratic, of a distance
uniform vec2 in_LightCone[MostLights]; // cosine of its half angle, and the exponent within
#endif
uniform vec3 in_LightDiffuse[MostLights];
uniform vec3 in_LightSpecular[MostLights];
uniform vec3 in_Ambient;
uniform vec4 in_Materials[4]; // of components: ambient, diffuse, specular, its power
#ifdef FLATBLOCK_GRADIENT_MODULATION
uniform vec3 in_GradientModulation; // of ambient, diffuse, specular: how much depends on gradients
#endif
uniform bool in_TwoSidedLighting;
uniform float in_ShadingOpacityThreshold; // of what is seen, below which a piece keeps the last light

vec3 toViewer; // from all of this ray, in world coordinates

struct Light
{
  vec3 reflected; // factors for colours,
  vec3 specular;  // and what is added to them, for full opacity
};

// Direction to a light, how much of it arrives through empty space, and how far away it is.
vec3 directionTo(int light, vec3 position, out float share, out float farthest)
{
  share = 1.0;
  vec3 direction = in_LightDirection[light];
  bool isAtEye = direction == vec3(0.0);
  direction = isAtEye ? toViewer : direction;
  farthest = isAtEye && in_Eye.w > 0.0 ? length(in_SampleToWorld * (in_Eye.xyz - position)) : 1e30;
#ifdef FLATBLOCK_POSITIONAL_LIGHTS
  if (in_LightPosition[light].w > 0.0)
  {
    vec3 way = in_LightPosition[light].xyz - in_SampleToWorld * position;
    float distance = max(length(way), 1e-30);
    vec3 attenuation = in_LightAttenuation[light];
    way /= distance;
    share = 1.0 /
      max(attenuation.x + distance * (attenuation.y + distance * attenuation.z), 1e-30);
    vec2 cone = in_LightCone[light];
    float along = dot(way, direction);
    share *= along >= cone.x ? pow(max(along, 1e-6), cone.y) : 0.0;
    direction = way;
    farthest = distance;
  }
#endif
  return direction;
}

Light lightOn(vec3 gradient, vec3 position, int component)
{
  vec4 material = in_Materials[component];
#ifdef FLATBLOCK_GRADIENT_MODULATION
  material.xyz *= mix(vec3(1.0), vec3(min(magnitudeOf(gradient, component), 1.0)), in_GradientModulation);
#endif
  vec3 normal = -(in_GradientToWorld * gradient);
  normal /= max(length(normal), 1e-30);
  Light light = Light(material.x * in_Ambient, vec3(0.0));
#ifdef FLATBLOCK_SCATTERING
  vec3 scattered = material.x * in_ScatteredAmbient;
#endif
  for (int i = 0; i < in_Lights; ++i)
  {
    float share;
    float farthest;
    vec3 direction = directionTo(i, position, share, farthest);
    float facing = dot(normal, direction);
    float shining = dot(normal, normalize(direction + toViewer + 1e-12));
    facing = max(in_TwoSidedLighting ? abs(facing) : facing, 0.0);
    shining = max(in_TwoSidedLighting ? abs(shining) : shining, 1e-6);
    light.reflected += share * facing * material.y * in_LightDiffuse[i];
    light.specular += share * pow(shining, material.w) * material.z * in_LightSpecular[i];
#ifdef FLATBLOCK_SCATTERING
    scattered += share * transmittance(position, direction, farthest) *
      phaseOf(-dot(direction, toViewer)) * material.y * in_LightDiffuse[i];
#endif
  }
#ifdef FLATBLOCK_SCATTERING
  float volume = scatteredShare(gradient);
  light.reflected = mix(light.reflected, scattered, volume);
  light.specular *= 1.0 - volume;
#endif
  return light;
}

// The light before there is any: that on a surface seen from in front.
Light firstLight()
{
  Light light = Light(in_Materials[0].x * in_Ambient, vec3(0.0));
  for (int i = 0; i < in_Lights; ++i)
  {
    light.reflected += in_Materials[0].y * in_LightDiffuse[i];
  }
  return light;
}

vec3 lit(vec4 color, Light light)
{
  return min(color.rgb * light.reflected + color.a * light.specular, vec3(color.a));
}
