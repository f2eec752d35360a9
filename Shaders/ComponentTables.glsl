// The transfer functions of several components.

uniform int in_FirstEntries[FLATBLOCK_COMPONENTS]; // of each one's table
uniform float in_LastEntries[FLATBLOCK_COMPONENTS];
uniform vec2 in_TexelsToTables[FLATBLOCK_COMPONENTS];
#ifdef FLATBLOCK_INDEPENDENT
uniform float in_Weights[FLATBLOCK_COMPONENTS];
#elif FLATBLOCK_COMPONENTS == 4
uniform vec3 in_ColorScale; // of what is a colour itself
uniform vec3 in_ColorOffset;
#endif

vec4 matterOf(int component, float texel)
{
  float last = in_LastEntries[component];
  float position = clamp(texel * in_TexelsToTables[component].x + in_TexelsToTables[component].y, 0.0,
    last);
  float interval = min(floor(position), last - 1.0);
  int entry = in_FirstEntries[component] + int(interval);
  return mix(entryOfTable(entry), entryOfTable(entry + 1), position - interval);
}

#ifndef FLATBLOCK_INDEPENDENT
// The last component is opacity, what is before it is colour.
vec4 matterOfDependent(vec4 texels)
{
  const int Last = FLATBLOCK_COMPONENTS - 1;
#if FLATBLOCK_COMPONENTS == 4
  vec3 color = clamp(texels.rgb * in_ColorScale + in_ColorOffset, 0.0, 1.0);
#else
  vec3 color = matterOf(0, texels[0]).rgb;
#endif
  return vec4(color, matterOf(Last, texels[Last]).a);
}
#endif
