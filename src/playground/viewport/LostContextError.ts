/** The graphics card has let go of the drawing. Who was saving it says what that means. */
export class LostContextError extends Error {}
