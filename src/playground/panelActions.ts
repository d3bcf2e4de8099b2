import { LIGHT_LOOKS } from '../viewer/settings/lightLooks.js';
import { savedFormat } from '../viewer/settings/settingValues.js';
import type { Dialogs } from './dialogs/Dialogs.js';
import type { TakeAway } from './export/TakeAway.js';
import { findElement } from './page/findElement.js';
import type { PanelAction } from './panel/SettingsPanel.js';
import type { Session } from './session/Session.js';
import type { LaterParts } from './tasks/LaterParts.js';

/** The buttons of the panel, by the group of settings that they stand in. */
export function panelActions(
  session: Session,
  takeAway: TakeAway,
  dialogs: Dialogs,
  parts: LaterParts,
  fillScreen: () => void,
): readonly PanelAction[] {
  const { stage, settings } = session;
  const hand = parts.later(async () => {
    const { HandSheet } = await import('./hand/HandSheet.js');
    return new HandSheet(findElement('hand-sheet'), session);
  });
  const lights = Object.entries(LIGHT_LOOKS).map(
    ([label, look]): PanelAction => ({ label, group: 'Light', run: () => session.change(look) }),
  );
  const fullScreen: PanelAction = { label: 'Full screen (F)', group: 'View', run: fillScreen };
  const share: PanelAction = { label: 'Share this drawing', group: 'Picture', run: () => takeAway.run('share') };
  return [
    { label: 'Draw with your own hand', group: 'Drawing', run: () => hand.use((sheet) => sheet.open()) },
    { label: 'Show the map', group: 'Drawing', run: () => dialogs.showMap() },
    ...lights,
    { label: 'Show the whole model', group: 'View', run: stage.view.frameForUser },
    ...(document.fullscreenEnabled ? [fullScreen] : []),
    { label: () => `Save ${savedFormat(settings)}`, group: 'Picture', run: () => takeAway.run('savePng') },
    { label: 'Save SVG, as lines', group: 'Picture', run: () => takeAway.run('saveSvg') },
    { label: 'Copy the picture', group: 'Picture', run: () => takeAway.copy() },
    { label: 'Save with the model, as ZIP', group: 'Picture', run: () => takeAway.run('saveDrawing') },
    ...('share' in navigator ? [share] : []),
    { label: 'Copy a link to this drawing', group: 'Picture', run: () => takeAway.run('copyLink') },
    { label: 'Copy the facts for a report', group: 'Picture', run: () => takeAway.run('copyFacts') },
    { label: 'Code and embedding', group: 'Picture', run: () => takeAway.openCode() },
    { label: 'Record a video', group: 'Video', run: () => takeAway.run('saveVideo') },
  ];
}
