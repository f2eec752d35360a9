//VTK::System::Dec
//VTK::Output::Dec

// One ray through the flat blocks. The fragment lies on a face of the box where rays leave it.
// Positions are in sample coordinates; distances along the ray are counted in steps, which are
// equally long in the data set's own unit of length, whatever the spacing and the direction.

//FlatBlock::Ray
//FlatBlock::Blocks

uniform float in_EnoughOpacity;     // a ray that has gathered this much ends
uniform sampler2D in_TransferTable; // colour, and opacity of one step
uniform vec2 in_TexelToTable;      // scale and offset: atlas texel to table coordinate

// Colour, multiplied by opacity, and opacity of the sample at a position in the atlas.
vec4 classify(vec3 atlasPosition)
{
  float texel = textureLod(in_Atlas, atlasPosition, 0.0).r;
  float entry = texel * in_TexelToTable.x + in_TexelToTable.y;
  vec4 color = textureLod(in_TransferTable, vec2(entry, 0.5), 0.0);
  return vec4(color.rgb * color.a, color.a);
}

// Samples lie in the middle of each step and are numbered from where the ray begins, whatever
// blocks they fall into: so block borders leave no trace.
vec4 march(Ray ray)
{
  vec3 firstSample = ray.origin + (ray.begin + 0.5) * ray.direction;
  float samples = ceil(ray.end - ray.begin - 0.5);
  BlockWalk walk = enterBlocks(ray);
  vec4 sum = vec4(0.0);
  float s = 0.0;
  while (s < samples)
  {
    float samplesToBorder = ceil(distanceToBorder(walk) - ray.begin - 0.5);
    float end = min(samplesToBorder, samples);
    Brick brick = fetchBrick(walk.block);
    if (brick.resident)
    {
      vec3 position = toAtlas(brick, firstSample);
      vec3 advance = ray.direction * brick.scale * in_AtlasTexel;
      for (; s < end && sum.a < in_EnoughOpacity; s += 1.0)
      {
        vec3 at = clamp(position + s * advance, brick.low, brick.high);
        sum += (1.0 - sum.a) * classify(at);
      }
    }
    s = max(s, end);
    if (sum.a >= in_EnoughOpacity || !crossBorder(walk))
    {
      break;
    }
  }
  return sum;
}

void main()
{
  Ray ray = rayThroughBox();
  clipToScene(ray);
  if (ray.begin >= ray.end)
  {
    discard;
  }
  vec4 color = march(ray);
  if (color.a <= 0.0)
  {
    discard;
  }
  gl_FragData[0] = color;
}
