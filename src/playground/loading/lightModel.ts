import { MathUtils, Spherical } from 'three';
import { flatteringLight } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { counted } from '../../viewer/files/common/ModelError.js';
import { type ModelExtras, movedExtras } from '../../viewer/files/common/ModelExtras.js';
import { lightsOfFile, viewsOfFile } from '../../viewer/sceneSetup/ofFile.js';
import { isLitBy, lightOf, type SavedView } from '../../viewer/settings/CameraView.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import { acceptSetting, type Settings } from '../../viewer/settings/settings.js';
import type { Viewport } from '../viewport/Viewport.js';

/** Lights models, and creates views from the cameras and lights of their files. Fetched with the first model that needs it. */
export class FileLights {
  /** If the shown model is lit by its file's lights: the previous lights, the file's, and the light that suits the view. */
  private lit: Record<'before' | 'given' | 'found', SavedView['light']> | undefined;

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
  ) {}

  /** Lights the shown model, after removing the lights of the previous file. */
  light(): void {
    const { settings, viewport, lit } = this;
    if (lit && isLitBy(settings, lit.given)) Object.assign(settings, lit.before);
    const before = lightOf(settings);
    const found = lightModel(viewport, settings);
    this.lit = found && { before, given: lightOf(settings), found };
  }

  /** Looks through the first camera of the shown model's file, if it has one. */
  lookThroughCamera(): void {
    const { settings, viewport } = this;
    // Turns the model upright, and its cameras with it.
    viewport.apply(lookOf(settings));
    if (!viewport.model) return;
    const { views } = viewsOfFile(extrasInWorld(viewport.model).cameras, lightOf(settings), undefined);
    const place = views.find(({ camera }) => camera)?.camera;
    if (place) viewport.view.place = place;
  }

  /** The views of the most recently lit model's file, and notes on cameras and lights left out. */
  viewsOf(model: HatchedModel): { views: SavedView[]; notes: string[] } {
    const { cameras, lights } = extrasInWorld(model);
    const { views, leftOut } = viewsOfFile(cameras, lightOf(this.settings), this.lit?.found);
    const dark = this.lit ? (lightsOfFile(lights)?.leftOut ?? 0) : 0;
    const notes = [counted(leftOut, 'camera', 'left out'), counted(dark, 'light', 'left out')];
    return { views, notes: notes.filter(Boolean) };
  }
}

/**
 * Lights the shown model for its view, or by its file's lights, and applies the settings.
 *
 * @returns the light that suits the view, if the model is lit by its file instead
 */
export function lightModel(viewport: Viewport, settings: Settings): SavedView['light'] | undefined {
  // Turns the model upright before it is lit.
  viewport.apply(lookOf(settings));
  if (!viewport.model) return undefined;
  const { view } = viewport;
  const camera = view.isFramed ? view.roomiest : viewport.camera;
  const { direction } = flatteringLight(viewport.model.root, camera, { onGround: view.framedPoints });
  if (settings.lightFollows === 'viewer') direction.applyQuaternion(viewport.camera.quaternion.clone().invert());
  const { theta, phi } = new Spherical().setFromVector3(direction);
  const place = { lightAzimuth: MathUtils.radToDeg(theta), lightElevation: 90 - MathUtils.radToDeg(phi) };
  for (const key of ['lightAzimuth', 'lightElevation'] as const) {
    settings[key] = acceptSetting(key, place[key]) as number;
  }
  const found = lightOf(settings);
  const ofFile = lightsOfFile(extrasInWorld(viewport.model).lights);
  if (ofFile) Object.assign(settings, ofFile.settings);
  viewport.apply(lookOf(settings));
  // The shadow has changed.
  if (view.isFramed) view.frame();
  return ofFile && found;
}

/** The cameras and lights of a model's file, in the space of the upright model. */
export function extrasInWorld({ root, extras }: HatchedModel): ModelExtras {
  const { parent } = root;
  if (!parent) return extras;
  parent.updateWorldMatrix(true, false);
  return movedExtras(extras, parent.matrixWorld);
}
