// What the playground says, in English and Japanese.

const WORDS = {
  name: ['T.I.P. playground', 'T.I.P. を試す'],
  show: ['Show', '表示'],
  tour: ['Guided tour', '10 課のツアー'],
  examples: ['Examples', '例'],
  own: ['A program of your own', '自分のプログラム'],
  lesson: ['Lesson {0}', '第 {0} 課'],
  lessons: ['Lessons', '課'],
  of: ['{0} of {1}', '{0} / {1}'],
  earlier: ['Back', '前の課'],
  later: ['Next', '次の課'],
  try: ['Try it: {0}', 'やってみよう: {0}'],
  program: ['Program', 'プログラム'],
  robot: ['Robot', 'ロボット'],
  events: ['Inputs by cycle', '入力（周期ごと）'],
  run: ['Run', '実行'],
  running: ['Runs …', '実行中 …'],
  replay: ['Replay of the run', '実行の再生'],
  findings: ['Errors and warnings', 'エラーと警告'],
  line: ['line {0}', '{0} 行目'],
  share: ['Copy link', 'リンクをコピー'],
  copied: ['The link to this program is copied.', 'このプログラムへのリンクをコピーしました。'],
  inAddress: ['The address of this page is the link to this program.', 'このページのアドレスが、このプログラムへのリンクです。'],
  wrong: ['It has errors, and does not run.', 'エラーがあるため実行できません。'],
  unreadable: ['The link holds no program that can be read.', 'リンクからプログラムを読み取れません。'],
  language: ['日本語', 'English'],
};

const LANGUAGES = ['en', 'ja'];
let language = 0;
const listeners = [];

/** Text in the page's language; {0}, {1} … are replaced. */
export function word(key, ...values) {
  return told(WORDS[key]).replace(/\{(\d)\}/g, (_, n) => values[n] ?? '');
}

/** That of an English and a Japanese text which is spoken. */
export function told(texts) {
  return texts[language];
}

/** `en` or `ja`. */
export function spoken() {
  return LANGUAGES[language];
}

/** Chooses a language, and has everything say its words again. */
export function speak(wanted) {
  language = Math.max(LANGUAGES.indexOf(wanted), 0);
  document.documentElement.lang = spoken();
  document.title = word('name');
  for (const element of document.querySelectorAll('[data-word]')) element.textContent = word(element.dataset.word);
  for (const element of document.querySelectorAll('[data-label]')) {
    element.setAttribute(element.tagName === 'IFRAME' ? 'title' : 'aria-label', word(element.dataset.label));
  }
  listeners.forEach((listener) => listener());
}

/** Calls a function whenever the language changes. */
export function whenSpoken(listener) {
  listeners.push(listener);
}
