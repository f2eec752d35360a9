//VTK::System::Dec
//VTK::Output::Dec
//FlatBlock::Defines

// One ray through the flat blocks: that of the fragment, if it meets their box at all. Positions are
// in sample coordinates; distances along the ray are counted in steps, which are equally long in the
// data set's own unit of length, whatever the spacing and the direction.

//FlatBlock::Counting
//FlatBlock::Ray
//FlatBlock::Clipping
//FlatBlock::AdaptiveImage
//FlatBlock::Blocks
//FlatBlock::Filter
//FlatBlock::Walk
//FlatBlock::TransferTable
//FlatBlock::Derivatives
//FlatBlock::Curvature
//FlatBlock::Gradient
//FlatBlock::Scattering
//FlatBlock::Shading
//FlatBlock::Classification
//FlatBlock::Selection
//FlatBlock::Progress
//FlatBlock::Gathering
//FlatBlock::March

void main()
{
  Ray ray = rayThroughBox();
  clipToScene(ray);
#ifdef FLATBLOCK_CLIPPING_PLANES
  clipToPlanes(ray);
#endif
  if (ray.begin >= ray.end)
  {
    discard;
  }
#ifdef FLATBLOCK_ADAPTIVE_IMAGE
  vec4 between;
  bool isBetween = isBetweenRays(between);
  ray.end = isBetween ? ray.begin : ray.end;
#endif
#ifdef FLATBLOCK_SHADING
  toViewer = -normalize(in_SampleToWorld * ray.direction);
#endif
#ifdef FLATBLOCK_SILHOUETTES
  sight = normalize(in_SampleToSteps * ray.direction);
#endif
  Progress progress = noProgress();
  vec4 color = colorAlong(ray, progress);
#ifdef FLATBLOCK_ADAPTIVE_IMAGE
  color = isBetween ? between : color;
#endif
#ifdef FLATBLOCK_SELECTION
  if (color.a < Seen)
  {
    discard;
  }
  color = idAt(seenAt);
#endif
#ifdef FLATBLOCK_COUNTING
  float samples = float(progress.samples);
#ifdef FLATBLOCK_SAMPLE_LIMIT
  samples = progress.isCutOff ? -samples : samples;
#endif
  gl_FragData[1] = vec4(samples, float(fetches), 0.0, 0.0);
#else
  if (color.a <= 0.0)
  {
    discard;
  }
#endif
#ifdef FLATBLOCK_DEPTH_IMAGE
  gl_FragData[1] = vec4(color.a < Seen ? 1.0 : 0.5 + 0.5 * depthOf(seenAt), 0.0, 0.0, 0.0);
#endif
  gl_FragData[0] = color;
}
