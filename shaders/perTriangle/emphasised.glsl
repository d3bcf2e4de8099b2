// The paper's drawings have the same weight all over.
#define emphasised(tone) tone
#define emphasisedColor(color) color
