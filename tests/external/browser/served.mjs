// Serves programs and tables by `tip serve`.
import { spawn } from 'node:child_process';
import { copyFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { createInterface } from 'node:readline';

/** Serves a copy of a program until `end()`, which returns the exit status. `said()` returns the text on stderr so far. */
export async function serve(program, ...options) {
  const file = join(mkdtempSync(join(tmpdir(), 'tip-serve-')), basename(program));
  copyFileSync(program, file);
  return { file, ...(await serveFile(file, ...options)) };
}

/** Serves a file, a program or a table, where it is. */
export async function serveFile(file, ...options) {
  const child = spawn(process.env.TIP, ['serve', '--quiet', file, ...options], { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  child.stderr.on('data', (data) => {
    said += data;
    process.stderr.write(data);
  });
  const address = await new Promise((resolve) => createInterface(child.stdout).once('line', resolve));
  const over = new Promise((resolve) => child.on('exit', resolve));
  const end = () => {
    child.kill('SIGINT');
    return over;
  };
  return { address, end, pid: child.pid, said: () => said };
}
