// Whether a second layer crosses where several lights disagree about the direction. With one light there is no code for it.
#define LAYERS_BY_LIGHTS (STROKE_LAYERS == STROKE_LAYERS_LIGHTS && LIGHTS_WITH_DIRECTION > 1)
