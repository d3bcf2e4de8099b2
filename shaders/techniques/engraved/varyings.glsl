#include "perFragment/varyings"

// Field space: that of the object, or one for all objects of a scene, from a common origin and in tiles.
varying vec3 vFieldPoint;
varying vec3 vFieldNormal; // at the scale of a stroke
varying float vViewUnitsPerPixel;
varying vec4 vFieldLight; // towards the light, unit; and one over its distance, 0 without an end; the same all over the object
