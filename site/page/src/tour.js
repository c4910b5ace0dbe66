// The content of the playground: lessons, examples and programs of one's own, and their addresses.

import { element, make } from '../../../tools/view/page/src/dom.js';
import { notice } from '../../../tools/view/page/src/page.js';
import { spoken, whenSpoken, word } from '../../../tools/view/page/src/words.js';
import { fragmentOf, readFragment } from './link.js';

/** Robots, examples and lessons of ../../contents.json, and their files by path; put here by ../assemble.mjs. */
const { robots, examples, lessons, files } = CONTENTS;
const told = (texts) => texts[spoken()];
/** The name of the pupil in the address of the page, since pupils may share a browser. */
const PUPIL = new URLSearchParams(location.search).get('pupil') ?? '';
const SHELF = `tip-lessons ${PUPIL}`;

/** Returns the texts that were written into lessons and examples before, by choice. */
function readKept() {
  try {
    return new Map(JSON.parse(localStorage.getItem(SHELF) ?? '[]'));
  } catch {
    // A page may have no storage.
    return new Map();
  }
}

export class Tour {
  constructor(session) {
    this.session = session;
    this.kept = readKept();
    session.listen((update) => {
      if (update.type === 'text') this.edited(update.text);
    });
    element('choice').addEventListener('change', ({ target }) => {
      const [kind, number] = target.value.split(' ');
      if (number) this.open({ [kind]: Number(number) });
    });
    element('lesson-before').addEventListener('click', () => this.open({ lesson: this.lesson - 1 }));
    element('lesson-after').addEventListener('click', () => this.open({ lesson: (this.lesson ?? 0) + 1 }));
    element('original').addEventListener('click', () => {
      const [kind, number] = this.choice.split(' ');
      this.keep(undefined);
      this.open({ [kind]: Number(number) });
    });
    element('wanted').addEventListener('submit', (event) => event.preventDefault());
    element('robot').addEventListener('change', () => this.begin());
    element('scripted').addEventListener('change', () => this.begin());
    element('share').addEventListener('click', () => this.share());
    window.addEventListener('hashchange', () => this.openAddress());
    whenSpoken(() => this.say());
  }

  /** Opens the lesson, example or program that the address names; else a robot that walks. */
  async openAddress() {
    if (location.hash === this.address) return;
    let wanted;
    try {
      wanted = await readFragment(location.hash);
    } catch {
      notice(word('unreadable'));
    }
    this.open(wanted ?? { example: 1 });
  }

  /** A lesson or an example by its number, or { text, robot, events }. */
  open({ lesson, example, text, robot, events }) {
    const shown = lesson ? lessons[lesson - 1] : examples[example - 1];
    const known = shown ?? (text === undefined ? lessons[0] : { robot, events });
    this.lesson = known === lessons[0] ? 1 : shown && lesson;
    this.choice = this.lesson ? `lesson ${this.lesson}` : shown ? `example ${example}` : 'own';
    this.name = known.program?.split('/').at(-1) ?? 'program.prg';
    const kept = this.kept.get(this.choice);
    this.text = text ?? kept ?? files[known.program];
    this.remember(this.choice === 'own' ? location.hash : `#${this.choice.replace(' ', '=')}`);
    this.say();
    element('robot').value = known.robot in robots ? known.robot : 'titan8';
    element('scripted').value = known.events ?? '';
    element('lesson').scrollTop = 0;
    this.run();
    if (kept) this.rememberText();
  }

  /** The same program from its beginning, on the robot that is chosen and with what is to happen to it. */
  async begin() {
    this.run();
    this.remember(await fragmentOf(this.wanted()));
  }

  run() {
    const { robot, scene } = robots[element('robot').value];
    const filled = (one) => one && { name: one.name, text: files[one.name] };
    const program = { name: this.name, text: this.text };
    const error = this.session.open({ program, robot: filled(robot), scene: filled(scene), events: element('scripted').value });
    element('scripted').toggleAttribute('aria-invalid', Boolean(error));
    if (error) notice(error);
  }

  /** The session has a text: what was opened, or what was written since. */
  async edited(text) {
    if (text === this.text.replace(/\r\n?/g, '\n')) return;
    this.text = text;
    if (this.choice !== 'own') this.keep(text);
    this.sayLesson();
    await this.rememberText();
  }

  /** Keeps what is written into the lesson or example that is shown, or forgets it. */
  keep(text) {
    if (text === undefined) this.kept.delete(this.choice);
    else this.kept.set(this.choice, text);
    try {
      localStorage.setItem(SHELF, JSON.stringify([...this.kept]));
    } catch {
      // Without storage the text is kept as long as the page is open.
    }
  }

  /** The address holds what has been written. */
  async rememberText() {
    this.remember(await fragmentOf(this.wanted()));
  }

  /** Returns the parts of a program of one's own that an address holds. */
  wanted() {
    return { text: this.text, robot: element('robot').value, events: element('scripted').value };
  }

  remember(address) {
    this.address = address;
    try {
      history.replaceState(null, '', address || location.pathname + location.search);
    } catch {
      // A page inside another one may have no address of its own.
    }
  }

  async share() {
    const fragment = await fragmentOf(this.wanted());
    this.remember(fragment);
    try {
      await navigator.clipboard.writeText(`${location.href.split('#')[0]}${fragment}`);
      notice(word('copiedLink'));
    } catch {
      // A page in a file may not.
      notice(word('inAddress'));
    }
  }

  /** Everything that is said in a language. */
  say() {
    const options = (list, kind) => list.map(({ title }, n) => make('option', { value: `${kind} ${n + 1}`, textContent: kind === 'lesson' ? `${n + 1}. ${told(title)}` : told(title) }));
    const group = (label, list) => Object.assign(make('optgroup', {}, ...list), { label });
    element('choice').replaceChildren(
      group(word('tour'), options(lessons, 'lesson')),
      group(word('examples'), options(examples, 'example')),
      make('option', { value: 'own', textContent: word('own') }),
    );
    element('choice').value = this.choice ?? 'own';
    const robot = element('robot').value || 'titan8';
    element('robot').replaceChildren(...Object.entries(robots).map(([value, { title }]) => make('option', { value, textContent: told(title) })));
    element('robot').value = robot;
    this.sayLesson();
  }

  sayLesson() {
    element('original').hidden = !this.kept.has(this.choice);
    const lesson = lessons[this.lesson - 1];
    // The first example is what one sees first: it leads to the tour.
    const isWelcome = this.choice === 'example 1';
    element('lesson').hidden = !lesson && !isWelcome;
    element('lesson-before').hidden = isWelcome;
    element('lesson-after').textContent = word(isWelcome ? 'beginTour' : 'lessonAfter');
    element('lesson-after').disabled = this.lesson === lessons.length;
    element('lesson-title').textContent = lesson ? told(lesson.title) : word('welcome');
    const text = lesson ? told(lesson.text) : [word('welcomeText')];
    element('lesson-text').replaceChildren(...text.map((textContent) => make('p', { textContent })));
    element('lesson-try').textContent = word('tryIt', lesson ? told(lesson.try) : word('welcomeTry'));
    element('lesson-number').textContent = [PUPIL, lesson ? word('of', this.lesson, lessons.length) : ''].filter(Boolean).join(' · ');
    element('lesson-before').disabled = this.lesson === 1;
  }
}
