/** Runs in the page: whether nothing has been loading or drawn for a while. */
export function isSettled() {
  const { framesDrawn, isIdle } = window.__playground ?? { framesDrawn: 0, isIdle: false };
  const isReady = isIdle && document.documentElement.dataset.state === 'ready';
  if (!isReady || window.__seen?.framesDrawn !== framesDrawn) window.__seen = { framesDrawn, since: performance.now() };
  return performance.now() - window.__seen.since > 600;
}
