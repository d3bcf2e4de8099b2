/** The elements of figures/index.html that the script works on. */
export const figuresPage = {
  figures: find('figures'),
  turn: find('turn') as HTMLInputElement,
  turnValue: find('turn-value'),
  hand: find('hand'),
  status: find('status'),
};

function find(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`figuresPage: figures/index.html has no element with the id "${id}"; add it back.`);
  return element;
}
