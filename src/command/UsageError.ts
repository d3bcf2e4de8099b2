/** A mistake in the command line, which is reported without a stack trace. */
export class UsageError extends Error {}
