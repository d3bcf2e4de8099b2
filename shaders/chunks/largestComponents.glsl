// Masks of the largest component of a vector and of the two largest. Ties are broken consistently, so that exactly one and exactly two are
// set.
void largestComponents(const in vec3 v, out vec3 largest, out vec3 twoLargest) {
  vec3 greater = step(v.yzx, v.xyz);
  vec3 less = 1.0 - greater;
  largest = min(greater, less.zxy);
  twoLargest = max(greater, less.zxy);
}
