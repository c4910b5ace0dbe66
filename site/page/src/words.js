// The texts that only the playground has, in English and Japanese.

export const TOUR_WORDS = {
  show: ['Show', '表示'],
  tour: ['Guided tour', '10 課のツアー'],
  examples: ['Examples', '例'],
  own: ['A program of your own', '自分のプログラム'],
  lessons: ['Lessons', '課'],
  of: ['{0} of {1}', '{0} / {1}'],
  lessonBefore: ['Back', '前の課'],
  lessonAfter: ['Next', '次の課'],
  beginTour: ['Begin the tour', 'ツアーを始める'],
  original: ['Discard my changes', '変更を破棄'],
  welcome: ['A robot that walks', '歩くロボット'],
  welcomeText: ['TITAN VIII runs the program in the editor, here in your browser. The tour explains the language in small steps.', 'TITAN VIII がエディタのプログラムをこのブラウザの中で実行しています。ツアーでは言語を少しずつ説明します。'],
  welcomeTry: ['Change SPEED = 300 to 150 and press "Run from start".', 'SPEED = 300 を 150 に変えて「最初から実行」を押してみてください。'],
  tryIt: ['Try it: {0}', 'やってみよう: {0}'],
  robot: ['Robot', 'ロボット'],
  scripted: ['Inputs by cycle', '入力（周期ごと）'],
  share: ['Copy link', 'リンクをコピー'],
  copiedLink: ['The link to this program is copied.', 'このプログラムへのリンクをコピーしました。'],
  inAddress: ['The address of this page is the link to this program.', 'このページのアドレスが、このプログラムへのリンクです。'],
  unreadable: ['The link holds no program that can be read.', 'リンクからプログラムを読み取れません。'],
};
