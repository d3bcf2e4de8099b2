/** Scenes with the faults and habits of models found on the net, written as files for the page to read. */
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  DataTexture,
  DoubleSide,
  ExtrudeGeometry,
  Float32BufferAttribute,
  Group,
  IcosahedronGeometry,
  type Material,
  Mesh,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
  Path,
  PlaneGeometry,
  Shape,
  SphereGeometry,
  SRGBColorSpace,
} from 'three';

type Point = readonly [x: number, y: number, z: number];

/** A scene and the format of its file. An OBJ file has neither sides nor colours. */
export interface FoundScene {
  format: 'glb' | 'obj';
  make(): Group;
}

export const FOUND_SCENES: Readonly<Record<string, FoundScene>> = {
  'house with sheets turned at random': { format: 'obj', make: () => turned(house(), chances(7), 0.5, 'meshes') },
  'room of single sides': {
    format: 'glb',
    make: () => room(walls(['floor', 'ceiling', 'back', 'front', 'left', 'right'], false)),
  },
  'room of double sides': { format: 'glb', make: () => room(walls(['floor', 'back', 'left', 'right'], true)) },
  'room without ceiling': { format: 'obj', make: () => room(walls(['floor', 'back', 'front', 'left', 'right'], true)) },
  'apartment as a closed box': { format: 'glb', make: apartment },
  'gear train': { format: 'obj', make: gearTrain },
  'truck inside out': { format: 'obj', make: () => turned(truck(), chances(1), 1, 'meshes') },
  'snowman with turned faces': { format: 'obj', make: () => turned(snowman(), chances(5), 0.3, 'faces') },
  street: { format: 'glb', make: street },
  'lamp with a glass shade': { format: 'glb', make: glassLamp },
  'ring of stones': { format: 'glb', make: stones },
  'dark helicopter': { format: 'glb', make: helicopter },
  'striped figure': { format: 'glb', make: figure },
  'row of robots': { format: 'glb', make: robots },
};

/** Numbers from 0 to 1 that look random and are the same for the same seed (minimal standard generator). */
function chances(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647;
  };
}

const paint = (color: string, more: MeshStandardMaterialParameters = {}): MeshStandardMaterial =>
  new MeshStandardMaterial({ color, roughness: 0.8, metalness: 0, ...more });

/** A mesh at x, y, z. Other transforms are set on the result. */
function part(name: string, geometry: BufferGeometry, material: Material, [x, y, z]: Point = [0, 0, 0]): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.name = name;
  mesh.position.set(x, y, z);
  return mesh;
}

const box = (name: string, size: Point, material: Material, place: Point): Mesh =>
  part(name, new BoxGeometry(...size), material, place);

/** A polygon as a fan of triangles around its first corner. */
function sheet(name: string, corners: readonly Point[], material: Material): Mesh {
  const fan = corners.slice(2).flatMap((corner, i) => [corners[0], corners[i + 1], corner]);
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(fan.flat(), 3));
  geometry.computeVertexNormals();
  return part(name, geometry, material);
}

/** Turns a share of the meshes or of the faces inside out. */
function turned(group: Group, chance: () => number, share: number, what: 'meshes' | 'faces'): Group {
  group.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const geometry: BufferGeometry = object.geometry.index ? object.geometry.toNonIndexed() : object.geometry.clone();
    const whole = chance() < share;
    const { array } = geometry.getAttribute('position');
    for (let face = 0; face < array.length; face += 9) {
      if (what === 'meshes' ? !whole : chance() >= share) continue;
      for (let k = face + 3; k < face + 6; k++) [array[k], array[k + 3]] = [array[k + 3], array[k]];
    }
    geometry.computeVertexNormals();
    object.geometry = geometry;
  });
  return group;
}

