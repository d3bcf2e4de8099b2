/** Whether warnings are turned off; `HatchingMaterial.silent` sets it. */
export const silence = { isOn: false };

/**
 * Writes a warning to the console, unless the library is silent.
 *
 * @param level `error` if something is not drawn at all
 */
export function warn(sentence: string, level: 'warn' | 'error' = 'warn'): void {
  if (!silence.isOn) console[level](sentence);
}

let hasWarned = false;

/**
 * Warns once that WebGPURenderer, with any backend, cannot draw materials written in GLSL. three.js only names the material and draws
 * its default material instead; this message also gives the remedy.
 *
 * @param what the name of the class
 * @param hasTwin whether `three-hatching/webgpu` has a class of the same name
 */
export function warnOfRenderer(what: string, hasTwin = true): void {
  if (hasWarned) return;
  hasWarned = true;
  warn(
    `${what}: WebGPURenderer draws no materials that are written in GLSL, with its WebGL 2 backend neither. Draw the scene with WebGLRenderer, from 'three'${hasTwin ? ", or take what has the same name in 'three-hatching/webgpu'" : ''}.`,
    'error',
  );
}

/**
 * Makes a promise warn, once, that an `await` is missing when a property of its result is read from the promise itself.
 *
 * @param call the function that returns the promise
 * @param members properties of the result that a caller without `await`, or three.js, would read first
 */
export function mustBeAwaited<Result>(
  promise: Promise<Result>,
  call: string,
  members: readonly (keyof Result & string)[],
): Promise<Result> {
  let hasWarned = false;
  for (const member of members) {
    Object.defineProperty(promise, member, {
      get() {
        if (!hasWarned) warn(`${call} returns a promise, which has no "${member}". Write await before the call.`);
        hasWarned = true;
      },
    });
  }
  return promise;
}

/** Whether a value is a promise, that is, whether an `await` is missing. */
export const isPromise = (value: unknown): boolean =>
  typeof (value as Partial<Promise<unknown>> | null | undefined)?.then === 'function';
