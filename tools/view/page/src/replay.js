// The page that contains the recording of a run.

import { element } from './dom.js';
import { exporting } from './export.js';
import { showFigures } from './figures.js';
import { choices, dialogs, keys, languages, observeSize, openStage, showTab, tabs, themes } from './page.js';
import { Player } from './player.js';
import { Plots } from './plots.js';
import { Recording } from './recording.js';
import { source } from './source.js';
import { endOf, listMarks, state } from './state.js';
import { timeline } from './timeline.js';
import { whenSpoken, word } from './words.js';

/** Shows the recording in an element. */
export async function openReplay(held) {
  let player;
  languages(() => player?.goToTime(player.time));
  const stage = openStage();
  const recording = await Recording.of(held.textContent);
  const compared = element('compared').textContent;
  const other = compared && (await Recording.of(compared));
  player = new Player(recording, other);
  element('title').textContent = recording.script.title || recording.script.name;
  whenSpoken(() => {
    const ghost = other ? ` · ${word('ghost', other.script.name)}` : '';
    element('file').textContent = `${recording.script.name} · ${recording.robot.name}${ghost}`;
  });
  stage?.begin(recording);
  if (other) stage?.compare(other);
  // Charts are built after the first picture of the robot.
  let plots;
  const charts = () => (plots ??= new Plots(player));
  const strip = timeline(player);
  const plot = (scalar) => {
    showTab('plots-tab');
    charts().showVariable(scalar);
  };
  source(player, plot);
  state(player, plot);
  whenSpoken(() => {
    element('outcome').textContent = other ? [recording, other].map((run) => `${stem(run)}: ${endOf(run)}`).join(' · ') : endOf(recording);
    element('outcome').classList.toggle('bad', recording.outcome.how === 'emergency' || other?.outcome?.how === 'emergency');
  });
  whenSpoken(() => listMarks(player));
  whenSpoken(() => showFigures(player, recording.summary, other || undefined));
  if (stage) {
    player.onMove(() => stage.show(player.time));
    exporting(player, stage);
    choices(stage, player);
  }
  player.onMove(() => rememberPlace(player));
  player.onState(() => rememberPlace(player));
  themes(() => {
    stage?.recolour();
    plots?.build();
    strip.draw();
    player.goToTime(player.time);
  });
  observeSize(stage, strip);
  tabs();
  dialogs();
  keys(player, stage);
  const go = () => player.goTo(linked() ?? player.place);
  window.addEventListener('hashchange', () => {
    player.pause();
    go();
  });
  stage?.resize();
  go();
  strip.draw();
  stage?.resetView();
  stage?.drawNow();
  const { dataset } = document.documentElement;
  dataset.ready = Math.round(performance.now());
  requestAnimationFrame(() => setTimeout(charts));
  // A page around this one may ask it to play immediately.
  if (dataset.plays !== undefined) player.play();
}

/** Returns the name of a run's file without folders and extension. */
function stem({ script }) {
  return script.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
}

/** Returns the cycle of an address such as `#cycle=611`. */
function linked() {
  const cycle = new URLSearchParams(location.hash.slice(1)).get('cycle');
  return /^\d+$/.test(cycle ?? '') ? Number(cycle) : undefined;
}

function rememberPlace(player) {
  if (player.playing) return;
  clearTimeout(rememberPlace.due);
  rememberPlace.due = setTimeout(() => {
    try {
      history.replaceState(null, '', `#cycle=${player.place}`);
    } catch {
      // A page inside another one may be unable to change its address.
    }
  }, 200);
}
