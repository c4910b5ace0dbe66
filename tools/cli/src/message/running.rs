//! What is said of a run on a simulated robot.

use super::count::Cycles;
use tip_runtime::command::Target;
use tip_sim::message::Awaited;
use tipc::language::Keyword;
use tipc::message::Text;

tipc::message_table! {
    /// What a run says of itself.
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
    StopsWaiting { wait: Waiting, time: String }
        "stopped after {time} s without a motion: {wait}; --cycles sets another end",
        "{time} s間動作がないため終了しました。{wait}。--cyclesで別の終わりを指定できます";
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
    AtMost { value: String }
        "{value} mm at most",
        "最大{value} mm";
    AtLeast { value: String }
        "{value} mm at least",
        "最小{value} mm";
    ZmpOutside { cycles: Cycles, by: String }
        "the zero moment point outside the feet in {cycles}, by {by} mm at most",
        "{cycles}でZMPが支持多角形の外、最大{by} mm";
    NoGrip { cycles: Cycles }
        "the feet would slip in {cycles}",
        "{cycles}で足が滑るはず";
    Crosses { cycles: Cycles }
        "legs or body in the floor, in a block or in each other in {cycles}",
        "{cycles}で脚か胴体が床や障害物の中、または脚どうしが重なり";
    Hurries { cycles: Cycles }
        "commanded to turn faster than its servo can in {cycles}",
        "{cycles}でサーボの最高速度を超える指令";
    Strays { cycles: Cycles, by: String }
        "a foot beside its path in {cycles}, by {by} mm at most",
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
    InTime
        "no cycle late",
        "遅れた周期なし";
    Late { late: String, all: String, worst: String }
        "{late} of {all} cycles late, {worst} ms at most",
        "{all}周期のうち{late}周期が遅れ、最大{worst} ms";
    Keys
        "keys: RETURN emergency stop, ESC halt, Ctrl-C end; others reach the program",
        "キー: RETURNは非常停止、ESCは停止要求、Ctrl-Cは終了。ほかのキーはプログラムに渡ります";
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
    Unsupported { time: String, cycle: String }
        "the robot lost its support after {time} s, in cycle {cycle}",
        "ロボットが{time} s、周期{cycle}で支えを失いました";
}

tipc::message_table! {
    /// How bad something is.
    Weight;

    Error "error", "エラー";
    Warning "warning", "警告";
}

tipc::message_table! {
    /// How a run ended.
    How;

    By { word: Keyword } "{word}", "{word}で終了";
    Emergency "emergency stop", "非常停止";
    Interrupted "interrupted", "中断";
    Limit "--cycles used up", "--cyclesの周期数に到達";
}

tipc::message_table! {
    /// What a line of the summary is about.
    Figure;

    Next "next", "次";
    Waits "waits", "待機";
    Travel "travel", "移動";
    Turn "turn", "旋回";
    Falls "falls", "転倒";
    Slip "slip", "滑り";
    Margin "margin", "余裕";
    Zmp "zmp", "動余裕";
    Grip "grip", "摩擦";
    Contact "contact", "干渉";
    Joint "joint", "関節";
    Path "path", "経路";
    Note "note", "注意";
    Lift "lift", "持上";
    Force "force", "力";
    Pace "pace", "周期";
}

tipc::message_table! {
    /// Where a robot went along its front.
    Along;

    Forward "forward", "前へ";
    Backward "backward", "後ろへ";
}

tipc::message_table! {
    /// To which side it went or turned.
    Aside;

    Right "to the right", "右へ";
    Left "to the left", "左へ";
}

tipc::message_table! {
    /// Where its body went.
    Upright;

    Up "up", "上へ";
    Down "down", "下へ";
}

tipc::message_table! {
    /// What a statement waits for.
    Until;

    Time "the time is over", "時間がたつまで";
    InPosition { target: Target } "{target} is within the JUST tolerance", "{target}がJUSTの許容範囲に入るまで";
    Near { target: Target } "{target} is within the NEAR tolerance", "{target}がNEARの許容範囲に入るまで";
    Key "a key is pressed", "キーが押されるまで";
    Motion "its motion is done", "動作が終わるまで";
    Touch "it feels a contact", "接触を感じるまで";
    Native "its native code is done", "ネイティブコードが終わるまで";
}

tipc::message_table! {
    /// The place, condition and duration of a wait.
    Waiting;

    Line { line: u32, what: Awaited, since: String, time: String }
        "line {line} waits for {what} since {since} s, for {time} s",
        "{line}行目が{what}を待っています({since} sから{time} s間)";
    Loop { first: u32, last: u32, what: Awaited, since: String, time: String }
        "lines {first} to {last} wait for {what} since {since} s, for {time} s",
        "{first}~{last}行目が{what}を待って繰り返しています({since} sから{time} s間)";
    Endless { first: u32, last: u32, since: String, time: String }
        "lines {first} to {last} repeat without a motion since {since} s, for {time} s",
        "{first}~{last}行目が動作のないまま繰り返しています({since} sから{time} s間)";
}
