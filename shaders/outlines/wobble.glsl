// The unsteadiness of a hand: a slow shift on the screen that belongs to the place on the object.
uniform float wobble; // pixels
uniform float radius; // of the bounding sphere, object units

// Waves of about a third of the radius in three directions, whose phases bend one another so that nothing seems to repeat.
// The numbers mean nothing: they are directions and phases without a pattern.
vec2 wobbleAt(const in vec3 anchor) {
  vec3 p = anchor / radius;
  float a = sin(dot(p, vec3(11.3, 7.1, -5.9)) + 1.7 * sin(dot(p, vec3(-4.3, 6.7, 9.1))));
  float b = sin(dot(p, vec3(-6.1, 9.7, 12.7)) + 1.3 * sin(dot(p, vec3(8.9, -3.7, 5.3))) + 2.0);
  float c = sin(dot(p, vec3(23.0, -19.0, 17.0)) + 4.0);
  return wobble * vec2(0.8 * a + 0.2 * c, 0.8 * b - 0.2 * c);
}

// How a hand presses along the way, from −1 to 1: in waves of about half the radius.
float pressureWave(const in vec3 anchor) {
  vec3 p = anchor / radius;
  return sin(dot(p, vec3(-5.3, 6.1, 7.9)) + 2.1 * sin(dot(p, vec3(4.7, 3.9, -6.7))));
}
