import { type BufferAttribute, type InstancedMesh, Matrix4, type Mesh, Vector3 } from 'three';
import { buildModel } from '../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../src/viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../src/viewer/drawing/meshes.js';
import { ModelError } from '../../src/viewer/files/common/ModelError.js';
import { type ModelFile, readModel } from '../../src/viewer/files/readModel.js';
import { checkSentence, checkWords } from './checkWords.js';

export type Outcome = { kind: 'model'; notes: string[] } | { kind: 'refused'; sentence: string };

/**
 * Reads and hatches files as the playground does before it draws them.
 *
 * @throws Error that says what is wrong, if the outcome is neither a model of finite numbers nor one plain sentence
 */
export async function outcomeOf(files: readonly ModelFile[]): Promise<Outcome> {
  try {
    const read = await readModel(files, () => {});
    const { model, notes } = await buildModel(read, () => {}, new AbortController().signal);
    try {
      checkModel(model);
    } finally {
      model.dispose();
    }
    for (const note of [...notes, ...read.details]) checkWords(note);
    return { kind: 'model', notes };
  } catch (error) {
    if (!(error instanceof ModelError)) throw error;
    checkSentence(error.message);
    return { kind: 'refused', sentence: error.message };
  }
}

function checkModel(model: HatchedModel): void {
  const { min, max } = model.bounds;
  checkNumbers('bounds', [...min.toArray(), ...max.toArray()]);
  for (const mesh of meshesOf(model.root)) checkGeometry(mesh);
  const { motion } = model;
  for (let clip = 0; clip < (motion?.clips.length ?? 0); clip++) {
    motion!.clip = clip;
    for (const share of [0, 0.3, 1]) {
      motion!.time = share * motion!.duration;
      checkPose(model);
    }
  }
  for (const name of motion?.morphs ?? []) motion!.setInfluence(name, 0.5);
  checkPose(model);
}

function checkGeometry({ geometry, visible, morphTargetInfluences }: Mesh): void {
  if (!visible) return;
  for (const [name, { array, count }] of Object.entries(geometry.attributes) as [string, BufferAttribute][]) {
    if (count === 0) throw new Error(`No ${name}`);
    checkNumbers(name, array);
  }
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    for (const { array } of targets) checkNumbers(`shape ${name}`, array);
    // three's renderer would throw an error.
    if (morphTargetInfluences?.length !== targets.length) throw new Error(`Shapes without influences: ${name}`);
  }
}

function checkPose({ root }: HatchedModel): void {
  root.updateMatrixWorld(true);
  const place = new Vector3();
  const matrix = new Matrix4();
  for (const mesh of meshesOf(root)) {
    if (!mesh.visible) continue;
    checkNumbers('matrix', mesh.matrixWorld.elements);
    checkNumbers('influences', mesh.morphTargetInfluences ?? []);
    mesh.getVertexPosition(0, place);
    checkNumbers('posed vertex', place.toArray());
    if (!('isInstancedMesh' in mesh)) continue;
    for (let i = 0; i < Math.min((mesh as InstancedMesh).count, 100); i++) {
      (mesh as InstancedMesh).getMatrixAt(i, matrix);
      checkNumbers('instance', matrix.elements);
    }
  }
}

function checkNumbers(what: string, values: ArrayLike<number>): void {
  for (let i = 0; i < values.length; i++) {
    if (!Number.isFinite(values[i])) throw new Error(`${what}[${i}] is ${values[i]}`);
  }
}
