/** A small break of the source, and the test that must fail with it. */
export interface Mutation {
  /** The broken behaviour, in a few words. */
  name: string;
  /** The broken file, from the root of the project. */
  file: string;
  /** The text to replace. It occurs once in the file. */
  find: string;
  replace: string;
  caughtBy: {
    /** The layer of tests, by its name in `npm test`. */
    layer: 'unit' | 'gpu' | 'visual' | 'e2e' | 'webgpu' | 'consumers';
    /** The file of the test, from the root of the project. */
    file: string;
    /** A part of the test's title. An `…` stands for whatever is between two parts. By default any test of the file may fail. */
    title?: string;
  };
}
