// Browsers of this machine, without a screen and with graphics by software.
import { execFileSync } from 'node:child_process';
import { chromium } from 'playwright-core';

const path = (name) => {
  try {
    return execFileSync('sh', ['-c', `command -v ${name}`]).toString().trim();
  } catch {
    return undefined;
  }
};

// The page itself is put together as on any machine without a graphics card: by the processor, and not by its graphics.
export function launch() {
  const args = ['--no-sandbox', '--enable-unsafe-swiftshader'];
  return chromium.launch({ executablePath: path('chromium'), args });
}

/** A page of its own with a recording. */
export function open(browser, file, options = {}, hash = '', prepare = undefined) {
  return visit(browser, `file://${file}${hash}`, options, prepare);
}

/** How long a new window of a browser is busy with its own menus: ms. They are pages as well, and take a third of a second. */
const MENUS = 1500;

/** Before a page whose time is taken: people open it in a window that is there already. */
export const settle = (page) => page.waitForTimeout(MENUS);

/** A page of its own, and all that it asked for and complained of. */
export async function visit(browser, address, options = {}, prepare = () => {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const [asked, complaints] = [[], []];
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url())) asked.push(request.url());
  });
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('dialog', (dialog) => complaints.push(`dialog: ${dialog.message()}`));
  await prepare(page);
  await page.goto(address);
  await page.waitForSelector('html[data-ready]', { state: 'attached', timeout: 30_000 });
  return { page, asked, complaints, close: () => context.close() };
}
