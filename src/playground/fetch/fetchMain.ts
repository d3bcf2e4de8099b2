/** A message from the fetching page to the playground. */
export type FetchMessage =
  | { kind: 'ready' }
  | { kind: 'progress'; bytes: number; total: number | undefined }
  | { kind: 'done'; content: Blob }
  /** The server answered with an HTTP error. */
  | { kind: 'refused'; status: number }
  | { kind: 'too large' }
  /** The server redirected to another site, to which the user has not agreed. */
  | { kind: 'redirected' }
  /** The request failed. Browsers do not tell scripts why. */
  | { kind: 'failed' };

/**
 * Fetches one file for the playground, which loads this page in a hidden frame. The Content-Security-Policy of this page allows requests to
 * other sites; that of the playground does not.
 */

/** The maximum size of a model. */
const MAX_BYTES = 512 * 2 ** 20;

addEventListener('message', ({ origin, source, data }: MessageEvent<{ address: string }>) => {
  if (origin === location.origin && source === parent) void answer(data.address);
});
/** Whether this page's policy has blocked a request. */
let isForbidden = false;
addEventListener('securitypolicyviolation', () => {
  isForbidden = true;
});
say({ kind: 'ready' });

function say(message: FetchMessage): void {
  parent.postMessage(message, location.origin);
}

/** Limits all later requests of this page to one site, because the user has not agreed to sites that it may redirect to. */
function keepTo(site: string): void {
  const policy = Object.assign(document.createElement('meta'), {
    httpEquiv: 'Content-Security-Policy',
    content: `connect-src ${site}`,
  });
  document.head.append(policy);
}

async function answer(address: string): Promise<void> {
  keepTo(new URL(address).origin);
  try {
    const response = await fetch(address, { credentials: 'omit', referrerPolicy: 'no-referrer' });
    if (!response.ok || !response.body) say({ kind: 'refused', status: response.status });
    else await read(response.body, Number(response.headers.get('Content-Length')) || undefined);
  } catch {
    // The event about the policy violation comes in a task of its own.
    await new Promise((resolve) => setTimeout(resolve));
    say({ kind: isForbidden ? 'redirected' : 'failed' });
  }
}

async function read(body: ReadableStream<Uint8Array<ArrayBuffer>>, total: number | undefined): Promise<void> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  const reader = body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    bytes += part.value.length;
    if (bytes > MAX_BYTES) {
      await reader.cancel();
      say({ kind: 'too large' });
      return;
    }
    say({ kind: 'progress', bytes, total });
  }
  say({ kind: 'done', content: new Blob(parts) });
}
