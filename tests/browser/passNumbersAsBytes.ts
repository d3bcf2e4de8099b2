import type { Page } from '@playwright/test';

/**
 * Lets `page.evaluate` pass long lists of numbers as bytes, there and back. Playwright passes a list number by number, which for a
 * small picture takes longer than everything else in a test. What arrives is the same.
 */
export function passNumbersAsBytes(page: Page): void {
  const evaluate = page.evaluate.bind(page) as (pageFunction: unknown, argument?: unknown) => Promise<unknown>;
  page.evaluate = (async (pageFunction: unknown, argument: unknown) => {
    if (typeof pageFunction !== 'function') return evaluate(pageFunction, argument);
    const source = `async (argument) => (${packed})(await (${pageFunction})((${unpacked})(argument)))`;
    // Playwright passes a function by its text.
    const whole = Object.assign(() => {}, { toString: () => source });
    return unpacked(await evaluate(whole, packed(argument)));
  }) as Page['evaluate'];
}

/** Replaces long lists of numbers, within lists and plain objects too. Runs in the page as well. */
function packed(value: unknown): unknown {
  const copies = new Map<object, unknown>();
  const pack = (one: unknown): unknown => {
    if (typeof one !== 'object' || one === null) return one;
    if (copies.has(one)) return copies.get(one);
    if (Array.isArray(one)) {
      let isOfNumbers = one.length > 256;
      let isOfBytes = true;
      // A loop, since array methods skip holes.
      for (let i = 0; isOfNumbers && i < one.length; i++) {
        isOfNumbers = typeof one[i] === 'number';
        isOfBytes &&= Object.is(one[i] & 255, one[i]);
      }
      if (isOfNumbers) return { numbersAsBytes: isOfBytes ? Uint8Array.from(one) : Float64Array.from(one) };
      const list: unknown[] = [];
      copies.set(one, list);
      for (const item of one) list.push(pack(item));
      return list;
    }
    const prototype = Object.getPrototypeOf(one);
    if (prototype !== Object.prototype && prototype !== null) return one;
    const object: Record<string, unknown> = {};
    copies.set(one, object);
    for (const [key, item] of Object.entries(one)) object[key] = pack(item);
    return object;
  };
  return pack(value);
}

/** Undoes {@link packed}, in place. Runs in the page as well. */
function unpacked(value: unknown): unknown {
  const seen = new Set<object>();
  const unpack = (one: unknown): unknown => {
    if (typeof one !== 'object' || one === null || seen.has(one)) return one;
    const prototype = Object.getPrototypeOf(one);
    if (!Array.isArray(one) && prototype !== Object.prototype && prototype !== null) return one;
    const { numbersAsBytes } = one as { numbersAsBytes?: Float64Array };
    if (numbersAsBytes) return Array.from(numbersAsBytes);
    seen.add(one);
    for (const [key, item] of Object.entries(one)) (one as Record<string, unknown>)[key] = unpack(item);
    return one;
  };
  return unpack(value);
}
