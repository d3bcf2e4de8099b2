/** Loads the checks and their messages, which nothing waits for. */
export const loadChecks = () => import('./checkDraws.js');
