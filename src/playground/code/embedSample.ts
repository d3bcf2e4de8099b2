import { shownName } from '../../viewer/files/common/shownText.js';
import { escapeHtml } from './escapeHtml.js';

/** HTML that shows the playground, without its panel, in another page. */
export function embedSample(address: string, title: string): string {
  return `<iframe
  src="${escapeHtml(address)}"
  title="Hatched drawing: ${escapeHtml(shownName(title))}"
  width="800"
  height="600"
  style="max-width: 100%; border: 0"
  loading="lazy"
  allow="fullscreen"
></iframe>
`;
}
