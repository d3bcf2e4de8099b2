import { type AnimationAction, type AnimationClip, AnimationMixer, type Mesh, type Object3D } from 'three';
import { distinctNames } from '../files/common/ModelError.js';
import { meshesOf } from './meshes.js';

/** The longest step between two frames, in seconds. Longer pauses, for instance in a hidden tab, are cut to it. */
const LONGEST_STEP = 0.1;

/** One morph target of one mesh. */
interface MorphTarget {
  mesh: Mesh;
  index: number;
  /** Its influence as stored in the file. */
  rest: number;
}

/** The animation of a model: one of its clips at a time, and its morph targets. */
export class Motion {
  readonly clips: readonly string[];
  readonly morphs: readonly string[];
  isPlaying = false;
  /** Speed factor of the clip. */
  speed = 1;

  private readonly mixer: AnimationMixer;
  private readonly morphTargets = new Map<string, MorphTarget[]>();
  /** Influences set by the user, which override the clip. */
  private readonly overrides = new Map<string, number>();
  private action: AnimationAction | undefined;

  /** Poses the model at the start of its first clip, if it has one. */
  constructor(
    root: Object3D,
    private readonly animations: readonly AnimationClip[],
  ) {
    this.mixer = new AnimationMixer(root);
    this.clips = distinctNames(
      animations.map(({ name }) => name),
      'Clip',
    );
    for (const mesh of meshesOf(root)) this.addMorphTargets(mesh);
    this.morphs = [...this.morphTargets.keys()];
    this.clip = 0;
  }

  /** Whether there is any clip or morph target. */
  get canMove(): boolean {
    return this.clips.length > 0 || this.morphs.length > 0;
  }

  /** Index of the active clip, or −1. */
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

  /** Length of the clip, in seconds. */
  get duration(): number {
    return this.action?.getClip().duration ?? 0;
  }

  /** Time in the clip, in seconds. */
  get time(): number {
    return this.action?.time ?? 0;
  }

  set time(seconds: number) {
    if (!this.action) return;
    this.action.time = seconds;
    this.pose();
  }

  /** Advances the clip if it is playing. */
  advance(seconds: number): void {
    if (this.isPlaying) this.pose(Math.min(seconds, LONGEST_STEP) * this.speed);
  }

  /** The influence of a morph target, usually in [0, 1]. */
  influenceOf(name: string): number {
    const [target] = this.morphTargets.get(name) ?? [];
    return target?.mesh.morphTargetInfluences?.[target.index] ?? 0;
  }

  /** Sets the influence of a morph target, overriding the clip. `undefined` returns it to the clip. */
  setInfluence(name: string, influence: number | undefined): void {
    if (influence === undefined) {
      this.overrides.delete(name);
      for (const { mesh, index, rest } of this.morphTargets.get(name) ?? []) mesh.morphTargetInfluences![index] = rest;
      // The mixer skips values that it has written before. Stopping the action makes it write them again.
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

  /** Groups morph targets of the same name, also across meshes. Unnamed ones get a number. */
  private addMorphTargets(mesh: Mesh): void {
    for (const [key, index] of Object.entries(mesh.morphTargetDictionary ?? {})) {
      const name = /^\d*$/.test(key) ? `Shape ${index + 1}` : key;
      const target = { mesh, index, rest: mesh.morphTargetInfluences?.[index] ?? 0 };
      this.morphTargets.set(name, [...(this.morphTargets.get(name) ?? []), target]);
    }
  }
}
