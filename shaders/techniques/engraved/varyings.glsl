#include "perFragment/varyings"
varying vec3 vFieldLight; // towards the light, unit, object space; the same all over the object
