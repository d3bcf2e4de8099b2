// L*/100 of a luminance in [0, 1] (CIE 1976).
float lightness(const in float y) {
  return y < 216.0 / 24389.0 ? y * 9.032963 : 1.16 * pow(y, 1.0 / 3.0) - 0.16;
}