/** A house of single sheets with windows and a door just before the wall, on a lawn. */
function house(): Group {
  const [wide, deep, eaves, ridge] = [4, 3, 2.4, 3.8];
  const [wall, roof, glass, wood, lawn] = ['#eae0cc', '#8c4033', '#405973', '#593319', '#66994d'].map((colour) =>
    paint(colour),
  );
  const upright = (name: string, [x0, z0, x1, z1]: readonly number[], low: number, high: number, material: Material) =>
    sheet(
      name,
      [
        [x0, low, z0],
        [x1, low, z1],
        [x1, high, z1],
        [x0, high, z0],
      ],
      material,
    );
  const front = deep + 0.01;
  return new Group().add(
    upright('front', [-wide, deep, wide, deep], 0, eaves, wall),
    upright('back', [wide, -deep, -wide, -deep], 0, eaves, wall),
    ...[-1, 1].flatMap((side) => [
      upright(`side ${side}`, [side * wide, side * deep, side * wide, -side * deep], 0, eaves, wall),
      sheet(
        `gable ${side}`,
        [
          [side * wide, eaves, side * deep],
          [side * wide, eaves, -side * deep],
          [side * wide, ridge, 0],
        ],
        wall,
      ),
      sheet(
        `roof ${side}`,
        [
          [-side * (wide + 0.4), eaves - 0.2, side * (deep + 0.5)],
          [side * (wide + 0.4), eaves - 0.2, side * (deep + 0.5)],
          [side * (wide + 0.4), ridge, 0],
          [-side * (wide + 0.4), ridge, 0],
        ],
        roof,
      ),
    ]),
    ...[-2.8, 0, 2.4].map((x) => upright(`window at ${x}`, [x - 0.5, front, x + 0.5, front], 0.8, 1.8, glass)),
    upright('door', [0.8, front, 1.7, front], 0, 1.9, wood),
    box('chimney', [0.7, 1.6, 0.7], roof, [2, 3.6, -0.8]),
    sheet(
      'lawn',
      [
        [-7, 0, 6],
        [7, 0, 6],
        [7, 0, -6],
        [-7, 0, -6],
      ],
      lawn,
    ),
  );
}

/** Half the width and depth, and the height of a room. */
const ROOM: Point = [3, 2.6, 2.2];

/** Walls whose fronts face inward. */
function walls(names: readonly string[], isDouble: boolean): Mesh[] {
  const [x, y, z] = ROOM;
  const corners: Readonly<Record<string, readonly Point[]>> = {
    floor: [
      [-x, 0, z],
      [x, 0, z],
      [x, 0, -z],
      [-x, 0, -z],
    ],
    ceiling: [
      [-x, y, -z],
      [x, y, -z],
      [x, y, z],
      [-x, y, z],
    ],
    back: [
      [-x, 0, -z],
      [x, 0, -z],
      [x, y, -z],
      [-x, y, -z],
    ],
    front: [
      [x, 0, z],
      [-x, 0, z],
      [-x, y, z],
      [x, y, z],
    ],
    left: [
      [-x, 0, z],
      [-x, 0, -z],
      [-x, y, -z],
      [-x, y, z],
    ],
    right: [
      [x, 0, -z],
      [x, 0, z],
      [x, y, z],
      [x, y, -z],
    ],
  };
  const wall = paint('#e6decc', isDouble ? { side: DoubleSide } : {});
  return names.map((name) => sheet(name, corners[name], wall));
}

const room = (sides: readonly Mesh[]): Group => new Group().add(...sides, ...furniture());

function furniture(): Mesh[] {
  const [cover, white, wood, cloth, rug] = ['#bf3333', '#f2f2f2', '#59381f', '#334d80', '#998033'].map((colour) =>
    paint(colour),
  );
  const pillow = part('pillow', new SphereGeometry(0.35, 24, 16), white, [-2.3, 0.7, -1]);
  pillow.scale.set(0.8, 0.35, 1.5);
  const shade = paint('#f2f2f2', { side: DoubleSide });
  return [
    box('bed', [2, 0.5, 1.6], cover, [-1.6, 0.35, -1]),
    pillow,
    box('headboard', [0.1, 1.1, 1.7], wood, [-2.65, 0.55, -1]),
    box('desk', [1.4, 0.06, 0.6], wood, [1.6, 0.75, -1.6]),
    ...[1, 2.2].flatMap((x) => [-1.85, -1.35].map((z) => box('desk leg', [0.06, 0.75, 0.06], wood, [x, 0.37, z]))),
    box('seat', [0.5, 0.06, 0.5], cloth, [1.6, 0.45, -0.8]),
    box('backrest', [0.5, 0.6, 0.06], cloth, [1.6, 0.8, -0.55]),
    ...[1.4, 1.8].flatMap((x) => [-1, -0.6].map((z) => box('chair leg', [0.05, 0.45, 0.05], cloth, [x, 0.22, z]))),
    part('lampshade', new ConeGeometry(0.25, 0.35, 24, 1, true), shade, [2, 1.2, -1.7]),
    part('lamp stand', new CylinderGeometry(0.03, 0.03, 0.4, 12), wood, [2, 0.95, -1.7]),
    box('rug', [2, 0.02, 1.2], rug, [0.2, 0.02, 0.8]),
    box('sofa', [1.8, 0.45, 0.8], cloth, [-0.2, 0.22, 1.3]),
    box('sofa back', [1.8, 0.7, 0.2], cloth, [-0.2, 0.5, 1.75]),
  ];
}

