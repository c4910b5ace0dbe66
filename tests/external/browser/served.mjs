// Programs that `tip serve` serves, each a copy in a folder of its own.
import { spawn } from 'node:child_process';
import { copyFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { createInterface } from 'node:readline';

/** Serves a copy of a program until `end()`, which gives the exit status; `said()` is what it has written to stderr. */
export async function serve(program, ...options) {
  const file = join(mkdtempSync(join(tmpdir(), 'tip-serve-')), basename(program));
  copyFileSync(program, file);
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
  return { file, address, end, pid: child.pid, said: () => said };
}
