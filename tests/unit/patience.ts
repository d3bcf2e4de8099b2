import { vi } from 'vitest';

/** How long tests wait for what comes on its own, in milliseconds: it comes within a fraction of that on the busiest machine. */
const PATIENCE = 60_000;

/** Waits until a check passes, for something that comes on its own. */
export const eventually = (check: () => void): Promise<void> => vi.waitFor(check, PATIENCE);
