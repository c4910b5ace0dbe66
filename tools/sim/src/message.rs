//! The messages of this crate: of the debugger, of the import of robots, and of plants in other processes.
//!
//! ```
//! use tip_sim::message::Debugging;
//!
//! assert_eq!(Debugging::Above.to_string(), "From above");
//! ```

use tip_runtime::command::Target;
use tip_runtime::model::Part;
use tipc::message::Text;
use tipc::message::list::{Faults, List};

tipc::message_table! {
    /// A place in a file: line and column, from 1.
    Place;

    At { line: u32, column: u32 } "line {line}, column {column}", "{line}行{column}列";
    In { file: String, line: u32, column: u32 }
        "`{file}`, line {line}, column {column}",
        "`{file}` の{line}行{column}列";
}

tipc::message_table! {
    /// A kind of joint that files have and no leg has.
    JointKind;

    Fixed "fixed", "固定(fixed)";
    Prismatic "prismatic", "直動(prismatic)";
    Floating "floating", "浮遊(floating)";
    Planar "planar", "平面(planar)";
    Spherical "spherical", "球(spherical)";
}

tipc::message_table! {
    /// The condition that ends a wait, in one word where the language has one.
    Awaited;

    Flags { names: Text } "{names}", "{names}";
    Key "a key", "キー入力";
    Motion "the end of its motion", "動作の完了";
    Touch "a contact", "接触";
    Native "its native code", "ネイティブコードの完了";
    Thread { name: Text } "the end of thread {name}", "スレッド{name}の終了";
    EachOther { names: Text }
        "the end of threads that wait for each other: {names}",
        "互いに待ち合うスレッド{names}の終了";
}

tipc::message_table! {
    /// Messages on a plant that another process simulates.
    Simulating;

    CannotStart { program: Text, reason: Text }
        "the external plant '{program}' does not start: {reason}",
        "外部プラント '{program}' を起動できません: {reason}";
    NoAnswer { to: Text, seconds: Text }
        "the external plant has not answered '{to}' within {seconds} s",
        "外部プラントが '{to}' に{seconds}秒以内に応答しませんでした";
    NeverReady { seconds: Text, version: Text }
        "the external plant has not answered 'hello' within {seconds} s; it has to read version {version} of the protocol, which has JSON lines: see docs/external-plant.md",
        "外部プラントが 'hello' に{seconds}秒以内に応答しませんでした。プロトコルのバージョン{version} (JSON Lines) に対応している必要があります。docs/external-plant.mdを参照してください";
    Exited { to: Text, status: Text }
        "the external plant ended with exit status {status} before it answered '{to}'",
        "外部プラントが '{to}' に応答する前に終了コード{status}で終了しました";
    Killed { to: Text }
        "the external plant was ended by a signal before it answered '{to}'",
        "外部プラントが '{to}' に応答する前にシグナルで終了しました";
    Closed { to: Text }
        "the external plant closed its standard output before it answered '{to}'",
        "外部プラントが '{to}' に応答する前に標準出力を閉じました";
    TooLong { to: Text, bytes: Text }
        "the external plant's answer to '{to}' has more than {bytes} bytes",
        "'{to}' への外部プラントの応答が{bytes}バイトを超えています";
    NotText { to: Text }
        "the external plant's answer to '{to}' is not UTF-8",
        "'{to}' への外部プラントの応答がUTF-8ではありません";
    WrongAnswer { to: Text, line: String, reason: String }
        "the external plant's answer to '{to}' is '{line}': {reason}",
        "'{to}' への外部プラントの応答が '{line}' です: {reason}";
    WrongField { to: Text, path: String, reason: String }
        "the external plant's answer to '{to}' is wrong at '{path}': {reason}",
        "'{to}' への外部プラントの応答の '{path}' に誤りがあります: {reason}";
    NotFinite { to: Text, path: String }
        "the external plant's answer to '{to}': '{path}' is not finite",
        "'{to}' への外部プラントの応答: '{path}' が有限の値ではありません";
    OtherVersion { found: u32, version: Text }
        "the external plant uses version {found} of the protocol, and this is version {version}, which has JSON lines: see docs/external-plant.md",
        "外部プラントのプロトコルはバージョン{found}ですが、こちらはバージョン{version} (JSON Lines) です。docs/external-plant.mdを参照してください";
    OtherCycle { to: Text, found: Text }
        "the external plant answered '{to}' for cycle {found}",
        "外部プラントが '{to}' に対してサイクル{found}の応答を返しました";
    Copy
        "a copy of a run, or one that was taken back, has no external plant",
        "コピーした実行や巻き戻した実行には外部プラントがありません";
}

