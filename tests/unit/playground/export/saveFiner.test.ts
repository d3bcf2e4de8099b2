import { BufferGeometry, Group, Mesh } from 'three';
import { beforeEach, expect, test, vi } from 'vitest';
import { finerModel } from '../../../../src/playground/export/finerModel.js';
import { saveFiner } from '../../../../src/playground/export/saveFiner.js';
import { savePicture } from '../../../../src/playground/export/savePicture.js';
import { PictureSession } from '../../../../src/playground/viewport/PictureSession.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

vi.mock('../../../../src/playground/export/finerModel.js', () => ({ finerModel: vi.fn() }));
vi.mock('../../../../src/playground/export/savePicture.js', () => ({ savePicture: vi.fn() }));

const SAVED = { kind: 'PNG', size: '10 × 20 px', pixelsPerRadius: 1000 };

/** A viewport with a simplified model, of which a finer geometry is read. */
function makeStage(simplified?: { triangles: number; error: number }) {
  const mesh = new Mesh();
  const frames = { isHeld: false };
  const viewport = {
    model: { root: new Group().add(mesh) },
    finer: undefined as BufferGeometry | undefined,
    quality: { finishSketch: () => {} },
    frames,
    scenery: { takeBack: vi.fn() },
    painter: { setShadowQuality: () => {} },
    changes: 0,
    outdateShadows: vi.fn(),
    resize: vi.fn(),
  };
  const geometry = new BufferGeometry();
  const dispose = vi.spyOn(geometry, 'dispose');
  vi.mocked(finerModel).mockResolvedValue({ geometry, triangles: 3_960_000, simplified });
  const { signal } = new AbortController();
  const save = (settings = {}) =>
    saveFiner([])(viewport as never, { ...defaultSettings(), ...settings }, 'scan', () => {}, signal);
  return { viewport, mesh, geometry, dispose, save };
}

beforeEach(() => {
  vi.mocked(savePicture).mockReset();
  vi.mocked(savePicture).mockResolvedValue(SAVED);
});

test('a picture uses the finer geometry, which is freed when frames resume', async () => {
  const { viewport, mesh, geometry, dispose, save } = makeStage({ triangles: 10_000_000, error: 0.0006 });
  const shown = mesh.geometry;
  vi.mocked(savePicture).mockImplementation(async () => {
    const session = new PictureSession(viewport as never);
    expect(mesh.geometry).toBe(shown);
    session.hold(1000);
    expect([mesh.geometry, viewport.frames.isHeld]).toEqual([geometry, true]);
    // Nodes may have drawn the frames.
    expect(viewport.scenery.takeBack).toHaveBeenCalledOnce();
    session.release();
    expect([mesh.geometry, viewport.frames.isHeld]).toEqual([shown, false]);
    // Shadows are those of the geometry, both times.
    expect(viewport.outdateShadows).toHaveBeenCalledTimes(2);
    expect(dispose).not.toHaveBeenCalled();
    return SAVED;
  });
  expect(await save()).toBe('Saved as PNG from 4.0 million triangles: up to 0.6 px off.');
  expect(dispose).toHaveBeenCalledOnce();
  expect(viewport.finer).toBeUndefined();
});

test('a picture of all triangles says so', async () => {
  expect(await makeStage().save()).toBe('Saved as PNG from all triangles: 10 × 20 px.');
  const { save } = makeStage();
  expect(await save({ technique: 'engraving', direction: 'form' })).toBe(
    'Saved as PNG from all triangles, lines laid anew: 10 × 20 px.',
  );
});

test('without a finer geometry, pictures are drawn of the one that frames show', () => {
  const { viewport, mesh } = makeStage();
  const shown = mesh.geometry;
  const session = new PictureSession(viewport as never);
  session.hold(1000);
  expect(mesh.geometry).toBe(shown);
  session.release();
  expect(viewport.outdateShadows).not.toHaveBeenCalled();
});

test('the finer geometry is freed if the picture fails, or another model was opened', async () => {
  const failing = makeStage();
  vi.mocked(savePicture).mockRejectedValueOnce(new Error('lost'));
  await expect(failing.save()).rejects.toThrow('lost');
  expect([failing.dispose.mock.calls.length, failing.viewport.finer]).toEqual([1, undefined]);
  const other = makeStage();
  const saving = other.save();
  other.viewport.model = { root: new Group() };
  await expect(saving).rejects.toThrow('another model was opened meanwhile');
  expect(other.dispose).toHaveBeenCalledOnce();
  expect(savePicture).toHaveBeenCalledOnce();
});
