// The deformation pass: writes the pose of one vertex.
layout(location = 0) out highp vec4 position;
layout(location = 1) out highp vec4 normal;
layout(location = 2) out highp vec4 turn;

flat varying vec3 vPosition;
flat varying vec3 vNormal;
flat varying vec4 vTurn;

void main() {
  position = vec4(vPosition, 1.0);
  normal = vec4(vNormal, 0.0);
  turn = vTurn;
}
