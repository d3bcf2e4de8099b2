import { beforeEach, expect, test, vi } from 'vitest';
import { askToFetch } from '../../../../src/playground/loading/ask.js';
import { LinkFollower } from '../../../../src/playground/session/LinkFollower.js';
import type { ModelFile } from '../../../../src/viewer/files/common/ModelFile.js';
import type { Settings } from '../../../../src/viewer/settings/settings.js';
import { type ModelChoice, NO_CHOICE } from '../../../../src/viewer/settings/shareLink.js';

vi.mock('../../../../src/playground/loading/ask.js', () => ({ askToFetch: vi.fn() }));

const ADDRESS = 'https://models.test/bunny.ply';

beforeEach(() => void vi.clearAllMocks());

interface PageContent {
  address?: string;
  drawing?: string;
  /** What the link describes. */
  link?: { settings?: Partial<Settings>; namesModel?: boolean; choice?: ModelChoice };
  /** The user's own model. */
  shown?: { settings?: Partial<Settings>; files?: readonly ModelFile[]; choice?: ModelChoice };
}

/** A follower of links on a page that shows a cube, and what it does to that. */
function onPage({ address, drawing, link = {}, shown = {} }: PageContent = {}) {
  const linked = {
    settings: { model: 'file', ink: '#123456' } as Partial<Settings>,
    namesModel: true,
    camera: undefined,
    address,
    views: [],
    hand: undefined,
    choice: NO_CHOICE as ModelChoice,
    ...link,
  };
  const modelLoader = {
    ownFiles: shown.files,
    choice: shown.choice ?? NO_CHOICE,
    showAddress: vi.fn(),
    showSomething: vi.fn(),
  };
  const session = {
    settings: { model: 'cube', ...shown.settings },
    modelLoader,
    linked: () => linked,
    showState: vi.fn(),
    showLook: vi.fn(),
    recordChange: vi.fn(),
  };
  const store = { open: vi.fn(async () => undefined) };
  const follower = new LinkFollower(session as never, { drawing, read: () => '' } as never, store as never);
  return { follower, session, modelLoader };
}

test('a model of another site is fetched if the user agrees; if not, something else is shown', async () => {
  const { follower, modelLoader } = onPage();
  vi.mocked(askToFetch).mockResolvedValueOnce(false);
  await follower.showAddress(ADDRESS, true, NO_CHOICE);
  expect([modelLoader.showAddress.mock.calls, modelLoader.showSomething.mock.calls.length]).toEqual([[], 1]);
  vi.mocked(askToFetch).mockResolvedValueOnce(true);
  await follower.showAddress(ADDRESS, true, NO_CHOICE);
  expect([modelLoader.showAddress.mock.calls, modelLoader.showSomething.mock.calls.length]).toEqual([
    [[ADDRESS, true, NO_CHOICE]],
    1,
  ]);
});

test('an agreement is ignored once the address has changed', async () => {
  const { follower, modelLoader, session } = onPage();
  let agree = (_: boolean): void => {};
  vi.mocked(askToFetch).mockImplementationOnce(() => new Promise((resolve) => (agree = resolve)));
  const asked = follower.showAddress(ADDRESS, true, NO_CHOICE);
  await follower.follow();
  agree(true);
  await asked;
  expect(vi.mocked(askToFetch).mock.calls[0][1].aborted).toBe(true);
  expect([modelLoader.showAddress.mock.calls, modelLoader.showSomething.mock.calls]).toEqual([[], []]);
  expect(session.showState).toHaveBeenCalledOnce();
});

test('until the user has agreed, the look of a link is shown on the model that is there', async () => {
  const { follower, session, modelLoader } = onPage({ address: ADDRESS });
  vi.mocked(askToFetch).mockResolvedValueOnce(true);
  await follower.follow();
  expect(session.showState).not.toHaveBeenCalled();
  expect(session.showLook.mock.calls[0][0].settings).toEqual({ model: 'cube', ink: '#123456' });
  expect(modelLoader.showAddress).toHaveBeenCalledExactlyOnceWith(ADDRESS, true, NO_CHOICE);
});

test.each([
  [{ upAxis: 'y' }, 'z'],
  [{ upAxis: '-z' }, '-z'],
] as const)('an address that names no model is a look for the user’s own one: %j', async (turn, upAxis) => {
  const files = [{ name: 'chair.stl' }] as unknown as readonly ModelFile[];
  const link = { settings: { model: 'dragon3', ink: '#123456', ...turn }, namesModel: false } as const;
  const shown = { files, settings: { model: 'file', upAxis: 'z' } } as const;
  const { follower, session } = onPage({ link, shown });
  await follower.follow();
  const [state] = session.showState.mock.calls[0];
  expect(state).toMatchObject({ settings: { model: 'file', ink: '#123456', upAxis }, files });
});

test('an address that names no model leaves the variant and the clip of the user’s own one, unless it asks for others', async () => {
  const files = [{ name: 'shoe.glb' }] as unknown as readonly ModelFile[];
  const shown = { files, choice: { variant: 1, clip: 2 } };
  const asked = { variant: undefined, clip: 3 };
  const { follower, session } = onPage({ link: { namesModel: false, choice: asked }, shown });
  await follower.follow();
  expect(session.showState.mock.calls[0][0]).toMatchObject({ choice: { variant: 1, clip: 3 }, files });
});

test('an address that names no model shows the first one where the user has none', async () => {
  const { follower, session } = onPage({ link: { settings: { model: 'dragon3' }, namesModel: false } });
  await follower.follow();
  expect(session.showState.mock.calls[0][0]).toMatchObject({ settings: { model: 'dragon3' }, files: undefined });
});
