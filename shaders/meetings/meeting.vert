// Lines where parts meet that move, over the whole screen: the main function of the vertex shader stage of outlines.
varying vec3 vMeetingLight; // towards the light, unit, view space; 0 if no light has a direction

void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
  vec3 light = meanLight((modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0)).xyz);
  vMeetingLight = light / max(length(light), 1e-20);
}
