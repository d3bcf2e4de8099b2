/** The oldest version of three.js, after its `0.`, that has all the nodes that are used here. */
const OLDEST = 186;

/**
 * Returns the nodes of three.js if their version is new enough.
 *
 * @param revision the version after its `0.`, such as `187` or `187dev`
 * @throws Error that says what to do
 */
export function newEnough<Nodes>(nodes: Nodes, revision: string): Nodes {
  if (Number.parseInt(revision, 10) >= OLDEST) return nodes;
  throw new Error(
    `three-hatching/webgpu needs three.js 0.${OLDEST} or newer, but this is 0.${revision}. Update three.js, or draw with WebGLRenderer and import from 'three-hatching', which works with any version from 0.170 on.`,
  );
}
