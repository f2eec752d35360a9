//VTK::System::Dec

// What covers all rays that may meet the volume: its box, in sample coordinates, or the viewport.

uniform bool in_CoversViewport;
uniform mat4 in_SampleToClip;
uniform vec3 in_LastSample;

// Corner of a unit cube, drawn as a strip of 14 vertices.
vec3 cubeCorner(int vertex)
{
  int bit = 1 << vertex;
  return vec3((0x287a & bit) != 0, (0x02af & bit) != 0, (0x31e3 & bit) != 0);
}

void main()
{
  if (in_CoversViewport)
  {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
  }
  else
  {
    gl_Position = in_SampleToClip * vec4(cubeCorner(gl_VertexID) * in_LastSample, 1.0);
  }
}
