// The paper's techniques have no emphasis.
#define noteEmphasis()
#define emphasised(tone) tone
#define emphasisedColor(color) color
