import { LIGHT_LOOKS } from '../viewer/settings/lightLooks.js';
import { savedFormat } from '../viewer/settings/settingValues.js';
import type { Dialogs } from './dialogs/Dialogs.js';
import type { Exports } from './export/Exports.js';
import { findElement } from './page/findElement.js';
import type { PanelAction } from './panel/SettingsPanel.js';
import type { Session } from './session/Session.js';
import type { LaterParts } from './tasks/LaterParts.js';

/** The buttons of the panel by group of settings. */
export function panelActions(
  session: Session,
  exports: Exports,
  dialogs: Dialogs,
  parts: LaterParts,
  fillScreen: () => void,
): readonly PanelAction[] {
  const { viewport, settings } = session;
  const hand = parts.later(async () => {
    const { HandSheet } = await import('./hand/HandSheet.js');
    return new HandSheet(findElement('hand-sheet'), session);
  });
  const lights = Object.entries(LIGHT_LOOKS).map(
    ([label, look]): PanelAction => ({ label, group: 'Light', run: () => session.change(look) }),
  );
  const fullScreen: PanelAction = { label: 'Full screen (F)', group: 'View', run: fillScreen };
  const share: PanelAction = { label: 'Share this drawing', group: 'Picture', run: () => exports.run('share') };
  return [
    { label: 'Draw with your own hand', group: 'Drawing', run: () => hand.use((sheet) => sheet.open()) },
    { label: 'Show the map', group: 'Drawing', run: () => dialogs.showMap() },
    ...lights,
    { label: 'Show the whole model', group: 'View', run: viewport.view.frameForUser },
    ...(document.fullscreenEnabled ? [fullScreen] : []),
    { label: () => `Save ${savedFormat(settings)}`, group: 'Picture', run: () => exports.run('savePng') },
    { label: 'Save SVG, as lines', group: 'Picture', run: () => exports.run('saveSvg') },
    { label: 'Copy the picture', group: 'Picture', run: () => exports.copy() },
    { label: 'Save with the model, as ZIP', group: 'Picture', run: () => exports.run('saveDrawing') },
    ...('share' in navigator ? [share] : []),
    { label: 'Copy a link to this drawing', group: 'Picture', run: () => exports.run('copyLink') },
    { label: 'Copy the facts for a report', group: 'Picture', run: () => exports.run('copyFacts') },
    { label: 'Code and embedding', group: 'Picture', run: () => exports.openCode() },
    { label: 'Record a video', group: 'Video', run: () => exports.run('saveVideo') },
  ];
}
