// N_t, which tone is computed from: the normals of the faces as the technique knows them, perhaps several at once, or one
// smooth normal. The chunks that follow work with either.
#include "technique/faceNormals"

// 1 where the front of the triangle is seen, −1 where its back is.
float seenSide(const in float faceDirection) {
  #ifdef DOUBLE_SIDED
    return faceDirection;
  #elif defined(FLIP_SIDED)
    return -1.0;
  #else
    return 1.0;
  #endif // DOUBLE_SIDED
}

// View space, turned towards the side that is seen. three has turned smoothNormal.
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
