/**
 * Sets the state of the page, which style sheets and tests can read: `lost` is without a graphics context, `failed` is
 * final.
 */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  document.documentElement.dataset.state = state;
}
