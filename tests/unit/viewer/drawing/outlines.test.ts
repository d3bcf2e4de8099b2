import {
  AnimationClip,
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  NumberKeyframeTrack,
  type Object3D,
  Texture,
} from 'three';
import { describe, expect, test, vi } from 'vitest';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { modelOfMesh } from '../../../../src/viewer/drawing/modelOfMesh.js';
import { modelOfScene } from '../../../../src/viewer/drawing/modelOfScene.js';
import { type Look, lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

const OPTIONS = { signal: new AbortController().signal, onProgress: () => {} };

function outlinesIn(root: Object3D): HatchingOutlines[] {
  const outlines: HatchingOutlines[] = [];
  root.traverse((object) => {
    if (object instanceof HatchingOutlines) outlines.push(object);
  });
  return outlines;
}

const lookWith = (some: Partial<Settings>): Look => lookOf({ ...defaultSettings(), ...some });

async function hatchedBox() {
  const { attributes, index } = new BoxGeometry();
  const positions = Float32Array.from(attributes.position.array);
  const indices = Uint32Array.from(index!.array);
  return modelOfMesh({ positions, indices, normals: null, colors: null }, OPTIONS);
}

/** Two plain meshes, one of which is drawn several times, one that deforms, and a card with leaves cut out of it. */
function someScene(): Group {
  const material = new MeshStandardMaterial();
  const instances = new InstancedMesh(new BoxGeometry(), material, 2);
  instances.setMatrixAt(1, new Matrix4().makeTranslation(2, 0, 0));
  const morphed = new BoxGeometry();
  const raised = Float32Array.from(morphed.getAttribute('position').array, (x) => 2 * x);
  morphed.morphAttributes.position = [new Float32BufferAttribute(raised, 3)];
  const leaves = new MeshStandardMaterial({ alphaTest: 0.5, map: new Texture() });
  const card = new Mesh(new BoxGeometry(1, 1, 0.01), leaves);
  card.name = 'card';
  return new Group().add(new Mesh(new BoxGeometry(), material), instances, new Mesh(morphed, material), card);
}

describe('the outlines of a model', () => {
  test('are as wide as the settings say, times the scale of the picture', async () => {
    const model = await hatchedBox();
    const [outlines] = outlinesIn(model.root);
    const look = lookWith({ outlineWidth: 2, outlineHand: 2, ink: '#203080' });
    model.apply(look);
    model.setWidths(look, 1);
    const { overshoot } = outlines.material;
    model.setWidths(look, 3);
    expect(outlines.material).toMatchObject({ outlineWidth: 6, wobble: 6, overshoot: 3 * overshoot });
    expect(outlines.material.ink.getHexString()).toBe('203080');
    expect(overshoot).toBeGreaterThan(0);
    model.dispose();
  });

  test('are freed with the model', async () => {
    const model = await hatchedBox();
    const [outlines] = outlinesIn(model.root);
    let freed = 0;
    for (const one of [outlines.geometry, outlines.material]) one.addEventListener('dispose', () => freed++);
    model.dispose();
    expect(freed).toBe(2);
  });

  test('are drawn unless they are switched off or a debug view is shown', async () => {
    const model = await hatchedBox();
    const [outlines] = outlinesIn(model.root);
    const visibleWith = (some: Partial<Settings>): boolean => {
      model.apply(lookWith(some));
      return outlines.visible;
    };
    expect(visibleWith({})).toBe(true);
    expect(visibleWith({ outlines: 'off' })).toBe(false);
    expect(visibleWith({ debugView: 'tone' })).toBe(false);
    expect(visibleWith({ compare: 'triangle' })).toBe(true);
    model.dispose();
  });

  test('belong to every mesh of a scene, cut-outs included, and share a material where their surfaces do, unless a mesh deforms', async () => {
    const { model } = await modelOfScene({ root: someScene(), animations: [] }, { ...OPTIONS, onGeometry: () => {} });
    const outlines = outlinesIn(model.root);
    expect(outlines).toHaveLength(4);
    expect(outlines.map(({ mesh }) => mesh?.name)).toContain('card');
    expect(new Set(outlines.map(({ material }) => material)).size).toBe(3);
    model.setWidths(lookWith({ outlineWidth: 5 }), 1);
    for (const { material } of outlines) expect(material.outlineWidth).toBe(5);
    model.dispose();
    expect(outlinesIn(model.root)).toEqual([]);
  });
});

test.each(['sketch', 'ink', 'colour', 'shadow', 'strokes', 'outline'] as const)(
  'after the part %s of a picture, the model is whole again',
  async (part) => {
    const model = await hatchedBox();
    const look = lookWith({ outlines: 'on', compare: 'triangle' });
    model.apply(look);
    model.useMaterials('compared');
    const [mesh] = meshesOf(model.root);
    const compared = mesh.material as HatchingMaterial;
    model.useMaterials('drawn');
    const materials = [mesh.material as HatchingMaterial, compared];
    const state = () => ({
      materials: materials.map(({ paperOpacity, blending, premultipliedAlpha, colorWrite, toneCurve }) => {
        return { paperOpacity, blending, premultipliedAlpha, colorWrite, toneCurve };
      }),
      outlines: outlinesIn(model.root).map(({ visible }) => visible),
      castShadow: mesh.castShadow,
    });
    const whole = state();
    expect(whole.outlines).toEqual([true]);
    expect(whole.materials[0].toneCurve).toEqual(whole.materials[1].toneCurve);
    model.show(part);
    expect(state()).not.toEqual(whole);
    expect(state().outlines).toEqual([part === 'ink' || part === 'outline']);
    model.show(part, false);
    expect(state().outlines).toEqual([false]);
    model.show('whole');
    expect(state()).toEqual(whole);
    model.show(part);
    model.apply(look);
    expect(state()).toEqual(whole);
    model.dispose();
  },
);

test('a clip may move the shapes of a mesh that cannot be seen', async () => {
  const scene = someScene();
  const hidden = new BoxGeometry();
  hidden.morphAttributes.position = [hidden.getAttribute('position').clone()];
  const mesh = new Mesh(hidden, new MeshStandardMaterial({ transparent: true, opacity: 0 }));
  mesh.name = 'hidden';
  scene.add(mesh);
  const clip = new AnimationClip('wave', -1, [new NumberKeyframeTrack('hidden.morphTargetInfluences', [0, 1], [0, 1])]);
  const warned = vi.spyOn(console, 'warn');
  const errors = vi.spyOn(console, 'error');
  const { model } = await modelOfScene({ root: scene, animations: [clip] }, { ...OPTIONS, onGeometry: () => {} });
  model.motion!.time = 0.5;
  expect([...warned.mock.calls, ...errors.mock.calls]).toEqual([]);
  model.dispose();
});
