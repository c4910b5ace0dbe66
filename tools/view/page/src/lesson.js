// The page of a robot that a hand teaches. It shows the robot; the keys of the terminal teach.

import { element, make } from './dom.js';
import { showTab } from './page.js';
import { showServos } from './servos.js';
import { whenSpoken, word } from './words.js';

const SAYS = { limp: 'lessonLimp', goes: 'lessonGoes', holds: 'lessonHolds' };

export class Lesson {
  /** Takes the state of the lesson. */
  take(lesson) {
    const isFirst = !this.lesson;
    this.lesson = lesson;
    if (isFirst) this.begin();
    this.show();
  }

  /** Shows the parts of the page that a lesson has, and hides the others. */
  begin() {
    document.documentElement.dataset.lesson = '';
    element('lesson').hidden = false;
    element('servos-box').hidden = false;
    showTab('state-tab');
    whenSpoken(() => this.show());
  }

  show() {
    const { phase, poses, chosen, samples, servos, problem } = this.lesson;
    const says = [word(SAYS[phase], poses[chosen] ?? '')];
    if (samples !== null) says.push(word('lessonSamples', samples));
    if (problem) says.push(problem);
    element('lesson-state').textContent = says.join(' ');
    element('lesson-state').classList.toggle('bad', Boolean(problem));
    const names = poses.map((name, place) => {
      const item = make('li', { textContent: name });
      if (place === chosen) item.setAttribute('aria-current', 'true');
      return item;
    });
    element('poses').replaceChildren(...names);
    showServos(servos);
  }
}
