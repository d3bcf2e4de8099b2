/**
 * Keeps the lines of an OBJ file that triangles are drawn from, in the form that three's loader reads: vertices, faces and the use of materials.
 * The loader takes words of a comment for corners, faces beside lines or points for lines, and minutes for many groups.
 */
export function cleanObj(text: string): string {
  return withAllColors(
    withLineFeeds(text)
      .replace(/\\[ \t]*\n/g, ' ')
      // Names of materials may hold a "#".
      .replace(/^([ \t]*(?:v[tn]?|f)[ \t][^#\n]*)#.*$/gm, '$1')
      .replace(/^[ \t]*usemtl[ \t]+/gm, 'usemtl ')
      .replace(/^(?![ \t]*(?:v[tn]?|f)[ \t]|usemtl ).+$/gm, ''),
  );
}

/** Makes vertices without a colour white where others have one. three's loader would give the colours to the wrong vertices. */
function withAllColors(text: string): string {
  if (!/^[ \t]*v(?:[ \t]+\S+){6}/m.test(text)) return text;
  return text.replace(/^([ \t]*v(?:[ \t]+\S+){3})(?:[ \t]+\S+){0,2}[ \t]*$/gm, '$1 1 1 1');
}

/** The names of material files in an OBJ file, line by line. A line may have several, see {@link namesIn}. */
export function materialLibraries(text: string): string[] {
  return [...withLineFeeds(text).matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t]*$/gm)].map(([, names]) => names ?? '');
}

/** The names in a line with several. They may contain spaces, and are told apart by their extension. */
export function namesIn(line: string): string[] {
  return line.match(/\S.*?\.mtl(?=\s|$)|\S.*/gi) ?? [];
}

/** Keeps the lines of an MTL file that a hatched surface shows: colours, their pictures, and cut-outs. */
export function cleanMtl(text: string): string {
  return (
    withLineFeeds(text)
      .replace(/^[ \t]*(newmtl|Kd|map_Kd|map_d)[ \t]+/gim, '$1 ')
      .replace(/^(?!(?:newmtl|Kd|map_Kd|map_d) ).+$/gim, '')
      // A colour may be one number, for all three, or a spectrum, which nothing reads.
      .replace(/^Kd ([-+.\de]+)[ \t]*$/gim, 'Kd $1 $1 $1')
      .replace(/^Kd (?:spectral|xyz).*$/gim, '')
      // These are options, which three's loader takes for a part of the name.
      .replace(/^(map_.*)$/gim, (line: string) => line.replace(MAP_OPTION, ''))
  );
}

const MAP_OPTION =
  /-(?:(?:blendu|blendv|cc|clamp|imfchan|type|texres|boost|bm)[ \t]+\S+|t(?:[ \t]+-?[\d.]+){1,3})[ \t]+/gi;

const withLineFeeds = (text: string): string => (text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text);
