//VTK::System::Dec
//VTK::Output::Dec

// A picture of rays, drawn over a viewport of another size: a pixel shows what is interpolated between
// the rays around it, or the mean of the rays in it.

uniform sampler2D in_RayImage;
uniform ivec2 in_ViewportOrigin;
uniform vec2 in_ViewportSize;
uniform int in_Taps; // along both axes of a pixel, each interpolates between four rays

void main()
{
  vec2 corner = floor(gl_FragCoord.xy) - vec2(in_ViewportOrigin);
  vec4 sum = vec4(0.0);
  for (int j = 0; j < in_Taps; ++j)
  {
    for (int i = 0; i < in_Taps; ++i)
    {
      vec2 tap = (vec2(i, j) + 0.5) / float(in_Taps);
      sum += textureLod(in_RayImage, (corner + tap) / in_ViewportSize, 0.0);
    }
  }
  gl_FragData[0] = sum / float(in_Taps * in_Taps);
}
