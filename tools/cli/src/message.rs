//! The messages of the command.

use count::{Cycles, Errors, Files, Steps, Warnings};
use smol_str::SmolStr;
use tip_runtime::command::Target;
use tip_runtime::model::Part;
use tip_sim::message::Awaited;
use tipc::language::Keyword;
use tipc::message::list::{Each, List};
use tipc::message::{Message, Other, Text};

/// Numbers of something, as arguments of messages.
pub(crate) mod count {
    tipc::count_table! {
        /// Number of errors.
        Errors: "1 error", "エラー1件"; "{count} errors", "エラー{count}件";
    }

    tipc::count_table! {
        /// Number of warnings.
        Warnings: "1 warning", "警告1件"; "{count} warnings", "警告{count}件";
    }

    tipc::count_table! {
        /// Number of steps.
        Steps: "1 step", "1ステップ"; "{count} steps", "{count}ステップ";
    }

    tipc::count_table! {
        /// Number of control cycles.
        Cycles: "1 cycle", "1周期"; "{count} cycles", "{count}周期";
    }

    tipc::count_table! {
        /// Number of files.
        Files: "1 file", "1ファイル"; "{count} files", "{count}ファイル";
    }
}

tipc::message_table! {
    /// Wrong usage of the command `tip`.
    Using;

    RunThat { file: Text }
        "`{file}` is not a command of tip: did you mean `tip run {file}`?",
        "`{file}` はtipのコマンドではありません。`tip run {file}` のことですか?";
    OtherWord { word: String, command: String }
        "`{word}` is not a command of tip: did you mean `tip {command}`?",
        "`{word}` はtipのコマンドではありません。`tip {command}` のことですか?";
    NoCommand { word: String, commands: Each }
        "`{word}` is not a command of tip; the commands are {commands}",
        "`{word}` はtipのコマンドではありません。コマンドは{commands}です";
    NoFile { command: String }
        "which program? `tip {command}` needs a file, as in `tip {command} walk.prg`",
        "どのプログラムですか? `tip {command} walk.prg` のようにファイルを指定してください";
    NoCode { code: String }
        "there is no code {code}: messages show a code in brackets, such as E205, E205-03 or W109",
        "{code}というコードはありません。コードは E205、E205-03、W109 のように、メッセージの角括弧の中にあります";
    NearCodes { code: String, near: Each }
        "there is no code {code}; near it are {near}",
        "{code}というコードはありません。近いコードは{near}です";
    NotACount { text: String }
        "`{text}` is not a count: write a whole number, 0 or more",
        "`{text}` は数えられません。0以上の整数を指定してください";
    NotPositive { text: String }
        "`{text}` is not a number of runs or cycles: write a whole number, 1 or more",
        "`{text}` は実行回数でも周期数でもありません。1以上の整数を指定してください";
    NotThreads { text: String }
        "`{text}` is not a number of threads: write a whole number, 1 or more",
        "`{text}` はスレッド数ではありません。1以上の整数を指定してください";
    NotAFoot { text: String }
        "`{text}` is not a foot: write the name of a link, or `LINK=X,Y,Z` for a position in its frame in metres, such as `shank=0,0,-0.13`",
        "`{text}` は足先の指定ではありません。リンクの名前か、`shank=0,0,-0.13` のようにリンク座標系での位置(メートル)を付けて書いてください";
    NotAPeriod { text: String }
        "`{text}` is not a time: write a number, 0.1 or more",
        "`{text}` は時間ではありません。0.1以上の数を指定してください";
    NotAHeight { text: String }
        "`{text}` is not a height: write a number of mm above 0, such as 250",
        "`{text}` は高さではありません。250のように0より大きいmmの値を指定してください";
    NoRobot { word: String, robots: Each }
        "there is no robot `{word}`; the robots are {robots}, and your own in a FILE.toml",
        "`{word}` というロボットはありません。{robots}か、自分のロボットのファイル(FILE.toml)を指定してください";
    NearRobot { word: String, near: String, robots: Each }
        "there is no robot `{word}`: did you mean `{near}`? The robots are {robots}, and your own in a FILE.toml",
        "`{word}` というロボットはありません。`{near}` のことですか? {robots}か、自分のロボットのファイル(FILE.toml)を指定してください";
    NoPlant { word: String, plants: Each }
        "there is no plant `{word}`; the plants are {plants}, and a process of your own as `exec:COMMAND`",
        "`{word}` というプラントはありません。{plants}か、自分のプロセスを `exec:COMMAND` の形で指定してください";
    NoProcess { command: String }
        "`{command}` is not a command line: write a program and its arguments, and close every quote, as in `exec:python3 simulate.py`",
        "`{command}` はコマンドラインではありません。`exec:python3 simulate.py` のようにプログラムと引数を書き、引用符は閉じてください";
    ProcessRunsOnce { command: &'static str }
        "`tip {command}` repeats or rewinds runs, which a process cannot do: use --plant dynamic here, and the process with `tip run`",
        "`tip {command}` はプログラムを繰り返し、または逆向きに実行しますが、プロセスはコピーも巻き戻しもできません。ここでは --plant dynamic を使い、プロセスは `tip run` で使ってください";
    ProcessIsRun { command: &'static str }
        "`tip {command}` records only the built-in plants; `tip run --plant exec:COMMAND --trace FILE --trace-motion` runs the process, and `tip view FILE --program PROGRAM` shows what it did",
        "`tip {command}` が記録できるのは内蔵のプラントだけです。プロセスは `tip run --plant exec:COMMAND --trace FILE --trace-motion` で実行し、`tip view FILE --program PROGRAM` で表示してください";
    SceneIsElsewhere
        "--scene is for the built-in plants; a process has surroundings of its own: pass the scene to the process",
        "--scene は内蔵のプラントの周囲を決めるもので、プロセスの周囲はプロセス自身が決めます。シーンはプロセスに渡してください";
    NotACondition { text: String }
        "`{text}` is not a condition: write one of forward, speed, falls, margin, slip, rate, torque, energy, cost and lift, then < <= > >= or =, and a number, as in `speed<100`",
        "`{text}` は条件ではありません。forward、speed、falls、margin、slip、rate、torque、energy、cost、liftのどれか、< <= > >= = のどれか、数を `speed<100` のように書いてください";
    NoFigure { name: String }
        "the second run has no figure `{name}`: `tip compare` without --fail-if lists the figures that it has",
        "2番目の実行には `{name}` の値がありません。--fail-ifを付けない `tip compare` で値の一覧を見られます";
    OneOutput
        "--format json and --trace - both write to standard output: give the trace a file",
        "--format json と --trace - はどちらも標準出力に書きます。トレースにはファイルを指定してください";
    FallsAreElsewhere
        "--deny falls and --deny collisions need a built-in plant: falls and collisions of a process's robot are not counted",
        "--deny falls と --deny collisions を使えるのは内蔵のプラントだけです。プロセスのロボットの転倒や干渉は数えられません";
    RecordError { text: String }
        "`{text}` is no error that a motion can have: give 0.2 to 45 deg",
        "`{text}` は誤差として使えません。0.2から45度を指定してください";
    ServeTrace
        "--trace of a served run needs a file: standard output has the address of the page",
        "配信中の実行の --trace にはファイルを指定してください。標準出力にはページのアドレスを書きます";
    RecordAtStream
        "--at adds to a program in a file: give its name after -o",
        "--at はファイルのプログラムに加えます。-oの後にファイル名を指定してください";
    RecordPlace { text: String }
        "`{text}` is no place in a program: give the number of a line from 3 on, or `end`",
        "`{text}` はプログラムの位置として使えません。3以上の行番号か `end` を指定してください";
    NotAnArgument { reason: Message }
        "{reason}",
        "{reason}";
    NotATime { text: String }
        "`{text}` is not a time above 0, such as 60s or 500ms",
        "`{text}` は60sや500msのような、0より長い時間ではありません";
    ResumesNothing
        "--resume needs a file: what went to standard output is not there to go on with",
        "--resumeにはファイルが必要です。標準出力に書いた表の続きは実行できません";
    HasPart { part: Text }
        "{part} holds an unfinished table: add --resume to go on with it, or remove the file",
        "{part} に書きかけの表があります。--resumeを付けて続きを実行するか、ファイルを削除してください";
    HasTable { file: Text }
        "{file} exists: --force replaces it, --resume shows it again if it is of this sweep, -o takes another name",
        "{file} はすでにあります。置き換えるには --force、同じスイープの結果をもう一度表示するには --resume を付けるか、-oで別の名前を指定してください";
    NotAFile { file: Text }
        "{file} is not a file: '-o -' writes the table to standard output",
        "{file} はファイルではありません。標準出力に書くには '-o -' を指定してください";
    NoSweep { file: Text }
        "{file} is where the specification of the sweep goes, and has something else: move it, or choose another name with -o",
        "{file} にはスイープの仕様を書きますが、別の内容があります。移動するか、-oで別の名前を指定してください";
    OtherSweep { file: Text }
        "{file} belongs to another sweep, with another program, robot, scene, options or version of tip: use its options, or another file",
        "{file} は別のスイープの表です(プログラム、ロボット、シーン、オプション、tipのバージョンのどれかが違います)。同じオプションにするか、別のファイルを指定してください";
    DamagedPart { part: Text, line: String }
        "line {line} of {part} is damaged, or of another version of tip: restore the file, or remove it to start again",
        "{part} の{line}行目は壊れているか、別のバージョンのtipのものです。ファイルを元に戻すか、削除して最初から実行してください";
    IsLink { file: Text }
        "{file} is a link: name the file itself with -o, or write '-o -' for standard output",
        "{file} はリンクです。-oでファイル自体を指定するか、標準出力に書くには '-o -' を指定してください";
    NotATableName { file: Text }
        "{file} is not the name of a table: write a name that ends in .csv, or '-o -' for standard output",
        "{file} は表の名前ではありません。.csvで終わる名前か、標準出力を表す '-o -' を指定してください";
    NotAPart { part: Text }
        "{part}, where an unfinished table goes, is not a regular file: remove it, or choose another name with -o",
        "書きかけの表を置く {part} は通常のファイルではありません。削除するか、-oで別の名前を指定してください";
    IsLocked { part: Text }
        "another process is writing {part}: wait for its end, or choose another name with -o",
        "別のプロセスが {part} に書いています。終わるのを待つか、-oで別の名前を指定してください";
    ForeignLines { part: Text }
        "{part} has a byte order mark or CR LF line ends, so another program has saved it: restore it, or remove it to start again",
        "{part} にBOMまたはCR LFの改行があります。別のプログラムで保存されたものです。元に戻すか、削除して最初から実行してください";
    OneTable
        "a table is not compared with another file: give it alone",
        "表はほかのファイルと比べられません。表だけを指定してください";
    CaseNeedsTable
        "--case needs the table of a sweep: tip view runs.csv --case 3",
        "--caseにはスイープの表が必要です: tip view runs.csv --case 3";
    NotAVersion { text: String }
        "`{text}` is not a version of the language, such as 3.1",
        "`{text}` は3.1のような言語のバージョンではありません";
    NoSuchEdition { text: String }
        "`{text}` is no edition of the language; there are 3.1 and 3.2",
        "`{text}` という版はありません。3.1 と 3.2 があります";
    NotACrateName { name: String, near: String }
        "`{name}` cannot be the name of a crate: begin with a small letter, go on with small letters and digits, and put a single `-` or `_` between them, as in `{near}`",
        "`{name}` はクレート名にできません。`{near}` のように、英小文字で始め、英小文字と数字を使い、その間を `-` か `_` 1つでつないでください";
    CrateNameTaken { name: String, near: String }
        "`{name}` cannot be the name of a crate, since it means something else to Rust or cargo: use `{near}`",
        "`{name}` はRustやcargoで別の意味をもつため、クレート名にできません。`{near}` なら使えます";
    // Errors that clap has in English only.
    NoOption { option: String }
        "there is no option `{option}`",
        "`{option}` というオプションはありません";
    NearOption { option: String, near: String }
        "there is no option `{option}`: did you mean `{near}`?",
        "`{option}` というオプションはありません。`{near}` のことですか?";
    NoSuchValue { value: String, values: Each }
        "`{value}` is not a possible value; the values are {values}",
        "`{value}` は指定できません。指定できるのは{values}です";
    NeedsValue
        "a value is missing",
        "値を指定してください";
    NotTogether { option: String, other: String }
        "`{option}` and `{other}` cannot be used together",
        "`{option}` と `{other}` は同時に使えません";
    MissingArgument { what: String }
        "`{what}` is missing",
        "`{what}` を指定してください";
    WhichCommand { commands: Each }
        "which command? The commands are {commands}",
        "コマンドを指定してください。コマンドは{commands}です";
    WatchInput
        "--watch needs files: standard input does not change",
        "--watchにはファイルが必要です。標準入力は変更を検出できません";
    ServeInput
        "standard input cannot be saved or read again: serve a file",
        "標準入力は保存も再読み込みもできません。ファイルを指定してください";
    ServeOthers
        "anyone with this address can run, edit and save the program",
        "このアドレスを知る人は誰でも、プログラムの実行・編集・保存ができます";
    ServeRuns
        "anyone with this address can see the table and replay its runs",
        "このアドレスを知る人は誰でも、表の閲覧と実行の再生ができます";
    TableFixes { option: String }
        "a table names its program, robot and inputs itself: leave out {option}",
        "表にはプログラム、ロボット、入力が含まれています。{option} を外してください";
    IsSpecification { table: Text }
        "this is what `tip sweep` writes next to its table: give the table {table}",
        "これは `tip sweep` が表のそばに書くファイルです。表 {table} を指定してください";
    ServeDrives
        "anyone with this address and a way to this machine can drive the robot, stop it, and run other programs on it; what they send is not encrypted: use a network of your own",
        "このアドレスを知り、このマシンに接続できる人は誰でも、ロボットの操縦・停止と別のプログラムの実行ができます。通信は暗号化されません。自分のネットワークで使ってください";
    LessonOthers
        "anyone with this address and a way to this machine can watch the robot and stop it; what they send is not encrypted: use a network of your own",
        "このアドレスを知り、このマシンに接続できる人は誰でも、ロボットを見て、非常停止できます。通信は暗号化されません。自分のネットワークで使ってください";
    ServeEnds
        "press Ctrl-C to stop",
        "Ctrl-Cで終了します";
    NoPlayground
        "this command was built without the page: take a released command, or run `site/build` in a clone of the project",
        "このコマンドにはページが入っていません。公開版のコマンドを使うか、クローンで `site/build` を実行してください";
    CutTrace { file: String, cycle: String }
        "{file}: the trace has no last record and is incomplete from cycle {cycle} on: copy it again, or run the program again with --trace; 'tip view' shows what there is",
        "{file}: トレースに最後の記録がなく、周期{cycle}以降が欠けています。コピーし直すか、--traceを付けてプログラムを実行し直してください。残っている部分は 'tip view' で表示できます";
    ShowsCutTrace { file: String, cycle: String }
        "warning: {file}: the trace has no last record and is incomplete from cycle {cycle} on",
        "警告: {file}: トレースに最後の記録がなく、周期{cycle}以降が欠けています";
    TraceWithoutProgram { file: Text }
        "{file} is a trace: name the program that it is of by --program FILE.prg",
        "{file} はトレースです。--program FILE.prg で元のプログラムを指定してください";
    CannotWrite { file: Text, reason: Text }
        "cannot write {file}: {reason}",
        "{file} に書き込めません: {reason}";
    LearnMore { first: &'static str, others: Each }
        "to learn more: tip explain {first}, and likewise {others}",
        "詳しくは: tip explain {first}({others}も同様)";
    LearnMoreOf { code: &'static str }
        "to learn more: tip explain {code}",
        "詳しくは: tip explain {code}";
    SeeHelp { command: String }
        "`tip help {command}` shows examples",
        "`tip help {command}` で使用例を見られます";
}

/// An option's value can be refused with these texts.
impl std::error::Error for Using {}

tipc::message_table! {
    /// Results of checks.
    Checking;

    Sound { file: Text, steps: Steps, robot: String, warnings: Warnings }
        "{file}: {steps} for {robot}, {warnings}",
        "{file}: {robot}用、{steps}、{warnings}";
    Faulty { file: Text, errors: Errors, warnings: Warnings }
        "{file}: {errors}, {warnings}",
        "{file}: {errors}、{warnings}";
    Total { files: Files, errors: Errors, warnings: Warnings }
        "{files}: {errors}, {warnings}",
        "{files}の合計: {errors}、{warnings}";
    Watching { files: Files }
        "watching {files}; press Ctrl-C to stop",
        "{files}の変更を待っています。Ctrl-Cで終わります";
    Again { count: usize }
        "check {count}",
        "{count}回目の検査";
}

tipc::message_table! {
    /// Summaries and warnings of runs.
    Running;

    Ended { file: Text, how: How, line: u32, cycles: Cycles, time: String }
        "{file}: {how} at line {line} after {cycles}, {time} s of robot time",
        "{file}: {line}行目で{how}({cycles}、ロボットの時間で{time} s)";
    Next { line: u32, statement: Text }
        "line {line}: {statement}",
        "{line}行目: {statement}";
    Waits { line: u32, statement: Text, until: Until }
        "line {line}: {statement}, which waits until {until}",
        "{line}行目: {statement} ({until}待ちます)";
    IsWaiting { wait: Waiting }
        "{wait}",
        "{wait}";
    GoesOn { wait: Waiting }
        "{wait}; --cycles sets an end, Ctrl-C ends the run",
        "{wait}。--cyclesで終わりを指定するか、Ctrl-Cで終了できます";
    LeftOut { texts: String }
        "FOUT.LOG is full: {texts} of F_MESSAGE's texts are left out",
        "FOUT.LOGがいっぱいになりました。F_MESSAGEのテキスト{texts}件は書かれていません";
    StopsWaiting { wait: Waiting, time: String }
        "stopped after {time} s without a motion: {wait}; --cycles sets another end",
        "{time} s間動作がないため終了しました。{wait}。--cyclesで別の終わりを指定できます";
    StopsInTimeWaiting { minutes: String, wait: Waiting }
        "stopped after {minutes} minutes of the robot's time: {wait}; --cycles sets another end",
        "ロボットの時間で{minutes}分たったため終了しました。{wait}。--cyclesで別の終わりを指定できます";
    StopsInTime { minutes: String }
        "stopped after {minutes} minutes of the robot's time; --cycles sets another end",
        "ロボットの時間で{minutes}分たったため終了しました。--cyclesで別の終わりを指定できます";
    Travel { y: String, along: Along, x: String, aside: Aside, z: String, upright: Upright }
        "{y} mm {along}, {x} mm {aside}, {z} mm {upright}",
        "胴体が{along}{y} mm、{aside}{x} mm、{upright}{z} mm";
    Turn { angle: String, aside: Aside }
        "{angle} deg {aside}",
        "{aside}{angle}度";
    NoFall "none", "なし";
    Falls { count: String, time: String, line: u32 }
        "{count}, the first after {time} s at line {line}",
        "{count}回、最初は{time} sに{line}行目で";
    WouldFall { count: String, time: String, line: u32 }
        "would fall: {count}, the first after {time} s at line {line}; the body stays upright",
        "転倒のおそれ{count}回、最初は{time} sに{line}行目で(胴体は倒れていません)";
    UprightFalls { count: String, upright: String, time: String, line: u32 }
        "{count}, the first after {time} s at line {line}; the body stays upright in {upright}",
        "{count}回、最初は{time} sに{line}行目で(うち{upright}回は胴体が倒れていません)";
    Speed { value: String, along: Along }
        "{value} mm/s {along}",
        "平均で{along}{value} mm/s";
    Least { value: String, unit: &'static str, time: String, cycle: String, line: u32 }
        "{value} {unit} at least, after {time} s (cycle {cycle}, line {line})",
        "最小{value} {unit}、{time} s(周期{cycle}、{line}行目)";
    Largest { value: String, unit: &'static str, of: Text, time: String, cycle: String, line: u32 }
        "{value} {unit} at most, {of} after {time} s (cycle {cycle}, line {line})",
        "最大{value} {unit}、{of}、{time} s(周期{cycle}、{line}行目)";
    LargestOf { value: String, unit: &'static str, limit: String, of: Text, time: String, cycle: String, line: u32 }
        "{value} of {limit} {unit} at most, {of} after {time} s (cycle {cycle}, line {line})",
        "最大{value} {unit}(上限{limit})、{of}、{time} s(周期{cycle}、{line}行目)";
    Work { value: String }
        "{value} J",
        "合計{value} J";
    WorkAndCost { value: String, cost: String }
        "{value} J, cost of transport {cost}",
        "{value} J、輸送コスト{cost}";
    WaitedAt { length: String, line: u32, time: String, cycle: String }
        "{length} s at line {line}, from {time} s on (cycle {cycle})",
        "{line}行目で{length} s、{time} sから(周期{cycle})";
    WaitedAtFor { length: String, line: u32, until: Message, time: String, cycle: String }
        "{length} s at line {line} for {until}, from {time} s on (cycle {cycle})",
        "{line}行目で{until}を{length} s、{time} sから(周期{cycle})";
    WaitedIn { length: String, first: u32, last: u32, time: String, cycle: String }
        "{length} s in lines {first} to {last}, from {time} s on (cycle {cycle})",
        "{first}~{last}行目で{length} s、{time} sから(周期{cycle})";
    WaitedInFor { length: String, first: u32, last: u32, until: Message, time: String, cycle: String }
        "{length} s in lines {first} to {last} for {until}, from {time} s on (cycle {cycle})",
        "{first}~{last}行目で{until}を{length} s、{time} sから(周期{cycle})";
    AtMost { value: String }
        "{value} mm at most",
        "最大{value} mm";
    Collisions { cycles: Cycles, by: String, one: Part, other: Part, time: String, line: u32 }
        "links overlap in {cycles}, {one} and {other} by {by} mm after {time} s at line {line}",
        "{cycles}でリンクが重なり、{one}と{other}は{time} sに{line}行目で{by} mm";
    ZmpOutside { cycles: Cycles, by: String }
        "the zero moment point outside the feet in {cycles}, by {by} mm at most",
        "{cycles}でZMPが支持多角形の外、最大{by} mm";
    NoGrip { cycles: Cycles }
        "the feet would slip in {cycles}",
        "{cycles}で足が滑るはず";
    Crosses { cycles: Cycles }
        "legs or body in the floor or in a block in {cycles}",
        "{cycles}で脚か胴体が床や障害物の中";
    Hurries { cycles: Cycles }
        "commanded to turn faster than its servo can in {cycles}",
        "{cycles}でサーボの最高速度を超える指令";
    Strays { cycles: Cycles, by: String }
        "a foot off its path in {cycles}, by {by} mm at most",
        "{cycles}で足先が経路の外、最大{by} mm";
    MassMatters
        "dynamics matter here: --plant dynamic",
        "ここでは動力学が効きます: --plant dynamic";
    Lift { object: u32, now: String, most: String }
        "object {object}: {now} mm, {most} mm at most",
        "物体{object}: {now} mm、最大{most} mm";
    Force { finger: u32, now: String, most: String }
        "F{finger}: {now} N, {most} N at most",
        "F{finger}: {now} N、最大{most} N";
    BusTime { servos: usize, mean: String, period: f64, share: String, longest: String }
        "{servos} servos, {mean} ms of {period} ms in each cycle ({share} %), {longest} ms at most",
        "サーボ{servos}台、1周期{period} msのうち平均{mean} ms({share} %)、最大{longest} ms";
    BusOverrun { servos: usize, mean: String, period: f64, longest: String }
        "{servos} servos, {mean} ms in each cycle, longer than its {period} ms: cycles are late; {longest} ms at most",
        "サーボ{servos}台、1周期に平均{mean} msかかり、制御周期{period} msを超えます(周期遅れ)。最大{longest} ms";
    BusAnswers { missing: String, asked: String, implausible: String, slowed: String, clipped: String }
        "{missing} of {asked} missing, {implausible} not believed; commands: {slowed} slowed down, {clipped} outside of limits",
        "{asked}回中、欠落{missing}回、不採用{implausible}回。指令: 減速{slowed}回、範囲外{clipped}回";
    CycleJitter { p50: usize, p99: usize, p999: usize, worst: String }
        "cycles start late by {p50}, {p99}, {p999} µs (p50, p99, p99.9), {worst} µs at most",
        "周期開始の遅れは{p50}、{p99}、{p999} µs(p50、p99、p99.9)、最大{worst} µs";
    InTime
        "no cycle late",
        "遅れた周期なし";
    Late { late: String, all: String, worst: String }
        "{late} of {all} cycles late, {worst} ms at most",
        "{all}周期のうち{late}周期が遅れ、最大{worst} ms";
    Keys
        "keys: RETURN emergency stop, ESC halt, Ctrl-C end; others reach the program",
        "キー: RETURNは非常停止、ESCは停止要求、Ctrl-Cは終了。ほかのキーはプログラムに渡ります";
    Sticks
        "sticks: W S or the arrows up and down are VR1, A D or left and right are VR2, Q E are VR3; they spring back",
        "スティック: W S(上下の矢印)がVR1、A D(左右の矢印)がVR2、Q EがVR3です。離すと中央に戻ります";
    NoKeys
        "keys: none, standard input is not a terminal; --keys and --events press them",
        "キー: 標準入力が端末ではないため使えません。--keysと--eventsで押せます";
    Walks { y: String, along: Along, margin: String, falls: String }
        "{y} mm {along}, margin {margin} mm, falls {falls}",
        "{along}{y} mm、余裕{margin} mm、転倒{falls}回";
    Lifts { value: String }
        "lift {value} mm",
        "持上{value} mm";
    Pushes { forces: String }
        "force {forces} N",
        "力{forces} N";
    Fell { time: String, cycle: String }
        "the robot fell after {time} s, in cycle {cycle}",
        "ロボットが{time} s、周期{cycle}で転倒しました";
    WouldHaveFallen { time: String, cycle: String }
        "the robot would fall after {time} s, in cycle {cycle}: its feet do not hold its centre of mass",
        "ロボットは{time} s、周期{cycle}で転倒するおそれがあります: 足が重心を支えていません";
    Collided { one: Part, other: Part, by: String, time: String, cycle: String }
        "{one} and {other} overlap by {by} mm after {time} s, in cycle {cycle}",
        "{one}と{other}が{time} s、周期{cycle}で{by} mm重なりました";
    WaitForEachOther { waits: Text, time: String, cycle: String }
        "threads wait for each other after {time} s, from cycle {cycle} on: {waits}; only STOP_THREAD ends that",
        "{time} s、周期{cycle}からスレッドが互いに待ち合っています: {waits}。STOP_THREADでしか終わりません";
    InLine { thread: String, line: u32 }
        "{thread} in line {line}",
        "{line}行目の{thread}";
    Unsupported { time: String, cycle: String }
        "the robot lost its support after {time} s, in cycle {cycle}",
        "ロボットが{time} s、周期{cycle}で支えを失いました";
}

tipc::message_table! {
    /// Comparisons of two runs.
    Comparing;

    Difference "difference", "差";
    BetterByMore "better (more is better)", "良い(大きいほど良い)";
    BetterByLess "better (less is better)", "良い(小さいほど良い)";
    WorseByMore "worse (less is better)", "悪い(小さいほど良い)";
    WorseByLess "worse (more is better)", "悪い(大きいほど良い)";
    Fails { condition: String }
        "the second run has {condition}",
        "2番目の実行は条件 {condition} を満たします";
}

tipc::message_table! {
    /// Results of sweeps.
    Sweeping;

    Made { file: Text, runs: String, made: String, time: String, rate: String }
        "{file}: {runs} runs, {made} of them now in {time} s, {rate} a second",
        "{file}: {runs}回の実行(うち今回{made}回、{time} s、毎秒{rate}回)";
    Share { count: String, all: String, share: String }
        "{count} of {all}, {share} %",
        "{all}回中{count}回、{share}%";
    Idle { axis: String }
        "warning: {axis} changes nothing while the robot walks without mass: --plant dynamic",
        "警告: 質量のないプラントで歩く間は、{axis} を変えても結果は変わりません: --plant dynamic";
    CutOff { count: String, all: String, time: String }
        "{count} of {all}, after {time} s or --cycles; --until sets another limit",
        "{all}回中{count}回({time} sまたは--cycles)。--untilで上限を変えられます";
    Outstanding { result: Text, case: String, values: Text }
        "{result}: case {case}{values}",
        "{result}: ケース{case}{values}";
    NoneRanked
        "no run without a fall or an emergency stop meets the conditions",
        "転倒も非常停止もせず条件を満たす実行はありません";
    OnFront { count: String, all: String }
        "{count} of {all} runs are on the Pareto front",
        "{all}回中{count}回がパレート最適です";
    Walked { speed: String }
        "{speed} mm/s forward",
        "前へ{speed} mm/s";
    Lifted { length: String }
        "object 1 lifted by {length} mm",
        "物体1を{length} mm持ち上げ";
    FellAfter { time: String }
        "a fall after {time} s",
        "{time} sで転倒";
    StoppedAfter { time: String }
        "an emergency stop after {time} s",
        "{time} sで非常停止";
    Progress { at: Text, all: Text, fell: Text, rate: Text, left: Text }
        "{at} of {all} runs, {fell} fell, {rate}, {left} left",
        "{all}回中{at}回、転倒{fell}回、{rate}、残り{left}";
    Kept { runs: String, all: String, part: Text }
        "{runs} of {all} runs are in {part}; the same command with --resume goes on",
        "{part} に{all}回中{runs}回の結果があります。同じコマンドに--resumeを付けると続きを実行します";
    NoSpecification { file: Text, error: Text }
        "{file}, which `tip sweep` writes next to its table, cannot be read: {error}",
        "`tip sweep` が表のそばに書く {file} を読めません: {error}";
    Page { file: Text, runs: String, size: String }
        "{file}: {runs} runs, {size} kB",
        "{file}: {runs}回の実行、{size} kB";
    NoTable { file: Text }
        "{file} is not the table of its specification: its first line has other columns, or is cut off",
        "{file} は仕様に対応する表ではありません。先頭の行の列が違うか、行が途中で切れています";
    OtherRow { file: Text, line: String, specification: Text }
        "line {line} of {file} is not a row of the sweep in {specification}: it was changed, cut off or doubled, or is of another sweep or version of tip; run the sweep again",
        "{file} の{line}行目は {specification} のスイープの行ではありません。変更、途中での切断、重複があるか、別のスイープまたは別のバージョンのtipのものです。スイープを実行し直してください";
}

tipc::message_table! {
    /// Severities.
    Weight;

    Error "error", "エラー";
    Warning "warning", "警告";
}

tipc::message_table! {
    /// Endings of runs.
    How;

    By { word: Keyword } "{word}", "{word}で終了";
    Emergency "emergency stop", "非常停止";
    Interrupted "interrupted", "中断";
    Limit "--cycles used up", "--cyclesの周期数に到達";
}

tipc::message_table! {
    /// Labels of the lines of a summary.
    Figure;

    Next "next", "次";
    Waits "waits", "待機";
    Travel "travel", "移動";
    Turn "turn", "旋回";
    Falls "falls", "転倒";
    Slip "slip", "滑り";
    Margin "margin", "余裕";
    Speed "speed", "速度";
    Rate "rate", "角速度";
    Torque "torque", "トルク";
    Energy "energy", "仕事";
    Waited "waited", "待ち";
    Gap "gap", "間隔";
    Zmp "zmp", "動余裕";
    Grip "grip", "摩擦";
    Contact "contact", "干渉";
    Joint "joint", "関節";
    Path "path", "経路";
    Note "note", "注意";
    Lift "lift", "持上";
    Force "force", "力";
    Pace "pace", "周期";
    Bus "bus", "バス";
    Answers "answers", "応答";
    Jitter "jitter", "ゆらぎ";
    Stops "stops", "停止";
    CutOff "cut off", "打切";
    Best "best", "最良";
    Worst "worst", "最悪";
}

tipc::message_table! {
    /// Directions along the front of a robot.
    Along;

    Forward "forward", "前へ";
    Backward "backward", "後ろへ";
}

tipc::message_table! {
    /// Directions to the side of a robot.
    Aside;

    Right "to the right", "右へ";
    Left "to the left", "左へ";
}

tipc::message_table! {
    /// Vertical directions.
    Upright;

    Up "up", "上へ";
    Down "down", "下へ";
}

tipc::message_table! {
    /// Conditions that statements wait for.
    Until;

    Time "the time is over", "時間がたつまで";
    InPosition { target: Target } "{target} is within the JUST tolerance", "{target}がJUSTの許容範囲に入るまで";
    Near { target: Target } "{target} is within the NEAR tolerance", "{target}がNEARの許容範囲に入るまで";
    Key "a key is pressed", "キーが押されるまで";
    Motion "its motion is done", "動作が終わるまで";
    Touch "it detects a contact", "接触を感じるまで";
    Native "its native code is done", "ネイティブコードが終わるまで";
    Thread { name: Text } "thread {name} ends", "スレッド{name}が終わるまで";
}

tipc::message_table! {
    /// Waits with line, condition and duration.
    Waiting;

    Line { line: u32, what: Awaited, since: String, time: String }
        "line {line} has been waiting for {what} for {time} s, since {since} s",
        "{line}行目が{what}を待っています({since} sから{time} s間)";
    Loop { first: u32, last: u32, what: Awaited, since: String, time: String }
        "lines {first} to {last} have been waiting for {what} for {time} s, since {since} s",
        "{first}~{last}行目が{what}を待って繰り返しています({since} sから{time} s間)";
    Still { line: u32, since: String, time: String }
        "line {line} has let time pass without a motion for {time} s, since {since} s",
        "{line}行目が動作のないまま時間の経過を待っています({since} sから{time} s間)";
    Endless { first: u32, last: u32, since: String, time: String }
        "lines {first} to {last} have repeated without a motion for {time} s, since {since} s",
        "{first}~{last}行目が動作のないまま繰り返しています({since} sから{time} s間)";
}

tipc::message_table! {
    /// Reasons of emergency stops.
    Stopping;

    // Faults of programs.
    NoValue { name: SmolStr }
        "`{name}` has no value yet",
        "`{name}` にまだ値がありません";
    AssignFirst
        "assign it before this statement runs",
        "この文を実行する前に代入してください";
    NoResult
        "a value is out of range, or the result is not a finite number",
        "値が範囲外か、計算結果が有限の数になりません";
    NoCall
        "this returns from a subroutine that was not called",
        "呼び出されていないのに戻ろうとしています";
    OtherMode
        "the target is not in the control mode that this command needs",
        "対象の制御モードがこのコマンドに合いません";
    Running { name: SmolStr, line: u32 }
        "thread {name} runs already: it is at line {line}",
        "スレッド{name}はすでに実行中です({line}行目)";
    WaitFirst { name: SmolStr }
        "put WAIT_THREAD {name}: before it, or STOP_THREAD {name}:",
        "手前にWAIT_THREAD {name}:かSTOP_THREAD {name}:を入れてください";
    WaitsForItself
        "a thread cannot wait for its own end",
        "スレッドは自分自身の終了を待てません";
    Locked { joint: Target, lines: List }
        "{joint} is locked by LOCK in line {lines}",
        "{joint}は{lines}行目のLOCKでロックされています";
    LockedBy { joint: Target, lines: List, name: SmolStr }
        "{joint} is locked by LOCK in line {lines}, in thread {name}",
        "{joint}はスレッド{name}の{lines}行目のLOCKでロックされています";
    Unlock { joint: Target }
        "put UNLOCK {joint} before it: a lock stays when its thread ends or is stopped",
        "手前にUNLOCK {joint}を入れてください。ロックはスレッドが終了・停止しても残ります";
    Occupied { word: &'static str, line: u32 }
        "the main program is executing {word} in line {line}; only one such command can run at a time",
        "メインプログラムが{line}行目の{word}を実行中です。この種のコマンドは同時に一つしか実行できません";
    OccupiedBy { word: &'static str, line: u32, name: SmolStr }
        "thread {name} is executing {word} in line {line}; only one such command can run at a time",
        "スレッド{name}が{line}行目の{word}を実行中です。この種のコマンドは同時に一つしか実行できません";
    TooDeep
        "more than ten calls are open at once",
        "呼び出しの入れ子が10段を超えました";
    LeaveSubroutines
        "leave each SUBROUTINE with RETURN or SUBEND, and let none call itself",
        "SUBROUTINEからはRETURNかSUBENDで戻り、自分自身を呼ばないでください";
    NoStep
        "there is no such step",
        "そのようなステップはありません";

    // Faults of robots.
    AtLimit { joint: Target, angle: f64, min: f64, max: f64 }
        "{joint} is at {angle} deg and cannot move further: its limits are {min} and {max} deg",
        "{joint}は現在{angle} degで、これ以上動けません。動作範囲は{min}から{max} degです";
    OutOfReach { target: Target }
        "{target} cannot reach its target, or a point on the way there",
        "{target}が目標か、その途中の位置に届きません";
    OnTheWay { target: Target, joint: Target, by: f64, limit: f64 }
        "{target} leaves its reach on the way to its target: {joint} is {by} deg from its limit of {limit} deg",
        "{target}が目標へ向かう途中で可動範囲を外れます。{joint}は限界の{limit} degまで{by} degです";
    JointsAre { joints: List }
        "the joints and their limits in deg: {joints}",
        "関節の角度と動作範囲(deg): {joints}";
    Nonsense { sensor: SmolStr }
        "the sensor of {sensor} reads invalid values: check the sensor and its cable",
        "{sensor}のセンサの値が異常です。センサと配線を確かめてください";
    Broken { what: Text }
        "the hardware of the robot failed: {what}",
        "ロボットのハードウェアの異常です: {what}";
    NotStopped { what: Text }
        "the robot could not be stopped ({what}): switch its power off",
        "ロボットを停止できませんでした({what})。電源を切ってください";
    Stalled
        "emergency stop: no control cycle for 3 s; does nobody read the output of this command?",
        "非常停止: 制御周期が3秒間実行されませんでした。このコマンドの出力が読まれているか確かめてください";
    KeyPressed
        "RETURN, the emergency stop, was pressed",
        "RETURNキー(非常停止)が押されました";
    PagePressed
        "the emergency stop was pressed on the page",
        "ページで非常停止が押されました";

    // The time of the stop, and the values.
    Moment { step: u32, cycle: SmolStr, time: SmolStr }
        "step {step}, cycle {cycle}, {time} s",
        "ステップ{step}、サイクル{cycle}、{time} s";
    Values { values: List } "{values}", "{values}";
}

tipc::message_table! {
    /// Results of making a crate.
    Making;

    Made { folder: Text, robot: String }
        "made {folder}, a crate for {robot}:",
        "{robot}用のクレート {folder} を作成しました:";
    DependsOnCheckout { folder: Text }
        "Cargo.toml depends on the crates of the checkout `{folder}`",
        "Cargo.tomlの依存先はチェックアウト `{folder}` のクレートです";
    DependsOnPublished { version: String }
        "Cargo.toml depends on the published crates of version {version}",
        "Cargo.tomlの依存先は公開されているバージョン{version}のクレートです";
    OwnDrives { robot: String }
        "there is no bus of servos for {robot}: fill in src/hardware.rs for its drives",
        "{robot}用のサーボのバスはありません。駆動部に合わせてsrc/hardware.rsを実装してください";
    Next
        "next:",
        "次のコマンド:";
    Walks { gait: String, ahead: f64, side: f64, turn: f64 }
        "the motion was tried: a {gait}; with mass the simulated robot walks {ahead} mm/s ahead, {side} mm/s sideways, turns {turn} deg/s, and does not fall",
        "動作を試しました: 歩容は {gait} です。質量のあるシミュレーションで、前進{ahead} mm/s、横歩き{side} mm/s、旋回{turn} deg/sで、倒れません";
    FallsOnSlope
        "on a slope of 5 deg it falls or slips: the program's head has the figures",
        "5度の坂では倒れるか滑ります。数値はプログラムの先頭にあります";
    GaitNeedsEdition
        "a gait needs edition 3.2: leave `--edition` out",
        "歩容には版3.2が必要です。`--edition` を付けないでください";
    Steer
        "sticks VR1 (ahead), VR2 (turn) and VR3 (sideways) steer it; without sticks the keys W S A D Q E do",
        "スティックVR1(前後)、VR2(旋回)、VR3(左右)で操縦します。スティックがなければW S A D Q Eキーを使います";
    NoGait { falls: u32 }
        "no gait was found; the motion bends one leg after the other instead, and the simulated robot falls {falls} times:",
        "歩容が見つからないので、脚を1本ずつ曲げる動作にしました。シミュレーションで倒れる回数は{falls}です。理由:";
    NoSuchGait { robot: String, gait: String, reason: Other }
        "{robot} cannot walk by `--gait {gait}`: {reason}",
        "{robot}は `--gait {gait}` では歩けません: {reason}";
    BoltedDown
        "it has no body: a description needs [body] to walk",
        "胴体がありません。歩くには記述に[body]が必要です";
    TooFewLegs
        "to lift one leg and stand on the others, a robot needs four legs",
        "1本を上げて立つには脚が4本必要です";
    TrotNeedsFour
        "a trot swings two diagonal pairs, and needs four legs exactly",
        "トロットは対角の2脚を交互に振るので、脚がちょうど4本必要です";
    TripodNeedsSix
        "half of the feet must hold the robot, which needs six legs",
        "半数の足で立つので、脚が6本必要です";
    NoBalance { feet: String, margin: f64 }
        "with {feet} in the air the centre of mass is {margin} mm inside the other feet, and 15 mm are needed; a crawl leans over them",
        "{feet}を上げたとき、重心は他の足の内側{margin} mmにあります。15 mm必要です。crawlなら胴体を他の足の上へ寄せます";
    Slips
        "with mass its feet slip, or the body touches the floor: it gets much less far than its feet go",
        "質量があると足が滑るか胴体が床に触れ、足の動きほど進みません";
    OutOfReach
        "feet do not reach their positions in the gait: set another `initial`, for example with `tip robot import --stand`, or wider limits",
        "足先が歩容の位置に届きません。`tip robot import --stand` などで `initial` を変えるか、`limits` を広げてください";
    TooSlow { speed: f64 }
        "servos that turn {speed} deg/s are too slow for it: look at `speed` of the drives, or choose another gait",
        "{speed} deg/sのサーボでは遅すぎます。`[[drive]]`の`speed`を確かめるか、別の歩容を選んでください";
    Falls
        "the simulated robot falls at every speed that was tried: set another `initial`, for example with `tip robot import --stand`",
        "試したどの速さでも、シミュレーションのロボットが倒れます。`tip robot import --stand` などで `initial` を変えてください";
    FolderTaken { folder: Text }
        "`{folder}` already exists: choose another name, or move it away",
        "`{folder}` はすでにあります。別の名前を指定するか、移動してください";
    NoFolder { folder: Text }
        "there is no folder `{folder}`: create it with `mkdir -p {folder}`",
        "フォルダー `{folder}` がありません。`mkdir -p {folder}` で作成できます";
    NotMade { folder: Text, error: Text, name: String }
        "`{folder}` cannot be made: {error}; choose a folder that you may write to, as in `tip new ~/{name}`",
        "`{folder}` を作成できません: {error}。`tip new ~/{name}` のように、書き込めるフォルダーを指定してください";
    NotForManifest { folder: Text }
        "`{folder}` is not UTF-8, or has a control character, and cannot be written in a Cargo.toml: rename the folder of the checkout",
        "`{folder}` はUTF-8でないか制御文字を含むため、Cargo.tomlに書けません。チェックアウトのフォルダー名を変えてください";
    NotACheckout { folder: Text, version: String }
        "`{folder}` is not a checkout of this project in version {version}: name the folder that holds tip-runtime and tip-macros",
        "`{folder}` はこのプロジェクト(バージョン{version})のチェックアウトではありません。tip-runtimeとtip-macrosのあるフォルダーを指定してください";
}

tipc::message_table! {
    /// The text of the lint about the crate around a program.
    Linting;

    CompiledForAnother { project: Text, given: String, source: Text, other: String }
        "{project} says {given}, {source} compiles it for {other}",
        "{project}では{given}、{source}では{other}になっています";
    SayOneRobot { project: Text }
        "let both say the same: the macro or build script, and {project}",
        "マクロまたはビルドスクリプトと{project}を一致させてください";
}

tipc::message_table! {
    /// Texts of the terminal debugger; those that every debugger shows are in `tip-sim`.
    DebugText;

    // Titles.
    Calls
        "Calls",
        "呼び出し";
    Locked
        "locked",
        "ロック中";
    Timers
        "timers",
        "タイマー";
    Side
        "Side",
        "側面図";
    Said
        "Messages",
        "メッセージ";
    MainProgram
        "(program)",
        "(本体)";

    // States.
    Stepped
        "paused",
        "停止中";
    There
        "arrived",
        "到達しました";
    AtBreakpoint
        "breakpoint",
        "ブレークポイント";
    Assigned { line: u32 }
        "assigned by line {line}",
        "{line}行目で代入";
    AssignedByEvent
        "assigned by an event",
        "イベントによる代入";
    Fell
        "the robot falls",
        "ロボットが転倒しました";
    Interrupted
        "interrupted",
        "中断しました";
    Changed
        "changed",
        "変更しました";
    Running
        "running; Esc interrupts",
        "実行中(Escで中断)";
    Searching { percent: u32 }
        "searching backwards, {percent} %; Esc interrupts",
        "逆方向に検索中 {percent}%(Escで中断)";

    // Questions.
    AskEvent
        "event (key F, VR1=8, N = 5)",
        "イベント(key F、VR1=8、N = 5)";
    AskExpression
        "expression",
        "式";
    AskWatch
        "variable to watch (empty: none)",
        "監視する変数(空欄で解除)";
    AskWho
        "variable, to go back to its last assignment",
        "変数(最後に代入した箇所へ戻ります)";
    AskCycle
        "cycle",
        "サイクル";
    AskCondition { line: u32 }
        "condition of the breakpoint on line {line} (empty: none)",
        "{line}行目のブレークポイントの条件(空欄で無条件)";
    AskPasses
        "passes that stop: 5, >= 5, % 5 (empty: each)",
        "停止する通過回数: 5、>= 5、% 5(空欄で毎回)";
    AskName
        "command, label or routine to stop before; enter it again to remove it",
        "直前で停止するコマンド、ラベル、ルーチン(再入力で解除)";
    AskDiscard { count: usize }
        "{count} cycles that have been run after this one would be discarded: y or n",
        "これより後の{count}サイクルの実行結果は破棄されます。よろしいですか(y/n)";

    // Answers.
    Comes { text: Text, value: Text }
        "{text} = {value}",
        "{text} = {value}";
    Watches { name: Text }
        "watching {name}",
        "{name}を監視します";
    StopsBefore { name: Text }
        "stops before each {name}",
        "{name}の直前で停止します";
    StopsNoMore { name: Text }
        "no longer stops before {name}",
        "{name}の直前では停止しません";
    NotANumber { text: Text }
        "`{text}` is not a cycle",
        "`{text}` はサイクル番号ではありません";
    NeitherEventNorAssignment { text: Text }
        "`{text}` is not an event, such as `key F`, `VR1=8`, `halt` or `N = 5`",
        "`{text}` はイベントではありません。`key F`、`VR1=8`、`halt`、`N = 5` のように書いてください";

    // Help.
    HelpMoves
        "r run, n over, s into, o out, c cycle, l to line, g to cycle, t thread, CAPITALS: back",
        "r:実行 n:次へ s:中へ o:外へ c:1サイクル l:行まで g:サイクル指定 t:スレッド 大文字:逆方向";
    HelpOthers
        "b break, B when, f name, w watch, W last set, i event, e value, q, ? explains",
        "b:ブレーク B:条件 f:名前 w:監視 W:代入元 i:イベント e:式 q:終了 ?:説明";
    Keys
        "Keys (any key closes this)",
        "キー(どのキーでも閉じます)";
    KeysForward
        "r: run to the next stop; R: back to the stop before",
        "r: 次の停止まで実行、R: 前の停止まで戻る";
    KeysOver
        "n: next step, over routines; N: the same backwards",
        "n: 次のステップ(ルーチンは越える)、N: その逆";
    KeysInto
        "s: next step, into routines; S: the same backwards",
        "s: 次のステップ(ルーチンに入る)、S: その逆";
    KeysOut
        "o: out of the routine; O: back to where it was called",
        "o: ルーチンを出る、O: 呼び出し元まで戻る";
    KeysCycle
        "c: one control cycle; C: the same backwards",
        "c: 1サイクル、C: その逆";
    KeysThread
        "t: look at the next thread",
        "t: 次のスレッドを見る";
    KeysLine
        "l: to the line of the cursor; L: back to it",
        "l: カーソルの行まで、L: その行まで戻る";
    KeysGo
        "g: to a cycle by its number; Esc: interrupt a run",
        "g: サイクル番号へ、Esc: 実行を中断";
    KeysBreak
        "b: breakpoint on the line; B: with a condition, or for some passes",
        "b: 行にブレークポイント、B: 条件や通過回数を付ける";
    KeysName
        "f: stop before a command, label or routine of a name",
        "f: この名前のコマンド、ラベル、ルーチンの直前で停止";
    KeysWatch
        "w: watch a variable: a run stops where it is set, and the list begins with it",
        "w: 変数を監視: 代入された箇所で停止し、一覧の先頭に表示";
    KeysLastSet
        "W: back to the last assignment of a variable",
        "W: 変数に最後に代入した箇所へ戻る";
    KeysChange
        "i: event: key F, VR1=8, halt, or an assignment such as N = 5",
        "i: イベント: key F、VR1=8、halt、または N = 5 のような代入";
    KeysValue
        "e: value of an expression; Tab: more variables",
        "e: 式の値、Tab: ほかの変数";
    KeysCursor
        "↑ ↓: move the cursor; `.`: to the running line; q: quit",
        "↑ ↓: カーソルを移動、`.`: 実行中の行へ、q: 終了";
}

tipc::message_table! {
    /// Messages of `tip drives` and of runs on a real robot.
    Driving;

    LateFrom "late", "遅れ";
    CycleShare "share", "割合";
    CycleCount "cycles", "周期数";
    JitterFigures { p50: usize, p99: usize, p999: usize, worst: String, missed: String, cycles: String }
        "half of the cycles start at most {p50} µs late, 99 % {p99} µs, 99.9 % {p999} µs, all {worst} µs; {missed} of {cycles} missed",
        "遅れは周期の半数で{p50} µs以下、99%で{p99} µs、99.9%で{p999} µs、最大{worst} µs。{cycles}周期のうち{missed}周期は間に合わず";
    KeepsPeriod { period: String, share: String }
        "a period of {period} ms is kept: cycles start late by {share} % of it at most",
        "周期{period} msは守られます: 遅れは最大で周期の{share}%です";
    KeepsPeriodUnevenly { period: String, share: String }
        "a period of {period} ms is kept unevenly: a cycle starts late by {share} % of it; try --fifo, a longer period or a less busy machine",
        "周期{period} msは守られますが不均一です: 遅れが周期の{share}%に達します。--fifo、長い周期、負荷の低いマシンを試してください";
    MissesPeriod { period: String, missed: String, cycles: String }
        "a period of {period} ms is not kept: {missed} of {cycles} cycles are missed; try --fifo, a longer period or a less busy machine",
        "周期{period} msは守られません: {cycles}周期のうち{missed}周期が間に合いません。--fifo、長い周期、負荷の低いマシンを試してください";
    NoCycles
        "no cycle was measured",
        "1周期も測定できませんでした";
    NoBus { file: Text }
        "{file} has no [bus]: docs/drives.md shows how to describe the servos",
        "{file}に[bus]がありません。サーボの書き方はdocs/drives.mdにあります";
    NotOnBus { file: Text, table: &'static str }
        "{file}: [{table}] cannot be on a bus: its servos measure and move joints only, so that the robot would stop in its first cycle. Run it without --hardware, leave [{table}] out of the file, or implement `Hardware` (docs/drives.md)",
        "{file}: [{table}]はバス上のサーボでは実現できません(サーボは関節の計測と駆動だけで、最初の周期で停止します)。--hardwareなしで実行するか、ファイルから[{table}]を除くか、`Hardware` を実装してください(docs/drives.md)";
    NoPort { file: Text }
        "which port? Give --port /dev/ttyUSB0, or `port` under [bus] of {file}",
        "ポートを指定してください(--port /dev/ttyUSB0、または{file}の[bus]の `port`)";
    CannotOpen { port: Text, error: Text }
        "cannot open {port}: {error}. Is it plugged in, used by another program, or yours to open (group dialout)?",
        "{port}を開けません: {error}。接続、他のプログラムによる使用、権限(dialoutグループ)を確かめてください";
    PortInUse { port: Text, process: Text, id: u32 }
        "{port} is in use by {process} (process {id}): end it first, because two masters on one bus move a robot to angles of neither",
        "{port}は{process}(プロセス{id})が使用中です。先に終了してください。一つのバスに二つのマスターは使えません";
    PortTaken { port: Text }
        "{port} is in use by another program: end it first, because two masters on one bus move a robot to angles of neither",
        "{port}は他のプログラムが使用中です。先に終了してください。一つのバスに二つのマスターは使えません";
    NoSimulatedPort
        "'simulated' needs the servos of a robot.toml: start `tip drives simulate robot.toml`, and give the port that it prints",
        "'simulated' にはrobot.tomlのサーボが必要です。`tip drives simulate robot.toml` を起動し、表示されるポートを指定してください";
    NotSimulated { text: String }
        "`{text}` is not a list of faults: write faults=0.01 (or corrupt, drop, duplicate, delay, truncate) and unplug=ID@S (or reset, overheat, block, sag, turn), separated by commas",
        "`{text}` は故障の並びではありません。faults=0.01(または corrupt、drop、duplicate、delay、truncate)と unplug=ID@S(または reset、overheat、block、sag、turn)をコンマで区切ってください";
    NoServoToFail { text: String, id: u32 }
        "`{text}` can never happen: the robot has no servo {id}",
        "`{text}` は起こりません。サーボ{id}はありません";
    WereStiff { joints: List }
        "the torque of these servos was on before this run, and stays on: {joints}. They hold; support the robot before you switch their power off",
        "次のサーボはこの実行の前からトルクが入っており、入ったままです: {joints}。電源を切る前にロボットを支えてください";
    NeedsYes
        "the robot is about to move, and no one can press a key: give --yes if that is safe",
        "ロボットが動きますが、キーを押す人がいません。安全なら--yesを付けてください";
    OnlyOnTerminal
        "this needs a terminal with a keyboard",
        "キーボードのある端末で実行してください";
    Connected { servos: usize, family: &'static str, port: Text, delay: u32 }
        "{servos} servos of {family} on {port}; they answer after {delay} µs",
        "{port}に{family}のサーボが{servos}台あります。応答遅れは{delay} µsです";
    Adapter { time: u32 }
        "the adapter collects answers for {time} ms: set its latency_timer to 1 (docs/drives.md), or cycles are late",
        "アダプタが応答を{time} msためます。latency_timerを1にしないと周期に遅れます(docs/drives.md)";
    Start { joint: String, angle: String, speed: f64 }
        "to the initial posture: {joint} has the longest way, {angle} deg, at {speed} deg/s at most",
        "初期姿勢へ移動します。最も大きく動く関節は{joint}({angle}度)、速さは{speed}度/s以下です";
    ServeStarts
        "keep clear; the button of the page, held for a second, or RETURN here starts the robot; RETURN is the emergency stop then",
        "ロボットから離れてください。ページのボタンを1秒間押し続けるか、ここでRETURNを押すと開始します。動作中のRETURNは非常停止です";
    PressReturn
        "keep clear; RETURN starts, Ctrl-C ends",
        "ロボットから離れてください。RETURNで開始、Ctrl-Cで終了します";
    StillStiff { joints: List }
        "still stiff, although they were to relax: {joints}. Switch their power off",
        "脱力しなかったサーボがあります: {joints}。電源を切ってください";
    PerhapsStiff { joints: List }
        "perhaps still stiff, because they did not confirm that they relaxed: {joints}. Switch their power off",
        "脱力を確認できないサーボがあります: {joints}。電源を切ってください";
    WithoutTorque { joints: List }
        "without torque, although they were to hold: {joints}",
        "保持するはずのサーボにトルクがありません: {joints}";
    PerhapsLimp { joints: List }
        "perhaps without torque or not where they are to be, because they did not confirm that they hold: {joints}",
        "保持を確認できないサーボがあります: {joints}";
    NoSuchJoint { joint: String }
        "the robot has no joint {joint}",
        "関節{joint}はありません";
    Found { servos: usize }
        "{servos} servos found",
        "サーボが{servos}台見つかりました";
    Scans { family: &'static str, last: u32 }
        "asking {family}, identities 0 to {last}",
        "{family}のID 0から{last}を調べています";
    NewModel { id: u32, number: u32 }
        "servo {id} reports the model number {number}, which no model here has: its scales are not known",
        "サーボ{id}の型番{number}は登録されていないため、換算係数が分かりません";
    OtherFamily { id: u32, model: &'static str, key: &'static str }
        "servo {id} is of another family: it reports to be {model} (--family {key})",
        "サーボ{id}は別の系列で、{model}です(--family {key})";
    Doubtful { id: u32, family: &'static str }
        "servo {id} answers as {family} would, but with values that such a servo cannot have: is it of another family?",
        "サーボ{id}の応答は{family}の形式ですが、値がありえません。別の系列ではありませんか?";
    AnswersOtherwise { id: u32, family: &'static str, other: &'static str, key: &'static str }
        "servo {id} does not answer as {family} does, but as {other}: give --family {key}",
        "サーボ{id}は{family}としては応答せず、{other}として応答します。--family {key} を指定してください";
    NoServo { id: u32, family: &'static str, others: String }
        "no servo {id} of {family} answers: look at power, wiring and --baud (new X servos have 57600, LX always 115200); nor does one answer as --family {others} at this speed",
        "{family}のサーボ{id}が応答しません。電源、配線、--baudを確かめてください(新しいXは57600、LXは常に115200)。この速度では --family {others} の応答もありません";
    NoneOfFamily { family: &'static str, others: String }
        "no servo of {family} answers: look at power, wiring and --baud (new X servos have 57600, LX always 115200), or try the other families, {others}: without --family all of them are asked",
        "応答する{family}のサーボがありません。電源、配線、--baudを確かめる(新しいXは57600、LXは常に115200)か、他の系列({others})を試してください。--familyを省くとすべて試します";
    NothingFound
        "no servo answers, of any family: look at power, wiring and --baud (new X servos have 57600, LX always 115200)",
        "どの系列のサーボも応答しません。電源、配線、--baudを確かめてください(新しいXは57600、LXは常に115200)";
    Renamed { id: u32, to: u32 }
        "servo {id} is servo {to} now",
        "サーボ{id}のIDを{to}にしました";
    OwnTool { id: u32, to: u32 }
        "a moteus gets its identity from its maker's tool: `moteus_tool --target {id} --console`, then `conf set id.id {to}` and `conf write`",
        "moteusのIDは製造元のツールで設定します。`moteus_tool --target {id} --console` で `conf set id.id {to}` と `conf write` を実行してください";
    IdTaken { id: u32 }
        "servo {id} exists already",
        "サーボ{id}は既にあります";
    ZeroHow
        "the torque is off. For each joint: turn it by hand to its angle 0, press RETURN; turn it a little in its positive direction, press RETURN. 's' and RETURN skips a joint",
        "トルクを切りました。関節ごとに、手で角度0に合わせてRETURN、正の向きに少し回してRETURNを押してください。's'とRETURNで飛ばします";
    ZeroReleases { joints: List }
        "these servos hold: {joints}. Support the robot; RETURN switches their torque off",
        "保持中のサーボがあります: {joints}。ロボットを支えてください。RETURNでトルクを切ります";
    IdReleases { id: u32 }
        "servo {id} holds. Support the robot; RETURN switches its torque off, and writes the number",
        "サーボ{id}は保持中です。ロボットを支えてください。RETURNでトルクを切り、番号を書き込みます";
    IdKept { id: u32 }
        "servo {id} keeps its number and its torque: RETURN alone would have written the number",
        "サーボ{id}の番号とトルクは変わりません。番号を書き込むにはRETURNだけを押してください";
    NotStill { joints: List }
        "{joints} gave no two equal positions in a row: keep the joint still, look at its cables, and do it again",
        "{joints}の位置が定まりません。関節を動かさず、ケーブルを確かめて、やり直してください";
    TurnedTooFar { joint: String, angle: String }
        "{joint} has turned by {angle} deg or the other way round, nobody can tell: turn it by less than a third of a turn, and do it again",
        "{joint}は{angle}度回ったのか逆向きなのか判別できません。3分の1回転未満にして、やり直してください";
    OverTheEnd { joint: String, end: u32 }
        "{joint} turned over the end of its servo's travel ({end} to 0), where the servo cannot follow: mount its horn turned if the joint has to go there",
        "{joint}はサーボの可動範囲の端({end}と0の間)を越えました。サーボはそこを通れないので、必要ならホーンを回して付け直してください";
    NotAnAnswer { text: String }
        "`{text}` is no answer: RETURN alone goes on, 's' and RETURN skips",
        "`{text}` は答えではありません。RETURNだけで進み、's'とRETURNで飛ばします";
    AtZero { joint: String }
        "{joint} at 0",
        "{joint}を角度0に";
    AtPositive { joint: String }
        "{joint} a little in its positive direction",
        "{joint}を正の向きに少し";
    NotTurned { joint: String }
        "{joint} has turned by less than 3 deg, so its sign and its 0 are not certain: do it again, or skip it",
        "{joint}は3度以上回っていないため、符号も角度0も決められません。やり直すか、飛ばしてください";
    ZeroSkipped { joint: String }
        "{joint} is skipped; its sign and its offset stay",
        "{joint}を飛ばしました。符号とオフセットは変えません";
    ZeroUnfinished { joints: List }
        "the input ended before these joints were done: {joints}",
        "入力が終わったため、次の関節は終わっていません: {joints}";
    ZeroWritten { joints: List, file: Text }
        "{file} has the signs and offsets of {joints} now",
        "{joints}の符号とオフセットを{file}に書き込みました";
    ZeroNone { file: Text }
        "no joint was turned to its angle 0; {file} stays as it is",
        "角度0に合わせた関節はありません。{file}は変えません";
    ZeroKept { file: Text }
        "{file} is not changed, because its [[drive]] tables are written in a form that only you can edit, or would be wrong then",
        "{file}は変更していません。[[drive]]表の書き方に対応していないか、書き込むと誤りになるためです";
    ZeroResult { file: Text }
        "these keys belong to the [[drive]] tables of {file}:",
        "次のキーを{file}の[[drive]]表に書いてください:";
    JogHow { joint: String }
        "{joint}: + and - turn it by 1 deg, q ends, RETURN is the emergency stop",
        "{joint}: +と-で1度ずつ動かし、qで終わります。RETURNは非常停止です";
    RecordFree
        "hold the robot: its joints are free. RETURN begins",
        "ロボットを支えてください。関節は自由に動きます。RETURNで始めます";
    RecordHow
        "SPACE adds the pose, m its mirror image; < and > choose, n names, d deletes, g goes there, p through all; q, ESC and Ctrl-C end and write",
        "SPACEで姿勢を、mで左右を反転した姿勢を加えます。< と > で選び、nで名前を付け、dで消し、gでその姿勢へ、pで全姿勢を順に動きます。q、ESC、Ctrl-Cで終わり、書き込みます";
    RecordMotionHow
        "SPACE begins, another SPACE ends and writes, as q, ESC and Ctrl-C do",
        "SPACEで始め、もう一度SPACEを押すと終わり、書き込みます(q、ESC、Ctrl-Cでも同じ)";
    RecordBegun
        "the motion is being recorded",
        "動きを記録しています";
    PoseAdded { number: usize }
        "pose {number} is added",
        "姿勢{number}を加えました";
    PoseDeleted { number: usize }
        "pose {number} is deleted",
        "姿勢{number}を消しました";
    NoPose
        "there is no pose yet",
        "姿勢はまだありません";
    PoseChosen { number: usize, name: String }
        "pose {number} is chosen: {name}",
        "姿勢{number}を選びました: {name}";
    PoseNameAsked { number: usize }
        "name of pose {number}",
        "姿勢{number}の名前";
    NotInAName { most: usize }
        "a name has letters, digits and _, {most} at most",
        "名前は英数字と _ で、{most}文字までです";
    NotAPoseName { name: String, most: usize }
        "`{name}` cannot name a pose: use a letter, then letters, digits and _, {most} characters at most, and no name that the program has",
        "`{name}` は姿勢の名前に使えません。英字で始まる{most}文字以内の英数字と _ で、プログラムにまだない名前にしてください";
    PoseGoes { speed: f64 }
        "the torque is switched on, and the joints move with {speed} deg/s; RETURN is the emergency stop",
        "トルクを入れ、関節を{speed}度/sで動かします。RETURNは非常停止です";
    PoseReached
        "the robot holds the pose. Support it; r switches the torque off",
        "姿勢を保持しています。ロボットを支えてください。rでトルクを切ります";
    RecordLimp
        "the joints are free",
        "関節は自由に動きます";
    NoMirror { leg: String }
        "no mirror image: leg {leg} has no leg on the other side whose joints mirror its own",
        "反転できません: 脚{leg}と左右対称な関節を持つ脚がありません";
    ImageOutside { joint: String, angle: String, min: f64, max: f64 }
        "the mirror image is not added: {joint} would be at {angle} deg, outside of {min} to {max}",
        "反転した姿勢は加えません: {joint}が{angle}度になり、範囲{min}から{max}の外です";
    RecordNothing { file: Text }
        "nothing was recorded; {file} is not written",
        "何も記録されていません。{file}は書き込みません";
    RecordTaken { file: Text }
        "{file} exists: --at end adds to it, --force replaces it, -o takes another name",
        "{file} はすでにあります。--at end で加えるか、--force で置き換えるか、-oで別の名前を指定してください";
    RecordEdition { file: Text }
        "{file} is a program of edition 3.1, without the words of a taught motion: `tip migrate --to 3.2` rewrites it",
        "{file} は3.1版のプログラムで、教示した動作に必要な語がありません。`tip migrate --to 3.2` で書き換えてください";
    RecordBeyond { file: Text, line: u32, end: u32 }
        "{file} has no place at line {line}: its END is in line {end}",
        "{file} の{line}行目には加えられません。ENDは{end}行目です";
    RecordFast { joint: String, speed: String, most: f64 }
        "{joint} was turned at up to {speed} deg/s, and its drive turns at {most} at most: it will lag behind there",
        "{joint}は最大{speed}度/sで動かされましたが、駆動の上限は{most}度/sです。そこでは遅れます";
    RecordTried
        "in simulation this happens:",
        "シミュレーションでは次のことが起こります:";
    RecordEndless { time: String }
        "the program has not ended after {time} s",
        "{time} sたってもプログラムが終わりません";
    Recorded { file: Text, points: usize }
        "{file} has the motion now; it was tried in simulation. Number of set points: {points}",
        "動きを{file}に書き込みました(目標点{points}個、シミュレーション済み)";
    RecordedLines { file: Text, points: usize }
        "{file} has the motion now; only its new lines were tried in simulation. Number of set points: {points}",
        "動きを{file}に書き込みました(目標点{points}個)。シミュレーションで試したのは新しい行だけです";
    Simulates { servos: usize, port: Text }
        "{servos} simulated servos on {port}; Ctrl-C ends",
        "{port}に模擬サーボが{servos}台あります。Ctrl-Cで終わります";
    NotHere
        "pseudo-terminals are available on Unix only",
        "疑似端末はUnixでのみ使えます";
    NoFifo { error: Text }
        "no real-time priority: {error}. It needs root, CAP_SYS_NICE, or a line `@realtime - rtprio 80` in /etc/security/limits.conf",
        "リアルタイム優先度にできません: {error}。root、CAP_SYS_NICE、または/etc/security/limits.confの `@realtime - rtprio 80` が必要です";
    NoLock { error: Text }
        "memory is not locked: {error}. It needs root, CAP_IPC_LOCK, or a line `@realtime - memlock unlimited` in /etc/security/limits.conf",
        "メモリを固定できません: {error}。root、CAP_IPC_LOCK、または/etc/security/limits.confの `@realtime - memlock unlimited` が必要です";

    // What stops a robot.
    PortGone
        "the port is gone: look at the USB cable",
        "ポートがなくなりました。USBケーブルを確かめてください";
    Silent { joint: String, id: u32, cycles: u32 }
        "{joint} (servo {id}) has not answered for more than {cycles} cycles: look at its cables and its power",
        "{joint}(サーボ{id})が{cycles}周期を超えて応答しません。ケーブルと電源を確かめてください";
    NotRead { joint: String, id: u32, cycles: u32 }
        "{joint} (servo {id}) was not asked for {cycles} cycles, because this machine was late in each or suspended: end other programs, use --fifo, or give `period` more time",
        "{joint}(サーボ{id})に{cycles}周期のあいだ問い合わせできませんでした(この計算機が一時停止したか、処理が毎周期遅れました)。ほかのプログラムを終了するか、--fifoを使うか、`period` を長くしてください";
    OtherModel { joint: String, id: u32, number: u32, model: &'static str }
        "{joint} (servo {id}) reports the model number {number}, which is not that of {model}",
        "{joint}(サーボ{id})の型番{number}は{model}のものではありません";
    BusLoad { read: String, period: f64, cycles: u32 }
        "reading all servos takes {read} ms, longer than a cycle of {period} ms has for it: each servo is read in one of {cycles} cycles",
        "全サーボの読み取りに{read} msが必要で、制御周期{period} msの読み取り時間を超えます。各サーボの読み取りは{cycles}周期に1回です";
    ShortTimeout { time: String, cycles: String }
        "without the host the servos stop after {time} ms, their longest time-out: {cycles} cycles",
        "ホストが止まると、サーボは最長のタイムアウトである{time} ms({cycles}周期)で停止します";
    BusTooSlow { period: String, read: String, write: String, shortest: String }
        "the bus cannot carry a cycle of {period} ms: reading all servos takes {read} ms, and commanding them {write} ms. Give it {shortest} ms or more (`period`, SET_SAMPLING_TIME), a faster bus or two of them",
        "バスの通信が制御周期{period} msに収まりません。全サーボの読み取りに{read} ms、指令に{write} msが必要です。サンプリング時間(`period`、SET_SAMPLING_TIME)を{shortest} ms以上にするか、バスを速くするか、2本に分けてください";
    BusTooSlowInTurn { period: String, read: String, write: String, shortest: String, cycles: u32, silence: u32 }
        "the bus cannot carry a cycle of {period} ms: reading all servos takes {read} ms, and commanding them {write} ms. Each servo would be read in one of {cycles} cycles, and `silence` is {silence}. Give it {shortest} ms or more (`period`, SET_SAMPLING_TIME), a larger `silence`, a faster bus or two of them",
        "バスの通信が制御周期{period} msに収まりません。全サーボの読み取りに{read} ms、指令に{write} msが必要です。各サーボの読み取りは{cycles}周期に1回になり、`silence` は{silence}です。サンプリング時間(`period`、SET_SAMPLING_TIME)を{shortest} ms以上にするか、`silence` を大きくするか、バスを速くするか、2本に分けてください";
    PeriodTooLong { most: String }
        "the servos' watchdogs would stop a healthy robot: with them the sampling time is {most} ms at most",
        "サーボのウォッチドッグが正常な動作を止めてしまいます。サンプリング時間は{most} ms以下にしてください";
    WrongRegister { joint: String, id: u32, name: &'static str, register: u32, value: String, wanted: String }
        "{joint} (servo {id}) would not go where it is sent: its register {register} ({name}) is {value}. Write {wanted} to it with the maker's tool while the torque is off",
        "{joint}(サーボ{id})は指令した角度に動きません(レジスタ{register}、{name}の値は{value})。トルクを切り、製造元のツールで{wanted}を書き込んでください";
    Hot { joint: String, id: u32, now: f64, most: f64 }
        "{joint} (servo {id}) has {now} °C, and {most} at most is allowed: let it cool, and look for what loads it",
        "{joint}(サーボ{id})が{now} °Cで、上限{most} °Cを超えました。冷まして、負荷の原因を調べてください";
    Voltage { joint: String, id: u32, now: f64, min: f64, max: f64 }
        "{joint} (servo {id}) measures {now} V, and {min} to {max} V are allowed: look at the battery",
        "{joint}(サーボ{id})の電圧{now} Vが範囲{min}から{max} Vの外です。電池を確かめてください";
    Overload { joint: String, id: u32, load: String, most: f64 }
        "{joint} (servo {id}) needs {load} of its torque for too long, and {most} at most is allowed: is it blocked?",
        "{joint}(サーボ{id})の負荷{load}が上限{most}を超え続けています。何かに当たっていませんか?";
    Alarm { joint: String, id: u32, bits: u32, meaning: &'static str }
        "{joint} (servo {id}) has the alarm {bits} ({meaning}) and has switched itself off: switch its power off and on",
        "{joint}(サーボ{id})がアラーム{bits}({meaning})で停止しました。電源を入れ直してください";
    Reset { joint: String, id: u32 }
        "{joint} (servo {id}) has lost its torque: it was reset, by a loose power connector perhaps",
        "{joint}(サーボ{id})のトルクがなくなりました。電源コネクタの緩みなどによるリセットです";
    TimedOut { joint: String, id: u32, time: String }
        "{joint} (servo {id}) was stopped by its watchdog, because it heard nothing for more than {time} ms: was this machine suspended or too busy, or a cable loose?",
        "{joint}(サーボ{id})が{time} msを超えて通信を受けず、ウォッチドッグで停止しました。この計算機の一時停止や高負荷、ケーブルの緩みを確かめてください";
    Lags { joint: String, id: u32, angle: String, most: f64 }
        "{joint} (servo {id}) is {angle} deg away from its command, and {most} at most is allowed: is it blocked, weak or without torque?",
        "{joint}(サーボ{id})が指令から{angle}度離れ、上限{most}度を超えました。障害物、力不足、トルクなしを確かめてください";
    Outside { joint: String, id: u32, angle: String, min: f64, max: f64 }
        "{joint} (servo {id}) is at {angle} deg, outside of {min} to {max}: move it by hand, or look at sign and offset (tip drives zero)",
        "{joint}(サーボ{id})の角度{angle}度が範囲{min}から{max}の外です。手で動かすか、符号とオフセットを確かめてください(tip drives zero)";
    NotHeld
        "the robot was left, because this command was stuck",
        "コマンドが停止したままだったため、ロボットの制御を終えました";
    Collides { one: Part, other: Part }
        "{one} and {other} would overlap: the command was not sent. List parts that may touch in `may_touch`. To warn and go on, set `collisions = \"warn\"` in [bus]",
        "{one}と{other}が重なるため、指令を送信しませんでした。触れてもよい部分は `may_touch` に書きます。[bus]の `collisions = \"warn\"` なら警告だけで続けます";
    WayCollides { one: Part, other: Part, by: String, angles: List }
        "{one} and {other} would overlap by {by} mm on the way there, at {angles} deg: nothing moves. Move the robot by hand to where its way is free, or list parts that may touch in `may_touch`. To warn and go on, set `collisions = \"warn\"` in [bus]",
        "途中で{one}と{other}が{by} mm重なるため({angles}度)、動きません。手で動かして通れる位置にするか、触れてもよい部分を `may_touch` に書いてください。[bus]の `collisions = \"warn\"` なら警告だけで続けます";
    WayOverlaps { one: Part, other: Part, by: String, angles: List }
        "{one} and {other} overlap by {by} mm on the way there, at {angles} deg",
        "途中で{one}と{other}が{by} mm重なります({angles}度)";
    PoseCollides { number: usize, one: Part, other: Part, by: String }
        "in pose {number} {one} and {other} overlap by {by} mm, as the description has them: without `collisions = \"warn\"` in [bus] the robot does not go there",
        "姿勢{number}では、ロボット記述によると{one}と{other}が{by} mm重なります。[bus]に `collisions = \"warn\"` がなければ、ロボットはこの姿勢になりません";
    NoTorques { joint: String }
        "{joint} is commanded a torque, and position servos take angles only",
        "{joint}にトルクが指令されましたが、位置サーボは角度しか受け付けません";
}
