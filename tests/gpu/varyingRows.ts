/** Counting the rows of varyings that two stages of a program need, after GLSL ES 3.00, section 11. */

/** A shader with its conditions resolved and the names of map coordinates replaced. */
export function preprocessed(source: string): string {
  const macros = new Map<string, string>();
  const open: { isOn: boolean; wasOn: boolean }[] = [];
  const lines: string[] = [];
  const isOn = () => open.every((one) => one.isOn);
  const decide = (condition: string): boolean => {
    let text = condition
      .replace(/\/\/.*/, '')
      .replace(/defined\s*\(?\s*(\w+)\s*\)?/g, (_, name: string) => (macros.has(name) ? '1' : '0'));
    for (let i = 0; i < 5; i++) text = text.replace(/\b[A-Za-z_]\w*\b/g, (name) => `(${macros.get(name) || '0'})`);
    return Boolean(new Function(`return (${text});`)());
  };
  const expanded = (line: string): string => {
    const replaced = line.replace(/\b(v[A-Z]\w*Uv|[A-Z]+_CHANNEL)\b/g, (name) => macros.get(name) ?? name);
    return replaced === line ? line : expanded(replaced);
  };
  for (const line of source.replace(/\/\*[\s\S]*?\*\//g, '').split('\n')) {
    const [, directive, rest = ''] = /^\s*#\s*(\w+)\s*(.*)$/.exec(line) ?? [];
    const last = open[open.length - 1];
    if (directive === 'if' || directive === 'ifdef' || directive === 'ifndef') {
      const name = /^\w+/.exec(rest)?.[0] ?? '';
      const holds = isOn() && (directive === 'if' ? decide(rest) : macros.has(name) === (directive === 'ifdef'));
      open.push({ isOn: holds, wasOn: holds });
    } else if (directive === 'elif' || directive === 'else') {
      last.isOn = false;
      last.isOn = !last.wasOn && open.slice(0, -1).every((one) => one.isOn) && (directive === 'else' || decide(rest));
      last.wasOn ||= last.isOn;
    } else if (directive === 'endif') open.pop();
    else if (!isOn()) continue;
    else if (directive === 'define') {
      const [, name, value] = /^(\w+)\s*(.*?)\s*(?:\/\/.*)?$/.exec(rest) ?? [];
      macros.set(name, value);
    } else if (directive === 'undef') macros.delete(rest.trim());
    else lines.push(expanded(line.replace(/\/\/.*/, '')));
  }
  return lines.join('\n');
}

const COMPONENTS: Record<string, number> = { float: 1, vec2: 2, vec3: 3, vec4: 4 };
const MATRICES: Record<string, [number, number]> = { mat3: [3, 3], mat4: [4, 4] };

/** Rows of four for the varyings that the fragment stage reads. */
export function varyingRows(vertexSource: string, fragmentSource: string): { rows: number; names: string[] } {
  const fragment = preprocessed(fragmentSource);
  const names: string[] = [];
  const ofSize = [0, 0, 0, 0, 0];
  for (const [, type, name, length] of preprocessed(vertexSource).matchAll(
    /^\s*varying\s+(\w+)\s+(\w+)\s*(?:\[\s*(\d+)\s*\])?\s*;/gm,
  )) {
    // The name occurs once where it is declared; one that is never read again is not a varying.
    if ((fragment.match(new RegExp(`\\b${name}\\b`, 'g')) ?? []).length < 2) continue;
    const [columns, size] = MATRICES[type] ?? [1, COMPONENTS[type]];
    if (!size) throw new Error(`varyingRows: ${name} is a ${type}, which is not known here.`);
    ofSize[size] += columns * Number(length ?? 1);
    names.push(`${type} ${name}${length ? `[${length}]` : ''}`);
  }
  const [, ones, twos, threes, fours] = ofSize;
  const halfRow = twos % 2;
  const left = Math.max(ones - threes - 2 * halfRow, 0);
  return { rows: fours + threes + Math.ceil(twos / 2) + Math.ceil(left / 4), names };
}
