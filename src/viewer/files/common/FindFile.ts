/** Returns the bytes of a dropped file by the URI that another file refers to, or undefined. */
export type FindFile = (uri: string) => Promise<Uint8Array | undefined>;
