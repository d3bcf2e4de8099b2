import type { PNG } from 'pngjs';
import { drop, follow, openPlayground, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { BOX_CORNERS, BOX_FACES } from '../../tools/modelFiles/box.js';
import { tetrahedron } from '../../tools/modelFiles/GltfBuilder.js';
import {
  file,
  largeTorus,
  octahedronAsciiStl,
  octahedronBin,
  octahedronBinaryStl,
  octahedronDracoGlb,
  octahedronGlb,
  octahedronGltf,
  octahedronMeshoptGlb,
  octahedronMtl,
  octahedronObj,
  octahedronPly,
  skyPng,
  squareMtl,
  squareObj,
  type TestFile,
} from '../../tools/modelFiles/modelFiles.js';
import { dae, fbx, usda, zip } from '../../tools/modelFiles/sceneWriters.js';
import { expect, test } from '../browser/test.js';
import { cases } from '../selection.mjs';
import { changedShare, meanInk, WHOLE } from './pictures.js';

test.use({ viewport: { width: 400, height: 300 } });

/** A model and a map that are made in no time. */
const SMALL = 'model=cube&mapSize=64&mapTones=4&outlines=off';

test('models of every format are drawn when dropped', { tag: '@more' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  const before = await readDrawing(page);
  const formats: [name: string, statistics: string, files: TestFile[]][] = [
    ['octahedron.glb', '16 triangles', [file('octahedron.glb', octahedronGlb())]],
    ['octahedron.obj', '8 triangles', [file('octahedron.obj', octahedronObj), file('octahedron.mtl', octahedronMtl)]],
    ['octahedron.ply', '8 triangles', [file('octahedron.ply', octahedronPly)]],
  ];
  const others: [name: string, statistics: string, files: TestFile[]][] = [
    [
      'octahedron.gltf',
      '16 triangles',
      [file('my shape.bin', octahedronBin()), file('octahedron.gltf', octahedronGltf('textures/../my%20shape.bin'))],
    ],
    ['meshopt.glb', '16 triangles', [file('meshopt.glb', await octahedronMeshoptGlb())]],
    ['draco.glb', '16 triangles', [file('draco.glb', await octahedronDracoGlb())]],
    ['binary.stl', '8 triangles', [file('binary.stl', octahedronBinaryStl())]],
    ['ascii.stl', '8 triangles', [file('ascii.stl', octahedronAsciiStl)]],
    // A moving model keeps its materials apart, with borders between them.
    ['box.fbx', '12 triangles, 24 border edges', [file('box.fbx', fbx(7300, true))]],
    ['box.dae', '12 triangles', [file('box.zip', Buffer.from(zip({ 'box.dae': dae() })))]],
    ['box.usdz', '12 triangles', [file('box.usdz', Buffer.from(zip({ 'box.usda': usda() }, 0)))]],
    ['misnamed.obj', '8 triangles', [file('misnamed.obj', octahedronPly)]],
  ];
  for (const [name, statistics, files] of [...formats, ...cases([], others)]) {
    await drop(page, files);
    await expect(page.locator('#model-name')).toHaveText(name);
    await expect(page.locator('#model-statistics')).toHaveText(statistics);
  }
  const after = await readDrawing(page);
  expect(changedShare(before, after)).toBeGreaterThan(0.1);
  expect(meanInk(after)).toBeGreaterThan(0.02);
});

test('parts of a model behind glass are drawn, and glass casts no shadow', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  const faces = (first: number): string =>
    BOX_FACES.map((face) => `f ${face.map((corner) => corner + first).join(' ')}`).join('\n');
  const corners = (scale: number): string =>
    BOX_CORNERS.map((corner) => `v ${corner.map((x) => scale * (x - 0.5)).join(' ')}`).join('\n');
  const obj = `mtllib shell.mtl\n${corners(1)}\n${corners(1.6)}\nusemtl inside\n${faces(1)}\nusemtl shell\n${faces(9)}\n`;
  const drawn = async (opacity: number): Promise<PNG> => {
    await drop(page, [
      file(`shell-${opacity}.obj`, obj.replaceAll('shell.mtl', `shell-${opacity}.mtl`)),
      file(`shell-${opacity}.mtl`, `newmtl inside\nKd 1 1 1\nnewmtl shell\nKd 1 1 1\nd ${opacity}\n`),
    ]);
    await expect(page.locator('#model-name')).toHaveText(`shell-${opacity}.obj`);
    return readDrawing(page);
  };
  const [opaque, glass] = [await drawn(1), await drawn(0.25)];
  // The space between the box and its shell is paper, except for a few strokes.
  expect(changedShare(opaque, glass)).toBeGreaterThan(0.1);
  expect(meanInk(glass)).toBeLessThan(0.7 * meanInk(opaque));
});

