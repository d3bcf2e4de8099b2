// The paper's drawings have the same weight all over.
#define noteEmphasis()
#define emphasised(tone) tone
#define emphasisedColor(color) color
