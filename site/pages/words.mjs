// Texts of the pages around the playground, in English and Japanese.

const doors = (list) => `<ul class="doors">${list.map(([href, title, text]) => `<li><a href="${href}">${title}</a><br>${text}</li>`).join('')}</ul>\n`;

export const WORDS = {
  /** The heading of the list of documents in README.md and README.ja.md. */
  readOn: ['read-on', '資料'],
  doors: [
    doors([
      ['playground.html', 'Try it', 'Change a motion and see the robot walk, in this browser. Nothing is installed.'],
      ['#first-minute', 'Install it', 'One command checks, runs and shows motions.'],
      ['#embed-it-in-your-crate', 'Embed it', 'A motion becomes Rust in your crate, for your robot.'],
    ]),
    doors([
      ['playground.html', '試す', 'このブラウザの中で動作を書き換え、ロボットを歩かせます。インストールは要りません。'],
      ['#最初の1分', 'インストールする', '1つのコマンドで動作を検査し、実行し、表示します。'],
      ['#自分のクレートに組み込む', '組み込む', '動作は自分のクレートの Rust になり、自分のロボットで動きます。'],
    ]),
  ],
  home: ['TIP', 'TIP'],
  playground: ['Playground', 'プレイグラウンド'],
  gallery: ['Gallery', 'ギャラリー'],
  lessons: ['Lessons', 'レッスン'],
  documentation: ['Documentation', '資料'],
  search: ['Search', '検索'],
  other: ['日本語', 'English'],
  skip: ['Skip to the content', '本文へ'],
  contents: ['On this page', 'このページの内容'],
  galleryText: [
    'Each run was simulated when this site was built. A replay shows the robot beside the line that moves it.',
    'どの実行も、このサイトを作るときにシミュレーションしたものです。再生ページでは、ロボットと、それを動かしている行が並びます。',
  ],
  diagram: ['Diagram of the run over time', '実行の時間線図'],
  replay: ['Replay', '再生'],
  source: ['Source', 'ソース'],
  change: ['Change it', '書き換える'],
  lessonsText: [
    'Each lesson opens in the playground, with a program to change. A program stays in this browser under the pupil\'s name. The address of the page holds it too, and can be sent.',
    'レッスンはプレイグラウンドで開き、プログラムを書き換えながら進みます。書いたプログラムは、名前ごとにこのブラウザに残ります。ページのアドレスにも含まれるので、アドレスを送れば共有できます。',
  ],
  pupil: ['Name', '名前'],
  begin: ['Begin', '始める'],
  none: ['Nothing was found.', '見つかりませんでした。'],
  found: ['Sections found:', '見つかった節:'],
};
