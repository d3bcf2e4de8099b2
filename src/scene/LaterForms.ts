import type { BufferAttribute, BufferGeometry } from 'three';
import { hatchNormal } from '../bake/hatchNormal.js';
import { expectForm, isFormed } from '../geometry/formGeometry.js';
import { MANY_TRIANGLES, type PrepareHatchingGeometryOptions } from '../geometry/prepareHatchingGeometry.js';
import { tell } from '../mistakes/tell.js';
import { bakeGeometries, cornerCount, type GeometryPlan } from './bakeGeometries.js';

/**
 * Bakes the fields of lines that follow the form for large geometries after the scene was hatched, so that its first picture never
 * waits for them: it is drawn with lines around the light.
 */
export class LaterForms {
  /** The plans of all geometries, without the fields that come later. */
  readonly atOnce: ReadonlyMap<BufferGeometry, GeometryPlan>;
  private readonly later = new Map<BufferGeometry, GeometryPlan>();
  /** For each geometry with a plan for later, the prepared one that is drawn until then. */
  private readonly drawn = new Map<BufferGeometry, BufferGeometry>();
  private readonly stopping = new AbortController();

  /** @param disposables holds the geometries that are drawn */
  constructor(
    plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
    private readonly options: PrepareHatchingGeometryOptions,
    private readonly disposables: { dispose(): void }[],
  ) {
    this.atOnce = new Map(
      [...plans].map(([geometry, plan]) => {
        if (!plan.form || cornerCount(geometry) <= 3 * MANY_TRIANGLES) return [geometry, plan];
        this.later.set(geometry, plan);
        return [geometry, { ...plan, form: false }];
      }),
    );
  }

  /** Says what is drawn until the fields are there. To be called before the first draw. */
  drawMeanwhile(baked: ReadonlyMap<BufferGeometry, BufferGeometry | Error>): void {
    for (const source of this.later.keys()) {
      const prepared = baked.get(source);
      if (!prepared || prepared instanceof Error) continue;
      expectForm(prepared);
      this.drawn.set(source, prepared);
    }
  }

  /**
   * Bakes the fields.
   *
   * @returns for each geometry that is drawn now the one that replaces it: none if the bake was stopped or has failed, or where a
   *   shape has no form
   */
  async bake(): Promise<ReadonlyMap<BufferGeometry, BufferGeometry>> {
    const { signal } = this.stopping;
    const replaced = new Map<BufferGeometry, BufferGeometry>();
    const plans = new Map([...this.later].filter(([source]) => this.drawn.has(source)));
    if (plans.size === 0) return replaced;
    try {
      const options = { ...this.options, onProgress: undefined, signal };
      for (const [source, formed] of await bakeGeometries(plans, options, { onBaked: () => {} })) {
        if (formed instanceof Error) sayFailed(formed);
        else if (isFormed(formed)) replaced.set(this.drawn.get(source)!, formed);
      }
    } catch (error) {
      if (!signal.aborted) sayFailed(error as Error);
    }
    for (const [drawn, formed] of replaced) {
      copyOcclusion(drawn, formed);
      this.disposables[this.disposables.indexOf(drawn)] = formed;
    }
    this.later.clear();
    this.drawn.clear();
    return replaced;
  }

  /** Stops the bake. */
  stop(): void {
    this.stopping.abort();
  }
}

const sayFailed = ({ message }: Error): void =>
  tell(`applyHatching: lines go by the light, because their form could not be baked. ${message}`);

/** Copies what `bakeOcclusion` has written meanwhile. The corners of both geometries are the same. */
function copyOcclusion(from: BufferGeometry, to: BufferGeometry): void {
  const source = from.attributes[hatchNormal.name] as BufferAttribute;
  const target = to.attributes[hatchNormal.name] as BufferAttribute;
  for (let corner = 0; corner < cornerCount(to); corner++)
    target.setW(to.index?.getX(corner) ?? corner, source.getW(from.index?.getX(corner) ?? corner));
}