test('cameras, lights and variants of a glTF file can be chosen', { tag: '@all' }, async ({ page }) => {
  const builder = tetrahedron();
  const { json } = builder;
  json.cameras = [
    { type: 'perspective', name: 'close', perspective: { yfov: 0.3, znear: 0.1 } },
    { type: 'orthographic', name: 'plan', orthographic: { xmag: 2, ymag: 2, znear: 0, zfar: 20 } },
  ];
  json.nodes.push(
    { camera: 0, translation: [0, 0, 6] },
    { rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2], extensions: { KHR_lights_punctual: { light: 0 } } },
  );
  // From above, with the right of the model up.
  json.nodes.push({ camera: 1, translation: [0, 6, 0], rotation: [-0.5, -0.5, -0.5, 0.5] });
  json.scenes[0].nodes = [0, 1, 2, 3];
  json.materials = [{}, { pbrMetallicRoughness: { baseColorFactor: [0.01, 0.01, 0.01, 1] } }];
  json.extensions = {
    KHR_lights_punctual: { lights: [{ type: 'directional' }] },
    KHR_materials_variants: { variants: [{ name: 'white' }, { name: 'black' }] },
  };
  const mappings = [{ material: 1, variants: [1] }];
  Object.assign(json.meshes[0].primitives[0], { extensions: { KHR_materials_variants: { mappings } } });
  // Wide enough for the card.
  await page.setViewportSize({ width: 1000, height: 500 });
  await openPlayground(page, `${SMALL}&colorHatching=100`);
  await drop(page, [file('extras.glb', Buffer.from(builder.glb()))]);
  const views = page.getByRole('group', { name: 'Views' }).getByRole('button');
  await expect(views).toHaveText(['1Lights of the file', '2Light for the view', '3close', '4plan']);
  // It opens in its first camera.
  await expect(views.nth(2)).toHaveAttribute('aria-pressed', 'true');
  await views.first().click();
  await expect(views.first()).toHaveAttribute('aria-pressed', 'true');
  const first = await readDrawing(page);
  expect(new URLSearchParams(await writtenHash(page)).get('lightElevation')).toBe('89');
  await views.nth(1).click();
  const lit = await readDrawing(page);
  expect(changedShare(first, lit)).toBeGreaterThan(0.02);
  await views.nth(2).click();
  const close = await readDrawing(page);
  expect(changedShare(lit, close)).toBeGreaterThan(0.05);
  await views.nth(3).click();
  await expect(views.nth(3)).toHaveAttribute('aria-pressed', 'true');
  const plan = await readDrawing(page);
  expect(changedShare(close, plan)).toBeGreaterThan(0.05);
  expect(await writtenHash(page)).toMatch(/camera=[^&]*orthographic/);
  await page.locator('#drawing').press('+');
  expect(changedShare(plan, await readDrawing(page))).toBeGreaterThan(0.02);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(views.nth(3)).toHaveAttribute('aria-pressed', 'true');
  expect(changedShare(plan, await readDrawing(page))).toBe(0);
  await page.locator('#drawing').press('Home');
  await views.nth(2).click();
  expect(changedShare(close, await readDrawing(page))).toBe(0);
  await views.first().click();
  const variants = page.getByRole('group', { name: 'Variants of the model' }).getByRole('button');
  await expect(variants).toHaveText(['white', 'black']);
  await variants.nth(1).click();
  await expect(variants.nth(1)).toHaveAttribute('aria-pressed', 'true');
  const black = await readDrawing(page);
  expect(meanInk(black)).toBeGreaterThan(1.2 * meanInk(first));
  // The change is a step of undo, and the page's address restores it.
  expect(new URLSearchParams(await writtenHash(page)).get('variant')).toBe('2');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(variants.nth(1)).toHaveAttribute('aria-pressed', 'false');
  expect(changedShare(first, await readDrawing(page))).toBe(0);
  expect(await writtenHash(page)).not.toContain('variant');
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(variants.nth(1)).toHaveAttribute('aria-pressed', 'true');
  expect(await writtenHash(page)).toContain('variant=2');
  await page.reload();
  await expect(variants.nth(1)).toHaveAttribute('aria-pressed', 'true');
  expect(changedShare(black, await readDrawing(page))).toBe(0);
  await variants.nth(1).click();
  await expect(variants.nth(1)).toHaveAttribute('aria-pressed', 'false');
  expect(changedShare(first, await readDrawing(page))).toBe(0);
  await drop(page, [file('octahedron.obj', octahedronObj)]);
  await expect(page.getByRole('group', { name: 'Variants of the model' })).toBeHidden();
  await expect(views).toHaveCount(0);
});

