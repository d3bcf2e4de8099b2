#include "perFragment/varyings"
varying vec3 vToViewer; // object space, of any length
