//! The lines of the help that are one sentence, in Japanese.

/// What a command, an option or a value is said to be in English, and in Japanese. Each has a row.
pub(super) const LINES: &[(&str, &str)] = &[
    // Commands.
    (
        "Compiler, checker and simulator for T.I.P. 3.1 robot programs",
        "T.I.P. 3.1 のロボットプログラムのコンパイラ・検査器・シミュレータ",
    ),
    (
        "Make a crate whose robot moves at once, with a test and an editor's configuration",
        "すぐに動くロボットのクレートを、テストとエディタの設定ごと作る",
    ),
    (
        "Report everything that is wrong with programs",
        "プログラムの誤りをすべて報告する",
    ),
    (
        "Run a program on the simulated robot",
        "シミュレーションのロボットでプログラムを実行する",
    ),
    (
        "Lay programs out in the one style",
        "プログラムをただ一つの書式に整える",
    ),
    (
        "Write what a run did as a log for other tools: MCAP or CSV",
        "実行の記録を他のツール向けのログに書き出す (MCAP または CSV)",
    ),
    (
        "Draw what a run did as diagrams: SVG",
        "実行の記録を図にする (SVG)",
    ),
    (
        "Write a program in another form",
        "プログラムを別の形式で書き出す",
    ),
    (
        "Count the control cycles that the parts of a program take",
        "プログラムの各部分にかかる制御周期を数える",
    ),
    (
        "Compare a program's compiled code with the reference interpreter",
        "コンパイルしたコードを基準のインタプリタと比べる",
    ),
    (
        "Write a page that replays a run: the robot in 3-D beside its program",
        "実行を再生するページを書き出す (ロボットの 3D 表示とプログラム)",
    ),
    (
        "Run a program live in a page, where it is steered and edited",
        "プログラムをページ上で実行し、操作・編集する",
    ),
    (
        "Debug a program on the terminal, forwards and backwards",
        "端末上でデバッグする (前にも後ろにも進める)",
    ),
    (
        "Serve a debugger to editors: the Debug Adapter Protocol",
        "エディタ向けのデバッガ (Debug Adapter Protocol)",
    ),
    (
        "Turn a program of an older version into one of version 3.1",
        "古い版のプログラムを 3.1 版に書き換える",
    ),
    (
        "Say what the code of a finding means, with a wrong and a right program",
        "エラーや警告のコードを、誤った例と正しい例で説明する",
    ),
    (
        "Serve an editor: the language server",
        "エディタ向けの言語サーバ",
    ),
    (
        "Print what a shell completes the command line with",
        "シェルの補完スクリプトを表示する",
    ),
    ("Write the pages of man", "man のページを書き出す"),
    ("Descriptions of robots", "ロボットの記述ファイル"),
    (
        "Report everything that is wrong with a description, or what the robot has",
        "記述ファイルの誤りをすべて報告する。なければロボットの構成を示す",
    ),
    (
        "List the robots that have a name",
        "名前のあるロボットの一覧を示す",
    ),
    (
        "Show what a robot has, and where the figures of a published one come from",
        "ロボットの構成を示す。公開されているロボットは数値の出典も示す",
    ),
    (
        "The robot: a name that 'tipc robot list' shows, or a description",
        "ロボット: 'tipc robot list' が示す名前、または記述ファイル",
    ),
    (
        "Make a description of a URDF file",
        "URDF ファイルから記述ファイルを作る",
    ),
    (
        "Write a robot as URDF, or as a model of MuJoCo",
        "ロボットを URDF か MuJoCo のモデルで書き出す",
    ),
    (
        "Print this message or the help of the given subcommand(s)",
        "この説明、または指定したコマンドの説明を表示する",
    ),
    // What every command has.
    ("Print help", "説明を表示する"),
    (
        "Print help (see more with '--help')",
        "説明を表示する (詳細は '--help')",
    ),
    ("Print version", "版を表示する"),
    // Files and robots.
    ("The program", "プログラム"),
    (
        "The programs; '-' is standard input",
        "プログラム。'-' は標準入力",
    ),
    ("The older program", "古い版のプログラム"),
    ("The file", "ファイル"),
    (
        "The file; its ending says what it is",
        "書き出すファイル。拡張子で形式が決まる",
    ),
    ("The description", "記述ファイル"),
    (
        "The URDF file; xacro has to be expanded first",
        "URDF ファイル。xacro は先に展開する",
    ),
    (
        "A link that is a chain's foot, where that is not the last one; with '=X,Y,Z' a place in its frame, in m; several with commas between them",
        "末端のリンク以外を足先にする。'=X,Y,Z' を付けるとリンク座標系での位置 (m)。複数はコンマで区切る",
    ),
    (
        "Leave a chain out, such as an arm or a head; several with commas between them",
        "腕や頭などの連鎖を除く。複数はコンマで区切る",
    ),
    (
        "The chains that become F1, F2, …, with commas between them; else in the order of the file",
        "F1、F2、… にする連鎖をコンマで区切って並べる。省くとファイルの順",
    ),
    (
        "Begin with all feet so many mm below the robot frame, the body level; else in the middle of the limits",
        "初期姿勢で、全ての足先をロボット座標系のこの高さ (mm) だけ下に置き、胴体を水平にする。省くと限界の中央",
    ),
    (
        "The robot of every program: a name that 'tipc robot list' shows, or a description",
        "すべてのプログラムのロボット: 'tipc robot list' が示す名前、または記述ファイル",
    ),
    (
        "Talk through standard input and output, as it always does",
        "標準入出力で話す (常にそうする)",
    ),
    (
        "The robot that the program is for: a name that 'tipc robot list' shows, or a description; else that of tip.toml, or titan8",
        "対象のロボット: 'tipc robot list' が示す名前、または記述ファイル。省くと tip.toml のもの、なければ titan8",
    ),
    (
        "The robot that the programs are for, if it is none that has a name",
        "対象のロボット (名前のないロボットの場合)",
    ),
    (
        "The robot: hexapod, a name that 'tipc robot list' shows, or a description",
        "ロボット: hexapod、'tipc robot list' が示す名前、または記述ファイル",
    ),
    (
        "The robot: a name that 'tipc robot list' shows, a description, or a URDF file that is to be made regular",
        "ロボット: 'tipc robot list' が示す名前、記述ファイル、または整形する URDF ファイル",
    ),
    (
        "The version of the language that line 1 must name",
        "1 行目に書かれているべき言語の版",
    ),
    (
        "How the file spells text; auto, unless tip.toml says otherwise, takes UTF-8 if it is valid, else Shift_JIS",
        "ファイルの文字コード。auto (tip.toml に指定がない場合) は、UTF-8 として正しければ UTF-8、そうでなければ Shift_JIS",
    ),
    (
        "How the files spell text; auto, unless tip.toml says otherwise, takes UTF-8 if it is valid, else Shift_JIS",
        "ファイルの文字コード。auto (tip.toml に指定がない場合) は、UTF-8 として正しければ UTF-8、そうでなければ Shift_JIS",
    ),
    (
        "How the file spells text; auto takes UTF-8 if it is valid, else Shift_JIS",
        "ファイルの文字コード。auto は、UTF-8 として正しければ UTF-8、そうでなければ Shift_JIS",
    ),
    // How findings are shown.
    (
        "How findings are shown: snippets for people, or lines for tools",
        "エラーや警告の表示形式。人向けの抜粋、またはツール向けの行",
    ),
    (
        "With the source line, help and colour",
        "ソースの行、助言、色つき",
    ),
    ("One line each", "1 件 1 行"),
    ("One JSON object a line", "1 行に JSON オブジェクト一つ"),
    (
        "One document of SARIF 2.1.0 for all files, by check alone",
        "全ファイルで一つの SARIF 2.1.0 文書 (check だけ)",
    ),
    (
        "The language of reasons and helps, if not that of the locale",
        "理由や助言の言語。省くとロケールに従う",
    ),
    (
        "The language of the page, if not that of the locale",
        "ページの言語。省くとロケールに従う",
    ),
    ("English", "英語"),
    ("Japanese", "日本語"),
    (
        "Whether findings for people have colours; auto: on a terminal, unless NO_COLOR says otherwise",
        "人向けの表示に色をつけるか。auto は端末なら色をつける (NO_COLOR があれば除く)",
    ),
    ("On a terminal", "端末なら"),
    ("Everywhere", "常に"),
    ("Nowhere", "つけない"),
    (
        "Fail over these: the codes of warnings, as W112; 'warnings' for all of them; 'falls' of the robot in a run",
        "これらがあれば失敗とする: W112 のような警告のコード、すべての警告は 'warnings'、実行中の転倒は 'falls'",
    ),
    (
        "Say nothing but the program's messages and the errors that end a run",
        "プログラムのメッセージと、実行を終わらせるエラーだけを表示する",
    ),
    ("Say nothing but errors", "エラーだけを表示する"),
    (
        "Say nothing but the address and errors",
        "アドレスとエラーだけを表示する",
    ),
    // check and fmt.
    (
        "Apply the fixes that are certain, and write the files; from standard input to standard output",
        "確実な修正を適用してファイルに書く。標準入力なら標準出力へ",
    ),
    (
        "Apply likely fixes as well",
        "確実とまでは言えない修正も適用する",
    ),
    (
        "Say nothing of programs in which nothing is found",
        "問題のないプログラムについては何も表示しない",
    ),
    (
        "Check again whenever a file changes",
        "ファイルが変わるたびに検査し直す",
    ),
    (
        "Write nothing, and print the names of the files that would change",
        "何も書かず、変わるはずのファイル名を表示する",
    ),
    (
        "Write nothing, and print what would change",
        "何も書かず、変わるはずの箇所を表示する",
    ),
    // Runs.
    (
        "Stop after this many control cycles",
        "この数の制御周期で終える",
    ),
    (
        "Keys that are pressed before the step of a cycle: one ASCII character each, or 0x1B form",
        "周期のステップの前に押すキー。ASCII 1 文字、または 0x1B の形",
    ),
    (
        "Request a halt before the step of this cycle",
        "この周期のステップの前に停止を要求する",
    ),
    (
        "Make an input read this voltage from a cycle on: VR1-3, PAW1-4, ANTENNA, J11 and so on",
        "ある周期から、入力をこの電圧にする: VR1-3、PAW1-4、ANTENNA、J11 など",
    ),
    (
        "Events before the step of a cycle, such as '10:key F, 300:VR1=8, 500:push 80 0 0 for 5, 900:halt'",
        "周期のステップの前に起こること。例: '10:key F, 300:VR1=8, 500:push 80 0 0 for 5, 900:halt'",
    ),
    (
        "What surrounds the robot: cylinder, an object under a hand, or a scene of your own",
        "ロボットの周囲: cylinder (ハンドの下の物体)、または自作のシーン",
    ),
    (
        "How a walking robot is simulated: quasi-static, at rest wherever it is, or dynamic, with mass; for 'tipc run' also exec:COMMAND, a process of yours that simulates any robot",
        "歩行ロボットのシミュレーション: quasi-static は各時点で静止とみなし、dynamic は質量を考える。tipc run では exec:COMMAND も使え、どのロボットも自分のプロセスでシミュレーションできる",
    ),
    (
        "Write the trace, one JSON object a line, to a file, or to standard output for '-'",
        "トレースを 1 行 1 JSON オブジェクトでファイルに書く。'-' は標準出力",
    ),
    (
        "End each record of the trace with a hash of the robot's commands and measurements",
        "トレースの各行の終わりに、ロボットへの指令と計測値のハッシュを付ける",
    ),
    (
        "End each record of the trace with what the simulated robot did: pose, angles, loads, margin, falls, and what a robot without mass leaves out",
        "トレースの各行の終わりに、ロボットの動きを付ける: 姿勢、関節角、荷重、余裕、転倒、質量のないロボットでは分からないこと",
    ),
    (
        "Write the log files of the language into this folder",
        "言語が定めるログファイルをこのフォルダに書く",
    ),
    (
        "Run as fast as the robot does, and show how it is; keys are those of the terminal",
        "ロボットと同じ速さで実行し、状態を表示する。キーは端末から",
    ),
    ("How many runs a search makes", "探索で実行する回数"),
    (
        "The Cargo.toml of the project whose tip-runtime is used, if not that of the current folder",
        "使う tip-runtime のあるプロジェクトの Cargo.toml。省くと現在のフォルダのもの",
    ),
    // Pages, logs, diagrams.
    (
        "Keep the motion of one cycle in so many; without it MCAP has 50 Hz at most, CSV each cycle",
        "動きをこの数の周期ごとに残す。省くと MCAP は最大 50 Hz、CSV は毎周期",
    ),
    (
        "What is drawn, from top to bottom; everything without it",
        "上から順に描くもの。省くとすべて",
    ),
    (
        "Which feet carry the robot, or which fingertips touch something",
        "どの足が体を支えるか、どの指先が何かに触れるか",
    ),
    ("Where the feet go: mm", "足先の軌跡 (mm)"),
    ("The angle of each joint: deg", "各関節の角度 (deg)"),
    (
        "What each motor gives: N·m or mN·m",
        "各モータのトルク (N·m または mN·m)",
    ),
    (
        "The load of each foot, or the force of each fingertip: N",
        "各足の荷重、または各指先の力 (N)",
    ),
    (
        "The program of FILE, which is a trace that 'tipc run --trace-motion' wrote",
        "FILE が 'tipc run --trace-motion' の書いたトレースのとき、そのプログラム",
    ),
    (
        "Write the page here; otherwise beside FILE, as FILE.html",
        "ページの書き出し先。省くと FILE の隣の FILE.html",
    ),
    (
        "The address to listen at; port 0 is any that is free",
        "待ち受けるアドレス。ポート 0 は空いているどれか",
    ),
    (
        "Do not run until someone asks for it",
        "求められるまで実行を始めない",
    ),
    // Other forms.
    ("Which form", "形式"),
    ("Rust source", "Rust のソース"),
    ("FORMAL.TMP", "FORMAL.TMP"),
    ("LABEL.TMP", "LABEL.TMP"),
    ("TIP.OBJ", "TIP.OBJ"),
    ("WARNING.LOG", "WARNING.LOG"),
    (
        "Write to a file instead of standard output",
        "標準出力ではなくファイルに書く",
    ),
    (
        "Write a model of MuJoCo (MJCF), with motors, contacts and what surrounds the robot",
        "MuJoCo のモデル (MJCF) を書く。モータ・接触・ロボットの周囲も含む",
    ),
    (
        "Write URDF, with boxes, cylinders and spheres for its shapes",
        "URDF を書く。形は直方体・円柱・球",
    ),
    (
        "The code of a finding, as E205-03 or W109, or the class of one, as E205",
        "エラーや警告のコード (E205-03、W109 など)、またはその分類 (E205 など)",
    ),
    ("The shell", "シェル"),
    (
        "The folder for the pages, one for each command; it is made if need be",
        "ページを書くフォルダ。コマンドごとに 1 ページ。なければ作る",
    ),
    // New crates.
    (
        "The crate's name, or a new folder that ends with it",
        "クレートの名前、またはその名前で終わる新しいフォルダ",
    ),
    (
        "Add a skeleton for drives of your own: the trait Hardware",
        "自分の駆動系のひな形 (トレイト Hardware) を加える",
    ),
    (
        "The checkout of this project to depend on; else the one that tipc was built from, else the published crates",
        "依存するこのプロジェクトのチェックアウト。省くと tipc を作ったもの、なければ公開版のクレート",
    ),
];
