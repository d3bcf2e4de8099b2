import { tell } from '../../mistakes/tell.js';

/** The oldest version of three.js, after its `0.`, that draws outlines of nodes. Of 0.186, which draws surfaces, they were missing. */
const OLDEST = 187;

let wasTold = false;

/**
 * Says once that outlines are missing, if they are.
 *
 * @param revision the version after its `0.`, such as `187` or `187dev`
 */
export function tellOfOlderThree(revision: string): void {
  if (wasTold || Number.parseInt(revision, 10) >= OLDEST) return;
  wasTold = true;
  tell(
    `HatchingOutlines of 'three-hatching/webgpu' need three.js 0.${OLDEST} or newer, but this is 0.${revision}: surfaces are drawn, outlines are not. Update three.js.`,
    'error',
  );
}
