// How many layers of strokes a surface can need. Where several lights disagree about the direction, one cannot serve them
// all: a second layer crosses the first. With one light there is nothing to disagree about, and no code for it.
#define LIGHTS_WITH_DIRECTION (NUM_DIR_LIGHTS + NUM_SUN_LIGHTS + NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS)
#if defined(SECOND_LAYER) && LIGHTS_WITH_DIRECTION > 1
  #define STROKE_LAYERS 2
#else
  #define STROKE_LAYERS 1
#endif // SECOND_LAYER
