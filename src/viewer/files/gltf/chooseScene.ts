import { type FileChange, hiddenChange } from '../common/fileChanges.js';
import { ModelError, shownName } from '../common/ModelError.js';
import type { GltfDocument } from './gltfDocument.js';

const MAX_NODES = 100_000;
const MAX_DEPTH = 500;

/** The part of a glTF document that is shown. */
export interface ChosenScene {
  name: string | undefined;
  /** Indices of the root nodes. */
  roots: number[];
  /** Indices of all visible nodes. */
  visible: number[];
  /** Notes about the choice, for the caption. */
  notes: string[];
  /** Details for the longer text that opens on request. */
  details: string[];
  /** Changes that were made to what the document says. */
  changes: FileChange[];
}

/**
 * Chooses the document's default scene, or else its first. Without scenes, all nodes are shown; without nodes, every mesh, by a node added
 * to the document.
 *
 * @param showsHidden whether nodes that are hidden in the document are shown
 * @throws ModelError if there is no mesh, or nodes form a cycle, or are too many
 */
export function chooseScene(document: GltfDocument, fileName: string, showsHidden = false): ChosenScene {
  const { scenes, nodes, meshes } = document;
  if (meshes.length === 0) throw new ModelError(`${fileName} holds no mesh, so there is nothing to draw.`);
  const hasNodes = nodes.length > 0;
  if (!hasNodes) nodes.push(...meshes.map((_, mesh) => ({ mesh })));
  const index = document.scene ?? 0;
  const scene = hasNodes ? scenes[index] : undefined;
  const { roots, others } = topmostNodes(document, scene?.nodes ?? [], fileName);
  if (!scene) roots.push(...others);
  const notes: string[] = [];
  const details: string[] = [];
  if (!scene) details.push(`it has no scene: all its ${hasNodes ? 'nodes' : 'meshes'} are shown`);
  else if (scenes.length > 1) {
    notes.push(`scene ${index + 1} of ${scenes.length}${scene.name ? `, “${shownName(scene.name)}”` : ''}`);
  }
  const all = nodesBelow(nodes, roots);
  const visible = showsHidden ? [...all] : visibleNodes(document, roots);
  const shown = new Set(visible);
  const hidden = [...all].filter((node) => nodes[node].mesh !== undefined && !shown.has(node)).length;
  return { name: scene?.name, roots, visible, notes, details, changes: hiddenChange(hidden) };
}

/**
 * Leaves every node at most one parent: three's loader would wait forever for a node that is its own descendant. Nodes of the scene keep a
 * parent within the scene, in preference to one outside.
 *
 * @param listed the nodes of the scene
 * @returns the nodes without a parent: those of the scene, and all others
 */
function topmostNodes(
  { nodes }: GltfDocument,
  listed: readonly number[],
  fileName: string,
): { roots: number[]; others: number[] } {
  if (nodes.length > MAX_NODES) {
    throw new ModelError(`${fileName} has ${nodes.length.toLocaleString('en')} nodes, too many for a page.`);
  }
  const isTaken = new Uint8Array(nodes.length);
  const takeChildren = (node: number): void => {
    nodes[node].children = nodes[node].children?.filter((child) => {
      const isNew = isTaken[child] === 0;
      isTaken[child] = 1;
      return isNew;
    });
  };
  const free = (among: Iterable<number>): number[] => [...among].filter((node) => isTaken[node] === 0);
  const inScene = nodesBelow(nodes, listed);
  for (const node of inScene) takeChildren(node);
  // A node below another node of the scene is drawn there.
  const roots = free(new Set(listed));
  for (const node of roots) isTaken[node] = 1;
  for (const node of nodes.keys()) if (!inScene.has(node)) takeChildren(node);
  const others = free(nodes.keys());
  checkNesting(nodes, [...roots, ...others], fileName);
  return { roots, others };
}

/** Nodes and all their descendants, each once. */
function nodesBelow(nodes: GltfDocument['nodes'], from: readonly number[]): Set<number> {
  const found = new Set<number>();
  const pending = [...from];
  for (let node = pending.pop(); node !== undefined; node = pending.pop()) {
    if (found.has(node)) continue;
    found.add(node);
    for (const child of nodes[node].children ?? []) pending.push(child);
  }
  return found;
}

/** @throws ModelError unless all nodes descend from the root nodes, at a moderate depth */
function checkNesting(nodes: GltfDocument['nodes'], tops: readonly number[], fileName: string): void {
  const pending = tops.map((node) => ({ node, depth: 0 }));
  let count = 0;
  for (let next = pending.pop(); next; next = pending.pop()) {
    const { node, depth } = next;
    count++;
    if (depth > MAX_DEPTH) throw new ModelError(`${fileName} nests its nodes more than ${MAX_DEPTH} deep.`);
    for (const child of nodes[node].children ?? []) pending.push({ node: child, depth: depth + 1 });
  }
  if (count < nodes.length) throw new ModelError(`${fileName} is damaged: some of its nodes contain themselves.`);
}

function visibleNodes({ nodes }: GltfDocument, roots: readonly number[]): number[] {
  const visible = new Set<number>();
  const pending = [...roots];
  for (let node = pending.pop(); node !== undefined; node = pending.pop()) {
    if (nodes[node].extensions?.KHR_node_visibility?.visible === false) continue;
    visible.add(node);
    for (const child of nodes[node].children ?? []) pending.push(child);
  }
  return [...visible];
}
