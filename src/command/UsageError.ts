/** A mistake in the command line, reported without a stack trace. */
export class UsageError extends Error {}
