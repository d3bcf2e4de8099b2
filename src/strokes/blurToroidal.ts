/**
 * Blurs a toroidal field of size² numbers in both directions, with a tent filter of 2·radius + 1 texels that sums to one. `size` is a power
 * of two. Takes the same time for any radius.
 *
 * @param alongRows the radius along rows; by default the same
 */
export function blurToroidal(field: Float32Array, size: number, radius: number, alongRows = radius): Float32Array {
  return blurRows(blurRows(field, size, alongRows), size, radius);
}

/** Blurs the rows and transposes. Applied twice, it blurs both ways. */
function blurRows(field: Float32Array, size: number, radius: number): Float32Array {
  const mask = size - 1;
  const result = new Float32Array(field.length);
  const row = new Float64Array(size);
  const sums = new Float64Array(size);
  const width = radius + 1;
  const scale = 1 / (width * width);
  for (let start = 0, y = 0; y < size; y++, start += size) {
    for (let x = 0; x < size; x++) row[x] = field[start + x];
    // A tent filter is two box filters. After the first, sums[x] covers the texels from x − radius to x.
    boxFilter(row, sums, width, mask);
    boxFilter(sums, row, width, mask);
    for (let x = 0; x < size; x++) result[x * size + y] = row[(x + radius) & mask] * scale;
  }
  return result;
}

/** For each value the sum of the `width` values that end there, with wrap-around. */
function boxFilter(values: Float64Array, sums: Float64Array, width: number, mask: number): void {
  let sum = 0;
  for (let x = 1 - width; x <= 0; x++) sum += values[x & mask];
  sums[0] = sum;
  for (let x = 1; x <= mask; x++) {
    sum += values[x] - values[(x - width) & mask];
    sums[x] = sum;
  }
}
