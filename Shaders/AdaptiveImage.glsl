// A coarse image of rays: where those around a pixel are alike, it shows what is between them.

uniform sampler2D in_CoarseRays;
uniform float in_ImageTolerance; // by which colours and opacities of these may differ

bool isBetweenRays(out vec4 color)
{
  vec2 size = vec2(textureSize(in_CoarseRays, 0));
  vec2 place = (gl_FragCoord.xy - vec2(in_ViewportOrigin)) / in_ViewportSize;
  ivec2 first = ivec2(clamp(floor(place * size - 0.5), vec2(0.0), max(size - 2.0, 0.0)));
  ivec2 last = min(first + 1, ivec2(size) - 1);
  vec4 rays[4] = vec4[4](texelFetch(in_CoarseRays, first, 0),
    texelFetch(in_CoarseRays, ivec2(last.x, first.y), 0),
    texelFetch(in_CoarseRays, ivec2(first.x, last.y), 0), texelFetch(in_CoarseRays, last, 0));
  vec4 low = min(min(rays[0], rays[1]), min(rays[2], rays[3]));
  vec4 high = max(max(rays[0], rays[1]), max(rays[2], rays[3]));
  color = textureLod(in_CoarseRays, place, 0.0);
  return all(lessThanEqual(high - low, vec4(in_ImageTolerance)));
}
