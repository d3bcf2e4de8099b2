import { REVISION } from 'three';
import { version } from '../../../package.json';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import type { ModelStatistics } from '../../viewer/drawing/statistics.js';
import { extensionOf, withoutGz } from '../../viewer/files/common/ModelFile.js';
import { FORMATS } from '../../viewer/files/formats.js';
import { writeLink } from '../../viewer/settings/shareLink.js';
import type { Session } from '../session/Session.js';
import { rendererName } from '../viewport/graphicsCard.js';

/** Collects the facts for a bug report on a session. */
export function factsOf({ viewport, settings, modelLoader }: Session): string {
  const { canvas, context, view, model } = viewport;
  const meshes = model ? meshesOf(model.root) : [];
  const formed = meshes.filter(({ geometry }) => geometry.userData.hatching?.direction === 'form');
  return describeFacts({
    versions: { hatching: version, three: REVISION },
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

/** The facts in a bug report on the page, the machine and the drawing. */
export interface Facts {
  /** Versions of this library and of three.js, such as `0.1.0` and `187`. */
  versions: { hatching: string; three: string };
  /** The user agent string. */
  browser: string;
  /** Name of the graphics card and its driver, as far as the browser tells it. */
  graphics: string;
  /** Size of the drawing in CSS pixels, and device pixels per CSS pixel. */
  sheet: { width: number; height: number; pixelRatio: number };
  /** The name of a built-in model, or the names of the user's files, of which only the extensions are reported. */
  model: string | readonly string[];
  statistics: ModelStatistics | undefined;
  /** The number of meshes, and of those baked with form lines. */
  meshes: { all: number; formed: number };
  /** The settings as the text of a link, without the address of a model and the user's names for views. */
  settings: string;
}

/** Formats the facts as lines of text for a report. */
export function describeFacts({
  versions,
  browser,
  graphics,
  sheet,
  model,
  statistics,
  meshes,
  settings,
}: Facts): string {
  const lines: [string, string][] = [
    ['three-hatching', versions.hatching],
    ['three.js', `r${versions.three}`],
    ['Browser', browser],
    ['Graphics', graphics],
    ['Sheet', `${sheet.width} × ${sheet.height} CSS pixels, pixel ratio ${Number(sheet.pixelRatio.toFixed(3))}`],
    ['Model', typeof model === 'string' ? model : describeFiles(model)],
    ['Mesh', statistics ? describeMesh(statistics) : 'none'],
    ['Lines along the form', `on ${meshes.formed} of ${meshes.all} meshes`],
    ['Settings', settings],
  ];
  return `${lines.map(([name, value]) => `${name}: ${value}`).join('\n')}\n`;
}

function describeFiles(names: readonly string[]): string {
  const extensions = new Set(names.map((name) => extensionOf(withoutGz(name))));
  const formats = FORMATS.filter((format) => format.extensions.some((extension) => extensions.has(extension)));
  return `own, ${formats.map(({ name }) => name).join(' and ') || 'of another format'}, in ${names.length} ${names.length === 1 ? 'file' : 'files'}`;
}

const describeMesh = ({ triangles, borderEdges, nonManifoldEdges, degenerateTriangles }: ModelStatistics): string =>
  [
    `${triangles} triangles`,
    `${borderEdges} border edges`,
    `${nonManifoldEdges} non-manifold edges`,
    `${degenerateTriangles} without area`,
  ].join(', ');
