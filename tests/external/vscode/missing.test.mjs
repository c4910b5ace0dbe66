// The extension without the command: a message says how to get it.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { open } from './host.mjs';

/** Opens a program in an editor with a setting tip.path and an environment. */
async function opened(setting, env) {
  const editor = await open({ 'walk.prg': '3.1\n\nEND\n' }, setting, env);
  const { page } = editor;
  page.setDefaultTimeout(30_000);
  await page.keyboard.press('Control+P');
  await page.locator('.quick-input-widget input').fill('walk.prg');
  await page.locator('.quick-input-list .monaco-list-row', { hasText: 'walk.prg' }).first().click();
  return editor;
}

test('a command that is not on PATH is reported with the line that installs it', async () => {
  const home = mkdtempSync(join(tmpdir(), 'tip-home-'));
  const { page, shot, close } = await opened('', { PATH: '/usr/bin:/bin', HOME: home });
  try {
    const message = page.locator('.notification-toast', { hasText: 'The command tip was not found on PATH' });
    await message.waitFor();
    const text = await message.innerText();
    for (const part of [join(home, '.cargo', 'bin'), 'cargo install --path tools/cli', 'tip.path']) {
      assert.ok(text.includes(part), text);
    }
    await shot('not-on-path');
  } finally {
    await close();
    rmSync(home, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
});

test('a setting that names no command is reported, and the button shows how to install it', async () => {
  const { page, shot, close } = await opened('/nowhere/tip');
  try {
    const message = page.locator('.notification-toast', { hasText: 'There is no command /nowhere/tip' });
    await message.waitFor();
    await shot('missing');
    await message.getByText('How to Install').click();
    const texts = () => Promise.all(page.frames().map((frame) => frame.locator('body').innerText({ timeout: 1000 }).catch(() => '')));
    let shown = false;
    for (let times = 0; times < 20 && !shown; times += 1) {
      await page.waitForTimeout(500);
      shown = (await texts()).some((text) => text.includes('cargo install --path tools/cli'));
    }
    await shot('installation');
    assert.ok(shown);
  } finally {
    await close();
  }
});
