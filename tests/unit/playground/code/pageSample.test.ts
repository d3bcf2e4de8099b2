import { readFileSync } from 'node:fs';
import type { AnimationClip, BufferGeometry, Group } from 'three';
import * as three from 'three';
import { ParametricGeometry } from 'three/addons/geometries/ParametricGeometry.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { mergeGeometries, mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { codeForms } from '../../../../src/playground/code/codeForms.js';
import type { CodeDrawing, CodeModel } from '../../../../src/playground/code/modelSource.js';
import { IMPORT_MAP, modelSource } from '../../../../src/playground/code/modelSource.js';
import * as forms from '../../../../src/playground/models/forms.js';
import { BUILT_IN_MODELS, BUST_FOOT, type BuiltInModel } from '../../../../src/playground/models/models.js';
import { presetLook } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

const pageSample = (drawing: CodeDrawing): string => codeForms.page(drawing).code;
const moduleSample = (drawing: CodeDrawing): string => codeForms.module(drawing).code;

const drawing = (model: Partial<CodeDrawing['model']>, settings: Partial<Settings> = {}): CodeDrawing => ({
  model: { model: 'file', title: 'bust.glb', sceneRadius: undefined, isOpen: false, hasParts: true, ...model },
  settings: { ...defaultSettings(), ...settings },
  camera: { position: [0.123456, 1, 4], target: [0, 0, 0] },
  groundHeight: -0.7,
  aspect: 1.5,
});

/** Throws a SyntaxError if a module's text is no JavaScript. Nothing is run. */
function parse(text: string): void {
  new Function(`return async () => { ${text.replace(/^import .*$/gm, '').replace('export async', 'async')} }`);
}

const EVERYTHING: Record<string, unknown> = {
  ...three,
  ParametricGeometry,
  TeapotGeometry,
  mergeGeometries,
  mergeVertices,
};

/** Runs the code that makes a model. @returns the value of `result` after it */
function run(model: Pick<CodeModel, 'model' | 'title'>, result: string, imported: object = {}): unknown {
  const { code, functions = '' } = modelSource(model);
  const names = {
    ...imported,
    ...EVERYTHING,
  };
  return new Function(...Object.keys(names), `${functions}\n${code}\nreturn ${result};`)(...Object.values(names));
}

const versionOf = (name: string): string =>
  JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8')).version as string;

