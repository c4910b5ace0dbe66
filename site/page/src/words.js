// What the playground says beside what every page of a run says, in English and Japanese.

export const TOUR_WORDS = {
  show: ['Show', '表示'],
  tour: ['Guided tour', '10 課のツアー'],
  examples: ['Examples', '例'],
  own: ['A program of your own', '自分のプログラム'],
  lessons: ['Lessons', '課'],
  of: ['{0} of {1}', '{0} / {1}'],
  lessonBefore: ['Back', '前の課'],
  lessonAfter: ['Next', '次の課'],
  tryIt: ['Try it: {0}', 'やってみよう: {0}'],
  robot: ['Robot', 'ロボット'],
  scripted: ['Inputs by cycle', '入力（周期ごと）'],
  share: ['Copy link', 'リンクをコピー'],
  copiedLink: ['The link to this program is copied.', 'このプログラムへのリンクをコピーしました。'],
  inAddress: ['The address of this page is the link to this program.', 'このページのアドレスが、このプログラムへのリンクです。'],
  unreadable: ['The link holds no program that can be read.', 'リンクからプログラムを読み取れません。'],
};
