/** @throws Error that names a file, its fault and the remedy */
export function fail(name: string, fault: string): never {
  throw new Error(`TonalArtMap.load: ${name} ${fault}.`);
}

/** Waits for work on a file. If it fails, the name of the file is put before the message of the error. */
export async function withFileName<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (error) {
    fail(name, error instanceof Error ? error.message : String(error));
  }
}
