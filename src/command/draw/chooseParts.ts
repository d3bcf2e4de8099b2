import { ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import { changesBetween } from '../readOptions.js';

/** The parts that the command line names. */
interface NamedParts {
  /** Names of parts that are hidden; `*` stands for any letters. */
  hide: readonly string[];
  /** Names of the only parts that are drawn; empty for all. */
  only: readonly string[];
}

/** At most this many names are offered in place of an unknown one. */
const OFFERED = 3;

/**
 * The indices of the hidden parts of a model, in rising order.
 *
 * @param names of all parts
 * @param linked those that are hidden in a link, which count unless the only parts to draw are named
 * @param model its name, for the message
 * @throws ModelError that offers the nearest names, if there is no part of a name
 */
export function chooseParts(
  names: readonly string[],
  { hide, only }: NamedParts,
  linked: readonly number[],
  model: string,
): number[] {
  const hidden = new Set(only.length > 0 ? [] : linked);
  const kept = new Set(only.flatMap((wanted) => partsNamed(names, wanted, model)));
  if (only.length > 0) for (const part of names.keys()) if (!kept.has(part)) hidden.add(part);
  for (const wanted of hide) for (const part of partsNamed(names, wanted, model)) hidden.add(part);
  return [...names.keys()].filter((part) => hidden.has(part));
}

function partsNamed(names: readonly string[], wanted: string, model: string): number[] {
  const plain = wanted.trim().toLowerCase();
  const exact = names.findIndex((name) => name.toLowerCase() === plain);
  if (exact !== -1) return [exact];
  const pattern = plain.split('*').map((text) => text.replace(/[\\^$.+?()[\]{}|]/g, '\\$&'));
  const matcher = new RegExp(`^${pattern.join('.*')}$`, 's');
  const found = pattern.length > 1 ? [...names.keys()].filter((part) => matcher.test(names[part].toLowerCase())) : [];
  if (found.length > 0) return found;
  const nearest = nearestNames(names, plain).map(shownName);
  throw new ModelError(
    `${model} has no part ${shownName(wanted)}; ${nearest.length === 1 ? 'the nearest name is' : 'the nearest names are'} ${nearest.join(', ')}.`,
  );
}

/** The names with the fewest letters changed; first those that contain the wanted one. */
function nearestNames(names: readonly string[], wanted: string): string[] {
  const ranked = names.map((name) => {
    const plain = name.toLowerCase();
    return { name, distance: plain.includes(wanted) ? 0 : changesBetween(plain, wanted) };
  });
  return ranked
    .sort((a, b) => a.distance - b.distance)
    .slice(0, OFFERED)
    .map(({ name }) => name);
}