/** Two furnished rooms, closed all round, of walls with two sides. */
function apartment(): Group {
  const all = ['floor', 'ceiling', 'back', 'front', 'left', 'right'];
  const second = room(walls(all, true));
  second.position.x = 2 * ROOM[0];
  return new Group().add(room(walls(all, true)), second);
}

/** Three gears on two axles before a plate. The axles pass through the gears' discs. */
function gearTrain(): Group {
  const steel = paint('#b3b3b3');
  const axle = (name: string, radius: number, length: number, place: Point) => {
    const mesh = part(name, new CylinderGeometry(radius, radius, length, 32), steel, place);
    mesh.rotation.x = Math.PI / 2;
    return mesh;
  };
  return new Group().add(
    part('gear of 24', gear(24, 2, 0.5), steel),
    part('gear of 14', gear(14, 1.15, 0.5), steel, [3.2, 0.3, 0]),
    part('gear of 30', gear(30, 2.5, 0.4), steel, [3.2, 0.3, 0.8]),
    axle('axle', 0.4, 3, [0, 0, 0.4]),
    axle('second axle', 0.22, 3.4, [3.2, 0.3, 0.4]),
    box('plate', [8, 6, 0.3], steel, [1.5, 0, -1]),
  );
}

function gear(teeth: number, radius: number, thickness: number): BufferGeometry {
  const outline = Array.from({ length: teeth }, (_, tooth) =>
    [
      [0, 0.88],
      [0.35, 1.08],
      [0.75, 1.08],
      [1.1, 0.88],
    ].map(([turn, reach]) => {
      const angle = ((2 * tooth + turn) / teeth) * Math.PI;
      return [reach * radius * Math.cos(angle), reach * radius * Math.sin(angle)] as const;
    }),
  ).flat();
  const shape = new Shape();
  for (const [i, [x, y]] of outline.entries()) i === 0 ? shape.moveTo(x, y) : shape.lineTo(x, y);
  shape.holes.push(new Path().absarc(0, 0, 0.1 * radius, 0, 2 * Math.PI, true));
  return new ExtrudeGeometry(shape, { depth: thickness, bevelEnabled: false, curveSegments: 24 });
}

/** A truck of boxes and open tubes. */
function truck(): Group {
  const red = paint('#a02020');
  return new Group().add(
    box('cargo', [4, 2.2, 2], red, [0, 1.6, 0]),
    box('cab', [1.3, 1.6, 2], red, [2.8, 1.3, 0]),
    ...[-1.4, -0.5, 2.8].flatMap((x) =>
      [-1, 1].map((z) => {
        const tyre = part(`tyre at ${x} ${z}`, new CylinderGeometry(0.45, 0.45, 0.3, 24, 1, true), red, [x, 0.45, z]);
        tyre.rotation.x = Math.PI / 2;
        return tyre;
      }),
    ),
    sheet(
      'bumper',
      [
        [3.5, 0.3, 1],
        [3.5, 0.3, -1],
        [3.5, 0.7, -1],
        [3.5, 0.7, 1],
      ],
      red,
    ),
  );
}

/** Balls, a cone and cylinders that cut each other. */
function snowman(): Group {
  const snow = paint('white');
  const nose = part('nose', new ConeGeometry(0.12, 0.7, 24), snow, [0, 3.8, 0.85]);
  nose.rotation.x = Math.PI / 2;
  const ball = (name: string, radius: number, y: number) =>
    part(name, new SphereGeometry(radius, 48, 32), snow, [0, y, 0]);
  return new Group().add(
    ball('foot', 1.2, 1.1),
    ball('chest', 0.85, 2.7),
    ball('head', 0.6, 3.8),
    nose,
    part('hat', new CylinderGeometry(0.4, 0.45, 0.7, 32), snow, [0, 4.6, 0]),
    part('brim', new CylinderGeometry(0.75, 0.75, 0.06, 48), snow, [0, 4.28, 0]),
  );
}