test('a mirrored part of a model is not turned inside out', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  await drop(page, [file('octahedron.glb', octahedronGlb())]);
  await expect(page.locator('#model-statistics')).toHaveText('16 triangles');
  // A model that is opened gets a light of its own.
  await follow(page, 'model=file&lightAzimuth=0&lightElevation=60&camera=0,1,6,0,0,0');
  const picture = await readDrawing(page);
  // Lit from above. Turned inside out, the octahedron would be lighter below.
  const top = { ...WHOLE, bottom: 0.5 };
  const left = meanInk(picture, { ...top, right: 0.5 });
  const mirrored = meanInk(picture, { ...top, left: 0.5 });
  expect(left).toBeGreaterThan(0.005);
  expect(mirrored / left).toBeCloseTo(1, 0);
  const below = meanInk(picture, { ...WHOLE, top: 0.5, left: 0.5 });
  expect(below).toBeGreaterThan(1.5 * mirrored);
});

test('a picked file is drawn, with its colours and its picture', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, 'model=cube&camera=0,0,5,0,0,0');
  await page
    .locator('#file-input')
    .setInputFiles([file('octahedron.obj', octahedronObj), file('octahedron.mtl', octahedronMtl)]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.obj');
  const { data } = await readDrawing(page);
  let red = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] > 150 && data[i + 1] < 110) red++;
  expect(red).toBeGreaterThan(1000);

  await drop(page, [file('square.obj', squareObj), file('square.mtl', squareMtl), file('sky.png', skyPng())]);
  await expect(page.locator('#model-name')).toHaveText('square.obj');
  await follow(page, 'model=file&camera=0,0,5,0,0,0');
  const picture = await readDrawing(page);
  const count = { blue: 0, green: 0, blueUnderGreen: 0 };
  const greenColumns = new Set<number>();
  for (let i = 0; i < picture.data.length; i += 4) {
    const [, green, blue] = picture.data.subarray(i, i + 3);
    const column = (i / 4) % picture.width;
    if (green > blue + 100) {
      count.green++;
      greenColumns.add(column);
    }
    if (blue > green + 100) {
      count.blue++;
      if (greenColumns.has(column)) count.blueUnderGreen++;
    }
  }
  expect(count.blue).toBeGreaterThan(3000);
  expect(count.green).toBeGreaterThan(3000);
  expect(count.blueUnderGreen).toBeLessThan(300);
});

