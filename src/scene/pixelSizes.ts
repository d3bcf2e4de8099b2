/** The properties of `HatchingMaterial` and `HatchingLineMaterial` that are measured in pixels of the drawing buffer. */
export const STROKE_SIZES = ['strokeWidth', 'lineSpacing', 'texelPixels', 'toothSize'] as const;
export const LINE_SIZES = ['lineWidth', 'wobble', 'overshoot', 'toothSize'] as const;
