// The extension where the command is not: a message that leads to it.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { open } from './host.mjs';

const { page, shot, close } = await open({ 'walk.prg': '3.1\n\nEND\n' }, '/nowhere/tip');
after(close);
page.setDefaultTimeout(30_000);

test('a command that is missing is named, and how to install it', async () => {
  await page.keyboard.press('Control+P');
  await page.locator('.quick-input-widget input').fill('walk.prg');
  await page.locator('.quick-input-list .monaco-list-row', { hasText: 'walk.prg' }).first().click();
  const message = page.locator('.notification-toast', { hasText: 'The command /nowhere/tip is not found' });
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
});
