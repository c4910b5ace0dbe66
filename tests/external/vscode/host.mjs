// code-server with the extension, and a Chromium that shows it.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const { CODE_SERVER, CODE_NODE = process.execPath, TIP, VSIX, SHOTS } = process.env;

const SETTINGS = {
  'workbench.startupEditor': 'none',
  'workbench.secondarySideBar.defaultVisibility': 'hidden',
  'chat.disableAIFeatures': true,
  'security.workspace.trust.enabled': false,
  'telemetry.telemetryLevel': 'off',
  'editor.minimap.enabled': false,
  'editor.hover.delay': 100,
  'window.confirmBeforeClose': 'never',
};

const freePort = () =>
  new Promise((resolve) => {
    const probe = createServer().listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });

/** An editor on files, by their names; `tip` is its setting tip.path, and `env` adds to its environment. */
export async function open(files, tip = TIP, env = {}) {
  const home = mkdtempSync(join(tmpdir(), 'tip-host-'));
  const folder = join(home, 'robot');
  mkdirSync(folder);
  // Where a command is belongs to the machine.
  for (const [whose, settings] of [['User', SETTINGS], ['Machine', { 'tip.path': tip }]]) {
    mkdirSync(join(home, 'data', whose), { recursive: true });
    writeFileSync(join(home, 'data', whose, 'settings.json'), JSON.stringify(settings));
  }
  for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);

  const folders = ['--user-data-dir', join(home, 'data'), '--extensions-dir', join(home, 'extensions')];
  const installed = spawnSync(CODE_NODE, [CODE_SERVER, ...folders, '--install-extension', VSIX], { encoding: 'utf8' });
  if (installed.status !== 0) throw new Error(installed.stdout + installed.stderr);
  const port = await freePort();
  const options = ['--auth', 'none', '--bind-addr', `127.0.0.1:${port}`, '--disable-telemetry', '--disable-update-check'];
  const server = spawn(CODE_NODE, [CODE_SERVER, ...folders, ...options, folder], {
    env: { ...process.env, ...env },
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  await new Promise((resolve, reject) => {
    server.stdout.on('data', (text) => String(text).includes('listening on') && resolve());
    server.on('exit', () => reject(new Error('code-server ended')));
  });

  const browser = await chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(`http://127.0.0.1:${port}/?folder=${folder}`);
  await page.waitForSelector('.monaco-workbench', { timeout: 120_000 });
  return {
    page,
    folder,
    async close() {
      await browser.close();
      server.kill();
      await new Promise((resolve) => server.once('exit', resolve));
      rmSync(home, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
    /** A picture to look at, where one is wanted. */
    async shot(name) {
      if (!SHOTS) return;
      mkdirSync(SHOTS, { recursive: true });
      await page.screenshot({ path: join(SHOTS, `${name}.png`) });
    },
  };
}
