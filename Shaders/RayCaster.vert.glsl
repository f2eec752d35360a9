//VTK::System::Dec

// The box of a volume, in sample coordinates: (0,0,0) is the first sample, (1,0,0) the next along x.

uniform mat4 in_SampleToClip;
uniform vec3 in_LastSample;

out vec3 boxPosition;

// Corner of a unit cube, drawn as a strip of 14 vertices.
vec3 cubeCorner(int vertex)
{
  int bit = 1 << vertex;
  return vec3((0x287a & bit) != 0, (0x02af & bit) != 0, (0x31e3 & bit) != 0);
}

void main()
{
  boxPosition = cubeCorner(gl_VertexID) * in_LastSample;
  gl_Position = in_SampleToClip * vec4(boxPosition, 1.0);
}
