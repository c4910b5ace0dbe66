//! What is said of a run that an emergency stop has ended.

use smol_str::SmolStr;
use tip_runtime::command::Target;
use tipc::message::list::List;

tipc::message_table! {
    /// Why a run has stopped.
    Stopping;

    // What the program did.
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
        "nothing called what returns here",
        "呼び出されていないのに戻ろうとしています";
    OtherMode
        "the target is under another control than this command needs",
        "対象の制御モードがこのコマンドに合いません";
    TooDeep
        "more than ten calls are open at once",
        "呼び出しの入れ子が10段を超えました";
    LeaveSubroutines
        "leave each SUBROUTINE with RETURN or SUBEND, and let none call itself",
        "SUBROUTINEからはRETURNかSUBENDで戻り、自分自身を呼ばないでください";
    NoStep
        "there is no such step",
        "そのようなステップはありません";

    // What the robot did.
    AtLimit { joint: Target, angle: f64, min: f64, max: f64 }
        "{joint} is at {angle} deg and cannot go on: its limits are {min} and {max} deg",
        "{joint}は現在{angle} degで、これ以上動けません。動作範囲は{min}から{max} degです";
    OutOfReach { target: Target }
        "{target} cannot reach its target, or a place on the way there",
        "{target}が目標か、その途中の位置に届きません";
    JointsAre { joints: List }
        "the joints and their limits in deg: {joints}",
        "関節の角度と動作範囲(deg): {joints}";
    Nonsense { sensor: SmolStr }
        "the sensor of {sensor} reads nonsense: see to it and its cable",
        "{sensor}のセンサの値が異常です。センサと配線を確かめてください";
    Broken { what: &'static str }
        "the hardware of the robot failed: {what}",
        "ロボットのハードウェアの異常です: {what}";
    KeyPressed
        "someone pressed RETURN, the emergency stop",
        "RETURNキー(非常停止)が押されました";

    // The moment, and its values.
    Moment { step: u32, cycle: SmolStr, time: SmolStr }
        "step {step}, cycle {cycle}, {time}",
        "ステップ{step}、サイクル{cycle}、{time}";
    Values { values: List } "{values}", "{values}";
}
