import { download, type SaveDrawing } from '../export/download.js';
import { coverCanvas } from '../export/drawCovered.js';
import { viewSize } from '../page/page.js';
import { PictureSession } from '../viewport/PictureSession.js';
import { recordVideo } from './recordVideo.js';

/** Records the video by the settings, and shows its frames meanwhile. */
export const saveVideo: SaveDrawing = async (viewport, settings, name, report, signal) => {
  const view = viewSize();
  const cover = coverCanvas(viewport, settings.paper);
  try {
    const { content, extension, sentence } = await recordVideo(viewport, new PictureSession(viewport), settings, {
      ...{ view, name, signal },
      onProgress: (progress) => report('recording the video', progress),
      onFrame: cover.show,
    });
    download(content, `${name}${extension}`);
    return sentence;
  } finally {
    cover.remove();
  }
};
