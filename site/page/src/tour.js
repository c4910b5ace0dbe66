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
/** The key of a lesson, an example or the program of one's own; other tabs write others. */
const keyOf = (choice) => `tip-lessons ${PUPIL} ${choice}`;
/** Lines end alike in the editor and in files. */
const lines = (text) => text.replace(/\r\n?/g, '\n');
/** Returns a program with its robot and its events: titan8 and none, if they are missing or unknown. */
const complete = ({ text, robot, events }) => ({ text, robot: Object.hasOwn(robots, robot) ? robot : 'titan8', events: events ?? '' });
const isSame = (one, other) => lines(one.text) === lines(other.text) && one.robot === other.robot && one.events === other.events;

/** What was written before, where the page has no storage. */
const unstored = new Map();

/** Returns what was written before, { text, robot, events }; undefined if nothing was. */
function readKept(choice) {
  try {
    const kept = unstored.get(choice) ?? JSON.parse(localStorage.getItem(keyOf(choice)) ?? 'null');
    return typeof kept?.text === 'string' ? complete(kept) : undefined;
  } catch {
    return undefined;
  }
}

/** Keeps what was written, or forgets it if it is undefined. */
function writeKept(choice, wanted) {
  try {
    if (wanted) localStorage.setItem(keyOf(choice), JSON.stringify(wanted));
    else localStorage.removeItem(keyOf(choice));
    unstored.delete(choice);
  } catch {
    unstored.set(choice, wanted);
  }
}

export class Tour {
  constructor(session) {
    this.session = session;
    session.listen((update) => {
      if (update.type === 'text') this.edited(update.text);
    });
    element('choice').addEventListener('change', ({ target }) => {
      const [kind, number] = target.value.split(' ');
      // What one goes on to write in a program of one's own is not the lesson's any more.
      this.open(number ? { [kind]: Number(number) } : (readKept('own') ?? this.wanted()));
    });
    element('lesson-before').addEventListener('click', () => this.open({ lesson: this.lesson - 1 }));
    element('lesson-after').addEventListener('click', () => this.open({ lesson: (this.lesson ?? 0) + 1 }));
    element('original').addEventListener('click', () => {
      const [kind, number] = this.choice.split(' ');
      writeKept(this.choice, undefined);
      this.open({ [kind]: Number(number) });
      notice(word('discarded'));
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
    this.open(wanted ?? { example: 1 }, false);
  }

  /**
   * Shows a lesson or an example by its number, a program { text, robot, events }, or both: what was written into the lesson. It gets an
   * address of its own, from which the browser's Back returns, unless the address has led to it.
   */
  open({ lesson, example, text, robot, events }, hasNewAddress = true) {
    const given = text === undefined ? undefined : complete({ text, robot, events });
    const shown = lessons[lesson - 1] ?? examples[example - 1] ?? (given ? undefined : lessons[0]);
    const number = lessons.indexOf(shown) + 1;
    const name = number ? `lesson ${number}` : `example ${example}`;
    const kept = shown && readKept(name);
    // Somebody else's text of a lesson does not take the place of one's own.
    const isOwn = !shown || (given && kept && !isSame(given, kept));
    this.choice = isOwn ? 'own' : name;
    this.lesson = isOwn || !number ? undefined : number;
    this.original = isOwn ? undefined : complete({ ...shown, text: files[shown.program] });
    this.name = isOwn ? 'program.prg' : shown.program.split('/').at(-1);
    const wanted = given ?? kept ?? this.original;
    this.text = wanted.text;
    this.say();
    element('robot').value = wanted.robot;
    element('scripted').value = wanted.events;
    element('lesson').scrollTop = 0;
    this.run();
    // Somebody else's program is not yet one's own.
    if (this.original) this.keep();
    else this.sayLesson();
    if (hasNewAddress) this.remember(this.shown, true);
    this.rememberText();
  }

  /** The same program from its beginning, on the robot that is chosen and with what is to happen to it. */
  begin() {
    if (!this.run()) return;
    this.keep();
    this.rememberText();
  }

  /** Runs the program from its beginning; returns true if it can. */
  run() {
    const { robot, scene } = robots[element('robot').value];
    const filled = (one) => one && { name: one.name, text: files[one.name] };
    const program = { name: this.name, text: this.text };
    const error = this.session.open({ program, robot: filled(robot), scene: filled(scene), events: element('scripted').value });
    element('scripted').toggleAttribute('aria-invalid', Boolean(error));
    if (error) notice(error);
    return !error;
  }

  /** The session has a text: what was opened, or what was written since. */
  edited(text) {
    if (text === lines(this.text)) return;
    this.text = text;
    this.keep();
    this.rememberText();
  }

  /** True if something else is wanted than the lesson or example has. */
  get isChanged() {
    return !this.original || !isSame(this.wanted(), this.original);
  }

  /** Keeps what is written into the lesson, the example or the program of one's own. */
  keep() {
    writeKept(this.choice, this.isChanged ? this.wanted() : undefined);
    this.sayLesson();
  }

  /** The address of the lesson or example that is shown. */
  get shown() {
    return this.choice === 'own' ? '#' : `#${this.choice.replace(' ', '=')}`;
  }

  /** The address holds what has been written. */
  async rememberText() {
    const turn = (this.turn = {});
    const address = this.isChanged ? await fragmentOf(this.wanted(), this.shown) : this.shown;
    // Another address may have been found first.
    if (turn === this.turn) this.remember(address);
  }

  /** Returns the parts of a program that an address holds. */
  wanted() {
    return { text: this.text, robot: element('robot').value, events: element('scripted').value };
  }

  remember(address, isNew = false) {
    this.address = address;
    try {
      history[isNew ? 'pushState' : 'replaceState'](null, '', address);
    } catch {
      // A page inside another one may have no address of its own.
    }
  }

  async share() {
    const fragment = await fragmentOf(this.wanted(), this.shown);
    this.remember(fragment);
    try {
      // Whoever gets the link is another pupil.
      await navigator.clipboard.writeText(`${location.href.split(/[?#]/)[0]}${fragment}`);
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
    element('original').hidden = !this.original || !this.isChanged;
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
