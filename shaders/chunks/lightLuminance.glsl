// three declares luminance() for fragment shaders only; these are its Rec. 709 weights.
float lightLuminance(const in vec3 rgb) {
  return dot(rgb, vec3(0.2126, 0.7152, 0.0722));
}
