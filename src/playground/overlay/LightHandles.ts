import { acceptSetting, SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { placeOfLight, placeOfSecondLight } from '../../viewer/settings/settingValues.js';
import { page } from '../page/page.js';
import type { Viewport } from '../viewport/Viewport.js';
import { LightHandle } from './LightHandle.js';

/** The handles of the two lights. Dragging them changes the settings. */
export class LightHandles {
  private readonly first: LightHandle;
  private readonly second: LightHandle;

  /** @param onChange called after each change, with the name of the handle */
  constructor(
    viewport: Viewport,
    private readonly settings: Settings,
    onChange: (source: string) => void,
  ) {
    const change = (source: string, values: Partial<Settings>): void => {
      // Rounds like controls and links, so that a link restores exactly this drawing.
      for (const [key, value] of Object.entries(values))
        Object.assign(settings, { [key]: acceptSetting(key as keyof Settings, value) });
      onChange(source);
    };
    const common = {
      viewport: page.viewport,
      camera: viewport.camera,
      framedPoints: () => viewport.view.framedPoints,
      framedCount: () => viewport.view.framedCount,
      isWithViewer: () => settings.lightFollows === 'viewer',
      onDrag: (dragging: boolean) => {
        viewport.view.controls.enabled = !dragging;
        if (dragging) page.lamp.classList.add('is-known');
      },
    };
    this.first = new LightHandle(page.lamp, {
      ...common,
      name: 'Light',
      lightPosition: viewport.scenery.lights.position,
      place: () => placeOfLight(settings),
      home: () => ({
        azimuth: SETTINGS.lightAzimuth.default,
        elevation: SETTINGS.lightElevation.default,
        distance: SETTINGS.lightDistance.default,
      }),
      onMove: ({
        azimuth = settings.lightAzimuth,
        elevation = settings.lightElevation,
        distance = settings.lightDistance,
      }) => change('lamp', { lightAzimuth: azimuth, lightElevation: elevation, lightDistance: distance }),
    });
    const secondPlace = () => placeOfSecondLight(settings) ?? { azimuth: 0, elevation: 0 };
    this.second = new LightHandle(page.secondLamp, {
      ...common,
      name: 'Second light',
      lightPosition: viewport.scenery.lights.secondPosition,
      place: secondPlace,
      home: () => ({ azimuth: SETTINGS.secondAzimuth.default, elevation: SETTINGS.secondElevation.default }),
      // Once the user moves it, the second light no longer follows the first.
      onMove: ({ azimuth = secondPlace().azimuth, elevation = secondPlace().elevation }) =>
        change('second lamp', { secondLight: 'free', secondAzimuth: azimuth, secondElevation: elevation }),
    });
  }

  /** Moves the handles to the lights' positions in the picture. Call this after each frame, and while one is delayed. */
  update(): void {
    page.secondLamp.hidden = page.lamp.hidden || this.settings.secondLight === 'none';
    this.first.update();
    if (!page.secondLamp.hidden) this.second.update();
  }
}
