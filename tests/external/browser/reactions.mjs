// Measures how soon a robot on simulated servos reacts to an emergency stop, and to the loss of the driver's page, and reads the
// registers of its servos afterwards: node reactions.mjs [stops|losses] [TIMES]. To cut the network between two namespaces, it needs
// root.
import { execFileSync, spawn } from 'node:child_process';
import { chmodSync, closeSync, constants, mkdtempSync, openSync, readFileSync, readSync, writeFileSync, writeSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { chromium } from 'playwright-core';
import { launch, visit } from './browsers.mjs';
import { serve } from './served.mjs';
import { Viewer, spread, wait } from './viewer.mjs';

const [kind, times] = [process.argv[2] ?? 'stops', Number(process.argv[3] ?? 100)];
const folder = mkdtempSync(join(tmpdir(), 'tip-reactions-'));
const WATCHERS = 20;

/** Starts servos on a pseudo-terminal, which outlive the server. */
async function bus(robot) {
  const child = spawn(process.env.TIP, ['drives', 'simulate', robot], { stdio: ['ignore', 'pipe', 'inherit'] });
  const line = await new Promise((resolve) => createInterface(child.stdout).once('line', resolve));
  return { port: /\/dev\/\S+?(?=[;,\s]|$)/.exec(line)[0], end: () => child.kill('SIGINT') };
}

/** Reads the torque switch of each servo, register 40 of an STS3215, by a request of its protocol. */
async function torque(port) {
  const file = openSync(port, constants.O_RDWR | constants.O_NOCTTY | constants.O_NONBLOCK);
  const states = [];
  for (const id of [1, 2, 3]) {
    const body = [id, 4, 2, 40, 1];
    const answer = Buffer.alloc(64);
    let state;
    for (let tries = 0; tries < 20 && state === undefined; tries += 1) {
      writeSync(file, Buffer.from([255, 255, ...body, ~body.reduce((sum, byte) => sum + byte, 0) & 255]));
      await wait(50);
      let count = 0;
      try {
        count = readSync(file, answer);
      } catch {
        continue;
      }
      const at = answer.subarray(0, count).lastIndexOf(Buffer.from([255, 255, id, 3]));
      if (at >= 0) state = answer[at + 5];
    }
    states.push(state);
  }
  closeSync(file);
  return states.join(' ');
}

/** Writes the description of the leg of the tests, with other times of silence, and with tolerance for servos on a pseudo-terminal. */
function robot(silence) {
  const file = join(folder, `leg-${silence.join('-')}.toml`);
  const text = readFileSync('leg.toml', 'utf8').replace(/driver_silence.*/, `driver_silence = ${JSON.stringify(silence)}`);
  // On a busy machine a pseudo-terminal passes answers on late.
  writeFileSync(file, text.replace('servo =', 'latency = 20\nsilence = 100\nservo ='));
  return file;
}

const run = (file, port, ...options) => serve('steered.prg', '--hardware', file, '--port', port, ...options);

/** Stops the robot on the page of a watcher, and returns the time until the page shows the stop, by its own clock. */
const stops = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        const state = document.getElementById('drive-state');
        const begin = performance.now();
        const seen = new MutationObserver(() => {
          const found = /Stopped in (\d+) ms/.exec(state.textContent);
          if (!found) return;
          seen.disconnect();
          resolve(performance.now() - begin);
        });
        seen.observe(state, { childList: true });
        document.getElementById('stop').click();
      }),
  );

