// Classification of several components, each interpolated by itself. Opacity and colours that depend
// on gradients, and light, are those of a point.

// Of all components, an axis each.
#ifdef FLATBLOCK_GRADIENT
#define Gradients Differences
#else
#define Gradients vec4
#endif

// What the gradient of a component does to its matter.
vec4 modulated(vec4 matter, int component, Gradients gradients, vec3 position)
{
#ifdef FLATBLOCK_GRADIENT
  vec3 gradient =
    vec3(gradients.x[component], gradients.y[component], gradients.z[component]);
#ifdef FLATBLOCK_GRADIENT_OPACITY
  float across = float(component) / float(max(FLATBLOCK_COMPONENTS - 1, 1));
  matter.a *= lookUpGradient(across, component, gradient).r;
#endif
#ifdef FLATBLOCK_SHADING
  matter.rgb = lit(vec4(matter.rgb, 1.0), lightOn(gradient, position, component));
#endif
#endif
  return matter;
}

#ifdef FLATBLOCK_INDEPENDENT
// Weighted as vtkGPUVolumeRayCastMapper does: light adds up, and the extinction is the mean of all,
// weighted by themselves.
vec4 matterOfAll(vec4 texels, Gradients gradients, vec3 position)
{
  float total = 0.0;
  float squares = 0.0;
  vec3 light = vec3(0.0);
  for (int i = 0; i < FLATBLOCK_COMPONENTS; ++i)
  {
    if (in_Weights[i] > 0.0)
    {
      vec4 matter = modulated(matterOf(i, texels[i]), i, gradients, position);
      total += in_Weights[i] * matter.a;
      squares += matter.a * matter.a;
      light += in_Weights[i] * matter.a * matter.rgb;
    }
  }
  return squares > 0.0 ? vec4(light * (total / squares), squares / total) : vec4(0.0);
}
#else
// As with vtkGPUVolumeRayCastMapper gradients are those of the first component.
vec4 matterOfAll(vec4 texels, Gradients gradients, vec3 position)
{
  return modulated(matterOfDependent(texels), 0, gradients, position);
}
#endif

Point pointAt(Brick brick, vec3 position)
{
  vec4 texels = texelOf(brick, position);
#ifdef FLATBLOCK_GRADIENT
  Gradients gradients = differencesAt(brick, position);
#else
  const Gradients gradients = Gradients(0.0);
#endif
  Point point;
  point.matter = matterOfAll(texels, gradients, position);
#ifdef FLATBLOCK_HOLES
  point.isHole = isHole(texels);
#endif
  return point;
}
