mat3 deformedToRest = mat3(1.0);
#ifdef USE_SKINNING
  mat3 skin = mat3(skinMatrix);
  if (determinant(skin) != 0.0) deformedToRest = inverse(skin);
#endif // USE_SKINNING
#ifdef USE_MORPHNORMALS
  // Morph targets move vertices, they turn nothing. What they do to the normal is all that is known here.
  deformedToRest = rotationBetween(morphedNormal, normal) * deformedToRest;
#endif // USE_MORPHNORMALS

// Geometry that was never prepared still has its own normals.
vec3 strokeNormal = dot(hatchNormal.xyz, hatchNormal.xyz) > 0.25 ? hatchNormal.xyz : normal;
// Lines that follow the form are fixed to the surface, whatever strokes are.
#if STROKE_ANCHOR == STROKE_ANCHOR_REST || defined(FOLLOWS_FORM)
  vec3 anchorPosition = position;
  mat3 viewToAnchor = deformedToRest * viewToObject;
#else
  vec3 anchorPosition = transformed;
  // From the left is the transpose: what the inverse transpose of the deformation is to the normal.
  strokeNormal = strokeNormal * deformedToRest;
  mat3 viewToAnchor = viewToObject;
#endif // STROKE_ANCHOR
#ifndef RIGID
  vViewToAnchor = viewToAnchor;
#endif // RIGID
