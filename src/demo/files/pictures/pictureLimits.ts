/** Pixels of one picture: one of 44 kilobytes can decode to a gigabyte. */
export const MAX_PIXELS = 2 ** 26;
/** Of all pictures of a model together as they are in their files, which are decoded one after the other. */
export const MAX_TOTAL_PIXELS = 2 ** 28;
/** Of all pictures together as they are drawn: eight of 2,048 pixels square, 171 megabytes with their smaller levels. */
export const MAX_DRAWN_PIXELS = 2 ** 25;
export const MAX_DRAWN_SIDE = 4096;
