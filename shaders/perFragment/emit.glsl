mat3 deformedToRest = mat3(1.0);
#ifdef USE_SKINNING
  mat3 skin = mat3(skinMatrix);
  if (determinant(skin) != 0.0) deformedToRest = inverse(skin);
#endif // USE_SKINNING
#ifdef USE_MORPHNORMALS
  // Morph targets give no rotation of their own: it is taken from the change of the normal.
  deformedToRest = rotationBetween(morphedNormal, normal) * deformedToRest;
#endif // USE_MORPHNORMALS

// The smoothed normal, or the geometry's own where it was not prepared.
vec3 strokeNormal = dot(hatchNormal.xyz, hatchNormal.xyz) > 0.25 ? hatchNormal.xyz : normal;
// Lines that follow the form are fixed to the surface at rest, whatever the choice.
#if STROKE_ANCHOR == STROKE_ANCHOR_REST || defined(FOLLOWS_FORM)
  vec3 anchorPosition = position;
  mat3 viewToAnchor = deformedToRest * viewToObject;
#else
  vec3 anchorPosition = transformed;
  // Multiplied from the left, that is by the transpose: the inverse transpose of the deformation, as normals need.
  strokeNormal = strokeNormal * deformedToRest;
  mat3 viewToAnchor = viewToObject;
#endif // STROKE_ANCHOR
#ifndef RIGID
  vViewToAnchor = viewToAnchor;
#endif // RIGID