tipc::message_table! {
    /// Reasons and helps of such lints.
    Linting;

    // Inputs.
    NotConnected { input: Text }
        "nothing is connected to {input}: the servos of a real robot measure its joints alone",
        "{input}には何も接続されていません。実機のサーボが計測するのは関節だけです";
    OpenChannel { channel: Text }
        "nothing is connected to channel {channel}",
        "チャンネル{channel}には何も接続されていません";
    GiveInput { input: Text, volts: f64 }
        "give it a value in V: `--sensor {input}={volts}@0`",
        "値(V)を `--sensor {input}={volts}@0` のように指定してください";

    // SPECIAL.
    AnswersNone { robot: &'static str }
        "{robot} has no SPECIAL of its own",
        "{robot}自身のSPECIALはありません";
    AnswersOthers { robot: &'static str, numbers: List }
        "{robot} answers {numbers}",
        "{robot}が応えるのは{numbers}です";
    OwnNative
        "if native code of yours answers it, silence this with `// tip: allow(W123)`",
        "自分のネイティブコードで応えるなら、`// tip: allow(W123)` でこの警告を消せます";

    // Targets.
    TurnsTooFar { joint: Target, by: f64, limit: f64 }
        "{joint} would turn {by} deg beyond its limit of {limit} deg",
        "{joint}が限界の{limit}度を{by}度超えます";
    TurnsFromTo { joint: Target, min: f64, max: f64 }
        "{joint} turns from {min} to {max} deg",
        "{joint}の可動範囲は{min}度から{max}度までです";
    ComesNoNearer { target: Target, by: f64 }
        "{target} ends about {by} mm before it",
        "{target}は約{by} mm届きません";
    CannotReach { target: Target, by: f64 }
        "{target} cannot reach its target: it ends about {by} mm before it",
        "{target}が目標に約{by} mm届きません";
    LeavesReach { target: Target, x: f64, y: f64, z: f64 }
        "the straight path of {target} leaves its reach near {x} {y} {z}",
        "{target}の直線経路が{x} {y} {z}付近で可動範囲を外れます";
    GoAround
        "go around in two moves: put a PTP and a WAIT_INPOS before it",
        "手前にPTPとWAIT_INPOSを入れ、2回に分けて回り込んでください";
    ChooseNearer
        "choose a place nearer to the base of the leg; positions are mm in the robot's frame",
        "脚の付け根に近い位置にしてください。位置はロボット座標系で、単位はmmです";
    Overlaps { one: Part, other: Part, by: f64 }
        "{one} and {other} overlap by {by} mm there",
        "そこでは{one}と{other}が{by} mm重なります";
    ChooseApart
        "choose a target farther away; parts that may touch are listed in `may_touch` of the robot's description",
        "もっと離れた目標にしてください。触れてもよい部分は、ロボット記述の `may_touch` に書きます";
    SlidesNotThere
        "the slider does not go there",
        "スライダはそこまで動きません";
    SlidesFromTo { axis: &'static str, min: f64, max: f64 }
        "along {axis} it goes from {min} to {max} mm",
        "{axis}方向の可動範囲は{min} mmから{max} mmまでです";
}

tipc::message_table! {
    /// Messages of a debugger.
    Debugging;

    // Titles.
    Variables
        "Variables",
        "変数";
    Legs
        "Modes and targets",
        "制御モードと目標";
    Above
        "From above",
        "上面図";
    Unassigned
        "unassigned",
        "未代入";

    // Control modes of a leg.
    AtRest
        "rest",
        "停止";
    Position
        "position",
        "位置";
    Compliance
        "compliance",
        "コンプライアンス";
    Velocity
        "velocity",
        "速度";
    Effort
        "force",
        "力";

    // Reasons of a stop.
    Start
        "at the beginning",
        "先頭です";
    Ended
        "the program is over",
        "プログラムは終了しました";

    // Refused requests.
    NoStepFrom { line: u32 }
        "no step is on line {line} or after it",
        "{line}行目以降にステップがありません";
    NoSuchName { name: Text }
        "'{name}' is not a routine, label or command of the program",
        "'{name}' という名前のルーチン、ラベル、コマンドはこのプログラムにありません";
    NoSuchVariable { name: Text }
        "{name}: the program has no variable of that name",
        "{name}: この名前の変数はプログラムにありません";
    IsConstant { name: Text }
        "{name}: that name is a constant",
        "{name}: これは定数の名前です";
    NotFinite { name: Text }
        "{name}: a variable holds finite numbers only",
        "{name}: 変数に入れられるのは有限の数だけです";
    NoCountOfHits { text: Text }
        "'{text}' is not a count of hits, such as 5, >= 5 or % 5",
        "'{text}' は通過回数の指定ではありません。5、>= 5、% 5 のように書いてください";
    WouldDiscard { cycles: usize }
        "later cycles that would be discarded: {cycles}",
        "これより後の{cycles}サイクルの実行結果が破棄されます";
    NoInput { port: Text }
        "the robot has no input {port}",
        "このロボットに入力 {port} はありません";
    Massless { event: Text }
        "'{event}' is for walking robots with mass: --plant dynamic",
        "'{event}' は質量のある歩行ロボット用です(--plant dynamic)";
    BoltedDown { event: Text }
        "'{event}' is for walking robots: this one is bolted down",
        "'{event}' は歩行ロボット用です。このロボットは固定されています";
}

tipc::message_table! {
    /// Messages of the import of a robot from URDF or MJCF.
    Importing;

    // Reasons to refuse a file.
    NotXml { error: Text }
        "this is neither URDF nor MJCF: {error}",
        "URDFとしてもMJCFとしても読めません: {error}";
    NotARobot { element: String }
        "the root element is `{element}`; that of URDF is `robot`, that of MJCF is `mujoco`: convert the file first, if it is SDF",
        "ルート要素が `{element}` ですが、URDFでは `robot`、MJCFでは `mujoco` です。SDFなら、先に変換してください";
    NoLink
        "the robot has no link: write one, as `<link name=\"base\"/>`, and joints that turn on it",
        "リンクがありません。`<link name=\"base\"/>` のように書き、その上に回転する関節を置いてください";
    TooDeep { element: String, most: u32 }
        "element `{element}` is nested deeper than {most} levels: no robot needs that",
        "要素 `{element}` の入れ子が{most}段を超えています。ロボットにそこまでの深さは要りません";
    TooManyAttributes { at: Place, element: String, most: u32 }
        "{at}: element `{element}` has more than {most} attributes: no robot needs so many",
        "{at}: 要素 `{element}` の属性が{most}個を超えています。ロボットにそんなに多くの属性は要りません";
    UnknownEncoding { encoding: String }
        "the file says that its encoding is `{encoding}`, which cannot be read: save it as UTF-8",
        "文字コードが `{encoding}` と書かれていますが、読めない文字コードです。UTF-8で保存してください";
    NotInEncoding { at: Place, encoding: &'static str }
        "{at}: these bytes are not {encoding}: save the file as UTF-8, or say which encoding it has, as `<?xml version=\"1.0\" encoding=\"Shift_JIS\"?>`",
        "{at}: {encoding}として読めないバイトがあります。UTF-8で保存するか、`<?xml version=\"1.0\" encoding=\"Shift_JIS\"?>` のように文字コードを書いてください";
    Doctype
        "the file has a DTD, and entities of its own are not read: leave `<!DOCTYPE …>` out, and write what its entities stand for",
        "DTDがあります。独自の実体参照は読みません。`<!DOCTYPE …>` を取り、実体の中身をそのまま書いてください";
    Xacro { at: Place }
        "{at}: this is xacro, of which URDF is made: expand it first, as `xacro robot.xacro > robot.urdf` (the tool comes with ROS, and by `pip install xacro`)",
        "{at}: URDFの元になるxacroです。先に `xacro robot.xacro > robot.urdf` のように展開してください(xacroはROSに付属し、`pip install xacro` でも入ります)";
    NoAttribute { at: Place, element: String, attribute: &'static str, example: &'static str }
        "{at}: element `{element}` has no attribute `{attribute}`: write it, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` に属性 `{attribute}` がありません。`{attribute}=\"{example}\"` のように書いてください";
    NoElement { at: Place, element: String, child: &'static str, example: &'static str }
        "{at}: element `{element}` holds no element `{child}`: write it, as `{example}`",
        "{at}: 要素 `{element}` の中に `{child}` がありません。`{example}` のように書いてください";
    ElementTwice { at: Place, element: String, child: &'static str }
        "{at}: element `{element}` holds element `{child}` twice: leave one out",
        "{at}: 要素 `{element}` の中に `{child}` が2つあります。1つにしてください";
    NotOneShape { at: Place, element: String, known: List }
        "{at}: element `{element}` holds one shape and nothing else: write one of the elements {known}",
        "{at}: 要素 `{element}` の中身は形状1つだけです。{known}のどれか1つを書いてください";
    NotAKindOfJoint { at: Place, element: String, attribute: &'static str, value: String, known: List }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not a kind of joint: write one of {known}",
        "{at}: 要素 `{element}` の属性 `{attribute}` の `{value}` という関節の種類はありません。{known}のどれかを書いてください";
    NotANumber { at: Place, element: String, attribute: &'static str, value: String, example: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not a number: write one, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` の属性 `{attribute}` の `{value}` は数値ではありません。`{attribute}=\"{example}\"` のように書いてください";
    NotSoManyNumbers { at: Place, element: String, attribute: &'static str, value: String, wanted: usize, example: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not {wanted} numbers: write them with blanks between, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` の属性 `{attribute}` の `{value}` は{wanted}個の数値ではありません。`{attribute}=\"{example}\"` のように空白で区切ってください";
    NotALength { at: Place, element: String, attribute: &'static str, value: String, example: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, and URDF 1.2 takes lengths above 0: write such, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` の属性 `{attribute}` が `{value}` ですが、URDF 1.2の長さは0より大きい値です。`{attribute}=\"{example}\"` のように書いてください";
    Negative { at: Place, element: String, attribute: &'static str, value: String, example: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, and URDF 1.2 takes 0 or more: write such, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` の属性 `{attribute}` が `{value}` ですが、URDF 1.2では0以上です。`{attribute}=\"{example}\"` のように書いてください";
    BoundsSwapped { at: Place, lower: f64, upper: f64 }
        "{at}: attribute `upper` of element `limit` is {upper}, less than attribute `lower`, {lower}: write the smaller as `lower`",
        "{at}: 要素 `limit` の `upper` ({upper})が `lower` ({lower})より小さくなっています。小さい方を `lower` に書いてください";
    TwoTurns { at: Place }
        "{at}: attributes `rpy` and `quat_xyzw` of element `origin` both say how it is turned: leave one out",
        "{at}: 要素 `origin` の向きが `rpy` と `quat_xyzw` の両方に書かれています。一方にしてください";
    ForwardIsUp { forward: &'static str }
        "`--forward {forward}` and `--up` name the same axis: forward is across it",
        "`--forward {forward}` と `--up` が同じ軸を指しています。前は上と直交する軸にしてください";
    NotAWord { at: Place, element: String, attribute: &'static str, value: String, known: List }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`: write one of {known}",
        "{at}: 要素 `{element}` の属性 `{attribute}` の `{value}` は使えません。{known}のどれかを書いてください";
    NotADirection { at: Place, element: String, attribute: &'static str, value: String, example: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which gives no direction: write axes that are longer than 0 and not parallel, as `{attribute}=\"{example}\"`",
        "{at}: 要素 `{element}` の属性 `{attribute}` の `{value}` からは向きが決まりません。長さが0でなく平行でない軸を `{attribute}=\"{example}\"` のように書いてください";
    NegativeSize { at: Place, element: String, attribute: &'static str }
        "{at}: attribute `{attribute}` of element `{element}` is below 0: write 0 or more",
        "{at}: 要素 `{element}` の属性 `{attribute}` が負です。0以上にしてください";
    TwoOrientations { at: Place, element: String }
        "{at}: element `{element}` says more than once how it is turned: leave one of `quat`, `axisangle`, `xyaxes`, `zaxis` and `euler`",
        "{at}: 要素 `{element}` の向きが2通りに書かれています。`quat`、`axisangle`、`xyaxes`、`zaxis`、`euler` のどれか1つにしてください";
    GlobalCoordinates { at: Place }
        "{at}: global coordinates, which MuJoCo has dropped: load the file in MuJoCo 2.3 and save it, so that each body has its own",
        "{at}: グローバル座標はMuJoCoでも廃止されました。MuJoCo 2.3で読み込んで保存し、ボディごとの座標にしてください";
    UnknownClass { at: Place, class: String, known: List }
        "{at}: no default class is called `{class}`: the classes are {known}",
        "{at}: `{class}` というdefaultクラスはありません。あるのは {known}";
    ClassTwice { at: Place, class: String }
        "{at}: default class `{class}` is defined for the second time: give each its own name",
        "{at}: defaultクラス `{class}` の定義は2つ目です。別々の名前にしてください";
    TooManyElements { at: Place, most: usize }
        "{at}: the file has more than {most} elements: no robot needs so many",
        "{at}: 要素が{most}個を超えています。ロボットにそんなに多くの要素は要りません";
    TooManyParts { at: Place, most: usize }
        "{at}: the model has more than {most} parts, copies among them: leave out what is no part of the robot",
        "{at}: モデルの部品が、複製を含めて{most}個を超えています。ロボットでないものを除いてください";
    TooManyCopies { at: Place, most: usize }
        "{at}: `count` of `replicate` is no whole number from 0 to {most}: write such",
        "{at}: `replicate` の `count` には0から{most}までの整数を書いてください";
    MakesBodies { at: Place, element: String }
        "{at}: element `{element}` makes bodies that are not in the file: load the file in MuJoCo, and import what `mj_saveLastXML` writes",
        "{at}: 要素 `{element}` はファイルにないボディを作ります。MuJoCoで読み込み、`mj_saveLastXML` が書いたファイルを取り込んでください";
    ClosedLoop { at: Place, element: String }
        "{at}: the constraint `{element}` closes a loop, and a leg is an open chain: leave it out, or write `active=\"false\"`, if the robot is to be imported without it",
        "{at}: 拘束 `{element}` が閉ループを作っていますが、脚は開いた連鎖です。拘束なしで取り込むなら、取り除くか `active=\"false\"` と書いてください";
    TwoRobots { one: String, other: String }
        "bodies `{one}` and `{other}` of the world both carry joints, and one is free: import a file with one robot",
        "ワールドのボディ `{one}` と `{other}` の両方に関節があり、一方は固定されていません。ロボット1台だけのファイルにしてください";
    InIncluded { at: Place, file: String, reason: Text }
        "{at}: included file `{file}`: {reason}",
        "{at}: 取り込むファイル `{file}`: {reason}";
    CannotInclude { at: Place, file: String, reason: Text }
        "{at}: `{file}` cannot be included: {reason}",
        "{at}: `{file}` を取り込めません: {reason}";
    IncludeWithoutFolder { at: Place, file: String }
        "{at}: `{file}` is not included, since this text is no file in a folder: import the file by its path",
        "{at}: ファイルとして渡されていないので `{file}` を取り込めません。パスを指定して取り込んでください";
    IncludeOutside { at: Place, file: String }
        "{at}: `{file}` is outside of the folder of the file: put it below that folder",
        "{at}: `{file}` はこのファイルのフォルダの外にあります。フォルダの中に置いてください";
    IncludedTwice { at: Place, file: String }
        "{at}: `{file}` is included for the second time, and MuJoCo includes a file once: leave one out",
        "{at}: `{file}` の取り込みは2回目です。MuJoCoでは1回だけなので、一方を除いてください";
    TooManyIncludes { at: Place, most: usize }
        "{at}: more than {most} files are included: no robot needs so many",
        "{at}: 取り込むファイルが{most}個を超えています。ロボットにそんなに多くは要りません";
    IncludesTooLarge { at: Place, limit: usize }
        "{at}: the files have more than {limit} MiB together: leave out what is no part of the robot",
        "{at}: ファイルが合わせて{limit} MiBを超えています。ロボットでないものを除いてください";
    Wheel { joint: String, link: String, before: String }
        "joint `{joint}` turns wheel `{link}`, and a wheel is no foot: end the leg before it with `--foot {before}=X,Y,Z`, in metres and in the frame of the link, or at the hub with `--foot {link}`",
        "関節 `{joint}` は車輪 `{link}` を回します。車輪は足先ではありません。リンク座標系での位置をメートルで `--foot {before}=X,Y,Z` と指定して手前で終わらせるか、`--foot {link}` でハブを足先にしてください";
    NoTurningJoint { link: String }
        "no joint turns on link `{link}`: a robot needs one chain of revolute joints at least",
        "リンク `{link}` に回転する関節がありません。回転関節の連鎖が少なくとも1本必要です";
    NoRobot { line: String, faults: Faults }
        "its numbers describe no robot, in m, kg, rad and N·m as URDF has them: {faults}; see what comes of them: `{line}`",
        "URDFの単位 (m、kg、rad、N·m) で読むと、この数値ではロボットになりません: {faults}。変換結果: `{line}`";
    OnItsSide { up: &'static str }
        "the first joints of all legs are in one upright plane, so that the robot lies on its side: import it with `--up {up}` if {up} is up in the file, or with `--up z` if it really is like that",
        "全ての脚の第1関節が鉛直な平面の中にあり、ロボットが横倒しになっています。ファイルの上向きが{up}なら `--up {up}` を、本当にこの形なら `--up z` を付けてください";
    TooManyChains { chains: usize, most: usize }
        "{chains} chains begin on the body, and a robot has {most} legs at most: leave out those that are no legs with `--skip`",
        "胴体から{chains}本の連鎖が出ていますが、脚は{most}本までです。脚でない連鎖は `--skip` で除いてください";
    TooManyJoints { leg: String, joints: usize, most: usize }
        "the leg of joint `{leg}` has {joints} joints, and {most} are the most: make some of them fixed",
        "関節 `{leg}` の脚には関節が{joints}個ありますが、{most}個までです。いくつかをfixedにしてください";
    OtherNumberOfJoints { leg: String, joints: usize, first: String, wanted: usize }
        "the leg of joint `{leg}` has {joints} joints, that of joint `{first}` has {wanted}: every leg needs the same number, so leave one out with `--skip`, end one earlier with `--foot`, or make the others fixed",
        "関節 `{leg}` の脚は{joints}関節、関節 `{first}` の脚は{wanted}関節です。全ての脚で同じ数になるよう、`--skip` で一方を除くか、`--foot` で手前を足先にするか、余りをfixedにしてください";
    LinkTwice { link: String, first: Place, second: Place }
        "link `{link}` is defined twice, at {first} and at {second}: give each its own name",
        "リンク `{link}` が2つあります({first}と{second})。別々の名前にしてください";
    JointTwice { joint: String, first: Place, second: Place }
        "joint `{joint}` is defined twice, at {first} and at {second}: give each its own name",
        "関節 `{joint}` が2つあります({first}と{second})。別々の名前にしてください";
    NoSuchLink { joint: String, link: String }
        "joint `{joint}` names link `{link}`, which is not there",
        "関節 `{joint}` の指すリンク `{link}` がありません";
    OnTwoJoints { link: String }
        "link `{link}` hangs on two joints: a loop cannot be imported",
        "リンク `{link}` が2つの関節につながっています。閉ループは取り込めません";
    NoBase
        "no link is the base: every one hangs on a joint",
        "基部となるリンクがありません。全てのリンクが関節の先にあります";
    TwoBases { one: String, other: String }
        "links `{one}` and `{other}` hang on no joint: one link must be the base of all others",
        "リンク `{one}` と `{other}` はどの関節の先にもありません。基部は1つだけにします";
    Circle { link: String, base: String }
        "link `{link}` does not hang on the base `{base}`: its joints make a circle",
        "リンク `{link}` が基部 `{base}` につながっていません。関節が輪になっています";
    Branches { leg: String, link: String, one: String, other: String }
        "the leg of joint `{leg}` branches at link `{link}` into the joints `{one}` and `{other}`: a leg is one chain, so make one of them fixed",
        "関節 `{leg}` の脚がリンク `{link}` で関節 `{one}` と `{other}` に分かれています。脚は一本の連鎖なので、一方をfixedにしてください";
    DoesNotTurn { joint: String, link: String, kind: JointKind }
        "joint `{joint}` on link `{link}` is {kind}: legs have joints that turn about one axis, so make it fixed, revolute or continuous (in MJCF, remove it or make it a hinge)",
        "リンク `{link}` の関節 `{joint}` は{kind}です。脚の関節は1軸回転なので、fixed、revolute、continuousのどれか(MJCFなら、取り除くかhinge)にしてください";
    Mimics { joint: String, link: String, other: String }
        "joint `{joint}` on link `{link}` mimics joint `{other}`: every joint of a leg moves by itself, so make it fixed",
        "リンク `{link}` の関節 `{joint}` は関節 `{other}` に連動(mimic)しています。脚の関節は独立に動くので、fixedにしてください";
    NoAxis { joint: String, link: String }
        "joint `{joint}` on link `{link}` turns about an axis of length 0",
        "リンク `{link}` の関節 `{joint}` の回転軸の長さが0です";
    NoFoot { link: String, joint: String }
        "link `{link}` after joint `{joint}` is the last of its leg, and nothing says where its foot is: say it with `--foot {link}=X,Y,Z`, in metres and in the frame of the link, or leave the chain out with `--skip {joint}`",
        "関節 `{joint}` の先のリンク `{link}` が脚の最後ですが、足先の位置が分かりません。リンク座標系での位置をメートルで `--foot {link}=X,Y,Z` のように指定するか、`--skip {joint}` でこの連鎖を除いてください";
    TwoFeet { link: String, joint: String, one: String, other: String }
        "link `{link}` after joint `{joint}` ends in the links `{one}` and `{other}`: name the one that is the foot with `--foot`, or leave the chain out with `--skip {joint}`",
        "関節 `{joint}` の先のリンク `{link}` が `{one}` と `{other}` の2つで終わっています。足先の方を `--foot` で指定するか、`--skip {joint}` でこの連鎖を除いてください";
    NoChain { word: String, chains: List }
        "no chain is called `{word}`: name a chain by one of its joints or links, or by what only its first joint's name has; the first joints are {chains}",
        "`{word}` という連鎖はありません。連鎖の関節かリンクの名前、または第1関節の名前だけにある語で指定してください。第1関節は {chains}";
    SeveralChains { word: String, chains: List }
        "`{word}` is in the names of several chains: {chains}; write the whole name of a joint or link",
        "`{word}` は複数の連鎖の名前({chains})にあります。関節かリンクの名前をそのまま書いてください";
    ChainTwice { word: String, chain: String }
        "`{word}` names the chain of joint `{chain}` for the second time",
        "`{word}` は関節 `{chain}` の連鎖を再び指しています";
    NotInOrder { chains: List }
        "the order lacks the chains of {chains}: name each leg once, or leave chains out with `--skip`",
        "順序に {chains} の連鎖がありません。各脚を1回ずつ書くか、`--skip` で除いてください";
    AllLeftOut { chains: List }
        "every chain is left out, and one leg has to stay: the first joints are {chains}",
        "全ての連鎖が除かれました。少なくとも1本の脚が必要です。第1関節は {chains}";
    NoSuchFoot { link: String, ends: List }
        "link `{link}` ends no leg: it is not there, on no leg, or after another foot; without it the legs end in {ends}",
        "リンク `{link}` は足先になりません。リンクがないか、脚の上にないか、別の足先より先にあります。指定しなければ足先は {ends}";

    FootTwice { link: String }
        "`--foot` names link `{link}` twice: a leg has one foot",
        "`--foot` がリンク `{link}` を2回指定しています。足先は脚ごとに1つです";

    CannotStand { height: f64, near: f64 }
        "no posture within the limits puts all feet {height} mm below the robot frame; one was found for `--stand {near}`",
        "全ての足先をロボット座標系の{height} mm下に置ける姿勢が、限界の中にありません。`--stand {near}` なら可能です";
    StandsNowhere
        "no posture within the limits has all feet equally far below the robot frame: leave `--stand` out, and set `initial`",
        "全ての足先が同じ高さになる姿勢が、限界の中に見つかりません。`--stand` を省いて `initial` を設定してください";
    StandIsForWalkers
        "`--stand` is for a robot that walks, and this one is bolted down: leave it out",
        "`--stand` は歩くロボットのための指定ですが、これは固定されたロボットです。省いてください";

    // Remarks on an accepted file.
    LeftOut { chains: List, mass: f64 }
        "left out, as asked: the chains of {chains}, which weigh {mass} kg",
        "指定により除いたもの: {chains} の連鎖 ({mass} kg)";
    CutOff { foot: String, joints: List, mass: f64 }
        "left out: what is after the foot {foot}, which weighs {mass} kg: joints {joints}",
        "除いたもの: 足先{foot}より先の{mass} kg。関節 {joints}";
    WheelIsFoot { joint: String }
        "doubtful: the foot is the hub of a wheel, as asked; a wheel is no foot, and the robot does not stand on it: {joint}",
        "要確認: 指定により車輪のハブを足先にしました。車輪は足先ではなく、接地するのはハブではありません: {joint}";
    NamesTurned { joints: List, forward: &'static str }
        "doubtful: the names of these legs contradict their places, and agree if {forward} is forward in the file: `--forward {forward}` turns the model: {joints}",
        "要確認: 脚の名前と位置が合いません。ファイルの{forward}が前なら合います。`--forward {forward}` で向きを変えられます: {joints}";
    NamesContradict { joints: List }
        "doubtful: the names of these legs contradict their places, whatever axis is forward; `--order` numbers them by name: {joints}",
        "要確認: どの軸を前としても脚の名前と位置が合いません。`--order` で名前に合わせて番号を付けられます: {joints}";
    Scenery { bodies: List }
        "dropped: bodies of the world that carry no joint: {bodies}",
        "読み捨てたもの: 関節のないワールドのボディ: {bodies}";
    IgnoredElements { elements: List }
        "dropped: elements that are not known, and are taken not to move the robot: {elements}",
        "読み捨てたもの: 知られていない要素(ロボットの動きには関わらないとみなします): {elements}";
    UnweighedMeshes { bodies: List }
        "doubtful: the mass of meshes without `mass` is not calculated; write `inertial`, or set `mass`: {bodies}",
        "要確認: `mass` のないメッシュの質量は計算しません。`inertial` を書くか、`mass` を設定してください: {bodies}";
    PostureOfFile { name: String }
        "the initial posture is that of keyframe {name}",
        "初期姿勢はキーフレーム{name}の姿勢です";
    PostureOutside { joints: List }
        "doubtful: the keyframe is outside of the limits of these joints, and the initial posture is at their ends: {joints}",
        "要確認: キーフレームが次の関節の限界を超えるので、初期姿勢は限界の端にします: {joints}";
    PostureFalls { name: String }
        "doubtful: the robot falls in the posture of keyframe {name}",
        "要確認: キーフレーム{name}の姿勢では倒れます";
    NoVelocity
        "assumed: the default OMEGA_MAX, since the format has no speeds of joints; set `omega_max`",
        "仮定: この形式には関節の速度がないので、OMEGA_MAXは既定値。`omega_max` を設定してください";
    Frames
        "frames: x forward and y left (REP 103) became x right and y forward",
        "座標系: x前・y左(REP 103)を、x右・y前に変えました";
    Dropped
        "dropped: looks, damping, friction, safety limits",
        "読み捨てたもの: 外観、減衰、摩擦、安全限界";
    Meshes { links: List }
        "dropped: collision shapes that are meshes: {links}",
        "読み捨てたもの: メッシュの衝突形状: {links}";
    NoSize { links: List }
        "dropped: collision shapes that have a size of 0 or less, or are farther away than 1 km: {links}",
        "読み捨てたもの: 寸法が0以下か、1 kmより遠い衝突形状: {links}";
    BaseShapes
        "dropped: the collision shapes of the base, which is bolted down",
        "読み捨てたもの: 固定された基部の衝突形状";
    NoSensors
        "assumed: no torque sensors; add [forces] if there are some",
        "仮定: トルクセンサなし。あれば[forces]を加えてください";
    InitialPosture
        "assumed: the initial posture is the middle of the limits; set `initial`",
        "仮定: 初期姿勢は限界の中央。`initial` を設定してください";
    Stands { height: f64 }
        "the initial posture has all feet {height} mm below the robot frame, as asked",
        "初期姿勢では、指定どおり全ての足先がロボット座標系の{height} mm下にあります";
    StandsByItself { height: f64 }
        "assumed: the initial posture has all feet {height} mm below the robot frame, since the robot would fall in the middle of its limits; set `initial`, or choose a height with `--stand`",
        "仮定: 限界の中央の姿勢では倒れるので、初期姿勢では全ての足先をロボット座標系の{height} mm下に置きます。`initial` を設定するか、`--stand` で高さを選んでください";
    DoesNotStand
        "doubtful: the robot falls in its initial posture, and no height was found at which it stands: set `initial`",
        "要確認: 初期姿勢で倒れます。立っていられる高さも見つかりません。`initial` を設定してください";
    Leg { number: usize, joint: String, link: String }
        "F{number}: joint {joint} to link {link}",
        "F{number}: 関節{joint}からリンク{link}まで";
    LegsByPlace { joints: List }
        "the legs are numbered by where they are, from front to rear and left before right: {joints}; `--order` chooses another order",
        "脚の番号は位置による順です(前から後ろ、左が先): {joints}。`--order` で変えられます";
    LegsWithoutPlace { joints: List }
        "doubtful: where the legs are does not tell front from rear and left from right, so that they are numbered in the order of the file: {joints}; say it with `--order`",
        "要確認: 脚の位置から前後左右が決まらないので、番号はファイルの順です: {joints}。`--order` で指定してください";
    LegsOfFile { joints: List }
        "F1, F2, … are in the order of the file: {joints}; `--order` chooses another order",
        "F1、F2、…の番号はファイルの順です: {joints}。`--order` で変えられます";
    UnknownVersion { version: String, read_as: &'static str }
        "doubtful: `{version}` is no version of URDF that is known, so that the file was read as {read_as}",
        "要確認: `{version}` というURDFの版は知られていないので、{read_as}として読みました";
    OldQuaternion { at: Place, elements: usize }
        "dropped: `quat_xyzw`, which URDF has since 1.1, {elements} times, first at {at}: write `version=\"1.1\"` in `<robot>`, or `rpy`, if it is to count",
        "読み捨てたもの: {elements}個の要素の `quat_xyzw`(最初は{at})。URDF 1.1からの属性です。使うなら `<robot>` に `version=\"1.1\"` と書くか、`rpy` で書いてください";
    OmegaMax
        "OMEGA_MAX is the velocity of the slowest joint",
        "OMEGA_MAXは最も遅い関節の速度です";
    TurnsAllRound { joints: List }
        "assumed: limits of -180 and 180 deg, since the file gives none: {joints}",
        "仮定: 限界がないので-180と180 deg: {joints}";
    InfiniteLimits { joints: List }
        "assumed: limits of -180 and 180 deg in place of infinite ones: {joints}",
        "仮定: 限界が無限大なので-180と180 deg: {joints}";
    LimitsOfContinuous { joints: List }
        "dropped: what continuous joints say of `lower` and `upper`, since they turn without end; their limits are -180 and 180 deg: {joints}",
        "読み捨てたもの: 連続回転(continuous)の関節の `lower` と `upper`。端がないので限界は-180と180 deg: {joints}";
    OpenLimits { joints: List }
        "assumed: one end of the limits, which is not stated or infinite; the other one is kept: {joints}",
        "仮定: 限界の一方が書かれていないか無限大。もう一方は書かれたとおり: {joints}";
    SwappedLimits { joints: List }
        "doubtful: `lower` is above `upper`, and the two were swapped: {joints}",
        "要確認: `lower` が `upper` より大きいので、入れ替えました: {joints}";
    LockedJoints { joints: List }
        "locked: `lower` and `upper` are equal, and the joint stays there: {joints}",
        "固定: `lower` と `upper` が等しいので、関節はその角度のままです: {joints}";
    Motor { joints: List }
        "assumed: motors of 10 N·m, since the file gives no effort above 0 and up to 100000 N·m: {joints}",
        "仮定: 0より大きく100000 N·m以下のeffortがないので、モータは10 N·m: {joints}";
    DoubtfulLimits { joints: List }
        "doubtful: limits of half a turn or more on both sides look like placeholders; set `limits`: {joints}",
        "要確認: 両側とも半回転以上の限界は仮の値のようです。`limits` を設定してください: {joints}";
    DoubtfulEffort { joints: List }
        "doubtful: an effort of 1000 N·m or more looks like a placeholder; set `torque`: {joints}",
        "要確認: 1000 N·m以上のeffortは仮の値のようです。`torque` を設定してください: {joints}";
    DoubtfulVelocity { joints: List }
        "doubtful: a velocity of 0, or of 1000 rad/s or more, looks like a placeholder and is no part of OMEGA_MAX; set `omega_max`: {joints}",
        "要確認: 0や1000 rad/s以上のvelocityは仮の値のようなので、OMEGA_MAXには使いません。`omega_max` を設定してください: {joints}";
    NoMass { joints: List }
        "doubtful: these joints carry 0 kg; set `mass`, or the plant with mass moves motors only: {joints}",
        "要確認: 次の関節の先の質量が0 kgです。`mass` を設定しないと、質量を持つプラントではモータだけが動きます: {joints}";
    NoInertia { links: List }
        "doubtful: these links have a mass, and an inertia of 0 about some axis; they count as point masses, and where they are most of the mass that moves as one, its inertia is that of a uniform rod or box: {links}",
        "要確認: 次のリンクには質量がありますが、慣性モーメントが0の軸があります。質点とみなし、一体で動く部分の質量の過半なら、慣性は一様な棒か箱のものとします: {links}";
    DoubtfulInertia { links: List }
        "doubtful: the inertia of these links is that of no rigid body, or of one larger than the robot; they count as point masses, and where they are most of the mass that moves as one, its inertia is that of a uniform rod or box: {links}",
        "要確認: 次のリンクの慣性テンソルは、どんな剛体にもないか、ロボットより大きな剛体のものです。質点とみなし、一体で動く部分の質量の過半なら、慣性は一様な棒か箱のものとします: {links}";
    TookIn { link: String, merged: List }
        "link {link} took in the links fixed to it: {merged}",
        "リンク{link}に、固定されたリンクをまとめました: {merged}";
    BoltedDown
        "assumed: the robot is bolted down; add [body] if it walks",
        "仮定: ロボットは床に固定。歩くなら[body]を加えてください";
    Walks
        "assumed: the robot walks; its body is a box around the first joints, 100 mm high: measure it, or leave [body] out if it is bolted down as a hand is",
        "仮定: ロボットは歩く。胴体は第1関節を囲む高さ100 mmの箱。実測してください。ハンドのように固定されているなら[body]を削除してください";
    ThickBody { axes: List }
        "doubtful: the first joints are in one plane, and the body is taken to be 100 mm thick there: set `{axes}`",
        "要確認: 第1関節が一平面にあるので、そこでの胴体の厚さを100 mmとしました。`{axes}` を設定してください";
    BodyOfShapes
        "assumed: the robot walks; its body is the box around the collision shapes of its base: leave [body] out if it is bolted down as a hand is",
        "仮定: ロボットは歩く。胴体は基部の衝突形状を囲む箱。ハンドのように固定されているなら[body]を削除してください";
    BodyOfBox
        "the robot walks; its body is the box of link body",
        "ロボットは歩きます。胴体はリンクbodyの箱です";
    Slider
        "the prismatic joints that end in link floor became the slider that carries the floor (FLOOR)",
        "リンクfloorに至る直動関節を、床を載せるスライダ(FLOOR)にしました";
    NotCompared { pairs: List }
        "not compared: pairs of parts that overlap in the initial posture, so that nothing reports or stops their collisions: {pairs}; give the links a smaller `radius` or their `shape`, or list pairs that may touch in `may_touch`",
        "比較しないもの: 初期姿勢で重なる部分の組。この組の干渉は報告も停止もされません: {pairs}。リンクの `radius` を小さくするか、`shape` を書くか、触れてもよい組を `may_touch` に書いてください";
    BodyMass
        "assumed: the body weighs 1 kg",
        "仮定: 胴体の質量は1 kg";
}
