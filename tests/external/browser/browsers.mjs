// Starts the browsers of this machine, without a screen and with graphics by software.
import { execFileSync } from 'node:child_process';
import { chromium } from 'playwright-core';

const path = (name) => {
  try {
    return execFileSync('sh', ['-c', `command -v ${name}`]).toString().trim();
  } catch {
    return undefined;
  }
};

// The processor composes the page, as on any machine without a graphics card.
export function launch() {
  const args = ['--no-sandbox', '--enable-unsafe-swiftshader'];
  return chromium.launch({ executablePath: path('chromium'), args });
}

/** Opens a recording in a page of its own. */
export function open(browser, file, options = {}, hash = '', prepare = undefined) {
  return visit(browser, `file://${file}${hash}`, options, prepare);
}

/** Time for which a new window of a browser is busy with its own menus, ms. Menus are pages, too, and take a third of a second. */
const MENUS = 1500;

/** Waits before the time of a page is taken. People open it in a window that is there already. */
export const settle = (page) => page.waitForTimeout(MENUS);

/** Opens an address in a page of its own. Returns the page, the addresses that it asked for, and its complaints. */
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
