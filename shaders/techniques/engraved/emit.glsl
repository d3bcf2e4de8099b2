#include "perFragment/emit"
vFieldPoint = objectToField * (anchorPosition - fieldOrigin);
vFieldNormal = objectToFieldNormal * strokeNormal;
vViewUnitsPerPixel = unitsPerPixel(mat3(1.0), mvPosition);

#ifdef FOLLOWS_FORM
  vForm = formVarying(formSlope, formValue.x, objectToFieldNormal, vFieldPoint);
  vFormCrossing = formVarying(formCrossing, formValue.y, objectToFieldNormal, vFieldPoint);
  #if LINE_FIELD == LINE_FIELD_ACROSS_FORM
    vec4 along = vForm;
    vForm = vFormCrossing;
    vFormCrossing = along;
  #endif // LINE_FIELD
#else
  mat4 restToView = objectToView;
  mat3 viewToRest = viewToObject;
  #if defined(USE_SKINNING) && STROKE_ANCHOR == STROKE_ANCHOR_REST
    // The light as the whole mesh sees it, not each of its bones: lines would break at joints. The first bone stands for the mesh.
    mat4 firstBone = bindMatrixInverse * getBoneMatrix(0.0) * bindMatrix;
    if (determinant(mat3(firstBone)) != 0.0) {
      restToView = objectToView * firstBone;
      viewToRest = inverse(mat3(restToView));
    }
  #endif // USE_SKINNING
  vFieldLight = fieldLight(objectToField * viewToRest, (restToView * vec4(fieldOrigin, 1.0)).xyz, vec3(0.0));
#endif // FOLLOWS_FORM
