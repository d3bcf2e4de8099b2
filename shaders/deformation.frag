// Position and normal of one vertex.
layout(location = 0) out highp vec4 position;
layout(location = 1) out highp vec4 normal;

flat varying vec3 vPosition;
flat varying vec3 vNormal;

void main() {
  position = vec4(vPosition, 1.0);
  normal = vec4(vNormal, 0.0);
}
