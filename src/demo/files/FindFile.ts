/** Bytes of a file of the drop by the name another file uses for it, or undefined. */
export type FindFile = (uri: string) => Promise<Uint8Array | undefined>;
