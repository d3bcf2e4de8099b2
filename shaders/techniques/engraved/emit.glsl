#include "perFragment/emit"
vFieldPoint = objectToField * (anchorPosition - fieldOrigin);
vFieldNormal = objectToFieldNormal * strokeNormal;
vViewToField = objectToField * viewToAnchor;
vViewUnitsPerPixel = unitsPerPixel(mat3(1.0), mvPosition);

// The light as the whole mesh sees it, not each of its bones: lines would break at joints. The first bone stands for the mesh.
mat4 restToObject = mat4(1.0);
#if defined(USE_SKINNING) && STROKE_ANCHOR == STROKE_ANCHOR_REST
  mat4 firstBone = bindMatrixInverse * getBoneMatrix(0.0) * bindMatrix;
  if (determinant(mat3(firstBone)) != 0.0) restToObject = firstBone;
#endif // USE_SKINNING
mat4 restToView = objectToView * restToObject;
vFieldLight = fieldLight(objectToField * inverse(mat3(restToView)), (restToView * vec4(fieldOrigin, 1.0)).xyz, vec3(0.0));
