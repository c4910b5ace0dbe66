//! What a debugger says.

use tipc::message::Text;

tipc::message_table! {
    /// What a debugger says.
    Debugging;

    // Titles.
    Variables
        "Variables",
        "変数";
    Calls
        "Calls",
        "呼び出し";
    Legs
        "Modes and targets",
        "制御モードと目標";
    Above
        "From above",
        "上面図";
    Side
        "From the side",
        "側面図";
    Said
        "Messages",
        "メッセージ";
    Unassigned
        "unassigned",
        "未代入";
    MainProgram
        "(program)",
        "(本体)";

    // How a leg is controlled.
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

    // Why it stands.
    Start
        "at the beginning",
        "先頭です";
    Stepped
        "stands",
        "停止中";
    There
        "there",
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
    Ended
        "the program is over",
        "プログラムは終了しました";
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

    // What is asked.
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
        "variable: who set it last?",
        "変数(最後に代入した箇所へ戻ります)";
    AskCycle
        "cycle",
        "サイクル";
    AskCondition { line: u32 }
        "condition of the breakpoint on line {line} (empty: none)",
        "{line}行目のブレークポイントの条件(空欄で無条件)";
    AskPasses
        "which passes stop it: 5, >= 5, % 5 (empty: each)",
        "停止する通過回数: 5、>= 5、% 5(空欄で毎回)";
    AskName
        "command, label or routine to stop before; again: not any more",
        "直前で停止するコマンド、ラベル、ルーチン(再入力で解除)";
    AskDiscard { count: usize }
        "{count} cycles that have been run after this one would be discarded: y or n",
        "これより後の{count}サイクルの実行結果は破棄されます。よろしいですか(y/n)";

    // What is answered.
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
        "stops before {name} no more",
        "{name}の直前では停止しません";
    NotANumber { text: Text }
        "`{text}` is not a cycle",
        "`{text}` はサイクル番号ではありません";
    NeitherEventNorAssignment { text: Text }
        "`{text}` is not an event, such as `key F`, `VR1=8`, `halt` or `N = 5`",
        "`{text}` はイベントではありません。`key F`、`VR1=8`、`halt`、`N = 5` のように書いてください";

    // Why it does not do what it is asked.
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
        "{cycles} cycles have been run after this one, and would be discarded",
        "これより後の{cycles}サイクルの実行結果が破棄されます";
    NoInput { port: Text }
        "the robot has no input {port}",
        "このロボットに入力 {port} はありません";
    Massless { event: Text }
        "'{event}' is for walking robots with mass: --plant dynamic",
        "'{event}' は質量のある歩行ロボット用です(--plant dynamic)";

    HelpMoves
        "r run, n over, s into, o out, c cycle, l to line, g to cycle, CAPITALS: back",
        "r:実行 n:次へ s:中へ o:外へ c:1サイクル l:行まで g:サイクル指定 大文字:逆方向";
    HelpOthers
        "b break, B when, f name, w watch, W who set, i event, e value, ↑↓ ., Esc, q",
        "b:ブレーク B:条件 f:名前 w:監視 W:代入元 i:イベント e:式 ↑↓ .:行 Esc:中断 q:終了";
}
