/** @throws Error that names a file and says what is wrong with it and what to do */
export function fail(name: string, fault: string): never {
  throw new Error(`TonalArtMap.load: ${name} ${fault}.`);
}

/** Waits for work on a file. Puts the file's name before the message of an error. */
export async function withFileName<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (error) {
    fail(name, error instanceof Error ? error.message : String(error));
  }
}
