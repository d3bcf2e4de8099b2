import { plottingTime } from './plotTime.js';

/** A layer of which a note tells. Lengths in millimetres. */
interface NotedLayer {
  name: string;
  /** The width of the pen; null where paths are filled. */
  pen: number | null;
  paths: number;
  drawn: number;
  /** The estimated time of plotting; null where paths are filled. */
  plotSeconds: number | null;
}

const metres = (millimetres: number): string => `${(millimetres / 1000).toFixed(2)} m`;

/**
 * The lines of a note on a drawing for pens: the words of its user, then each layer with its pen, its paths, their length and the time of plotting, and last the
 * sum.
 *
 * @param words of the user; empty for none
 */
export function noteLines(words: string, layers: readonly NotedLayer[]): string[] {
  const own = words.split('\n').filter((line) => line.trim() !== '');
  const drawn = layers.reduce((sum, layer) => sum + layer.drawn, 0);
  const seconds = layers.reduce((sum, layer) => sum + (layer.plotSeconds ?? 0), 0);
  return [
    ...own,
    ...layers.map(
      ({ name, pen, paths, drawn, plotSeconds }) =>
        `${name}: ${pen} mm, ${paths.toLocaleString('en')} ${paths === 1 ? 'path' : 'paths'}, ${metres(drawn)}, ${plottingTime(plotSeconds ?? 0)}`,
    ),
    ...(layers.length > 1 ? [`In all ${metres(drawn)}, ${plottingTime(seconds)}`] : []),
  ];
}
