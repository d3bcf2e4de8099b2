/** Calls back when the browser is idle, which may be never. Browsers that cannot tell wait for a moment. */
const whenIdle = (run: () => void): unknown =>
  'requestIdleCallback' in window ? requestIdleCallback(run) : setTimeout(run, 200);

/**
 * Fetches the parts of the page that are not there yet, one after the other while it is idle, so that they open without a connection.
 * They are not run. A part that fails is fetched again when it is needed.
 */
export async function fetchRest(): Promise<void> {
  // Users who save data get only the parts that they use.
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