async function measureStops(isFlooded) {
  const browser = await launch();
  const file = robot([0.8, 600, 600]);
  const servos = await bus(file);
  const server = await run(file, servos.port);
  const driver = await Viewer.at(server.address);
  const { page } = await visit(browser, server.address, { viewport: { width: 390, height: 844 } });
  const [told, shown] = [[], []];
  let flood = [];
  if (isFlooded) {
    flood = await Promise.all(Array.from({ length: WATCHERS }, () => Viewer.at(server.address)));
    for (const one of flood) one.timer = setInterval(() => one.socket.bufferedAmount < 1e5 && Array.from({ length: 10 }, () => one.send({ do: 'hover', at: [3, 3] })), 20);
  }
  for (let n = 0; n < times; n += 1) {
    await driver.start();
    await page.waitForFunction(() => document.getElementById('drive-state').textContent.includes('The program runs'));
    shown.push(await stops(page));
    await driver.until(({ phase }) => phase === 'left', 'it is left');
    told.push(driver.robot.stopped_in);
    driver.release();
    // In the first second after the stop of another page a restart is refused.
    await wait(1100);
    if (n + 1 === times) break;
    driver.send({ do: 'restart' });
    await driver.until(({ phase }) => phase === 'ready', 'it is ready');
  }
  for (const one of [driver, ...flood]) one.close();
  await browser.close();
  await server.end();
  const states = await torque(servos.port);
  servos.end();
  const sent = isFlooded ? `, ${flood.reduce((sum, { id }) => sum + id, 0)} messages of ${WATCHERS} watchers` : '';
  console.log(`emergency stop of a watcher's page${sent}: torque of the servos ${states} (it holds)`);
  console.log(`  until the servos are told: ${spread(told)}`);
  console.log(`  until the page shows it:   ${spread(shown)}`);
}

/** Makes a network of its own for a browser, which reaches the server over a line that can be cut. */
function network() {
  const ip = (...words) => execFileSync('ip', words);
  const name = 'tip-phone';
  ip('netns', 'add', name);
  ip('link', 'add', 'tip-host', 'type', 'veth', 'peer', 'name', 'tip-page', 'netns', name);
  ip('addr', 'add', '10.77.0.1/24', 'dev', 'tip-host');
  ip('link', 'set', 'tip-host', 'up');
  ip('-n', name, 'addr', 'add', '10.77.0.2/24', 'dev', 'tip-page');
  ip('-n', name, 'link', 'set', 'tip-page', 'up');
  ip('-n', name, 'link', 'set', 'lo', 'up');
  process.on('exit', () => ip('netns', 'del', name));
  const inside = join(folder, 'chromium');
  writeFileSync(inside, `#!/bin/sh\nexec ip netns exec ${name} chromium "$@"\n`);
  chmodSync(inside, 0o755);
  return {
    inside,
    cut: () => ip('link', 'set', 'tip-host', 'down'),
    mend: () => ip('link', 'set', 'tip-host', 'up'),
    /** Sends a signal to the processes of pages. */
    signal: (signal) => {
      const pids = ip('netns', 'pids', name).toString().trim().split('\n').map(Number);
      for (const pid of pids.filter((pid) => readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes('--type=renderer'))) process.kill(pid, signal);
    },
  };
}

const throttle = () => {
  window.asleep = setInterval(() => {
    const end = performance.now() + 990;
    while (performance.now() < end);
  }, 1000);
};

const LOSSES = {
  'button released': [({ page }) => page.dispatchEvent('#hold', 'pointerup'), () => {}],
  'page out of focus': [({ page }) => page.evaluate(() => window.dispatchEvent(new Event('blur'))), () => {}],
  'page hidden': [({ page }) => page.evaluate(() => document.dispatchEvent(new Event('visibilitychange'))), () => {}],
  'page suspended': [({ line }) => line.signal('SIGSTOP'), ({ line }) => line.signal('SIGCONT')],
  // On a phone that is asleep a timer fires once a second at most.
  'timers throttled': [({ page }) => page.evaluate(throttle), ({ page }) => page.evaluate(() => clearInterval(window.asleep))],
  'server frozen for 1 s': [({ server }) => process.kill(server.pid, 'SIGSTOP'), async ({ server }) => process.kill(server.pid, 'SIGCONT')],
  'network cut': [({ line }) => line.cut(), ({ line }) => line.mend()],
};

