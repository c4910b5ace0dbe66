// Counts late cycles of a robot on simulated servos, with a page connected and without one: node late.mjs [CYCLES [PERIOD]]. Both robots
// run at the same time, so that whatever else the machine does disturbs both.
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';
import { Viewer } from './viewer.mjs';

const [CYCLES, PERIOD] = [Number(process.argv[2] ?? 1e5), Number(process.argv[3] ?? 5)];

/** Writes the description of the leg of the tests, for which nobody needs to hold a button. */
function robot() {
  const text = readFileSync('leg.toml', 'utf8').replace(/driver_silence.*/, 'hold_to_drive = false\ndriver_silence = [3600, 3600, 3600]');
  const file = join(mkdtempSync(join(tmpdir(), 'tip-late-')), 'leg.toml');
  writeFileSync(file, text.replace('[bus]', `[standards]\nperiod = ${PERIOD}\n\n[bus]`));
  return file;
}

const browser = await launch();
const one = async (hasPage) => {
  const server = await serve('steered.prg', '--hardware', robot(), '--port', 'simulated');
  const driver = await Viewer.at(server.address);
  await driver.start();
  driver.close();
  const view = hasPage ? await visit(browser, server.address, { viewport: { width: 390, height: 844 } }) : undefined;
  await new Promise((resolve) => setTimeout(resolve, CYCLES * PERIOD));
  const last = await Viewer.at(server.address);
  const { late, phase, bus } = last.robot;
  last.close();
  await view?.close();
  await server.end();
  return `${hasPage ? 'a page' : 'no page'}: ${late} of about ${CYCLES} cycles of ${PERIOD} ms were late; ${phase}, bus ${bus.toFixed(2)} ms`;
};
console.log((await Promise.all([one(false), one(true)])).join('\n'));
await browser.close();
