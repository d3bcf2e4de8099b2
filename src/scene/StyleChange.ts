import type { Material } from 'three';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { namesIn } from './GivenValues.js';
import type { SceneStyle } from './HatchingCall.js';
import type { InPlaceOf } from './meshLooks.js';
import type { OutlineMaker } from './OutlineMaker.js';
import type { Replacement } from './Replacement.js';

/** The names of the parameters that were passed beside a preset: they count more than what was edited before. */
const passedNames = ({ preset }: ApplyHatchingOptions, parameters: unknown): string[] =>
  preset !== undefined && typeof parameters === 'object' && parameters !== null
    ? [...Object.keys(parameters), ...namesIn(parameters)]
    : [];

/**
 * The change of a scene from one look to another. What was changed on the materials of the first is carried over, and they stay in use,
 * with the values of the second.
 */
export class StyleChange {
  /** For each new replacement, the one that it takes over from, and whether that one's material stays in use. */
  private readonly earlier = new Map<Replacement, { old: Replacement; stays: boolean }>();
  private readonly passed: string[];
  private readonly passedToOutlines: string[];

  /** @param given the options of the new look, as they were passed */
  constructor(
    private readonly from: SceneStyle,
    given: ApplyHatchingOptions,
  ) {
    this.passed = passedNames(given, given.material);
    this.passedToOutlines = passedNames(given, given.outlines);
  }

  /** Takes over edits when materials are new, so that their programs and geometries are made for them. */
  takeEdits(added: readonly Replacement[]): void {
    const free = new Set(this.from.replacements.values());
    const exact = added.filter((next) => this.pair(next, this.from.replacements.get(next.key), free));
    for (const next of added) {
      if (exact.includes(next)) continue;
      const alike = [...this.from.replacements.values()].filter(({ source }) => source === next.source);
      this.pair(next, alike.find((old) => free.has(old)) ?? alike[0], free);
    }
    for (const [next, { old }] of this.earlier) next.takeEdits(old, this.passed);
  }

  /** Lets the former materials take the place of the new ones. Must be called before the first draw. */
  finish(maker: OutlineMaker | null): { inPlaceOf: InPlaceOf; spent: Material[] } {
    const inPlaceOf = new Map<Material, Material>();
    for (const [next, { old, stays }] of this.earlier) {
      // Edits may have been made since.
      next.takeEdits(old, this.passed);
      if (!stays) continue;
      old.stop();
      inPlaceOf.set(next.material, old.material);
      next.moveTo(old.material);
    }
    for (const [surface, look] of [...(maker?.looks ?? [])]) {
      const held = (inPlaceOf.get(surface) ?? surface) as HatchingMaterial;
      const old = this.from.outlineMaker?.looks.get(held);
      maker!.looks.delete(surface);
      if (old) {
        old.given.copyEdits(old.material, look.material, this.passedToOutlines);
        old.material.copy(look.material);
        old.material.needsUpdate = true;
        inPlaceOf.set(look.material, old.material);
      }
      maker!.looks.set(held, { material: old?.material ?? look.material, given: look.given });
    }
    return { inPlaceOf, spent: [...inPlaceOf.keys()] };
  }

  private pair(next: Replacement, old: Replacement | undefined, free: Set<Replacement>): boolean {
    if (!old) return false;
    this.earlier.set(next, { old, stays: free.delete(old) });
    return true;
  }
}