describe('copied code', () => {
  test('is JavaScript for every model, every kind of file and every part', () => {
    const all: Partial<Settings> = {
      shadows: 'on',
      shadowStrokes: 'reorient',
      ground: 'shadow',
      background: 'on',
      occlusion: 50,
      secondLight: 'left',
      lightKind: 'spot',
      lightFollows: 'viewer',
      upAxis: 'z',
      color: '#aabbcc',
    };
    for (const model of Object.keys(BUILT_IN_MODELS)) {
      parse(moduleSample(drawing({ model: model as Settings['model'], title: model }, all)));
    }
    const place = { scale: 0.5, position: [0, 1, 2] as [number, number, number] };
    const clip = { index: 1, time: 0.5, isPlaying: true };
    for (const title of [
      'a.gltf',
      'a.obj',
      'a.fbx',
      'a.dae',
      'a.usdz',
      'a.3mf',
      'a.3ds',
      'a.wrl',
      'a.ply.gz',
      'a.STL',
    ]) {
      const text = moduleSample(drawing({ title, place, clip }, presetLook('woodcut')));
      expect(text).toContain(`'${title}'`);
      parse(text);
    }
    parse(moduleSample(drawing({ title: 'all.zip' }, { mapStyle: 'file', outlines: 'off' })));
  });

  test.each([
    [false, 'new PerspectiveCamera(26, 1, 0.05, 100);', 'fov: MathUtils.radToDeg(2 * Math.atan(half)) });'],
    [true, 'new OrthographicCamera(-1, 1, 1, -1, 0.05, 100);', 'top: half, bottom: -half });'],
  ])('sees what a camera of a file sees; orthographic: %s', (isOrthographic, made, sized) => {
    const lens = { isOrthographic, high: 0.0123456, aspect: 2, up: [0.6, 0.8, 0] as [number, number, number] };
    const text = moduleSample({ ...drawing({}), camera: { position: [1, 2, 4], target: [0, 0, 0], lens } });
    parse(text);
    for (const part of [
      made,
      sized,
      'camera.up.set(0.6, 0.8, 0);',
      'const half = Math.max(0.012346, 0.024691 / aspect);',
    ])
      expect(text).toContain(part);
  });

  test.each<[Partial<Settings>, boolean]>([
    [{ technique: 'engraving' }, false],
    [{ technique: 'stipple' }, false],
    [{ technique: 'engraving', compare: 'adjacency' }, false],
    [{ technique: 'dryMedia' }, true],
    [{ technique: 'adjacency' }, true],
  ])('of a drawing loads a map only for what is drawn with one: %j', (look, isMapped) => {
    for (const mapStyle of ['file', 'ruled'] as const) {
      const text = moduleSample(drawing({ model: 'teapot' }, { ...look, mapStyle }));
      parse(text);
      expect(text.includes('map.json')).toBe(isMapped && mapStyle === 'file');
      expect(text.includes('playground saves in a ZIP')).toBe(isMapped && mapStyle === 'file');
      expect(/import \{[^}]*TonalArtMap/.test(text)).toBe(isMapped && mapStyle === 'file');
      expect(text.includes("tonalArtMap: { style: 'ruled' }")).toBe(isMapped && mapStyle === 'ruled');
    }
  });

  test('names the versions that are installed, and maps every name that it imports', () => {
    expect(IMPORT_MAP.three).toContain(`/three@${versionOf('three')}/`);
    for (const name of ['bunny', 'snowden', '@pmndrs/assets'] as const) {
      expect(Object.values(IMPORT_MAP).join()).toContain(`/${name}@${versionOf(name)}/`);
    }
    for (const model of [...(Object.keys(BUILT_IN_MODELS) as BuiltInModel[]), 'file'] as const) {
      const html = pageSample(drawing({ model, title: 'bust.glb' }));
      const map = JSON.parse(/<script type="importmap">(.*?)<\/script>/s.exec(html)![1]) as {
        imports: Record<string, string>;
      };
      for (const [, name] of html.matchAll(/^import .* from '(.*)';$/gm)) {
        const found = Object.keys(map.imports).some(
          (key) => name === key || (key.endsWith('/') && name.startsWith(key)),
        );
        expect(found, name).toBe(true);
      }
    }
  });

  test.each(Object.entries(forms))('makes the very form that the page draws: %s', (name, form) => {
    const model = name as keyof typeof forms;
    const geometry = run({ model, title: model }, 'geometry') as BufferGeometry;
    const drawn = mergeVertices(form().deleteAttribute('uv').deleteAttribute('normal'), 1e-4);
    expect(geometry.attributes.position.array).toEqual(drawn.attributes.position.array);
    expect(geometry.attributes.position.count).toBeGreaterThan(1000);
  });

  test('calls the drawing when all that it calls is there', () => {
    const html = pageSample(drawing({ model: 'shell', title: 'Shell' }));
    expect(html).not.toMatch(/^\/\/.*src\//m);
    expect(html.indexOf('const shell = ')).toBeGreaterThan(0);
    expect(html.indexOf("drawHatching(document.getElementById('drawing'))")).toBeGreaterThan(
      html.indexOf('const shell = '),
    );
  });

  test('makes the fish with its bones and clips, the bust without its stray triangles, and the whole bunny', async () => {
    const [fish, clips] = run({ model: 'fish', title: 'Fish' }, '[model, animations]') as [Group, AnimationClip[]];
    expect(clips.map(({ name }) => name)).toEqual(['Swim', 'Dart']);
    expect(fish.getObjectByName('spine9')).toBeDefined();

    const bust = run({ model: 'bust', title: 'Bust' }, 'geometry', { scan: await import('snowden/lo.js') });
    const { attributes } = bust as BufferGeometry;
    expect(Math.min(...attributes.position.array.filter((_, i) => i % 3 === 1))).toBeGreaterThanOrEqual(BUST_FOOT);
    expect(attributes.position.count).toBeGreaterThan(1000);

    const scan = await import('bunny');
    const bunny = run({ model: 'bunny', title: 'Bunny' }, 'geometry', { scan }) as BufferGeometry;
    expect(bunny.index!.count).toBe(3 * scan.cells.length);
    expect(bunny.attributes.position.count).toBe(scan.positions.length);
  });

  test('keeps names of files to themselves', () => {
    const title = `</script><img src=x onerror="alert(1)">'\n\\.glb`;
    const html = pageSample(drawing({ title }));
    expect(html.match(/<\/script>/g)).toHaveLength(2);
    expect(html).not.toContain('<img');
    parse(/<script type="module">(.*?)<\/script>/s.exec(html)![1]);
    parse(moduleSample(drawing({ title })));
    const embed = codeForms.embed(drawing({ title }), {
      address: 'https://a.test/?embed#x="1"&y',
      isModelInLink: false,
    });
    expect(embed.code).not.toContain('<img');
    expect(embed.code).toContain('src="https://a.test/?embed#x=&#34;1&#34;&#38;y"');
    expect(embed.about).toContain('cannot carry');
    // What turns text round would make code read otherwise than it runs.
    const turned = 'a\u202e\u2066\u200b\u{e0041}.glb';
    for (const code of [pageSample(drawing({ title: turned })), moduleSample(drawing({ title: turned }))]) {
      expect(code).not.toMatch(/\p{Cf}/u);
      expect(new Function(`return ${/loadAsync\(('.*')\)/.exec(code)![1]}`)()).toBe(turned);
    }
  });
});
