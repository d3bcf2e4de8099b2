import { Mesh, PlaneGeometry, Scene } from 'three';
import { expect, test } from 'vitest';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../../src/material/HatchingShadowMaterial.js';
import type { Lamp } from '../../../../src/vector/shading/radiance.js';
import { surfaceLookOf } from '../../../../src/vector/svg/readLook.js';
import { type Illumination, ToneReader } from '../../../../src/vector/ToneReader.js';
import { Ground } from '../../../../src/viewer/sceneSetup/Ground.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { firstView } from '../../../../src/viewer/settings/presets.js';

const AROUND = { ambient: 0, skies: [], probes: new Float64Array(9), environment: null };

/** The tone of a full shadow on a ground at what casts it, under one light. @param elevation of the light, degrees */
function shadowUnder(material: HatchingShadowMaterial, elevation: number): number {
  const angle = (elevation * Math.PI) / 180;
  const lamp: Lamp = {
    ...{ luminance: Math.PI, at: [Math.cos(angle), Math.sin(angle), 0], isFar: true },
    ...{ distance: 0, decay: 0, cone: null, castsShadow: true },
  };
  const light = { lamps: [lamp], shadows: [{}], isSoft: false, around: AROUND, bias: 0 } as unknown as Illumination;
  const mesh = new Mesh(new PlaneGeometry(), material);
  mesh.receiveShadow = true;
  const look = surfaceLookOf(material, mesh, { scale: 1, offset: 0 } as Parameters<typeof surfaceLookOf>[2], null);
  const projection = { eye: [0, 5, 5], backwards: [0, 0, 1], isOrthographic: false };
  const reader = new ToneReader(look, light, {} as never, projection as never);
  const place = { world: [0, 0, 0], toneNormal: [0, 1, 0], isPlane: true, occlusion: 0, paint: null };
  return reader.read(place as unknown as Parameters<ToneReader['read']>[0], 'all').tone;
}

test('the shadow on the ground is as dark under a low light as under a high one', async () => {
  const shadow = new HatchingShadowMaterial();
  let whenReady = (): void => {};
  const ready = new Promise<void>((resolve) => {
    whenReady = resolve;
  });
  const ground = new Ground(new Scene(), whenReady, { floor: new HatchingMaterial(), shadow });
  const look = lookOf(firstView());
  expect(look.ground).toBe('shadow');
  expect(look.drawn.reflectedLight).toBeGreaterThan(0);
  ground.apply(look);
  await ready;
  const high = shadowUnder(shadow, 60);
  expect(high).toBeGreaterThan(0.2);
  for (const elevation of [1, 5, 20, 80]) expect(shadowUnder(shadow, elevation), `${elevation}`).toBeCloseTo(high, 3);
});
