import { meshesOf } from '../../viewer/drawing/meshesOf.js';
import { writeLink } from '../../viewer/settings/shareLink.js';
import { VERSIONS } from '../code/versions.js';
import type { Session } from '../session/Session.js';
import { rendererName } from '../viewport/rendererName.js';
import { describeFacts } from './describeFacts.js';

/** Collects the facts for a bug report on a session. */
export function factsOf({ viewport, settings, modelLoader }: Session): string {
  const { canvas, context, view, model } = viewport;
  const meshes = model ? meshesOf(model.root) : [];
  const formed = meshes.filter(({ geometry }) => geometry.userData.hatching?.lineField === 'form');
  return describeFacts({
    versions: VERSIONS,
    browser: navigator.userAgent,
    graphics: rendererName(context),
    sheet: { width: canvas.clientWidth, height: canvas.clientHeight, pixelRatio: devicePixelRatio },
    model: modelLoader.ownFiles?.map(({ name }) => name) ?? settings.model,
    statistics: model?.statistics,
    meshes: { all: meshes.length, formed: formed.length },
    // Leaves out the address of a model and the names of views.
    settings: writeLink(settings, view.ownPlace),
  });
}
