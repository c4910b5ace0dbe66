// Finds the command `tip`.
import { execFile } from 'node:child_process';
import { homedir } from 'node:os';
import { join } from 'node:path';

/** The folder in which Cargo installs commands. */
export const cargoFolder = () => join(homedir(), '.cargo', 'bin');

/** The paths to try: that of the setting, else the name on PATH and the folder of Cargo. */
export function candidates(setting, folder) {
  const name = process.platform === 'win32' ? 'tip.exe' : 'tip';
  const path = setting.trim().replaceAll('${workspaceFolder}', folder ?? '.').replace(/^~(?=[/\\])/, homedir());
  return path === '' ? [name, join(cargoFolder(), name)] : [path];
}

/** The reason why a file is not the command; undefined if it is. */
function rejection(path) {
  return new Promise((resolve) => {
    execFile(path, ['--version'], { timeout: 10_000 }, (error, output) => {
      if (error?.code === 'ENOENT') resolve('missing');
      else if (typeof error?.code === 'string') resolve(error.message);
      // Another program may have the same name.
      else resolve(/^tip \d/.test(output) ? undefined : 'other');
    });
  });
}

/** The first candidate that is the command, or the reason why there is none. */
export async function find(setting, folder) {
  let reason;
  for (const path of candidates(setting, folder)) {
    const found = await rejection(path);
    if (found === undefined) return { path };
    if (reason === undefined || reason === 'missing') reason = found;
  }
  return { reason };
}
