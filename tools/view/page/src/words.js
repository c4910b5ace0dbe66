// The texts of the page, in English and Japanese.

const WORDS = {
  play: ['Play', '再生'],
  pause: ['Pause', '一時停止'],
  back: ['Back one cycle', '1 周期戻る'],
  forward: ['Forward one cycle', '1 周期進む'],
  earlier: ['Previous mark', '前の印'],
  later: ['Next mark', '次の印'],
  speed: ['Speed', '速度'],
  position: ['Place in the run', '実行中の位置'],
  cycle: ['cycle', '周期'],
  line: ['line', '行'],
  margin: ['margin', '安定余裕'],
  falls: ['falls', '転倒'],
  source: ['Program', 'プログラム'],
  state: ['State', '状態'],
  log: ['Events', '出来事'],
  plots: ['Plots', 'グラフ'],
  signals: ['Signals', '信号'],
  follow: ['Follow the robot', 'ロボットを追う'],
  trails: ['Foot trails', '足先の軌跡'],
  forces: ['Contact forces', '接触力'],
  support: ['Support polygon and centre of mass', '支持多角形と重心'],
  view: ['View', '表示'],
  reset: ['Reset the view', '視点を戻す'],
  theme: ['Light or dark', '明暗の切り替え'],
  language: ['日本語', 'English'],
  export: ['Export', '書き出し'],
  help: ['Keys', 'キー操作'],
  close: ['Close', '閉じる'],
  robot3d: ['The robot in three dimensions', 'ロボットの 3 次元表示'],
  gait: ['Gait: when each foot stands', '歩容: 各脚の接地'],
  touch: ['Contact: when each fingertip touches', '接触: 各指先の接触'],
  message: ['message', '出来事: メッセージ'],
  fall: ['fall', '転倒'],
  slip: ['slip', '滑り'],
  collision: ['collision', '干渉'],
  collisions: ['collisions', '干渉'],
  clearance: ['clearance', '間隔'],
  overlap: ['{0} and {1} overlap', '{0} と {1} が重なっています'],
  inCycles: ['in {0} cycles', '{0} 周期'],
  event: ['input', '入力'],
  fault: ['emergency stop', '非常停止'],
  slipped: ['{0} slipped', '{0} が滑りました'],
  fell: ['The robot fell', '転倒しました'],
  'would-fall': ['The robot would fall: its feet do not hold its centre of mass', '転倒するおそれがあります: 足が重心を支えていません'],
  'lost-support': ['The robot lost its support', '支えを失いました'],
  figures: ['Summary', '要約'],
  travel: ['travel', '移動'],
  turnOf: ['turn', '旋回'],
  averageSpeed: ['speed', '速度'],
  jointRate: ['rate', '角速度'],
  jointTorque: ['torque', 'トルク'],
  energy: ['energy', '仕事'],
  cost: ['cost of transport', '輸送コスト'],
  lift: ['lift', '持上'],
  contactForce: ['force', '力'],
  waited: ['waited', '待ち'],
  ahead: ['forward', '前へ'],
  behind: ['backward', '後ろへ'],
  right: ['to the right', '右へ'],
  left: ['to the left', '左へ'],
  up: ['up', '上へ'],
  down: ['down', '下へ'],
  atMost: ['{0} at most', '最大 {0}'],
  atLeast: ['{0} at least', '最小 {0}'],
  limit: ['limit {0}', '上限 {0}'],
  wouldFalls: ['would fall: {0}', '転倒のおそれ {0} 回'],
  uprightFalls: ['{0}; the body stays upright in {1}', '{0} 回 (うち {1} 回は胴体が倒れていません)'],
  difference: ['difference', '差'],
  better: ['better', '良い'],
  worse: ['worse', '悪い'],
  moreIsBetter: ['more is better', '大きいほど良い'],
  lessIsBetter: ['less is better', '小さいほど良い'],
  duration: ['time', '時間'],
  programsDiffer: ['The programs differ: − {0}, + {1}', 'プログラムの違い: − {0}、+ {1}'],
  programsEqual: ['Both runs are of the same program.', 'どちらも同じプログラムの実行です。'],
  subtract: ['Difference', '差'],
  alignByLine: ['Align by line', '行で揃える'],
  strongAndFaint: ['strong: {0}, faint: {1}', '濃い方: {0}、薄い方: {1}'],
  aboveAndBelow: ['above: {0}, below: {1}', '上: {0}、下: {1}'],
  otherMinusOne: ['{1} minus {0}', '{1} − {0}'],
  slips: ['Slip', '滑り'],
  noEvents: ['Nothing happened besides the motion.', '動作のほかに出来事はありません。'],
  variables: ['Variables', '変数'],
  unassigned: ['unassigned', '未代入'],
  modes: ['Modes and last commands', 'モードと直前のコマンド'],
  'mode-rest': ['rest', '停止'],
  'mode-position': ['position', '位置'],
  'mode-compliance': ['compliance', 'コンプライアンス'],
  'mode-velocity': ['velocity', '速度'],
  'mode-effort': ['force', '力'],
  flags: ['Flags that are up', '立っているフラグ'],
  threads: ['Threads', 'スレッド'],
  timers: ['Timers', 'タイマー'],
  locks: ['Locked joints', 'ロック中の関節'],
  lamps: ['Lamps', 'ランプ'],
  inputs: ['Keys and inputs', 'キーと入力'],
  setBy: ['{0} got its value in line {1}: go there', '{0} の代入元、行 {1} へ移動'],
  inLine: ['line {0}', '行 {0}'],
  readIn: ['read: line {0}', '読込: 行 {0}'],
  readBy: ['{0} was read in line {1} after it was changed: go there', '変更後の {0} を行 {1} が読みました。そこへ移動'],
  unread: ['not read yet', '未読込'],
  unreadYet: ['The program has not read {0} since it was changed', 'プログラムは変更後の {0} をまだ読んでいません'],
  plotIt: ['Plot {0}', '{0} をグラフに表示'],
  none: ['none', 'なし'],
  position6: ['Body', '胴体'],
  angles: ['Joint angles', '関節角度'],
  loads: ['Contact forces', '接触力'],
  torques: ['Torques', 'トルク'],
  objects: ['Objects', '物体'],
  height: ['height', '高さ'],
  object: ['object {0}', '物体 {0}'],
  image: ['Image (PNG)', '画像 (PNG)'],
  video: ['Video (WebM)', '動画 (WebM)'],
  frames: ['Frames (PNG in a ZIP)', '連番画像 (PNG の ZIP)'],
  embed: ['Copy iframe', 'iframe をコピー'],
  link: ['Copy link', 'リンクをコピー'],
  copied: ['Copied', 'コピーしました'],
  seconds: ['Seconds from here', 'ここからの秒数'],
  rate: ['Frames per second', '毎秒のコマ数'],
  recordingNow: ['Recording … {0}', '記録中 … {0}'],
  stopIt: ['Stop', '中止'],
  noVideo: ['This browser encodes no video; the frames are saved.', 'このブラウザは動画を作れません。連番画像を保存しました。'],
  noWebgl: ['This browser shows no 3-D graphics (WebGL is off). The rest of the page works.', 'このブラウザでは 3 次元表示が使えません (WebGL が無効です)。ほかの部分は使えます。'],
  endedProgram: ['{0} after {1}', '{1} 後に {0}'],
  endedLimit: ['recorded for {1}', '{1} 間を記録'],
  endedInterrupted: ['interrupted after {1}', '{1} 後に中断'],
  endedEmergency: ['emergency stop after {1}', '{1} 後に非常停止'],
  keySpace: ['play or pause', '再生・一時停止'],
  keyArrows: ['one cycle back or forward', '1 周期戻る・進む'],
  keyShiftArrows: ['one second back or forward', '1 秒戻る・進む'],
  keyEnds: ['to the beginning or the end', '先頭・末尾へ'],
  keyMarks: ['previous or next mark', '前・次の印へ'],
  keySpeed: ['slower or faster', '遅く・速く'],
  keyFollow: ['follow the robot or not', '追跡の切り替え'],
  keyHelp: ['this list', 'この一覧'],
  never: ['never runs', '実行されません'],
  zoomHint: ['Drag to zoom, double-click for the whole run, click to go there, Shift-click to measure from there.', 'ドラッグで拡大、ダブルクリックで全体、クリックで移動、Shift+クリックで差の基準。'],
  measure: ['Measure from here', 'ここから測る'],
  lags: ['Setpoints minus angles', '目標角 − 関節角'],
  joints: ['Joints', '関節'],
  angle: ['angle °', '角度 °'],
  setpoint: ['setpoint °', '目標 °'],
  limits: ['limits °', '範囲 °'],
  torque: ['torque {0}', 'トルク {0}'],
  feet: ['Feet in the robot frame: x, y, z in mm', '足先 (ロボット座標系の x, y, z、mm)'],
  gridScale: ['grid 100 mm', '格子 100 mm'],
  labels: ['Names, axes and forward', '名前・座標軸・前方'],
  front: ['forward', '前'],
  gif: ['Animation (GIF)', '動画 (GIF)'],
  ghost: ['ghost: {0}', '薄い方: {0}'],
};

