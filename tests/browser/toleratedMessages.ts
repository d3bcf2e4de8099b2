/** Console messages that are the browser's remarks about itself. Every other warning or error fails the test. */
export const toleratedMessages: readonly { pattern: RegExp; reason: string }[] = [
  {
    pattern: /GPU stall due to ReadPixels/,
    reason: 'Reading pixels back is what the tests are for.',
  },
];
