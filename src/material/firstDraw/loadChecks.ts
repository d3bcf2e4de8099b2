type LoadChecks = () => Promise<typeof import('./checkDraws.js')>;

/** Loads the checks of first draws and their messages, which nothing waits for. Undefined in production. */
export let loadChecks: LoadChecks | undefined;

/** Has first draws checked from now on. */
export function addChecks(load: LoadChecks): void {
  loadChecks = load;
}
