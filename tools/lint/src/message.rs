//! The messages of this crate, and the parts of them that vary.
//!
//! ```
//! use tip_lint::message::Changes;
//!
//! assert_eq!(Changes::from(2).to_string(), "2 changes");
//! ```

use smol_str::SmolStr;
use tip_runtime::command::Target;
use tipc::language::{Edition, Keyword};
use tipc::message::list::{List, Pieces, Quoted};
use tipc::message::phrase::{Assign, Type};
use tipc::message::{Message, Text};

tipc::count_table! {
    /// A number of changes of a program.
    Changes: "1 change", "変更1か所"; "{count} changes", "変更{count}か所";
}

tipc::count_table! {
    /// A number of questions about a program.
    Questions: "1 question", "質問1件"; "{count} questions", "質問{count}件";
}

tipc::count_table! {
    /// A number of diagnostics.
    Diagnostics: "1 finding", "1件"; "{count} findings", "{count}件";
}

tipc::count_table! {
    /// A number of diagnostics beyond those that are reported.
    More: "... and 1 more finding", "……ほかに1件あります"; "... and {count} more findings", "……ほかに{count}件あります";
}

tipc::message_table! {
    /// The robots that a migrated program loads for.
    Loads;

    ForNone "loads for no robot yet; `tip check` on the new program says why", "まだどのロボットでも読み込めません。新しいプログラムを`tip check`にかけると理由が分かります";
    For { robots: List } "loads for {robots}", "{robots}で読み込めます";
}

