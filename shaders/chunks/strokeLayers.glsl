// Whether layers cross where several lights disagree about the direction, which one layer cannot serve. With one light there
// is nothing to disagree about, and no code for it.
#define LAYERS_BY_LIGHTS (STROKE_LAYERS == STROKE_LAYERS_LIGHTS && LIGHTS_WITH_DIRECTION > 1)
