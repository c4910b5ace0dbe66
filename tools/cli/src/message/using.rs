//! What is said of a command line that asks for what there is not.

use tipc::message::Text;
use tipc::message::list::Each;

tipc::message_table! {
    /// Wrong usage of the command `tipc`.
    Using;

    RunThat { file: Text }
        "`{file}` is not a command of tipc: did you mean `tipc run {file}`?",
        "`{file}` はtipcのコマンドではありません。`tipc run {file}` のことですか?";
    OtherWord { word: String, command: String }
        "`{word}` is not a command of tipc: did you mean `tipc {command}`?",
        "`{word}` はtipcのコマンドではありません。`tipc {command}` のことですか?";
    NoCommand { word: String, commands: Each }
        "`{word}` is not a command of tipc; the commands are {commands}",
        "`{word}` はtipcのコマンドではありません。コマンドは{commands}です";
    NoFile { command: String }
        "which program? `tipc {command}` needs a file, as `tipc {command} walk.prg`",
        "どのプログラムですか? `tipc {command} walk.prg` のようにファイルを指定してください";
    NoCode { code: String, codes: Each }
        "no finding has the code {code}; the codes are {codes}",
        "{code}というコードはありません。コードは{codes}です";
    NotACount { text: String }
        "`{text}` is not a count: write a whole number, 0 or more",
        "`{text}` は数えられません。0以上の整数を指定してください";
    NotPositive { text: String }
        "`{text}` compares nothing: write a whole number, 1 or more",
        "`{text}` では何も比較されません。1以上の整数を指定してください";
    NotAFoot { text: String }
        "`{text}` is not a foot: write the name of a link, or `LINK=X,Y,Z` for a place in its frame, in metres, as `shank=0,0,-0.13`",
        "`{text}` は足先の指定ではありません。リンクの名前か、`shank=0,0,-0.13` のようにリンク座標系での位置(メートル)を付けて書いてください";
    NotAHeight { text: String }
        "`{text}` is not a height: write a number of mm above 0, as 250",
        "`{text}` は高さではありません。250のように0より大きいmmの値を指定してください";
    NoRobot { word: String, robots: Each }
        "no robot is called `{word}`; there are {robots}, and yours in a FILE.toml",
        "`{word}` というロボットはありません。{robots}か、自分のロボットのファイル(FILE.toml)を指定してください";
    NearRobot { word: String, near: String, robots: Each }
        "no robot is called `{word}`: did you mean `{near}`? There are {robots}, and yours in a FILE.toml",
        "`{word}` というロボットはありません。`{near}` のことですか? {robots}か、自分のロボットのファイル(FILE.toml)を指定してください";
    NoPlant { word: String, plants: Each }
        "no plant is called `{word}`; there are {plants}, and a process of yours as `exec:COMMAND`",
        "`{word}` というプラントはありません。{plants}か、自分のプロセスを `exec:COMMAND` の形で指定してください";
    NoProcess { command: String }
        "`{command}` is not a command line: write a program and its arguments, and close every quote, as in `exec:python3 simulate.py`",
        "`{command}` はコマンドラインではありません。`exec:python3 simulate.py` のようにプログラムと引数を書き、引用符は閉じてください";
    ProcessRunsOnce { command: &'static str }
        "`tipc {command}` runs programs again or backwards, and a process can neither be copied nor taken back: take --plant dynamic here, and the process with `tipc run`",
        "`tipc {command}` はプログラムを繰り返し、または逆向きに実行しますが、プロセスはコピーも巻き戻しもできません。ここでは --plant dynamic を使い、プロセスは `tipc run` で使ってください";
    ProcessIsRun { command: &'static str }
        "`tipc {command}` records our plants only; `tipc run --plant exec:COMMAND --trace FILE --trace-motion` runs the process, and `tipc view FILE --program PROGRAM` shows what it did",
        "`tipc {command}` が記録できるのは内蔵のプラントだけです。プロセスは `tipc run --plant exec:COMMAND --trace FILE --trace-motion` で実行し、`tipc view FILE --program PROGRAM` で表示してください";
    SceneIsElsewhere
        "--scene surrounds our plants, and a process has its own surroundings: give the scene to the process",
        "--scene は内蔵のプラントの周囲を決めるもので、プロセスの周囲はプロセス自身が決めます。シーンはプロセスに渡してください";
    FallsAreElsewhere
        "--deny falls needs a plant of ours: nobody counts the falls of a process's robot",
        "--deny falls を使えるのは内蔵のプラントだけです。プロセスのロボットの転倒は数えられません";
    NotAVersion { text: String }
        "`{text}` is not a version of the language, as 3.1 is",
        "`{text}` は3.1のような言語のバージョンではありません";
    NotACrateName { name: String, near: String }
        "`{name}` cannot be the name of a crate: begin with a small letter, go on with small letters and digits, and put a single `-` or `_` between them, as in `{near}`",
        "`{name}` はクレート名にできません。`{near}` のように、英小文字で始め、英小文字と数字を使い、その間を `-` か `_` 1つでつないでください";
    CrateNameTaken { name: String, near: String }
        "`{name}` means something else to Rust or cargo, and cannot be the name of a crate: `{near}` can",
        "`{name}` はRustやcargoで別の意味をもつため、クレート名にできません。`{near}` なら使えます";
    // What the library of the command line says in English itself.
    NoOption { option: String }
        "there is no option `{option}`",
        "`{option}` というオプションはありません";
    NearOption { option: String, near: String }
        "there is no option `{option}`: did you mean `{near}`?",
        "`{option}` というオプションはありません。`{near}` のことですか?";
    NoSuchValue { value: String, values: Each }
        "`{value}` is not a value of it; the values are {values}",
        "`{value}` は指定できません。指定できるのは{values}です";
    NeedsValue
        "it wants a value",
        "値を指定してください";
    NotTogether { option: String, other: String }
        "`{option}` and `{other}` do not go together",
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
        "whoever has this address can run, edit and save the program",
        "このアドレスを知る人は誰でも、プログラムの実行・編集・保存ができます";
    ServeEnds
        "Ctrl-C ends",
        "Ctrl-Cで終了します";
    SeeHelp { command: String }
        "`tipc help {command}` shows examples",
        "`tipc help {command}` で使用例を見られます";
}
