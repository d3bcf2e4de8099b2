import { type AnimationAction, type AnimationClip, AnimationMixer, type Mesh, type Object3D } from 'three';
import { meshesOf } from './meshesOf.js';

/** A frame that comes later than this, as after a page was hidden, moves no further. In seconds. */
const LONGEST_STEP = 0.1;

/** A shape of a mesh. */
interface MorphTarget {
  mesh: Mesh;
  index: number;
  /** How much there is of it where nothing moves. */
  rest: number;
}

/** How a model moves: one of its clips at a time, and shapes it can be morphed to. */
export class Motion {
  readonly clips: readonly string[];
  readonly morphs: readonly string[];
  isPlaying = false;
  /** 1 is as the clip was made. */
  speed = 1;

  private readonly mixer: AnimationMixer;
  private readonly morphTargets = new Map<string, MorphTarget[]>();
  /** Shapes that a person has taken from the clip, by how much of them there is. */
  private readonly overrides = new Map<string, number>();
  private action: AnimationAction | undefined;

  /** Shows the first clip, if there is any, at its beginning. */
  constructor(
    root: Object3D,
    private readonly animations: readonly AnimationClip[],
  ) {
    this.mixer = new AnimationMixer(root);
    this.clips = animations.map(({ name }, i) => name || `Clip ${i + 1}`);
    for (const mesh of meshesOf(root)) this.addMorphTargets(mesh);
    this.morphs = [...this.morphTargets.keys()];
    this.clip = 0;
  }

  /** Whether there is anything to move. */
  get canMove(): boolean {
    return this.clips.length > 0 || this.morphs.length > 0;
  }

  /** The number of the clip that is shown. */
  get clip(): number {
    return this.action ? this.animations.indexOf(this.action.getClip()) : -1;
  }

  set clip(index: number) {
    const clip = this.animations[index];
    if (!clip) return;
    this.mixer.stopAllAction();
    this.action = this.mixer.clipAction(clip).play();
    this.pose();
  }

  /** Seconds that the clip takes. */
  get duration(): number {
    return this.action?.getClip().duration ?? 0;
  }

  /** Seconds into the clip. */
  get time(): number {
    return this.action?.time ?? 0;
  }

  set time(seconds: number) {
    if (!this.action) return;
    this.action.time = seconds;
    this.pose();
  }

  /** Moves on, if it plays. */
  advance(seconds: number): void {
    if (this.isPlaying) this.pose(Math.min(seconds, LONGEST_STEP) * this.speed);
  }

  /** How much there is of a shape, usually in [0, 1]. */
  influenceOf(name: string): number {
    const [target] = this.morphTargets.get(name) ?? [];
    return target?.mesh.morphTargetInfluences?.[target.index] ?? 0;
  }

  /** Takes a shape from the clip and holds it; undefined gives it back. */
  setInfluence(name: string, influence: number | undefined): void {
    if (influence === undefined) {
      this.overrides.delete(name);
      for (const { mesh, index, rest } of this.morphTargets.get(name) ?? []) mesh.morphTargetInfluences![index] = rest;
      // Only stopping makes the mixer write again what it thinks is there already.
      const { time } = this;
      this.action?.stop().play();
      this.time = time;
    } else this.overrides.set(name, influence);
    this.pose();
  }

  dispose(): void {
    this.mixer.stopAllAction();
  }

  private pose(seconds = 0): void {
    this.mixer.update(seconds);
    for (const [name, influence] of this.overrides) {
      for (const { mesh, index } of this.morphTargets.get(name)!) mesh.morphTargetInfluences![index] = influence;
    }
  }

  /** Targets of one name are one shape, also on several meshes; a target without a name gets a number. */
  private addMorphTargets(mesh: Mesh): void {
    for (const [key, index] of Object.entries(mesh.morphTargetDictionary ?? {})) {
      const name = /^\d*$/.test(key) ? `Shape ${index + 1}` : key;
      const target = { mesh, index, rest: mesh.morphTargetInfluences?.[index] ?? 0 };
      this.morphTargets.set(name, [...(this.morphTargets.get(name) ?? []), target]);
    }
  }
}
