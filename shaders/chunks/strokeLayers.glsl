#define LIGHTS_WITH_DIRECTION (NUM_DIR_LIGHTS + NUM_SUN_LIGHTS + NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS)

// Whether layers cross where several lights disagree about the direction, which one layer cannot serve. With one light there
// is nothing to disagree about, and no code for it.
#define LAYERS_BY_LIGHTS (STROKE_LAYERS == STROKE_LAYERS_LIGHTS && LIGHTS_WITH_DIRECTION > 1)