test('a file that cannot be read gives one clear sentence and leaves the drawing unchanged', async ({ page }) => {
  await openPlayground(page, SMALL);
  const before = await readDrawing(page);
  const glb = octahedronGlb();
  const points = octahedronPly.replace(/element face.*\nproperty list.*\n/, '').replace(/^3 .*\n/gm, '');
  const refused: [files: TestFile[], sentence: RegExp][] = [
    [[file('empty.glb', '')], /^empty\.glb is empty\.$/],
    [[file('page.stl', '<!DOCTYPE html><html><body>404</body></html>')], /^page\.stl is a web page, not a 3D model\.$/],
    [[file('photo.obj', Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'))], /^photo\.obj is a picture/],
    [[file('cut.glb', glb.subarray(0, glb.length - 40))], /^cut\.glb is cut short: it should have .* bytes/],
    [[file('alone.gltf', octahedronGltf('alone.bin'))], /^alone\.gltf needs alone\.bin; drop both files together\.$/],
    [
      [file('short.gltf', octahedronGltf('short.bin')), file('short.bin', Buffer.alloc(10))],
      /^short\.bin is cut short/,
    ],
    [
      [file('away.gltf', octahedronGltf('https://example.org/away.bin'))],
      /^away\.gltf needs away\.bin; drop both files together\.$/,
    ],
    [
      [file('loop.gltf', octahedronGltf('a.bin', { nodes: [{ children: [1], mesh: 0 }, { children: [0] }] }))],
      /^loop\.gltf is damaged: some of its nodes contain themselves\.$/,
    ],
    [[file('old.gltf', '{"asset":{"version":"1.0"}}')], /^old\.gltf is glTF version 1\.0/],
    [
      [
        file(
          'greedy.gltf',
          octahedronGltf('a.bin', {
            accessors: new Array(2).fill({ count: 1e8, componentType: 5125, type: 'VEC3' }),
          }),
        ),
        file('a.bin', octahedronBin()),
      ],
      /^greedy\.gltf asks for more memory/,
    ],
    [[file('points.ply', points)], /^points\.ply holds points but no triangles/],
    [
      [file('nan.obj', 'v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\nf 1 2 9\n')],
      /^None of the triangles .* valid corners\.$/,
    ],
    [[file('flat.obj', 'v 1 1 1\nf 1 1 1\n')], /^The model has no size/],
    [[file('lines.obj', 'v 0 0 0\nv 1 0 0\nl 1 2\n')], /^The file holds no triangles/],
    [[file('letter.txt', 'Dear all,')], /^letter\.txt is not a model this page can read/],
  ];
  for (const [files, sentence] of refused) {
    await drop(page, files);
    await expect(page.locator('#status')).toHaveText(sentence);
  }
  await ready(page);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
});

test('joining the triangles of a large model can be cancelled', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  const before = await readDrawing(page);
  // The click is made in the page, because the bake does not wait, and after the placeholder was drawn, which must be removed again.
  const shown = await page.evaluate(
    () =>
      new Promise<string>((resolve) => {
        location.hash = 'model=dragon1&mapSize=64&mapTones=4&outlines=off';
        let framesBefore = 0;
        const look = (): void => {
          const name = document.querySelector('#model-name')!.textContent!;
          const { framesDrawn } = window.__playground!;
          // The frame of the placeholder may be drawn by the time its name is seen.
          if (name === 'Cube') framesBefore = framesDrawn;
          const isJoining = /^Joining 871,414 triangles/.test(document.querySelector('#status')!.textContent!);
          if (!isJoining || name === 'Cube' || framesDrawn <= framesBefore) {
            requestAnimationFrame(look);
            return;
          }
          document.querySelector<HTMLButtonElement>('#cancel')!.click();
          resolve(name);
        };
        look();
      }),
  );
  expect(shown).toMatch(/dragon/i);
  await expect(page.locator('#status')).toHaveText('Cancelled; the drawing is as it was.');
  await ready(page);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  await expect(page.getByRole('button', { name: 'Cancel' })).toBeHidden();
  await page.getByRole('button', { name: 'Settings' }).click();
  await expect(page.getByRole('combobox', { name: 'Model', exact: true })).toHaveValue('Cube');
  await page.getByRole('button', { name: 'Settings' }).click();
  expect(changedShare(before, await readDrawing(page))).toBe(0);
});

test('a large model is drawn at once, before it is baked, and stays where it was when it is ready', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, SMALL);
  // Whether a frame has shown the model while there was work left, and how the model was framed then.
  await page.evaluate(() => {
    const seen = window as unknown as { __early?: Promise<number> };
    const before = window.__playground!.framesDrawn;
    let framesBefore = 0;
    seen.__early = new Promise((resolve) => {
      const look = (): void => {
        const { framesDrawn, isIdle } = window.__playground!;
        const isNamed = document.title.includes('torus');
        // The frame of the placeholder may be drawn by the time its name is seen.
        if (!isNamed) framesBefore = framesDrawn;
        if (document.documentElement.dataset.state === 'ready' && isIdle && framesDrawn > before) resolve(0);
        else if (isNamed && framesDrawn > framesBefore && document.documentElement.dataset.state === 'loading')
          resolve(1);
        else requestAnimationFrame(look);
      };
      look();
    });
  });
  await drop(page, [largeTorus()]);
  expect(await page.evaluate(() => (window as unknown as { __early: Promise<number> }).__early)).toBe(1);
  await ready(page);
  await expect(page.locator('#model-statistics')).toHaveText(/^\d+,\d+ triangles$/);
  await expect(page.locator('.earlier-picture')).toBeHidden();
});

