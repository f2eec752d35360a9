// Blinn and Phong's light on gradients of the volume.

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

vec3 toViewer; // from all of this ray, in world coordinates

struct Light
{
  vec3 reflected; // factors for colours,
  vec3 specular;  // and what is added to them, for full opacity
};

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

vec3 lit(vec4 color, Light light)
{
  return color.rgb * light.reflected + color.a * light.specular;
}
