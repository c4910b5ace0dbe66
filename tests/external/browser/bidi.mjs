// Drives Debian's Firefox by WebDriver BiDi, because Playwright cannot. It has a screen in memory and graphics by software.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const PREFERENCES = { 'webgl.force-enabled': true, 'webgl.forbid-software': false, 'intl.accept_languages': 'en', 'ui.systemUsesDarkTheme': 0 };

/** Resolves to the first match in the output of a process. */
function reads(stream, pattern) {
  return new Promise((resolve) => {
    let text = '';
    stream.on('data', (data) => {
      text += data;
      const found = pattern.exec(text);
      if (found) resolve(found[1]);
    });
  });
}

/** Starts Firefox; `changed` preferences replace those that all tests have. */
export async function launchFirefox(changed = {}) {
  const screen = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', '1400x1000x24'], { stdio: ['ignore', 'pipe', 'ignore'] });
  const display = await reads(screen.stdout, /(\d+)\n/);
  const profile = mkdtempSync(join(tmpdir(), 'tip-firefox-'));
  const preferences = Object.entries({ ...PREFERENCES, ...changed }).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`);
  writeFileSync(join(profile, 'user.js'), preferences.join(''));
  const env = { ...process.env, DISPLAY: `:${display}`, MOZ_X11_EGL: '1', LIBGL_ALWAYS_SOFTWARE: '1' };
  const firefox = spawn('firefox-esr', ['--no-remote', '--profile', profile, '--remote-debugging-port', '0'], { env, stdio: ['ignore', 'ignore', 'pipe'] });
  const address = await reads(firefox.stderr, /WebDriver BiDi listening on (ws:\S+)/);
  const session = await Session.at(`${address}/session`);
  return {
    session,
    async close() {
      for (const process of [firefox, screen]) {
        process.kill();
        await new Promise((resolve) => process.once('exit', resolve));
      }
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

class Session {
  static async at(address) {
    const session = new Session();
    session.socket = new WebSocket(address);
    session.waiting = new Map();
    session.last = 0;
    session.socket.onmessage = ({ data }) => session.take(JSON.parse(data));
    await new Promise((resolve) => (session.socket.onopen = resolve));
    await session.send('session.new', { capabilities: {} });
    await session.send('session.subscribe', { events: ['log.entryAdded', 'network.beforeRequestSent'] });
    const { contexts } = await session.send('browsingContext.getTree');
    session.context = contexts[0].context;
    return session;
  }

  take(message) {
    if (message.id) {
      const { resolve, reject } = this.waiting.get(message.id);
      if (message.type === 'error') reject(new Error(`${message.error}: ${message.message}`));
      else resolve(message.result);
    } else if (message.method === 'log.entryAdded') {
      if (['error', 'warn'].includes(message.params.level)) this.complaints.push(message.params.text);
    } else if (!/^(data|blob):/.test(message.params.request.url)) this.asked.push(message.params.request.url);
  }

  send(method, params = {}) {
    this.last += 1;
    this.socket.send(JSON.stringify({ id: this.last, method, params }));
    return new Promise((resolve, reject) => this.waiting.set(this.last, { resolve, reject }));
  }

  /** Calls a function in the page, and returns its result. Arguments and result are JSON. */
  async run(task, ...values) {
    const expression = `(async () => JSON.stringify(await (${task})(...${JSON.stringify(values)})))()`;
    const answer = await this.send('script.evaluate', { expression, target: { context: this.context }, awaitPromise: true });
    if (answer.type === 'exception') throw new Error(answer.exceptionDetails.text);
    return answer.result.value === undefined ? undefined : JSON.parse(answer.result.value);
  }

  /** Opens a page. */
  async load(url) {
    [this.asked, this.complaints] = [[], []];
    // It goes there from another page, because a new fragment alone opens nothing anew.
    await this.send('browsingContext.navigate', { context: this.context, url: 'about:blank', wait: 'complete' });
    await this.send('browsingContext.navigate', { context: this.context, url, wait: 'complete' });
  }

  /** Opens a page and waits until it is ready. */
  async open(url) {
    await this.load(url);
    await this.ready();
  }

  /** Waits until the page that is shown is ready. */
  async ready() {
    await this.run(async () => {
      while (!document.documentElement.dataset.ready) await new Promise((resolve) => setTimeout(resolve, 50));
    });
  }
}
