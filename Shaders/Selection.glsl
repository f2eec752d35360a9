// Ids in place of colours, as vtkHardwareSelector reads them: that of the prop, or of the cell or point
// where the ray first met something.

const int PropPass = 0;
const int LowPass = 1;  // the lower 24 bits of an id
const int HighPass = 2; // the others

uniform int in_SelectionPass;
uniform vec3 in_PropColor;
uniform vec3 in_SampleToId; // added to a position in samples: the id along each axis is what is below
uniform int in_Ids[3];      // an axis

vec4 idAt(vec3 position)
{
  if (in_SelectionPass == PropPass)
  {
    return vec4(in_PropColor, 1.0);
  }
  ivec3 last = ivec3(in_Ids[0], in_Ids[1], in_Ids[2]) - 1;
  uvec3 place = uvec3(clamp(ivec3(floor(position + in_SampleToId)), ivec3(0), last));
  uint id = place.x + uint(in_Ids[0]) * (place.y + uint(in_Ids[1]) * place.z);
  id = in_SelectionPass == LowPass ? id & 0xffffffu : id >> 24;
  return vec4(vec3(id & 0xffu, (id >> 8) & 0xffu, id >> 16) / 255.0, 1.0);
}
