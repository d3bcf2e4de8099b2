import { expect, test } from 'vitest';
import { type KeptLook, KeptLooks, MOST_LOOKS } from '../../../../src/playground/savedLooks/SavedLooks.js';
import { acceptLook, hasLook, presetLook } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

/** Storage that can be full, and shared by several tabs. */
function fakeStorage() {
  const entries = new Map<string, string>();
  const storage = {
    isFull: false,
    getItem: (key: string) => entries.get(key) ?? null,
    setItem(key: string, value: string) {
      if (storage.isFull) throw new DOMException('Full.', 'QuotaExceededError');
      entries.set(key, value);
    },
    damage: (text: string) => entries.set([...entries.keys()][0] ?? 'three-hatching looks', text),
  };
  return storage;
}

const lookNamed = (name: string): KeptLook => ({
  id: name,
  name,
  look: acceptLook({ ...defaultSettings(), ...presetLook('pencil'), shadows: 'on' }),
  picture: 'data:image/webp;base64,AAAA',
});
const add = (name: string) => (looks: readonly KeptLook[]) => [...looks, lookNamed(name)];
const namesOf = (kept: KeptLooks) => kept.list.map(({ name }) => name);

test('looks are restored on the next page, with every value', () => {
  const storage = fakeStorage();
  expect(new KeptLooks(() => storage as never).change(add('soft'))).toBe(true);
  const later = new KeptLooks(() => storage as never);
  expect(later.list).toEqual([lookNamed('soft')]);
  const settings = { ...defaultSettings(), ...later.list[0].look };
  expect(settings).toMatchObject({ technique: 'dryMedia', shadows: 'on' });
  expect(hasLook(settings, later.list[0].look)).toBe(true);
  expect(hasLook({ ...settings, ink: '#123456' }, later.list[0].look)).toBe(false);
});

test('looks saved in two tabs are in both', () => {
  const storage = fakeStorage();
  const [one, other] = [new KeptLooks(() => storage as never), new KeptLooks(() => storage as never)];
  one.change(add('a'));
  other.change(add('b'));
  one.refresh();
  expect(namesOf(one)).toEqual(['a', 'b']);
});

test('nothing is lost if the browser stores nothing or is out of space', () => {
  const storage = fakeStorage();
  const kept = new KeptLooks(() => storage as never);
  kept.change(add('kept'));
  storage.isFull = true;
  expect(kept.change(add('second'))).toBe(false);
  kept.refresh();
  expect(kept.change(add('third'))).toBe(false);
  expect(namesOf(kept)).toEqual(['kept', 'second', 'third']);
  storage.isFull = false;
  expect(kept.change((looks) => looks)).toBe(true);
  expect(namesOf(new KeptLooks(() => storage as never))).toEqual(['kept', 'second', 'third']);
  const none = new KeptLooks(() => {
    throw new DOMException('Denied.', 'SecurityError');
  });
  expect(none.change(add('only here'))).toBe(false);
  expect(namesOf(none)).toEqual(['only here']);
});

test('valid looks are read from damaged or hostile storage, with allowed values only', () => {
  const storage = fakeStorage();
  const read = (text: string) => {
    storage.damage(text);
    return new KeptLooks(() => storage as never).list;
  };
  for (const text of ['{', 'null', '7', '{"length":3}', '[1,null,[],{"id":"x"},{"id":"x","look":7,"name":"x"}]'])
    expect(read(text), text).toEqual([]);
  const hostile = {
    id: 'x',
    name: 'a\u202Eb',
    look: { technique: 'nonsense', ink: 'red', strokeWidth: 1e9, mapStyle: 'file', model: 'cube', edge: {} },
    picture: 'https://evil.test/track.png',
  };
  const [{ name, look, picture }] = read(
    `[${JSON.stringify(hostile).replace('"look":{', '"look":{"__proto__":{"a":1},')}]`,
  );
  expect(name).toBe('a b');
  expect(picture).toBeUndefined();
  expect(look).toEqual({ ...acceptLook({}), strokeWidth: 8 });
  expect(read(JSON.stringify(Array(500).fill(lookNamed('x'))))).toHaveLength(MOST_LOOKS);
});
