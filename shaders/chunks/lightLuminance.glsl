// Luminance by the weights of Rec. 709, for both shaders: three.js declares luminance() for fragment shaders only.
float lightLuminance(const in vec3 rgb) {
  return dot(rgb, vec3(0.2126, 0.7152, 0.0722));
}
