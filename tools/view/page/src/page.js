// Parts of the page that a replay and a live run share.

import { element, make } from './dom.js';
import { Stage } from './stage.js';
import { otherLanguage, speak, word } from './words.js';

/** Chooses the language of the browser, or of the page around this one, and switches it at a click. */
export function languages(spoken = () => {}) {
  const { speaks } = document.documentElement.dataset;
  speak(speaks ?? (navigator.language.startsWith('ja') ? 'ja' : 'en'));
  element('language').addEventListener('click', () => {
    speak(otherLanguage());
    spoken();
  });
}

/** Fits stage and strip to their room. */
export function observeSize(stage, strip) {
  new ResizeObserver(() => {
    stage?.resize();
    strip.draw();
  }).observe(element('stage'));
}

/** Opens the stage, or shows a text if the browser has no 3-D graphics. */
export function openStage() {
  try {
    return new Stage(element('canvas'));
  } catch {
    element('stage').append(make('p', { className: 'apology', textContent: word('noWebgl') }));
    element('canvas').hidden = true;
    element('export')?.toggleAttribute('hidden', true);
    element('choices').hidden = true;
    return undefined;
  }
}

/** Connects the switches of the stage. Returns a function that shows those that the robot can have. */
export function choices(stage, player) {
  for (const name of Object.keys(stage.shows)) {
    const button = element(`show-${name}`);
    button.addEventListener('click', () => {
      stage.shows[name] = !stage.shows[name];
      button.setAttribute('aria-pressed', stage.shows[name]);
      stage.show(player.time);
    });
  }
  element('reset').addEventListener('click', () => stage.resetView());
  const offer = () => {
    const { planar, body } = stage.robot;
    element('show-follow').hidden = planar || !body;
    element('show-support').hidden = !body;
    element('scale').hidden = planar;
    element('show-forces').hidden = !stage.recording.has('load.0');
  };
  offer();
  return offer;
}

/** Time for which a notice is shown, ms. */
const NOTICE = 6000;

/** Shows a notice for a while. */
export function notice(text) {
  const box = element('notice');
  box.textContent = text;
  box.hidden = false;
  clearTimeout(notice.due);
  notice.due = setTimeout(() => (box.hidden = true), NOTICE);
}

export function themes(recolour) {
  const root = document.documentElement;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const use = (name) => {
    root.dataset.theme = name;
    recolour();
  };
  dark.addEventListener('change', () => use(dark.matches ? 'dark' : 'light'));
  element('theme').addEventListener('click', () => use(root.dataset.theme === 'dark' ? 'light' : 'dark'));
  use(dark.matches ? 'dark' : 'light');
}

export function showTab(id) {
  for (const tab of document.querySelectorAll('[role=tab]')) {
    const chosen = tab.id === id;
    if (chosen && getComputedStyle(tab).display === 'none') return;
  }
  for (const tab of document.querySelectorAll('[role=tab]')) {
    const chosen = tab.id === id;
    tab.setAttribute('aria-selected', chosen);
    tab.tabIndex = chosen ? 0 : -1;
    element(tab.getAttribute('aria-controls')).classList.toggle('chosen', chosen);
  }
  document.dispatchEvent(new Event('tab'));
}

export function tabs() {
  const all = [...document.querySelectorAll('[role=tab]')];
  for (const tab of all) {
    tab.addEventListener('click', () => showTab(tab.id));
    tab.addEventListener('keydown', (event) => {
      const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      const visible = all.filter((one) => getComputedStyle(one).display !== 'none');
      const next = visible[(visible.indexOf(tab) + way + visible.length) % visible.length];
      showTab(next.id);
      next.focus();
    });
  }
}

export function dialogs() {
  // The page of a live run has no export dialog.
  const all = [['export', 'export-box'], ['help', 'help-box'], ['signals', 'signals-box']];
  for (const [button, box] of all.filter(([button]) => element(button))) {
    element(button).addEventListener('click', () => element(box).showModal());
    element(box).addEventListener('click', (event) => {
      if (event.target === element(box) || event.target.closest('.close')) element(box).close();
    });
  }
}

export function keys(player, stage) {
  const second = (way) => {
    player.pause();
    player.goToTime(player.time + way * 1000);
  };
  const arrow = (way) => (event) => (event.shiftKey ? second(way) : player.step(way));
  const acts = {
    ' ': () => player.toggle(),
    ArrowLeft: arrow(-1),
    ArrowRight: arrow(1),
    Home: () => player.step(-Infinity),
    End: () => player.step(Infinity),
    n: () => player.skip(1),
    p: () => player.skip(-1),
    '[': () => player.changeSpeed(-1),
    ']': () => player.changeSpeed(1),
    m: () => element('plot-mark').click(),
    f: () => element('show-follow').click(),
    r: () => stage?.resetView(),
    '?': () => element('help-box').showModal(),
  };
  document.addEventListener('keydown', (event) => {
    const { target, key } = event;
    const typing = target.closest('dialog, select, textarea, input:not([type=range])');
    const own = target.closest('button') && (key === ' ' || key === 'Enter');
    if (typing || own || event.ctrlKey || event.metaKey || event.altKey || !(key in acts)) return;
    event.preventDefault();
    acts[key](event);
  });
}
