import { viewSize } from '../page/page.js';
import { recordVideo } from '../video/recordVideo.js';
import { PictureSession } from '../viewport/PictureSession.js';
import { raiseCurtain } from './behindCurtain.js';
import type { SaveDrawing } from './download.js';
import { download } from './download.js';

/** Records the video by the settings, and shows its frames meanwhile. */
export const saveVideo: SaveDrawing = async (viewport, settings, name, report, signal) => {
  const view = viewSize();
  const curtain = raiseCurtain(viewport, settings.paper);
  try {
    const { content, extension, sentence } = await recordVideo(viewport, new PictureSession(viewport), settings, {
      ...{ view, name, signal },
      onProgress: (progress) => report('recording the video', progress),
      onFrame: curtain.show,
    });
    download(content, `${name}${extension}`);
    return sentence;
  } finally {
    curtain.lower();
  }
};
