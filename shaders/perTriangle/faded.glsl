// The paper's techniques have no fading.
#define computeFading()
#define faded(tone) tone
#define fadedColor(color) color
