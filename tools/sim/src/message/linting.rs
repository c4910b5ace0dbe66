//! The texts of lints that need the robot itself: its reach, and the SPECIALs that it answers.

use tip_runtime::command::Target;
use tipc::message::list::List;

tipc::message_table! {
    /// Reasons and helps of such lints.
    Linting;

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
    LeavesReach { target: Target, x: f64, y: f64, z: f64 }
        "the straight path of {target} leaves its reach near {x} {y} {z}",
        "{target}の直線経路が{x} {y} {z}付近で可動範囲を外れます";
    GoAround
        "go around in two moves: put a PTP and a WAIT_INPOS before it",
        "手前にPTPとWAIT_INPOSを入れ、2回に分けて回り込んでください";
    ChooseNearer
        "choose a place nearer to the base of the leg; positions are mm in the robot's frame",
        "脚の付け根に近い位置にしてください。位置はロボット座標系で、単位はmmです";
    SlidesNotThere
        "the slider does not go there",
        "スライダはそこまで動きません";
    SlidesFromTo { axis: &'static str, min: f64, max: f64 }
        "along {axis} it goes from {min} to {max} mm",
        "{axis}方向の可動範囲は{min} mmから{max} mmまでです";
}