const LANGUAGES = ['en', 'ja'];
let language = 0;
const listeners = [];

/** Adds the texts of one kind of page. */
export function teach(words) {
  Object.assign(WORDS, words);
}

/** Returns a text in the page's language. {0}, {1} … are replaced. */
export function word(key, ...values) {
  const text = WORDS[key][language];
  return text.replace(/\{(\d)\}/g, (_, n) => values[n] ?? '');
}

/** Chooses a language and calls the listeners. */
export function speak(wanted) {
  language = Math.max(LANGUAGES.indexOf(wanted), 0);
  document.documentElement.lang = LANGUAGES[language];
  for (const element of document.querySelectorAll('[data-word]')) {
    element.textContent = word(element.dataset.word);
  }
  for (const element of document.querySelectorAll('[data-label]')) label(element, element.dataset.label);
  listeners.forEach((listener) => listener());
}

/** Returns the index of the page's language in lists of texts: 0 is English, 1 is Japanese. */
export function spoken() {
  return language;
}

export function otherLanguage() {
  return LANGUAGES[1 - language];
}

/** Sets the name of an element for screen readers and as a tooltip. */
export function label(element, key, ...values) {
  const text = word(key, ...values);
  element.setAttribute('aria-label', text);
  element.title = text;
}

/** Calls a function now and whenever the language changes. */
export function whenSpoken(listener) {
  listeners.push(listener);
  listener();
}
