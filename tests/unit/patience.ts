/** How long tests wait for what comes on its own, in milliseconds: it comes within a fraction of that on the busiest machine. */
export const PATIENCE = 60_000;
