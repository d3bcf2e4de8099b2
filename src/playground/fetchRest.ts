/** Calls back when the browser is idle, or after a moment in browsers without requestIdleCallback. */
const whenIdle = (run: () => void): unknown =>
  'requestIdleCallback' in window ? requestIdleCallback(run) : setTimeout(run, 200);

/**
 * Fetches the remaining scripts of the page one at a time while the page is idle, so that they open without a connection. Does not run
 * them. A script that fails is fetched again when it is needed.
 */
export async function fetchRest(): Promise<void> {
  // In data-saving mode, only the parts in use are fetched.
  if ((navigator as { connection?: { saveData?: boolean } }).connection?.saveData) return;
  const response = await fetch('parts.json').catch(() => undefined);
  if (!response?.ok) return;
  for (const part of (await response.json()) as string[]) await fetchPart(part);
}

function fetchPart(address: string): Promise<void> {
  return new Promise((resolve) => {
    whenIdle(() => {
      const link = Object.assign(document.createElement('link'), { rel: 'modulepreload', href: address });
      const end = (): void => {
        link.remove();
        resolve();
      };
      link.addEventListener('load', end);
      link.addEventListener('error', end);
      document.head.append(link);
    });
  });
}
