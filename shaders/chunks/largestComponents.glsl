// Marks the largest component of a vector with 1, and the two largest. Ties go the same way in all components, so that there is
// always exactly one, and exactly two.
void largestComponents(const in vec3 v, out vec3 largest, out vec3 twoLargest) {
  vec3 greater = step(v.yzx, v.xyz);
  vec3 less = 1.0 - greater;
  largest = min(greater, less.zxy);
  twoLargest = max(greater, less.zxy);
}
