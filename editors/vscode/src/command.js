// Where the command `tip` is.
import { execFile } from 'node:child_process';
import { homedir } from 'node:os';
import { join } from 'node:path';

/** Where to look for it: where the settings say, else on PATH and where Cargo installs. */
export function places(setting, folder) {
  const name = process.platform === 'win32' ? 'tip.exe' : 'tip';
  const path = setting.trim().replaceAll('${workspaceFolder}', folder ?? '.').replace(/^~(?=[/\\])/, homedir());
  return path === '' ? [name, join(homedir(), '.cargo', 'bin', name)] : [path];
}

/** Why a file is not the command, or nothing if it is. */
function wrong(path) {
  return new Promise((resolve) => {
    execFile(path, ['--version'], { timeout: 10_000 }, (error, output) => {
      if (error?.code === 'ENOENT') resolve('missing');
      else if (typeof error?.code === 'string') resolve(error.message);
      // Linux has a command of the same name for networks.
      else resolve(/^tip \d/.test(output) ? undefined : 'other');
    });
  });
}

/** The first place where the command is; if nowhere, why. */
export async function find(setting, folder) {
  let reason;
  for (const path of places(setting, folder)) {
    const found = await wrong(path);
    if (found === undefined) return { path };
    if (reason === undefined || reason === 'missing') reason = found;
  }
  return { reason };
}
