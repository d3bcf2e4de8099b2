/** The graphics context was lost. The caller that was saving the drawing explains what that means. */
export class LostContextError extends Error {}
