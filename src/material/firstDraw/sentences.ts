const PREPARE = 'await prepareHatchingGeometry(geometry)';
const PREPARE_ADJACENCY = 'await prepareHatchingGeometry(geometry, { adjacency: true })';
const WITH_ADJACENCY = "Prepare it with { adjacency: true }, or use the technique 'hatching'.";
const AT_REST = 'is lit and hatched in its rest pose:';

/** A warning about a mesh, with further arguments. */
export type Sentence = (mesh: string, ...details: string[]) => string;

/** The warning texts: what is wrong, and the remedy. docs/troubleshooting.md lists the same sentences. */
export const SENTENCES = {
  noMap: (mesh: string) =>
    `${mesh} is drawn without strokes, because its material has no tonalArtMap. Set one, for example TonalArtMap.draw(), or use the technique 'engraving'.`,
  noNormals: (mesh: string) =>
    `${mesh} has no normals and cannot be lit. Call geometry.computeVertexNormals(), or draw the result of ${PREPARE} instead.`,
  noAdjacency: (mesh: string) =>
    `${mesh} has no triangle adjacency and cannot be hatched. Draw the result of ${PREPARE_ADJACENCY} instead, or use the technique 'hatching'.`,
  noneAsked: (mesh: string) => `${mesh} was prepared without triangle adjacency. ${WITH_ADJACENCY}`,
  lostAdjacency: (mesh: string) =>
    `${mesh} has lost its triangle adjacency: that of the layout 'pull' is not kept when geometries are merged, exported or serialised. ${WITH_ADJACENCY}`,
  cornerAtRest: (mesh: string) =>
    `${mesh} ${AT_REST} its layout 'corner' stores no other pose. Prepare it with the layout 'pull' or 'auto', or use the technique 'hatching'.`,
  deviceAtRest: (mesh: string) =>
    `${mesh} ${AT_REST} this device cannot draw into float textures (EXT_color_buffer_float). Use the technique 'hatching', which does not need them.`,
  instancesAtRest: (mesh: string) =>
    `${mesh} ${AT_REST} the instances of an InstancedMesh cannot have morph targets of their own. Use the technique 'hatching', or meshes.`,
  noForm: (mesh: string) =>
    `${mesh} is drawn with the direction 'light', because it was prepared without form. Prepare it with { form: true }.`,
  moved: (mesh: string) =>
    `the positions of ${mesh} have changed since it was prepared; its strokes and outlines have not. Move the mesh instead of the geometry, or vertices by bones or morph targets, which both follow, or change the geometry before prepareHatchingGeometry.`,
  movedIndexed: (mesh: string) =>
    `the positions of ${mesh} have changed since it was prepared; its strokes and outlines have not. Move the mesh, or vertices by bones or morph targets, which both follow, or prepare it again. Without outlines, geometry.deleteAttribute('hatchNormal') draws it with its own normals.`,
  toneMapped: (mesh: string) =>
    `${mesh} is drawn with the tone mapping of the renderer, which makes paper and ink grey. Set toneMapped: false on its material, or renderer.toneMapping = NoToneMapping; in React Three Fiber use <Canvas flat>.`,
  noLight: (mesh: string) => `${mesh} gets no light. Add a DirectionalLight of intensity Math.PI to the scene.`,
  ambientOnly: (mesh: string) =>
    `${mesh} has the same tone on all sides, because all its light is ambient. Add a DirectionalLight of intensity Math.PI in the place of the AmbientLight.`,
  tooDark: (mesh: string, sum: string) =>
    `${mesh} gets too little light: its lights add up to ${sum}. Raise their intensities until the sum is about Math.PI.`,
  tooBright: (mesh: string, sum: string) =>
    `${mesh} gets too much light: its lights add up to ${sum}. Lower their intensities until the sum is about Math.PI.`,
  tooFine: (mesh: string, property: string, value: string, better: string) =>
    `${mesh} has strokes smaller than a pixel, which make plain grey: ${property} is ${value}. Set it to about ${better}.`,
  tooCoarse: (mesh: string, property: string, value: string, better: string) =>
    `${mesh} has strokes larger than itself: ${property} is ${value}. Set it to about ${better}.`,
  onlyFrame: (mesh: string) =>
    `${mesh} was drawn before the map and the code of its material had loaded, and never since. Draw again when they have: material.ready.then(() => renderer.render(scene, camera)).`,
} satisfies Record<string, Sentence>;

export type Mistake = keyof typeof SENTENCES;

/** A number with two significant digits, for messages. */
export const rounded = (value: number): string => String(Number(value.toPrecision(2)));
