import type { Material, WebGLRenderer } from 'three';

/** What three is to upload beside what it uploads anyway, when it goes on to another material, camera or program. */
type Wanted = 'nothing' | 'mesh' | 'all';

/** A uniform of a program, as three keeps it. */
interface ProgramUniform {
  readonly id: string;
}

/** What three keeps of a material, as far as it counts here. */
interface KeptByThree {
  /** The uniforms of the material that its present program has; null after another program was chosen. */
  uniformsList?: ProgramUniform[] | null;
}

/**
 * Lets three upload the uniforms that a mesh has for its own without all the others. By itself three uploads those of a material once for
 * all meshes in a row, and where `uniformsNeedUpdate` is set every one of them again, of which a program has about fifty.
 *
 * When three goes on to another material it first clears `uniformsNeedUpdate`, and then uploads its list of uniforms. For each mesh after
 * that it asks for `uniformsNeedUpdate`, uploads the list, and clears it. So the list is a short one from when three asks to when it
 * clears. Where three keeps no such list, it uploads all.
 */
export class MeshUniforms {
  private wanted: Wanted = 'nothing';
  private kept: KeptByThree | undefined;
  /** The list that three made, and what of it is of the mesh. */
  private whole: ProgramUniform[] | null = null;
  private short: ProgramUniform[] = [];

  /**
   * @param names of the uniforms that are of the mesh. Either no texture is among them or all that the programs of the material have are:
   *   each takes the unit that comes next.
   */
  constructor(
    private readonly material: Material,
    private readonly names: readonly string[],
  ) {
    Object.defineProperty(material, 'uniformsNeedUpdate', {
      get: () => {
        if (this.wanted === 'mesh') this.shorten();
        return this.wanted !== 'nothing';
      },
      set: (value: boolean) => {
        this.wanted = value ? 'all' : 'nothing';
        this.restore();
      },
      enumerable: true,
      configurable: true,
    });
  }

  /** Whether somebody asked for all uniforms of the material. Unlike `uniformsNeedUpdate` it changes nothing. */
  get isAllWanted(): boolean {
    return this.wanted === 'all';
  }

  /** Has the uniforms of the mesh uploaded that is about to be drawn. Allocates nothing. */
  want(renderer: WebGLRenderer): void {
    if (this.wanted === 'all') return;
    this.wanted = 'mesh';
    this.kept = renderer.properties?.get(this.material) as KeptByThree | undefined;
  }

  private shorten(): void {
    const { kept } = this;
    if (!kept?.uniformsList || kept.uniformsList === this.short) return;
    if (kept.uniformsList !== this.whole) this.take(kept.uniformsList);
    kept.uniformsList = this.short;
  }

  /** A function of its own: what a closure keeps is allocated whenever the function around it is called. */
  private take(list: ProgramUniform[]): void {
    this.whole = list;
    this.short = list.filter(({ id }) => this.names.includes(id));
  }

  private restore(): void {
    // Where three has chosen another program meanwhile, the list is of that.
    if (this.kept?.uniformsList === this.short) this.kept.uniformsList = this.whole;
    this.kept = undefined;
  }
}
