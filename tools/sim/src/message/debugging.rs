//! Messages of a debugger.

use tipc::message::Text;

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
    Ended
        "the program is over",
        "プログラムは終了しました";

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
        "later cycles that would be discarded: {cycles}",
        "これより後の{cycles}サイクルの実行結果が破棄されます";
    NoInput { port: Text }
        "the robot has no input {port}",
        "このロボットに入力 {port} はありません";
    Massless { event: Text }
        "'{event}' is for walking robots with mass: --plant dynamic",
        "'{event}' は質量のある歩行ロボット用です(--plant dynamic)";
}
