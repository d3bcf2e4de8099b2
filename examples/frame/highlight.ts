/** What stands out in a source: comments, strings, and the words of the language. */
const PARTS =
  /(?<comment>\/\*[\s\S]*?\*\/|\/\/.*|<!--[\s\S]*?-->)|(?<string>'[^'\n]*'|"[^"\n]*"|`[^`]*`)|(?<word>\b(?:import|from|export|const|let|for|of|if|else|return|await|async|function|new|type|while)\b|<\/?[a-z][\w-]*)/g;

/** Writes a source into an element, its parts in spans that name them. */
export function highlight(element: HTMLElement, source: string): void {
  let end = 0;
  for (const match of source.matchAll(PARTS)) {
    const span = document.createElement('span');
    span.className = Object.keys(match.groups!).find((name) => match.groups![name] !== undefined)!;
    span.textContent = match[0];
    element.append(source.slice(end, match.index), span);
    end = match.index + match[0].length;
  }
  element.append(source.slice(end));
}