/** A picture of squared pixels, by a function of their place. */
function picture(side: number, colourAt: (x: number, y: number) => readonly [number, number, number]): DataTexture {
  const pixels = Uint8Array.from({ length: 4 * side * side }, (_, i) => {
    const pixel = Math.floor(i / 4);
    return i % 4 === 3 ? 255 : colourAt(pixel % side, Math.floor(pixel / side))[i % 4];
  });
  const texture = new DataTexture(pixels, side, side);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

/** Houses with painted windows, trees and cars along a road. */
function street(): Group {
  const facade = paint('white', {
    map: picture(64, (x, y) =>
      x % 16 > 4 && x % 16 < 12 && y % 16 > 3 && y % 16 < 13 ? [50, 60, 80] : [200, 185, 160],
    ),
  });
  const [asphalt, bark, leaves, grass, brick, red, black, glass] = [
    '#333333',
    '#4d331a',
    '#26661a',
    '#4d8033',
    '#994d33',
    '#cc1a1a',
    '#0d0d0d',
    '#1a2633',
  ].map((colour) => paint(colour));
  const chance = chances(11);
  const sideOf = (i: number) => (i % 2 ? 1 : -1);
  return new Group().add(
    box('road', [30, 0.1, 6], asphalt, [0, -0.05, 0]),
    box('lawn', [30, 0.08, 20], grass, [0, -0.1, 0]),
    ...Array.from({ length: 12 }, (_, i) => {
      const height = 2 + 4 * chance();
      return box(`house ${i}`, [3.4, height, 3], i % 3 ? facade : brick, [
        -12 + 4.5 * Math.floor(i / 2),
        height / 2,
        5.5 * sideOf(i),
      ]);
    }),
    ...Array.from({ length: 14 }, (_, i) => [
      part(`trunk ${i}`, new CylinderGeometry(0.08, 0.1, 1, 8), bark, [-13 + 2 * i, 0.5, 3.4 * sideOf(i)]),
      part(`crown ${i}`, new IcosahedronGeometry(0.6, 2), leaves, [-13 + 2 * i, 1.3, 3.4 * sideOf(i)]),
    ]).flat(),
    ...Array.from({ length: 5 }, (_, i) => [
      box(`car ${i}`, [1.4, 0.5, 0.7], i % 2 ? red : black, [-10 + 5 * i, 0.3, 1.2 * sideOf(i)]),
      box(`cabin ${i}`, [0.7, 0.35, 0.6], glass, [-10 + 5 * i, 0.7, 1.2 * sideOf(i)]),
    ]).flat(),
  );
}

function glassLamp(): Group {
  const glass = paint('#e6f2ff', { transparent: true, opacity: 0.25, side: DoubleSide });
  const brass = paint('#cc994d', { metalness: 1, roughness: 0.25 });
  return new Group().add(
    part('shade', new SphereGeometry(1, 48, 32), glass, [0, 2.6, 0]),
    part('bulb', new SphereGeometry(0.3, 32, 24), paint('#ffe699', { emissive: '#ffe699' }), [0, 2.6, 0]),
    part('stem', new CylinderGeometry(0.12, 0.12, 1.8, 24), brass, [0, 0.9, 0]),
    part('foot', new CylinderGeometry(0.8, 0.95, 0.2, 48), brass, [0, 0.1, 0]),
  );
}

/** 600 stones in three greys around a well. */
function stones(): Group {
  const greys = ['#666666', '#404040', '#998c80'].map((colour) => paint(colour));
  const stone = new IcosahedronGeometry(0.22, 1);
  const chance = chances(3);
  return new Group().add(
    part('ground', new CylinderGeometry(9, 9, 0.2, 64), paint('#80734d'), [0, -0.1, 0]),
    part('well', new CylinderGeometry(1.5, 1.6, 1.4, 40), paint('#b3b3a6'), [0, 0.7, 0]),
    ...Array.from({ length: 600 }, (_, i) => {
      const [angle, reach] = [2 * Math.PI * chance(), 6 + 1.6 * chance()];
      const place: Point = [reach * Math.cos(angle), 0.15 + 0.4 * chance(), reach * Math.sin(angle)];
      const mesh = part(`stone ${i}`, stone, greys[i % 3], place);
      mesh.rotation.set(3 * chance(), 3 * chance(), 0);
      mesh.scale.setScalar(0.5 + chance());
      return mesh;
    }),
  );
}

/** A helicopter whose colours are all dark. Its nose points along +x. */
function helicopter(): Group {
  const olive = paint('#2e331f');
  const black = paint('#141414', { metalness: 1, roughness: 0.4 });
  const body = part('body', new SphereGeometry(1, 48, 32), olive, [0, 1.4, 0]);
  body.scale.set(1.8, 0.9, 0.9);
  const screen = part(
    'windscreen',
    new SphereGeometry(1, 48, 24, 0, 2 * Math.PI, 0, Math.PI / 2.2),
    paint('#0d141a', { roughness: 0.1 }),
    [0.35, 1.45, 0],
  );
  screen.rotation.z = -1.1;
  screen.scale.set(0.85, 1.52, 0.86);
  const along = (name: string, radii: readonly [number, number], length: number, place: Point, turn: number) => {
    const mesh = part(name, new CylinderGeometry(...radii, length, 24), name === 'tail' ? olive : black, place);
    mesh.rotation.z = turn;
    return mesh;
  };
  const blade = new BoxGeometry(3.4, 0.04, 0.24).translate(1.7, 0, 0);
  return new Group().add(
    body,
    screen,
    along('tail', [0.12, 0.3], 3.6, [-3, 1.7, 0], Math.PI / 2 - 0.08),
    box('fin', [0.6, 1.1, 0.08], paint('#b31a1a'), [-4.7, 2.1, 0]),
    along('mast', [0.1, 0.14], 0.6, [0, 2.5, 0], 0),
    ...[0, 1, 2, 3].map((i) => {
      const mesh = part(`blade ${i}`, blade, black, [0, 2.8, 0]);
      mesh.rotation.y = 0.4 + (i * Math.PI) / 2;
      return mesh;
    }),
    ...[-0.7, 0.7].flatMap((z) => [
      along(`skid ${z}`, [0.07, 0.07], 3, [0.1, 0.1, z], Math.PI / 2),
      ...[-0.7, 0.9].map((x) => along(`strut ${x} ${z}`, [0.05, 0.05], 0.9, [x, 0.45, 0.85 * z], 0)),
    ]),
  );
}

/** A figure that looks along +z, in a shirt with stripes of two colours of equal lightness. */
function figure(): Group {
  const shirt = paint('white', { map: picture(64, (_, y) => (y % 16 < 8 ? [60, 140, 200] : [110, 150, 60])) });
  const face = paint('white', { map: picture(128, faceAt) });
  const [skin, jeans, leather] = ['#ebbfa1', '#263366', '#1a1a1a'].map((colour) => paint(colour));
  const torso = part('torso', new CapsuleGeometry(0.42, 0.7, 12, 32), shirt, [0, 1.5, 0]);
  torso.scale.z = 0.7;
  return new Group().add(
    torso,
    part('head', new SphereGeometry(0.36, 48, 32), face, [0, 2.55, 0]),
    part('nose', new SphereGeometry(0.07, 16, 12), skin, [0, 2.52, 0.36]),
    ...[-1, 1].flatMap((side) => {
      const arm = part(`arm ${side}`, new CapsuleGeometry(0.12, 0.75, 8, 24), shirt, [0.58 * side, 1.55, 0]);
      arm.rotation.z = 0.25 * side;
      const shoe = part(`shoe ${side}`, new SphereGeometry(0.2, 24, 16), leather, [0.2 * side, 0.08, 0.12]);
      shoe.scale.set(0.8, 0.5, 1.5);
      return [arm, shoe, part(`leg ${side}`, new CapsuleGeometry(0.17, 0.8, 8, 24), jeans, [0.2 * side, 0.55, 0])];
    }),
  );
}

/** Eyes, a mouth and hair on the map of a sphere, where x = 32 of 128 is its front, and y = 0 its lowest row. */
function faceAt(x: number, y: number): readonly [number, number, number] {
  if ([24, 40].some((eye) => Math.hypot(x - eye, y - 73) < 4)) return [20, 20, 20];
  if (Math.abs(y - 50) < 2 && x > 24 && x < 40) return [150, 40, 40];
  return y > 92 || x > 64 ? [60, 35, 20] : [235, 190, 160];
}

/** 60 robots of seven boxes each, on a square. */
function robots(): Group {
  const [square, body, joint, eye] = ['#a6a69e', '#737a80', '#26292b', '#e6c84d'].map((colour) => paint(colour));
  const robot = (column: number, row: number) => {
    const group = new Group();
    group.position.set(1.6 * (column - 4.5), 0, 1.8 * (row - 2.5));
    return group.add(
      box('chest', [0.7, 0.8, 0.4], body, [0, 1.2, 0]),
      box('head', [0.4, 0.35, 0.35], body, [0, 1.85, 0]),
      box('visor', [0.3, 0.1, 0.06], eye, [0, 1.88, 0.18]),
      ...[-1, 1].flatMap((side) => [
        box('arm', [0.16, 0.8, 0.18], joint, [0.46 * side, 1.15, 0]),
        box('leg', [0.22, 0.8, 0.24], joint, [0.18 * side, 0.4, 0]),
      ]),
    );
  };
  return new Group().add(
    part('square', new PlaneGeometry(20, 14).rotateX(-Math.PI / 2), square),
    ...Array.from({ length: 60 }, (_, i) => robot(i % 10, Math.floor(i / 10))),
  );
}
