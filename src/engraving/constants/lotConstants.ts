/**
 * What random numbers of lines are made by, for the processor and, as defines, for the shaders: factors of words of 32 bits. Few bits of the
 * value of a line are set; multiplied by the golden ratio, they are spread evenly (Fibonacci hashing).
 */
export const LOT_FACTORS = { GOLDEN_RATIO: 0x9e3779b9, SECOND_FACTOR: 0x85ebca6b, THIRD_FACTOR: 0x2c1b3c6d } as const;
