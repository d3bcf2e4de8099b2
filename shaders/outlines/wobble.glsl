// The unsteadiness of a hand: a slow screen-space offset that is fixed to the object.
uniform float wobble; // pixels
uniform float radius; // of the bounding sphere, object units

// Sines in three directions, whose phases vary with one another, so that nothing seems to repeat.
vec2 wobbleAt(const in vec3 anchor) {
  vec3 p = anchor / radius;
  float a = sin(dot(p, STRAY_ACROSS) + ACROSS_BEND * sin(dot(p, ACROSS_BENT)));
  float b = sin(dot(p, STRAY_UP) + UP_BEND * sin(dot(p, UP_BENT)) + UP_PHASE);
  float c = sin(dot(p, STRAY_FINELY) + FINE_PHASE);
  return wobble * vec2(STRAY_SHARES.x * a + STRAY_SHARES.y * c, STRAY_SHARES.x * b - STRAY_SHARES.y * c);
}

// The pressure of the hand along the outline, from −1 to 1, in waves of about half the radius.
float pressureWave(const in vec3 anchor) {
  vec3 p = anchor / radius;
  return sin(dot(p, vec3(-5.3, 6.1, 7.9)) + 2.1 * sin(dot(p, vec3(4.7, 3.9, -6.7))));
}
