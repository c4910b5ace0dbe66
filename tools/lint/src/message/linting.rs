//! The texts of lints, and of comments that silence them.

use smol_str::SmolStr;
use tip_runtime::command::Target;
use tipc::language::Keyword;
use tipc::message::list::{Pieces, Quoted};
use tipc::message::phrase::{Assign, Type};

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
