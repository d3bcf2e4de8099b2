AdjacencyPrimitive drawn = readDrawnPrimitive();
AdjacencyPrimitive anchor = readAnchorPrimitive(drawn);
AdjacencyTurns turns = readTurns();
vec3 anchorPosition = readAnchorPosition(readDrawnPosition(transformed));
vec3 normalC = normalOf(triangleC(drawn));
vec3 strokesC = strokeCoordinates(
  anchorPosition, triangleC(anchor), triangleC(drawn), normalC, turns.c, objectToView, viewToObject
);
#if LEVEL_RULE == LEVEL_RULE_DEPTH
  vUnitsPerPixel = unitsPerPixel(viewToObject, mvPosition);
#endif // LEVEL_RULE
