import { expect, test } from 'vitest';
import { colorsOf, colouredBoxMtl, colouredBoxObj, read } from '../../../../tools/modelFiles/modelWriters.js';
import { fbx } from '../../../../tools/modelFiles/sceneWriters.js';

const obj = (mtl: string, text = colouredBoxObj): Promise<string[]> =>
  read(['box.obj', text], ['box.mtl', mtl], ['p.png', '']).then(({ notes }) => notes);

test('displacement of OBJ is said', async () => {
  expect(await obj(colouredBoxMtl)).toEqual([]);
  expect(await obj(`${colouredBoxMtl}\ndisp -s 1 1 1 p.png\n`)).toEqual(['displacement left out']);
  expect(await obj(`${colouredBoxMtl}\r\n  map_disp p.png\r\n`)).toEqual(['displacement left out']);
});

/** A picture that is joined to a property of the first material. */
const textured = (property: string, moves = false): string =>
  fbx(7300, moves)
    .replace('Connections:  {', `Connections:  {\n\tC: "OP",40,11, "${property}"\n\tC: "OO",50,40`)
    .replace(
      'Objects:  {',
      `Objects:  {
	Texture: 40, "Texture::p", "" {
		Type: "TextureVideoClip"
		FileName: "p.png"
		RelativeFilename: "p.png"
	}
	Video: 50, "Video::p", "Clip" {
		Type: "Clip"
		Filename: "p.png"
		RelativeFilename: "p.png"
	}`,
    );

test.each([false, true])('reports displacement maps of FBX, animated: %s', async (moves) => {
  const { readModel } = await import('../../../../src/viewer/files/readModel.js');
  const content = new Blob([textured('DisplacementColor', moves)]);
  const { notes, kind } = await readModel([{ name: 'box.fbx', content }], () => {});
  expect([kind, notes]).toEqual([moves ? 'parts' : 'mesh', ['displacement left out']]);
});

test('curves of OBJ are lines', async () => {
  const curve = `${colouredBoxObj}\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n`;
  expect(await obj(colouredBoxMtl, curve)).toEqual(['points and lines left out']);
});

test.each([
  ['255 128 0', '255,128,0'],
  ['1 0 0', '255,0,0'],
  ['1 0 0.5', '255,0,128'],
])('colours of OBJ vertices may be whole numbers up to 255: %s', async (colour, drawn) => {
  const text = colouredBoxObj.replace(/^(v .*)$/gm, `$1 ${colour}`).replace(/^(usemtl|mtllib).*$/gm, '');
  expect(new Set(colorsOf(await read(['box.obj', text])))).toEqual(new Set([drawn]));
});
