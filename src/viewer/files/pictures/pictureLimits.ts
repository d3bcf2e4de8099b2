/** The most pixels of one picture: a file of 44 kilobytes can decode to a gigabyte. */
export const MAX_PIXELS = 2 ** 26;
/** The most pixels of all pictures of a model together in their files. They are decoded one after the other. */
export const MAX_TOTAL_PIXELS = 2 ** 28;
/** The most pixels of all pictures together as they are drawn: eight of 2,048 pixels square take 171 megabytes with their mipmaps. */
export const MAX_DRAWN_PIXELS = 2 ** 25;
export const MAX_DRAWN_SIDE = 4096;
