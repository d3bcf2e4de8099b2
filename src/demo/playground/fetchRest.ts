/** So long is a browser given to be idle: one that is never idle fetches nothing. */
const whenIdle = (run: () => void): unknown =>
  'requestIdleCallback' in window ? requestIdleCallback(run) : setTimeout(run, 200);

/**
 * Fetches the parts of the page that are not there yet, one after the other while it is idle, so that they open without a connection.
 * They are not run. What does not come is fetched again when it is needed.
 */
export async function fetchRest(): Promise<void> {
  // Who counts bytes gets what is used.
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
