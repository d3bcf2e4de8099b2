/**
 * The names of parts as users see and give them: those of the file, without blanks around them. Unnamed parts are numbered by their place,
 * and of parts with the same name all but the first get a number.
 *
 * @param names of the file, empty where it has none
 */
export function partNames(names: readonly string[]): string[] {
  const plain = names.map((name, i) => name.trim() || `Part ${i + 1}`);
  const all = new Set(plain);
  const counts = new Map<string, number>();
  return plain.map((name) => {
    let count = (counts.get(name) ?? 0) + 1;
    let unique = name;
    if (count > 1) {
      // A file may have “Wheel”, “Wheel” and “Wheel 2”.
      while (all.has(`${name} ${count}`)) count++;
      unique = `${name} ${count}`;
      all.add(unique);
    }
    counts.set(name, count);
    return unique;
  });
}
