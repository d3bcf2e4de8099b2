import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** Whether the history has a commit: a shallow clone may not, and an unpacked archive has no history. */
export function hasCommit(commit, folder = root) {
  return spawnSync('git', ['cat-file', '-e', `${commit}^{commit}`], { cwd: folder, stdio: 'ignore' }).status === 0;
}
