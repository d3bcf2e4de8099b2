// N_t, the normal that tone is computed from: face normals, several at once in some techniques, or one smooth normal.
#include "technique/faceNormals"

// The sign of a face: 1 in front, −1 at the back.
float seenSide(const in float faceDirection) {
  #ifdef DOUBLE_SIDED
    return faceDirection;
  #elif defined(FLIP_SIDED)
    return -1.0;
  #else
    return 1.0;
  #endif // DOUBLE_SIDED
}

// View space, facing the viewer. three.js has turned smoothNormal already.
#if TONE_NORMAL == TONE_NORMAL_SMOOTH
  #define ToneNormals vec3
  #define PerToneNormal float

  vec3 readToneNormals(const in vec3 smoothNormal, const in float faceDirection) {
    return smoothNormal;
  }
#else
  #define ToneNormals FaceNormals
  #define PerToneNormal PerFaceNormal

  FaceNormals readToneNormals(const in vec3 smoothNormal, const in float faceDirection) {
    return readFaceNormals(seenSide(faceDirection));
  }
#endif // TONE_NORMAL