async function measureLosses() {
  const line = network();
  const browser = await chromium.launch({ executablePath: line.inside, args: ['--no-sandbox', '--enable-unsafe-swiftshader'] });
  // On a busy machine the page may be silent for longer than the default of 0.3 s.
  const file = robot([0.8, 600, 600]);
  const servos = await bus(file);
  const server = await run(file, servos.port, '--listen', '10.77.0.1:0');
  const watcher = await Viewer.at(server.address);
  const open = async () => {
    const view = await visit(browser, server.address, { viewport: { width: 390, height: 844 }, hasTouch: true });
    await view.page.waitForSelector('html[data-hardware]', { state: 'attached' });
    return { ...view, server, line };
  };
  const press = async ({ page }) => {
    for (let tries = 0; tries < 40; tries += 1) {
      // A connection that was lost does not drive when it is back.
      await page.evaluate(() => document.getElementById('take').hidden || document.getElementById('take').click());
      await page.waitForSelector('#give:not([hidden])', { timeout: 4000 }).catch(() => {});
      await page.dispatchEvent('#hold', 'pointerup');
      await page.evaluate(() => {
        const button = document.getElementById('hold');
        button.setPointerCapture = () => {};
        button.dispatchEvent(new PointerEvent('pointerdown', { button: 0, pointerId: 7, bubbles: true }));
      });
      if (await watcher.until(({ phase, stage }) => phase === 'running' && stage === 'driven', 'it is driven', 8000).catch(() => undefined)) return;
    }
    throw new Error(`it is not driven: ${await page.textContent('#drive-state')}`);
  };
  const view = await open();
  for (const [name, [lose, mend]] of Object.entries(LOSSES)) {
    const found = [];
    for (let n = 0; n < times; n += 1) {
      await press(view);
      await wait(100);
      const begin = performance.now();
      const reacts = watcher.until(({ stage }) => stage === 'paused', name);
      if (name.startsWith('server')) {
        await lose(view);
        await wait(1000);
        await mend(view);
      } else await lose(view);
      found.push((await reacts) - begin);
      const { cycles } = watcher.robot;
      if (!name.startsWith('server')) await mend(view);
      // Coming back moves nothing.
      await wait(200);
      if (watcher.robot.stage !== 'paused') throw new Error(`${name}: it moves by itself, ${cycles}`);
    }
    console.log(`${name}: paused after ${spread(found)}`);
  }
  await view.close();
  await server.end();
  console.log(`  the servos after Ctrl-C: torque ${await torque(servos.port)} (it relaxes)`);
  servos.end();
  // The reactions after the pause are measured with the default times.
  const ends = {
    'page closed': ['steered.prg', ['paused', 'halt'], 'it relaxes'],
    'page closed, a program that hears no halt': ['deaf.prg', ['paused', 'halt', 'emergency'], 'it holds'],
  };
  for (const [name, [program, stages, how]] of Object.entries(ends)) {
    const own = robot([0.3, 3, 10]);
    const line = await bus(own);
    const lost = await serve(program, '--hardware', own, '--port', line.port);
    const viewer = await Viewer.at(lost.address);
    const driver = await Viewer.at(lost.address);
    await driver.start();
    const begin = performance.now();
    driver.close();
    const at = [];
    for (const stage of stages) {
      const heard = await viewer.until((robot) => robot.stage === stage, stage);
      at.push(`${stage} ${(heard - begin).toFixed(0)} ms`);
    }
    await viewer.until(({ phase }) => phase === 'left', 'it is left');
    viewer.close();
    await lost.end();
    console.log(`${name}: ${at.join(', ')}; torque ${await torque(line.port)} (${how})`);
    line.end();
  }
  await browser.close();
}

if (kind === 'stops') {
  await measureStops(false);
  await measureStops(true);
} else await measureLosses();
process.exit();
