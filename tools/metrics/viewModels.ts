/** A model whose good side is known. */
export interface ViewModel {
  /** The package or folder that holds it, and its file there; for a model made by code, the name of its function. */
  source: [from: string, file: string];
  /** The azimuths of good views, in degrees from +z towards +x, where y is up. A view within 45° of one is as good. */
  good: readonly number[];
}

/** Seen three-quarter, from either side of the direction in which it looks. */
const threeQuarter = (front: number): number[] => [front - 40, front + 40];

const threebox = (file: string): [string, string] => ['threebox-plugin@2.2.7', `examples/models/${file}`];
const controllers = (file: string): [string, string] => [
  '@webxr-input-profiles/assets@1.0.20',
  `dist/profiles/${file}.glb`,
];

/** Faces, figures, animals, vehicles and tools, from npm's packages, `../shared/models` and this repository. */
export const VIEW_MODELS: Readonly<Record<string, ViewModel>> = {
  'face mask': { source: ['mind-ar@1.2.5', 'src/face-target/face-geometry/canonical-face-model.obj'], good: [0] },
  nefertiti: { source: ['shared', 'nefertiti_lowres.obj'], good: [0] },
  bust: { source: ['code', 'bust'], good: [350] },
  suzanne: { source: ['code', 'suzanne'], good: [0] },
  soldier: { source: threebox('Soldier.glb'), good: [180] },
  CesiumMan: { source: ['shared', 'CesiumMan.glb'], good: [90] },
  'statue of liberty': { source: threebox('landmarks/libertystatue.glb'), good: [35] },
  bunny: { source: ['code', 'bunny'], good: threeQuarter(290) },
  dragon: { source: ['code', 'dragon'], good: threeQuarter(300) },
  elephant: { source: threebox('history/elephant.glb'), good: threeQuarter(0) },
  triceratops: { source: threebox('history/triceratops.fbx'), good: threeQuarter(90) },
  spot: { source: ['shared', 'spot.obj'], good: threeQuarter(180) },
  'running fox': { source: ['shared', 'Fox.glb'], good: threeQuarter(0) },
  'sitting fox': { source: ['code', 'makeFox'], good: [0] },
  fish: { source: ['code', 'makeFish'], good: threeQuarter(270) },
  lorry: { source: threebox('vehicles/truck.glb'), good: threeQuarter(90) },
  'food truck': { source: threebox('Truck.obj'), good: threeQuarter(0) },
  aeroplane: { source: threebox('plane/plane.glb'), good: threeQuarter(180) },
  car: { source: threebox('vehicles/car.glb'), good: [45, 135, 225, 315] },
  'controller with buttons': { source: controllers('meta-quest-touch-plus/left'), good: [180] },
  'controller with a ring': { source: controllers('htc-vive/none'), good: [180] },
  'controller with a strap': { source: controllers('valve-index/left'), good: [165] },
  'remote control': { source: controllers('oculus-go/none'), good: threeQuarter(180) },
  'controller with a halo': { source: controllers('microsoft-mixed-reality/left'), good: [180] },
  hand: { source: ['shared', 'hand_lowres.obj'], good: [90, 270] },
  teapot: { source: ['code', 'teapot'], good: [0, 180] },
  lantern: { source: ['shared', 'Lantern.gltf'], good: [30, 150, 210, 330] },
  windmill: { source: threebox('windmill_a/windmill_a.gltf'), good: [90, 270] },
  room: { source: ['code', 'makeRoom'], good: [340] },
  stairs: { source: ['code', 'makeStairs'], good: [340] },
  house: { source: ['code', 'makeHouse'], good: [0] },
  gears: { source: ['code', 'gears'], good: [0, 30, 330] },
};
