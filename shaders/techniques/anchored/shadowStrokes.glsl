#include "turnedShadowLayer"
