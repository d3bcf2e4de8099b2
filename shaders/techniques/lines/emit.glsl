#include "perFragment/emit"
vFieldPoint = objectToField * (anchorPosition - fieldOrigin);
vFieldNormal = objectToFieldNormal * strokeNormal;
vRay = objectToField * (viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition));
vViewUnitsPerPixel = unitsPerPixel(mat3(1.0), mvPosition);

#ifdef FOLLOWS_FORM
  vForm = formVarying(formSlope, formValue.x, objectToFieldNormal, vFieldPoint);
  vFormCrossing = formVarying(formCrossing, formValue.y, objectToFieldNormal, vFieldPoint);
  #if DIRECTION == DIRECTION_ACROSS_FORM
    vec4 along = vForm;
    vForm = vFormCrossing;
    vFormCrossing = along;
  #endif // DIRECTION
#elif defined(TURNS_WITH_LIGHT) || defined(RUNS_AWAY)
  mat4 restToView = objectToView;
  mat3 viewToRest = viewToObject;
  #if defined(USE_SKINNING) && STROKE_ANCHOR == STROKE_ANCHOR_REST
    // The light in the space of the first bone, which stands for the mesh: by bone, lines would break at joints.
    mat4 firstBone = bindMatrixInverse * getBoneMatrix(0.0) * bindMatrix;
    if (determinant(mat3(firstBone)) != 0.0) {
      restToView = objectToView * firstBone;
      viewToRest = inverse(mat3(restToView));
    }
  #endif // USE_SKINNING
  vec4 light = fieldLight(objectToField * viewToRest, (restToView * vec4(fieldOrigin, 1.0)).xyz, vec3(0.0));
  #ifdef FIELD_BY_VERTEX
    Field field = firstField(light);
    vField = vec4(field.axis, field.bend);
    vFieldSide = across(field.axis);
  #else
    vFieldLight = light;
  #endif // FIELD_BY_VERTEX
#endif // FOLLOWS_FORM
