// The page: everything that shows where in the run one is, and everything that goes somewhere.

import { element, make } from './dom.js';
import { exporting } from './export.js';
import { Player } from './player.js';
import { Plots } from './plots.js';
import { Recording } from './recording.js';
import { source } from './source.js';
import { Stage } from './stage.js';
import { state } from './state.js';
import { timeline } from './timeline.js';
import { otherLanguage, speak, word } from './words.js';

async function open() {
  // A page around this one may choose the language, and have it play at once.
  const { speaks, plays } = document.documentElement.dataset;
  speak(speaks ?? (navigator.language.startsWith('ja') ? 'ja' : 'en'));
  const recording = await Recording.of(element('recording').textContent);
  const player = new Player(recording);
  element('title').textContent = recording.script.title || recording.script.name;
  element('file').textContent = `${recording.script.name} · ${recording.robot.name}`;
  const stage = openStage(recording);
  const plots = new Plots(player);
  const strip = timeline(player);
  const plot = (scalar) => {
    showTab('plots-tab');
    plots.showVariable(scalar);
  };
  source(player, plot);
  state(player, plot);
  if (stage) {
    player.onMove(() => stage.show(player.time));
    exporting(player, stage);
    showChoices(stage, player);
  }
  player.onMove(() => rememberPlace(player));
  player.onState(() => rememberPlace(player));
  const recolour = () => {
    stage?.recolour();
    plots.build();
    strip.draw();
    player.goToTime(player.time);
  };
  themes(recolour);
  element('language').addEventListener('click', () => {
    speak(otherLanguage());
    player.goToTime(player.time);
  });
  new ResizeObserver(() => {
    stage?.resize();
    strip.draw();
  }).observe(element('stage'));
  tabs();
  dialogs();
  keys(player, stage);
  const go = () => player.goTo(linked() ?? player.cycle);
  window.addEventListener('hashchange', () => {
    player.pause();
    go();
  });
  stage?.resize();
  go();
  strip.draw();
  stage?.resetView();
  stage?.drawNow();
  document.documentElement.dataset.ready = Math.round(performance.now());
  if (plays !== undefined) player.play();
}

/** The stage, or a word where the browser has no 3-D graphics. */
function openStage(recording) {
  try {
    return new Stage(element('canvas'), recording);
  } catch {
    element('stage').append(make('p', { className: 'apology', textContent: word('noWebgl') }));
    element('canvas').hidden = true;
    element('export').hidden = true;
    element('choices').hidden = true;
    return undefined;
  }
}

/** The cycle of `#cycle=611`. */
function linked() {
  const cycle = new URLSearchParams(location.hash.slice(1)).get('cycle');
  return /^\d+$/.test(cycle ?? '') ? Number(cycle) : undefined;
}

function rememberPlace(player) {
  if (player.playing) return;
  clearTimeout(rememberPlace.due);
  rememberPlace.due = setTimeout(() => {
    try {
      history.replaceState(null, '', `#cycle=${player.cycle}`);
    } catch {
      // A page inside another one may have no address of its own.
    }
  }, 200);
}

function showChoices(stage, player) {
  for (const name of Object.keys(stage.shows)) {
    const button = element(`show-${name}`);
    button.addEventListener('click', () => {
      stage.shows[name] = !stage.shows[name];
      button.setAttribute('aria-pressed', stage.shows[name]);
      stage.show(player.time);
    });
  }
  const { planar, body } = stage.robot;
  element('show-follow').hidden = planar || !body;
  element('show-support').hidden = !body;
  element('show-forces').hidden = !stage.recording.has('load.0');
  element('reset').addEventListener('click', () => stage.resetView());
}

function themes(recolour) {
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

function showTab(id) {
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

function tabs() {
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

function dialogs() {
  for (const [button, box] of [['export', 'export-box'], ['help', 'help-box'], ['signals', 'signals-box']]) {
    element(button).addEventListener('click', () => element(box).showModal());
    element(box).addEventListener('click', (event) => {
      if (event.target === element(box) || event.target.closest('.close')) element(box).close();
    });
  }
}

function keys(player, stage) {
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
    End: () => player.step(player.recording.cycles),
    n: () => player.skip(1),
    p: () => player.skip(-1),
    '[': () => player.changeSpeed(-1),
    ']': () => player.changeSpeed(1),
    f: () => element('show-follow').click(),
    r: () => stage?.resetView(),
    '?': () => element('help-box').showModal(),
  };
  document.addEventListener('keydown', (event) => {
    const { target, key } = event;
    const typing = target.closest('dialog, select, input:not(#scrub)');
    const own = target.closest('button') && (key === ' ' || key === 'Enter');
    if (typing || own || event.ctrlKey || event.metaKey || event.altKey || !(key in acts)) return;
    event.preventDefault();
    acts[key](event);
  });
}

open();