tipc::message_table! {
    /// Messages on a program that was written for another robot.
    RobotChoice;

    LooksLike { robot: &'static str, chosen: &'static str }
        "this looks like a program for {robot}: it has no errors there, and many for {chosen}",
        "{robot}用のプログラムのようです。{robot}ではエラーがなく、{chosen}では多数あります";
    Choose { robot: &'static str }
        "choose the robot with `--robot {robot}`, or `robot = \"{robot}\"` in a tip.toml",
        "ロボットを `--robot {robot}` か、tip.tomlの `robot = \"{robot}\"` で指定してください";
}

tipc::message_table! {
    /// Reason for an added declaration.
    Declared;

    OneType ": variables are declared since 3.0, AGL and TRQ as one type", "(3.0から変数は宣言が必要です。AGLとTRQは一つの型になりました)";
    Plainly ": variables are declared since 3.0", "(3.0から変数は宣言が必要です)";
}

tipc::message_table! {
    /// Messages of the formatter.
    Formatting;

    DoesNotLoad
        "left as it is: a program with errors cannot be formatted",
        "そのままにしました。エラーのあるプログラムは整形できません";
    LineTooLong { line: u32, limit: usize }
        "left as it is: line {line} would be longer than {limit} bytes; break it in two",
        "そのままにしました。整形すると{line}行目が{limit}バイトを超えます。2行に分けてください";
    OtherEncoding { encoding: &'static str }
        "left as it is: without its full-width blanks the file would be read as {encoding}; name its encoding",
        "そのままにしました。全角の空白がなくなると{encoding}として読まれます。文字コードを指定してください";
    OtherProgram
        "left as it is: formatted, it would be another program; this is a defect of tip, please report it",
        "そのままにしました。整形すると別のプログラムになってしまいます。tipの不具合ですので報告してください";
}

tipc::message_table! {
    /// Reasons and helps of lints.
    Linting;

    // Variables without a value.
    Has { name: String, lack: Lack }
        "`{name}` has {lack}",
        "`{name}` には、{lack}";
    Have { names: Quoted, lack: Lack }
        "{names} have {lack}",
        "{names} には、{lack}";
    Assign { assign: Assign } "{assign}", "{assign}";
    NoValueOnPath { path: Stretch, assign: Assign }
        "no value on the path through {path}; {assign}",
        "{path}を通る経路では値がありません。{assign}";

    // Threads, timers and log files.
    NothingStarts
        "no START_THREAD names it",
        "これを指定したSTART_THREADがありません";
    StartThread { name: SmolStr }
        "start it with `START_THREAD {name}:`",
        "`START_THREAD {name}:` で動かしてください";
    WaitsInItself
        "it runs as long as it waits",
        "待っている間、このスレッドは動いたままです";
    WaitElsewhere
        "wait for it in the main program or in another thread",
        "メインプログラムか別のスレッドで待ってください";
    OneLine
        "no F_MESSAGE ends its line",
        "改行するF_MESSAGEがありません";
    EndLine
        "end the text with `\\n`",
        "文字列の終わりに `\\n` を書いてください";
    TimerStands
        "it stays 0 until the timer is started",
        "タイマを動かすまで0のままです";
    StartTimer { timer: u32 }
        "start it with `START_TIMER {timer}`",
        "`START_TIMER {timer}` で動かしてください";
    OtherThread
        "a command for the same joint follows in this cycle",
        "この周期には、同じ関節への命令がこの後にもあります";
    ThisStands
        "this command stands",
        "この命令が有効になります";
    OneCommands
        "let one thread command the joint, or let the other one wait first",
        "関節への命令を1つのスレッドにまとめるか、もう一方を先に待たせてください";

    // Messages.
    NoVar { name: SmolStr }
        "no VAR is called `{name}`",
        "`{name}` というVAR型変数はありません";
    MeantPlaceholder { near: SmolStr }
        "did you mean `%{near}%`?",
        "`%{near}%` の間違いではありませんか?";
    DeclareOrLeaveOut { name: SmolStr }
        "declare it with `DEF_VAR {name}` to show its value",
        "値を表示するには `DEF_VAR {name}` で宣言してください";
    StructInMessage { name: SmolStr, found: Type }
        "`{name}` is {found}, and a message shows VARs only",
        "`{name}` は{found}です。MESSAGEで表示できるのはVAR型変数だけです";
    ShowCopy { member: String }
        "copy a member into a VAR, as `V = {member}`, and show `%V%`",
        "`V = {member}` のようにメンバをVAR型変数に代入し、`%V%` で表示してください";
    Decimals { name: SmolStr }
        "`{name}` is shown with 0 to 7 decimals",
        "`{name}` の小数点以下の桁数は0から7までです";
    SevenAtMost { name: SmolStr }
        "write one digit after the point, as `%{name}.2%`",
        "`%{name}.2%` のように、ピリオドの後に数字を1個書いてください";
    NoFormat
        "a value is shown by the name of its variable",
        "値は変数名で表示します";
    ShowValue { name: SmolStr }
        "write `%{name}%`",
        "`%{name}%` と書いてください";
    ShowAnyValue
        "`%A%` shows the value of A, `%A.2%` with 2 decimals",
        "`%A%` と書くとAの値が、`%A.2%` なら小数点以下2桁まで表示されます";
    QuotesShown
        "the quotes are part of the text",
        "引用符も文字列の一部になります";
    ParenthesesShown
        "the parentheses are part of the text",
        "括弧も文字列の一部になります";
    LeaveParenthesesOut
        "leave the parentheses out: the text ends with its line",
        "括弧は要りません。文字列は行末までです";
    LeaveQuotesOut
        "leave the quotes out: the text ends with its line",
        "引用符は要りません。文字列は行末までです";

    // Steps that do not run.
    NoPath
        "no path leads here",
        "ここに来る経路がありません";
    LabelOrDelete
        "put a label here that something jumps to, or take the steps out",
        "飛び先のラベルをここに置くか、不要なら削除してください";
    NothingJumps { name: SmolStr }
        "nothing jumps to `{name}:`, and no step runs into it",
        "`{name}:` へのジャンプも、ここに続くステップもありません";
    JumpOrDelete { name: SmolStr }
        "jump to it with `GOTO {name}:`, call it with `GOSUB {name}:`, or take it out",
        "`GOTO {name}:` でジャンプするか、`GOSUB {name}:` で呼んでください。不要なら削除してください";
    JumpInOneWord { jump: Keyword }
        "{jump} needs a blank after it",
        "{jump}の後には空白が必要です";
    JumpInTwoWords { written: SmolStr, word: SmolStr }
        "write `{written}`; if `{word}:` is a label, jump to it or take it out",
        "`{written}` と書いてください。`{word}:` がラベルなら、そこへジャンプさせるか、削除してください";
    LeadsElsewhere
        "this leads elsewhere",
        "ここで別の場所に移ります";

    // Calls.
    NeverReturns
        "no path from here comes to a RETURN",
        "ここからRETURNに来る経路がありません";
    CalledHere
        "called here",
        "ここで呼ばれています";
    EndWithReturn
        "end the part with RETURN; to leave for good, use GOTO instead of GOSUB",
        "最後にRETURNを置いてください。戻らないのなら、GOSUBの代わりにGOTOを使ってください";
    ReturnsNowhere
        "without a GOSUB this stops the program",
        "GOSUBなしで来ると、ここで緊急停止します";
    PutJumpAboveLabel
        "put GOTO or EXIT above the part that GOSUB calls",
        "GOSUBで呼ぶ部分の上にGOTOかEXITを置いてください";

    // Conditions and loops.
    AlwaysTrue "always true", "いつも真です";
    AlwaysFalse "always false", "いつも偽です";
    CompareVariable
        "compare a variable that changes, or take the condition out",
        "値の変わる変数と比較するか、条件を取り除いてください";
    NeverTurns
        "the loop never runs; compare a variable that changes",
        "ループは一度も実行されません。値の変わる変数と比較してください";
    TurnsOnce
        "the loop runs once; compare a variable that changes",
        "ループは一度で終わります。値の変わる変数と比較してください";
    BeyondEnd { from: f64, to: f64 }
        "{from} is already beyond {to}",
        "{from}は初めから{to}を過ぎています";
    CountBack { step: f64 }
        "count the other way with `STEP {step}`, or swap the bounds",
        "逆に数えるには `STEP {step}` を付けるか、両端を入れ替えてください";
    NothingChanges
        "no step of the loop assigns a variable of this condition",
        "この条件の変数に代入するステップがループの中にありません";
    ChangeOrLoop
        "change the variable in the loop; to repeat for ever write `LOOP:` … `GOTO LOOP:`",
        "ループの中で変数の値を変えてください。無限に繰り返すなら `LOOP:` … `GOTO LOOP:` と書きます";

    // Commands and equations.
    OneCycle { period: f64 }
        "this takes one whole cycle, {period} ms",
        "1周期の{period} msかかります";
    Milliseconds
        "SLEEP counts milliseconds: one second is `SLEEP 1000`",
        "SLEEPの単位はミリ秒です。1秒は `SLEEP 1000` です";
    AssignsSigned { number: SmolStr }
        "this assigns {number}, with a sign in front",
        "符号付きの{number}を代入しています";
    MeantUpdate { name: SmolStr, number: SmolStr }
        "to add write `{name} += {number}`; to assign, `{name} = {number}`",
        "加算は `{name} += {number}`、代入は `{name} = {number}` と書いてください";
    OthersAbsolute
        "the numbers after it are absolute",
        "その後の数値は絶対値です";
    MarkEach
        "write R before each number that is relative, and A before each that is absolute",
        "相対値には一つずつR、絶対値には一つずつAを付けてください";

    // Waits.
    PassesAtOnce { target: Target }
        "nothing moves {target}: the wait ends immediately",
        "{target}を動かす文がないので、待たずに先へ進みます";
    NeverControlled { target: Target }
        "nothing moves {target}: this stops the program",
        "{target}を動かす文がないので、ここで緊急停止します";
    InposOfNothing { target: Target }
        "nothing moves {target}: always true",
        "{target}を動かす文がないので、常に真です";
    NearOfNothing { target: Target }
        "nothing moves {target}: always false",
        "{target}を動かす文がないので、常に偽です";
    WaitForMoved
        "name what a motion command moves, or ALL",
        "動作コマンドで動かす対象か、ALLを書いてください";
    NobodySets
        "the program calls no SPECIAL: always false",
        "SPECIALを呼ばないプログラムなので、常に偽です";
    CallSpecial
        "native code sets this flag: call it with SPECIAL",
        "このフラグを立てるのはネイティブコードです。SPECIALで呼んでください";
}

tipc::message_table! {
    /// Missing part of a variable.
    Lack;

    Value "no value here", "ここではまだ値がありません";
    ValueOnSomePaths "a value here on some paths only", "経路によってはここで値がありません";
}

tipc::message_table! {
    /// A path through a program.
    Stretch;

    Line { line: u32 } "line {line}", "{line}行目";
    Lines { lines: Pieces } "lines {lines}", "{lines}行目";
}

tipc::message_table! {
    /// Messages about comments that silence warnings.
    Allowing;

    NoList
        "this comment names no warnings",
        "このコメントには警告のコードがありません";
    WriteList
        "write the codes of warnings in parentheses, as `// tip: allow(W101, W102)`",
        "`// tip: allow(W101, W102)` のように、警告のコードを括弧の中に書いてください";
    NoCode { name: SmolStr }
        "no warning has the code `{name}`",
        "`{name}` というコードの警告はありません";
    Error { code: &'static str }
        "{code} is an error, and errors stay",
        "{code}はエラーです。エラーは消せません";
    SilencesNothing
        "nothing here has this warning",
        "ここにこの警告はありません";
    TakeOut
        "take the code out",
        "このコードを削除してください";
}

tipc::message_table! {
    /// Replacements for words of other languages.
    Foreign;

    ShowText
        "show a text with `MESSAGE text`, without quotes; `%A%` in it shows the value of A",
        "文字の表示は `MESSAGE 文字列` です。引用符は不要で、`%A%` と書くとAの値が出ます";
    EndIf
        "ENDIF closes an IF, in one word",
        "IFを閉じるのは `ENDIF` (1語)です";
    Return
        "write `RETURN`",
        "`RETURN` と書いてください";
    Loops
        "a loop is `REPEAT` … `UNTIL condition`, or `WHILE condition` … `WEND`",
        "繰り返しは `REPEAT` … `UNTIL 条件式` か `WHILE 条件式` … `WEND` です";
    Continue
        "go on with `GOTO L1:`, and put `L1:` before the WEND, UNTIL or NEXT",
        "次の回に進むには `GOTO L1:` と書き、WEND、UNTIL、NEXTの前に `L1:` を置きます";
    Wait
        "`SLEEP 200` waits 200 ms, `WAIT_INPOS ALL` until all motions have ended, `REPEAT` … `UNTIL KB_HIT` until a flag is set",
        "200 ms待つのは `SLEEP 200`、全ての動作の終わりを待つのは `WAIT_INPOS ALL`、フラグを待つのは `REPEAT` … `UNTIL KB_HIT` です";
    Declare
        "declare variables with `DEF_VAR A` (a number), `DEF_POS P` or `DEF_JOINT Q`",
        "変数の宣言は `DEF_VAR A` (数値)、`DEF_POS P`、`DEF_JOINT Q` です";
    Constant
        "a constant is a variable: declare it with `DEF_VAR A`, and assign it on the next line: `A = 100`",
        "定数も変数で表します。`DEF_VAR A` で宣言し、次の行で `A = 100` のように代入してください";
    Let
        "no word stands before an assignment: `A = 1`",
        "代入の前に語は要りません: `A = 1`";
    Subroutine
        "write `SUBROUTINE NAME:` … `SUBEND`, and `CALL NAME:`",
        "`SUBROUTINE NAME:` … `SUBEND` と書き、`CALL NAME:` で呼びます";
    Goto
        "write `GOTO L1:`",
        "`GOTO L1:` と書いてください";
    Move
        "`PTP F1 x y z` moves a foot (mm), `PTP_ANGLE J11 30` turns a joint (deg)",
        "足先を動かすのは `PTP F1 x y z` (mm)、関節を回すのは `PTP_ANGLE J11 30` (deg)です";
    Stop
        "`ALL_STOP` stops the robot, `EXIT` ends the program",
        "ロボットを止めるのは `ALL_STOP`、プログラムを終えるのは `EXIT` です";
    Lamp
        "switch a lamp with `LAMP_ON 0` and `LAMP_OFF 0`",
        "ランプは `LAMP_ON 0` と `LAMP_OFF 0` で切り替えます";
    Cases
        "write `IF A == 1 THEN` … `ELSEIF A == 2 THEN` … `ELSE` … `ENDIF`",
        "`IF A == 1 THEN` … `ELSEIF A == 2 THEN` … `ELSE` … `ENDIF` と書いてください";
    Speed
        "set the speed with `SET_V_MAX F1 200` (feet) or `SET_OMEGA_MAX J11 90` (joints)",
        "速度は `SET_V_MAX F1 200` (足先)か `SET_OMEGA_MAX J11 90` (関節)で設定します";
    Acceleration
        "set the acceleration with `SET_A_MAX F1 1200`",
        "加速度は `SET_A_MAX F1 1200` で設定します";
    Teach
        "`TEACH_POSITION F1 P` stores where a foot is, `TEACH_ANGLE F1 Q` the angles of its joints",
        "足先の位置を読み取るのは `TEACH_POSITION F1 P`、関節角は `TEACH_ANGLE F1 Q` です";
    Home
        "`INITIAL_POSTURE` goes to the initial posture",
        "初期姿勢に戻るのは `INITIAL_POSTURE` です";
    ClearText
        "clear the message with `MESSAGE_CLEAR`",
        "メッセージを消すのは `MESSAGE_CLEAR` です";
    Motors
        "leave it out: the motors hold the robot from the start",
        "不要です。モータは最初から入っていて、ロボットを保持しています";
    NoSetup
        "leave it out: inputs, lamps and joints need no setting up",
        "不要です。入力、ランプ、関節の初期設定はありません";
    NoCatch
        "leave it out: a fault stops the program, and nothing can catch it; test before, as `IF A > 0 THEN`",
        "例外処理はありません。エラーが起きるとプログラムは止まります。`IF A > 0 THEN` のように前もって調べてください";
    RelativeMark
        "`PTP F1 x y z` is absolute, `REL_PTP F1 x y z` relative; `R` before one number makes that one relative",
        "絶対値は `PTP F1 x y z`、相対値は `REL_PTP F1 x y z` です。数値の前に `R` を付けると、その値だけ相対値になります";
    Count
        "count with `N += 1` or `N -= 1`",
        "数を増減するのは `N += 1` や `N -= 1` です";
    FromTheTop
        "a program runs from line 3 to END: leave it out, and repeat for ever with `LOOP:` … `GOTO LOOP:`",
        "プログラムは3行目からENDまで実行されます。これは取り、ずっと繰り返すなら `LOOP:` … `GOTO LOOP:` と書いてください";
    Nothing
        "leave it out: a block may be empty, and `REM` passes one control cycle",
        "消してください。ブロックは空でもかまいません。1制御周期だけ待つなら `REM` です";
    Ask
        "test with `IF condition GOTO L1:`, or wait with `REPEAT` … `UNTIL condition`",
        "調べるのは `IF 条件式 GOTO L1:`、待つのは `REPEAT` … `UNTIL 条件式` です";
    GoesOn
        "this belongs to it",
        "これもその一部です";
    OneFile
        "a program is one file: put the statements here",
        "プログラムは1つのファイルです。ここに直接書いてください";
    MoveEndOrComment
        "to run it, move END below it; write notes as comments, `// …`",
        "実行するなら、ENDをこの文より下に移してください。メモなら `// …` のようにコメントにしてください";
    Number { value: &'static str }
        "there are numbers only: write `{value}`",
        "値は数値だけです。`{value}` と書いてください";
}

tipc::message_table! {
    /// The titles of fixes, and texts about fixes.
    Fixing;

    Replace { old: SmolStr, new: SmolStr }
        "replace `{old}` with `{new}`",
        "`{old}` を `{new}` に直す";
    Insert { text: SmolStr }
        "insert `{text}`",
        "`{text}` を入れる";
    Remove { text: SmolStr }
        "remove `{text}`",
        "`{text}` を取る";
    RemoveInvisible
        "delete the invisible character",
        "見えない文字を消す";
    RemoveBlanks
        "remove the blanks",
        "空白を取る";
    RemoveParentheses
        "leave the parentheses out",
        "括弧を取る";
    RemoveDeclaration { name: SmolStr }
        "remove the declaration of `{name}`",
        "`{name}` の宣言を消す";
    HalfWidth
        "write it in half-width characters",
        "半角文字で書く";
    Comment
        "make it a comment with `//`",
        "`//` のコメントにする";
    TitleLine
        "put an empty title line before it",
        "その前に空の題名の行を入れる";
    OwnLine { name: SmolStr }
        "assign `{name}` on a line of its own",
        "`{name}` への代入を別の行に書く";
    OwnLines
        "put each statement on a line of its own",
        "文を1行に1つずつ書く";
    Block
        "make a block of it, with its statement on a line of its own",
        "文を別の行に書いて、ブロックにする";
    Show
        "show the text with MESSAGE, without quotes",
        "引用符を取り、MESSAGEで表示する";

    // Texts of `check` about fixes.
    Fixed { diagnostics: Diagnostics }
        "fixed {diagnostics}",
        "{diagnostics}を直しました";
    CanFix { diagnostics: Diagnostics }
        "`tip check --fix` fixes {diagnostics}",
        "`tip check --fix` で{diagnostics}を直せます";
    CanFixMore { diagnostics: Diagnostics, all: usize }
        "`tip check --fix` fixes {diagnostics}, with `--unsafe-fixes` {all}: review what it writes",
        "`tip check --fix` で{diagnostics}、`--unsafe-fixes` も付けると{all}件を直せます。結果を確かめてください";
    CanFixLikely { diagnostics: Diagnostics }
        "`tip check --fix --unsafe-fixes` fixes {diagnostics}: review what it writes",
        "`tip check --fix --unsafe-fixes` で{diagnostics}を直せます。結果を確かめてください";
}

tipc::message_table! {
    /// Messages of the migration of a program.
    Migrating;

    // Lines 1 and 2.
    WhichVersion
        "line 1 names no version: which version of the language is this program written for?",
        "1行目にバージョンがありません。どのバージョンの言語で書かれたプログラムですか?";
    UnknownVersion { version: String }
        "no version {version} of the language is known (1.0 to 3.1, and 4.0 in some programs of the time of 2.1): which one is this program written for?",
        "バージョン{version}の言語は知られていません(1.0から3.1まで。2.1の頃のプログラムには4.0もあります)。どのバージョンで書かれたプログラムですか?";
    Version { version: String }
        "version {version} becomes 3.1",
        "バージョン{version}を3.1にします";
    ToVersion { to: &'static str }
        "line 1 becomes {to}",
        "1行目を{to}にします";
    LabelIn3_2 { name: String, new: String }
        "the label {name} becomes {new}: {name} is a word of the language in 3.2",
        "ラベル{name}を{new}にします。{name}は3.2の予約語です";
    VariableIn3_2 { name: String, new: String }
        "the variable {name} becomes {new}: {name} is a word of the language in 3.2",
        "変数{name}を{new}にします。{name}は3.2の予約語です";
    ShowsMore
        "this MESSAGE shows more values in 3.2: which text is meant?",
        "3.2ではこのMESSAGEに表示される値が増えます。どの文字列にしますか?";
    RefusedIn3_2 { title: Text, reason: Box<Message> }
        "3.2 does not load this: {title}: {reason}",
        "3.2ではここを読み込めません: {title}: {reason}";
    EmptyTitle
        "put in an empty line 2: since 1.1 it holds the title",
        "2行目に空行を入れます。1.1から2行目は題名です";

    // Commands and equations.
    IsSince2_0 { old: String, new: String }
        "{old} is {new} since 2.0",
        "{old}は2.0から{new}です";
    IsSince3_1 { old: String, new: String }
        "{old} is {new} since 3.1",
        "{old}は3.1から{new}です";
    TwoSuccessors { old: String, target: String, feet: String, joints: String }
        "{old} {target} has two successors: {feet} takes feet (mm), {joints} joints (deg); which one is meant?",
        "{old} {target}の後継は2つあります。{feet}は足先(mm)、{joints}は関節(deg)です。どちらですか?";
    NotTheAngles
        "these are not the angles that COMPLIANCE_ANGLE takes, one for each joint: which of them are angles, and which is the stiffness for SET_ANGLE_STIFFNESS?",
        "COMPLIANCE_ANGLEの引数は関節ごとの角度ですが、数が合いません。どれが角度で、どれがSET_ANGLE_STIFFNESSの剛性ですか?";
    Compliance
        "COMPLIANCE is COMPLIANCE_ANGLE since 2.1",
        "COMPLIANCEは2.1からCOMPLIANCE_ANGLEです";
    AssignmentBehindFor { variable: String }
        "`=` after FOR {variable} since 3.1",
        "3.1からFOR {variable}の後に `=` を書きます";
    Sign { operand: String }
        "`- {operand}` is `-{operand}` since 2.0",
        "`- {operand}` は2.0から `-{operand}` です";
    Remark
        "REM becomes //: since 3.0 REM is a step of its own",
        "REMを//にします。3.0からREMは1ステップです";

    // WAIT_NEAR.
    OneTolerance
        "WAIT_NEAR takes one tolerance, not negative: which one is meant?",
        "WAIT_NEARの許容範囲は0以上の数値1個です。どれですか?";
    WholeLeg { target: String, leg: String }
        "{target} is moved to positions, and a tolerance in mm is set for a whole leg: may it be SET_NEAR_POSITION F{leg}?",
        "{target}は位置で動かしていますが、mmの許容範囲は脚全体に設定します。SET_NEAR_POSITION F{leg}でよいですか?";
    TwoSteps { setting: &'static str }
        "two steps, {setting} and WAIT_NEAR: since 3.1 the tolerance is set beforehand, and stays set",
        "{setting}とWAIT_NEARの2ステップにします。3.1から許容範囲は先に設定し、そのまま残ります";
    WhichMeasure { target: String }
        "the program moves {target} to positions and to angles: is this tolerance in mm (SET_NEAR_POSITION) or in deg (SET_NEAR_ANGLE)?",
        "このプログラムは{target}を位置でも角度でも動かします。許容範囲はmm(SET_NEAR_POSITION)ですか、deg(SET_NEAR_ANGLE)ですか?";

    // MESSAGE.
    Semicolon
        "`;` ends a MESSAGE since 3.0: which character should stand here instead?",
        "3.0から `;` はMESSAGEの終わりです。代わりにどの文字にしますか?";
    PlainText { name: String }
        "`%{name}%` was plain text and shows a value since 3.0: which one is meant?",
        "`%{name}%` は文字のままでしたが、3.0からは値を表示します。どちらですか?";
    Placeholder { old: String, new: String }
        "in a MESSAGE, {old} is {new} since 3.0",
        "MESSAGEの中の{old}は3.0から{new}です";

    // Names.
    Label { name: String, new: String }
        "the label {name} becomes {new}: {name} is a word of the language in 3.1",
        "ラベル{name}を{new}にします。{name}は3.1の予約語です";
    WordOfLanguage { word: String }
        "{word} is a word of the language in 3.1: what should the variable be called?",
        "{word}は3.1の予約語です。変数を何という名前にしますか?";
    Declares { line: Text, declared: Declared }
        "put in `{line}`{declared}",
        "`{line}` を入れます{declared}";
    OneVariable { old: String, name: String }
        "{old} and {name} are one variable by their number: written {name}",
        "{old}と{name}は番号から同じ変数です。{name}と書きます";
    NoNumber { name: String }
        "{name} has no number: which variable is meant?",
        "{name}に番号がありません。どの変数ですか?";
    NameTooLong { most: usize, name: String, length: usize }
        "a name has at most {most} bytes, {name} has {length}: what should the variable be called?",
        "名前は{most}バイトまでですが、{name}は{length}バイトあります。変数を何という名前にしますか?";

    // The last look.
    NoEnd
        "the program has no END: where does it end?",
        "プログラムにENDがありません。どこで終わりますか?";
    NoCommand { word: String }
        "{word} is not a command of version 3.1: what is meant?",
        "{word}は3.1のコマンドではありません。何のことですか?";
    NoStatement { title: Text, reason: Box<Message> }
        "this is not a statement of version 3.1 ({title}: {reason}): what is meant?",
        "これは3.1の文ではありません({title}: {reason})。何のことですか?";

    // The sentence at the end of the report.
    AlreadyCurrent { file: Text, version: Edition }
        "{file}: is a program of version {version} already, nothing is changed",
        "{file}: すでにバージョン{version}のプログラムです。何も変えません";
    Migrated { file: Text, changes: Changes, loads: Loads }
        "{file}: {changes}, {loads}",
        "{file}: {changes}、{loads}";
    ToAnswer { file: Text, questions: Questions }
        "{file}: {questions} to answer first, nothing is written",
        "{file}: 先に{questions}に答えてください。何も書いていません";
}
