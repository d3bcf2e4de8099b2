import { ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import { baseName } from '../../viewer/files/common/ModelFile.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import type { FetchMessage } from './fetchMain.js';

/** The file name of a URL, and its host in ASCII form, which has no look-alike letters. */
export function describeAddress(address: string): { name: string; site: string } {
  const { host, pathname } = new URL(address);
  let name = baseName(pathname);
  try {
    name = decodeURIComponent(name);
  } catch {
    // A name that cannot be decoded is shown as it is.
  }
  return { name: name || 'model', site: host };
}

/**
 * Fetches a model from another site, through a page in a hidden frame whose policy allows that. The caller must have asked the user.
 *
 * @throws ModelError with one sentence for the user
 */
export function fetchModel(
  address: string,
  { signal, onProgress }: { signal: AbortSignal; onProgress: (progress: number | undefined) => void },
): Promise<ModelFile> {
  const { name, site } = describeAddress(address);
  const shown = shownName(name);
  const frame = document.createElement('iframe');
  frame.hidden = true;
  frame.src = new URL('fetch/', document.baseURI).href;
  return new Promise<ModelFile>((resolve, reject) => {
    const end = (error?: unknown, content?: Blob): void => {
      removeEventListener('message', onMessage);
      // This also cancels the request.
      frame.remove();
      if (content) resolve({ name, content });
      else reject(error);
    };
    const onMessage = ({ source, origin, data }: MessageEvent<FetchMessage>): void => {
      if (source !== frame.contentWindow || origin !== location.origin) return;
      switch (data.kind) {
        case 'ready':
          frame.contentWindow?.postMessage({ address }, location.origin);
          return;
        case 'progress':
          onProgress(data.total && data.bytes / data.total);
          return;
        case 'done':
          end(undefined, data.content);
          return;
        case 'refused':
          end(new ModelError(`${site} has no such file: it answered ${data.status} for ${shown}.`));
          return;
        case 'too large':
          end(new ModelError(`${shown} has more than 512 MB, which is too much for a page.`));
          return;
        case 'redirected':
          end(
            new ModelError(
              `${shown} did not come: ${site} redirects to another site, to which you have not agreed. Download it there, and drop it here.`,
            ),
          );
          return;
        case 'failed':
          end(
            new ModelError(
              `${shown} did not come: ${site} cannot be reached, or does not let other pages fetch its files (CORS). Download it there, and drop it here.`,
            ),
          );
      }
    };
    addEventListener('message', onMessage);
    signal.addEventListener('abort', () => end(signal.reason), { once: true });
    document.body.append(frame);
  });
}
