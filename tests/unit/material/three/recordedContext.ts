/** A call of WebGL that tests look at. */
export interface Call {
  name: 'uniform' | 'draw' | 'link';
  /** The uniform that was set. */
  uniform?: string;
  /** Of a draw: the mode and the number of vertices. */
  mode?: number;
  count?: number;
}

const TYPES: Readonly<Record<string, number>> = {
  float: 0x1406,
  vec2: 0x8b50,
  vec3: 0x8b51,
  vec4: 0x8b52,
  int: 0x1404,
  uint: 0x1405,
  bool: 0x8b56,
  mat3: 0x8b5b,
  mat4: 0x8b5c,
  sampler2D: 0x8b5e,
  highpSampler2D: 0x8b5e,
  samplerCube: 0x8b60,
  usampler2D: 0x8dd2,
  sampler2DArray: 0x8dc1,
};

const POINTS = 0;
const TRIANGLES = 4;
export const MODES = { POINTS, TRIANGLES };

/** Answers of the context, by the name of what is asked. */
const ANSWERS: Readonly<Record<string, unknown>> = {
  VERSION: 'WebGL 2.0',
  SHADING_LANGUAGE_VERSION: 'WebGL GLSL ES 3.00',
  SCISSOR_BOX: [0, 0, 8, 8],
  VIEWPORT: [0, 0, 8, 8],
};

interface Shader {
  source: string;
}

interface Program {
  shaders: Shader[];
  uniforms: { name: string; type: number; size: number }[];
}

/** The uniforms that a program declares, whichever of them its conditions leave: of plain types. */
function uniformsOf(source: string): Program['uniforms'] {
  const declared = source.matchAll(/^\s*uniform (?:(?:high|medium|low)p )?(\w+) (\w+)(?:\[ ?(\d+) ?\])?;/gm);
  const found = new Map<string, Program['uniforms'][number]>();
  for (const [, type, name, count] of declared) {
    if (type in TYPES)
      found.set(name, { name: count ? `${name}[0]` : name, type: TYPES[type], size: Number(count ?? 1) });
  }
  return [...found.values()];
}

/**
 * A WebGL 2 context that draws nothing and records what a renderer asks of it, so that a whole WebGLRenderer of any version runs without a
 * browser.
 */
export function recordedContext(): { context: WebGL2RenderingContext; canvas: HTMLCanvasElement; calls: Call[] } {
  const calls: Call[] = [];
  const numbers = new Map<string, number>();
  const numberOf = (name: string): number => {
    if (!numbers.has(name)) numbers.set(name, 100_000 + numbers.size);
    return numbers.get(name)!;
  };
  const nameOf = (number: number): string | undefined => [...numbers].find(([, known]) => known === number)?.[0];
  const draw = (mode: number, count: number): void => void calls.push({ name: 'draw', mode, count });
  const functions: Record<string, (...given: never[]) => unknown> = {
    getContextAttributes: () => ({ alpha: true, antialias: false }),
    getExtension: () => ({}),
    getSupportedExtensions: () => [],
    getParameter: (what: number) => ANSWERS[nameOf(what) ?? ''] ?? 16,
    getShaderPrecisionFormat: () => ({ precision: 23, rangeMin: 127, rangeMax: 127 }),
    createShader: () => ({ source: '' }),
    shaderSource: (shader: Shader, source: string) => void Object.assign(shader, { source }),
    createProgram: () => ({ shaders: [], uniforms: [] }),
    attachShader: (program: Program, shader: Shader) => void program.shaders.push(shader),
    linkProgram: (program: Program) => {
      program.uniforms = uniformsOf(program.shaders.map(({ source }) => source).join('\n'));
      calls.push({ name: 'link' });
    },
    getProgramParameter: (program: Program, what: number) => {
      const name = nameOf(what);
      if (name === 'ACTIVE_UNIFORMS') return program.uniforms.length;
      return name === 'ACTIVE_ATTRIBUTES' || name === 'ACTIVE_UNIFORM_BLOCKS' ? 0 : true;
    },
    getActiveUniform: (program: Program, i: number) => program.uniforms[i],
    getUniformLocation: (_program: Program, name: string) => ({ name }),
    getProgramInfoLog: () => '',
    getShaderInfoLog: () => '',
    getShaderParameter: () => true,
    getAttribLocation: () => -1,
    getError: () => 0,
    isContextLost: () => false,
    checkFramebufferStatus: () => numberOf('FRAMEBUFFER_COMPLETE'),
    drawArrays: (mode: number, _first: number, count: number) => draw(mode, count),
    drawElements: (mode: number, count: number) => draw(mode, count),
    drawArraysInstanced: (mode: number, _first: number, count: number) => draw(mode, count),
    drawElementsInstanced: (mode: number, count: number) => draw(mode, count),
  };
  const setUniform = (location: { name: string } | null): void => {
    if (location) calls.push({ name: 'uniform', uniform: location.name.replace('[0]', '') });
  };
  const context = new Proxy({} as Record<string, unknown>, {
    get(known, name: string) {
      if (name in known) return known[name];
      if (name === 'POINTS' || name === 'TRIANGLES') return MODES[name];
      if (name in functions) return functions[name];
      if (/^uniform(Matrix)?\d/.test(name)) return setUniform;
      if (/^[A-Z]/.test(name)) return numberOf(name);
      return /^create/.test(name) ? () => ({}) : () => undefined;
    },
    set(known, name: string, value) {
      known[name] = value;
      return true;
    },
    has: () => true,
  }) as unknown as WebGL2RenderingContext;
  const canvas = Object.assign(new EventTarget(), {
    width: 8,
    height: 8,
    style: {},
    getContext: () => context,
  }) as unknown as HTMLCanvasElement;
  return { context, canvas, calls };
}