test('a model that is opened while another is joined is framed, lit and shadowed as if there had been no other', {
  tag: '@all',
}, async ({ page }) => {
  const own = [file('octahedron.obj', octahedronObj)];
  await openPlayground(page, SMALL);
  await drop(page, own);
  const alone = await readDrawing(page);
  const link = await writtenHash(page);
  await follow(page, SMALL);
  await page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        location.hash = 'model=dragon1&mapSize=64&mapTones=4&outlines=off';
        const look = (): void => {
          if (/^Joining/.test(document.querySelector('#status')!.textContent!)) resolve();
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
  await expect(page.locator('#model-name')).toHaveText(/dragon/);
  await drop(page, own);
  await ready(page);
  expect(await writtenHash(page)).toBe(link);
  expect(changedShare(alone, await readDrawing(page))).toBe(0);
});

test('the caption says what is missing, whole, and all else is behind a button', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  const name = 'a square with a name that is as long as names of files get, more or less';
  const [obj, mtl] = [squareObj.replace('square.mtl', `${name}.mtl`), squareMtl.replace('sky.png', `${name}.png`)];
  const note = page.locator('#model-note');
  const about = page.getByLabel('Information about the model');
  const statistics = page.locator('#model-statistics');
  await drop(page, [file(`${name}.obj`, obj), file(`${name}.mtl`, mtl), file('other.obj', obj)]);
  await expect(note).toHaveText(/^a square.+….+less\.png is missing: drop it along; 1 more behind “i”$/);
  await expect(statistics).toBeHidden();
  for (const [width, height] of [
    [360, 640],
    [640, 360],
    [1440, 900],
  ]) {
    await page.setViewportSize({ width, height });
    await ready(page);
    // Every line of it is in sight, with nothing over it.
    const unseen = await note.evaluate(
      (element) =>
        [...element.getClientRects()].filter(({ left, right, top, bottom }) =>
          [left + 2, right - 2].some((x) => !element.contains(document.elementFromPoint(x, (top + bottom) / 2))),
        ).length,
    );
    expect.soft(unseen, `lines of the note that are cut at ${width} × ${height}`).toBe(0);
    await about.click();
    await expect(statistics).toBeInViewport({ ratio: 1 });
    await page.locator('#drawing').click({ position: { x: 20, y: 20 } });
    await expect(statistics).toBeHidden();
  }
  await about.focus();
  await page.keyboard.press('Enter');
  await expect(statistics).toHaveText('2 triangles, 4 border edges');
  await expect(page.getByText('one of 2 models: drop other.obj by itself to see it')).toBeVisible();
  await expect(page.locator('#frame-time')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(statistics).toBeHidden();
  await expect(about).toBeFocused();
  await drop(page, [file(`${name}.png`, skyPng())]);
  await expect(note).not.toHaveText(/missing/);
});

test('a model that is the wrong way up is turned, and left as written on request', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(page, SMALL);
  await drop(page, [file('cone.obj', lyingConeObj())]);
  await expect(page.locator('#model-name')).toHaveText('cone.obj');
  await ready(page);
  await expect(page.getByText('It seems to be the wrong way up.')).toBeHidden();
  expect(await writtenHash(page)).toContain('upAxis=z');
  await page.getByLabel('Information about the model').click();
  await page.getByRole('switch', { name: /flat side/ }).uncheck();
  await ready(page);
  expect(await writtenHash(page)).not.toContain('upAxis=z');
});

/** A cone on the plane z = 0, in a format whose models stand on y = 0. */
function lyingConeObj(): string {
  const sides = 24;
  const rim = Array.from({ length: sides }, (_, i) => (2 * Math.PI * i) / sides);
  return [
    'v 0 0 2',
    'v 0 0 0',
    ...rim.map((angle) => `v ${Math.cos(angle)} ${Math.sin(angle)} 0`),
    ...rim.map((_, i) => `f 1 ${i + 3} ${((i + 1) % sides) + 3}`),
    ...rim.map((_, i) => `f 2 ${((i + 1) % sides) + 3} ${i + 3}`),
  ].join('\n');
}
