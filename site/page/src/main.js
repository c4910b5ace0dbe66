// The playground: a program is edited, checked while it is typed, run, and replayed by the page of `tipc view`.

import { Editor } from './editor.js';
import { fragmentOf, readFragment } from './link.js';
import { load } from './load.js';
import { page as replayOf } from './replay.js';
import { speak, spoken, told, whenSpoken, word } from './words.js';

const element = (id) => document.getElementById(id);

function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Robots, examples and lessons of ../../contents.json, and their files by path; put here by ../assemble.mjs. */
const { robots, examples, lessons, files } = CONTENTS;
/** How long one waits for the next key before a text is checked: ms. */
const QUIET = 150;

class Playground {
  constructor(ask, page) {
    this.ask = ask;
    this.page = page;
    this.editor = new Editor(element('editor'), () => this.changed(), () => this.run());
    this.findings = [];
    this.listen();
    whenSpoken(() => this.say());
  }

  listen() {
    element('choice').addEventListener('change', ({ target }) => {
      const [kind, number] = target.value.split(' ');
      if (number) this.open({ [kind]: Number(number) });
    });
    element('earlier').addEventListener('click', () => this.open({ lesson: this.lesson - 1 }));
    element('later').addEventListener('click', () => this.open({ lesson: this.lesson + 1 }));
    element('bar').addEventListener('submit', (event) => {
      event.preventDefault();
      this.run();
    });
    element('robot').addEventListener('change', () => this.changed());
    element('events').addEventListener('input', () => this.changed());
    element('share').addEventListener('click', () => this.share());
    element('language').addEventListener('click', () => speak(spoken() === 'ja' ? 'en' : 'ja'));
    window.addEventListener('hashchange', () => this.openAddress());
  }

  /** What the address names; else the first lesson. */
  async openAddress() {
    if (location.hash === this.address) return;
    let wanted;
    try {
      wanted = await readFragment(location.hash);
    } catch {
      this.notice(word('unreadable'));
    }
    this.open(wanted ?? { lesson: 1 });
  }

  open({ lesson, example, text, robot, events }) {
    const shown = lesson ? lessons[lesson - 1] : examples[example - 1];
    const known = shown ?? (text === undefined ? lessons[0] : { robot, events });
    this.lesson = known === lessons[0] && !shown ? 1 : shown && lesson;
    this.choice = this.lesson ? `lesson ${this.lesson}` : shown ? `example ${example}` : 'own';
    element('robot').value = known.robot in robots ? known.robot : 'titan8';
    element('events').value = known.events ?? '';
    this.name = known.program?.split('/').at(-1) ?? 'program.prg';
    this.editor.show(text ?? files[known.program]);
    this.remember(this.choice === 'own' ? location.hash : `#${this.choice.replace(' ', '=')}`);
    this.say();
    this.run();
  }

  state() {
    return { text: this.editor.text, robot: element('robot').value, events: element('events').value };
  }

  remember(address) {
    this.address = address;
    try {
      history.replaceState(null, '', address || location.pathname);
    } catch {
      // A page inside another one may have no address of its own.
    }
  }

  changed() {
    clearTimeout(this.due);
    this.due = setTimeout(async () => {
      this.check();
      this.remember(await fragmentOf(this.state()));
    }, QUIET);
  }

  /** A question about the program as it is. */
  question(task) {
    const { text, robot: name, events } = this.state();
    const { robot, scene } = robots[name];
    const filled = (one) => one && { name: one.name, text: files[one.name] };
    return { task, program: { name: this.name, text }, robot: filled(robot), scene: filled(scene), events, lang: spoken() };
  }

  check() {
    this.showFindings(this.ask(this.question('check')));
  }

  showFindings({ findings = [], error = '' }) {
    this.findings = findings;
    this.notice(error);
    this.editor.mark(findings);
    const rows = findings.map((finding) => {
      const help = finding.help ? [make('small', { textContent: finding.help })] : [];
      const button = make('button', { type: 'button' }, make('b', { textContent: `${word('line', finding.line)} ` }), finding.reason, ...help);
      button.addEventListener('click', () => this.editor.goTo(finding));
      return make('li', { className: finding.level }, button);
    });
    element('findings').replaceChildren(...rows);
  }

  run() {
    clearTimeout(this.due);
    element('run').disabled = true;
    element('run').textContent = word('running');
    // The button is drawn before the run, which leaves no time for it.
    setTimeout(() => {
      const answer = this.ask(this.question('run'));
      this.showFindings(answer);
      if (answer.recording) element('view').srcdoc = replayOf(this.page, this.name, answer.recording, spoken());
      else if (!answer.error) this.notice(word('wrong'));
      element('run').disabled = false;
      element('run').textContent = word('run');
    }, 30);
  }

  async share() {
    const address = `${location.href.split('#')[0]}${await fragmentOf(this.state())}`;
    this.remember(`#${address.split('#')[1]}`);
    try {
      await navigator.clipboard.writeText(address);
      this.notice(word('copied'));
    } catch {
      // A page in a file may not.
      this.notice(word('inAddress'));
    }
  }

  notice(text) {
    element('notice').textContent = text;
  }

  /** Everything that is said in a language. */
  say() {
    const options = (list, kind) => list.map(({ title }, n) => make('option', { value: `${kind} ${n + 1}`, textContent: kind === 'lesson' ? `${n + 1}. ${told(title)}` : told(title) }));
    const group = (label, list) => {
      const made = make('optgroup', {}, ...list);
      made.label = label;
      return made;
    };
    element('choice').replaceChildren(
      group(word('tour'), options(lessons, 'lesson')),
      group(word('examples'), options(examples, 'example')),
      make('option', { value: 'own', textContent: word('own') }),
    );
    element('choice').value = this.choice ?? 'own';
    const robot = element('robot').value;
    element('robot').replaceChildren(...Object.entries(robots).map(([value, { title }]) => make('option', { value, textContent: told(title) })));
    element('robot').value = robot in robots ? robot : 'titan8';
    this.sayLesson();
    if (this.name) this.check();
  }

  sayLesson() {
    const lesson = lessons[this.lesson - 1];
    element('lesson').hidden = !lesson;
    if (!lesson) return;
    element('lesson-title').textContent = told(lesson.title);
    element('lesson-text').replaceChildren(...told(lesson.text).map((textContent) => make('p', { textContent })));
    element('lesson-try').textContent = word('try', told(lesson.try));
    element('lesson-number').textContent = word('of', this.lesson, lessons.length);
    element('earlier').disabled = this.lesson === 1;
    element('later').disabled = this.lesson === lessons.length;
  }
}

async function begin() {
  speak(navigator.language.startsWith('ja') ? 'ja' : 'en');
  const { ask, page } = await load();
  const playground = new Playground(ask, page);
  playground.say();
  await playground.openAddress();
  document.documentElement.dataset.ready = Math.round(performance.now());
}

begin();
