//! Messages about the drives of a real robot.

use tipc::message::Text;

tipc::message_table! {
    /// Messages of `tip drives` and of runs on a real robot.
    Driving;

    NoBus { file: Text }
        "{file} has no [bus]: docs/drives.md shows how to describe the servos",
        "{file}に[bus]がありません。サーボの書き方はdocs/drives.mdにあります";
    NoPort { file: Text }
        "which port? Give --port /dev/ttyUSB0, or `port` under [bus] of {file}",
        "ポートを指定してください(--port /dev/ttyUSB0、または{file}の[bus]の `port`)";
    CannotOpen { port: Text, error: Text }
        "cannot open {port}: {error}. Is it plugged in, used by another program, or yours to open (group dialout)?",
        "{port}を開けません: {error}。接続、他のプログラムによる使用、権限(dialoutグループ)を確かめてください";
    NoSimulatedPort
        "'simulated' needs the servos of a robot.toml: start `tip drives simulate robot.toml`, and give the port that it prints",
        "'simulated' にはrobot.tomlのサーボが必要です。`tip drives simulate robot.toml` を起動し、表示されるポートを指定してください";
    NotSimulated { text: String }
        "`{text}` is not a list of faults: write faults=0.01 (or corrupt, drop, duplicate, delay, truncate) and unplug=ID@S (or reset, overheat, block, sag), separated by commas",
        "`{text}` は故障の並びではありません。faults=0.01(または corrupt、drop、duplicate、delay、truncate)と unplug=ID@S(または reset、overheat、block、sag)をコンマで区切ってください";
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
    PressReturn
        "keep clear; RETURN starts, Ctrl-C ends",
        "ロボットから離れてください。RETURNで開始、Ctrl-Cで終了します";
    NoSuchJoint { joint: String }
        "the robot has no joint {joint}",
        "関節{joint}はありません";
    Found { servos: usize }
        "{servos} servos found",
        "サーボが{servos}台見つかりました";
    NothingFound
        "no servo answers: look at power, wiring, --baud and --family",
        "応答するサーボがありません。電源、配線、--baud、--familyを確かめてください";
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
    AtZero { joint: String }
        "{joint} at 0",
        "{joint}を角度0に";
    AtPositive { joint: String }
        "{joint} a little in its positive direction",
        "{joint}を正の向きに少し";
    NotTurned
        "it has turned by less than 3 deg; its sign stays",
        "3度以上回っていないので、符号は変えません";
    ZeroWritten { joints: String, file: Text }
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
        "{joint}: + and - turn it by 1 deg, q ends",
        "{joint}: +と-で1度ずつ動かし、qで終わります";
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
    OtherModel { joint: String, id: u32, number: u32, model: &'static str }
        "{joint} (servo {id}) reports the model number {number}, which is not that of {model}",
        "{joint}(サーボ{id})の型番{number}は{model}のものではありません";
    WrongMode { joint: String, id: u32, register: u32, value: u32, right: u32 }
        "{joint} (servo {id}) does not go to positions: its register {register} is {value}. Write {right} to it with the maker's tool while the torque is off (Operating Mode, or CCW Angle Limit of AX and MX)",
        "{joint}(サーボ{id})は位置制御モードではありません(レジスタ{register}の値は{value})。トルクを切り、製造元のツールで{right}を書き込んでください(Operating Mode、AX・MXではCCW Angle Limit)";
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
    Lags { joint: String, id: u32, angle: String, most: f64 }
        "{joint} (servo {id}) is {angle} deg away from its command, and {most} at most is allowed: is it blocked, weak or without torque?",
        "{joint}(サーボ{id})が指令から{angle}度離れ、上限{most}度を超えました。障害物、力不足、トルクなしを確かめてください";
    Outside { joint: String, id: u32, angle: String, min: f64, max: f64 }
        "{joint} (servo {id}) is at {angle} deg, outside of {min} to {max}: move it by hand, or look at sign and offset (tip drives zero)",
        "{joint}(サーボ{id})の角度{angle}度が範囲{min}から{max}の外です。手で動かすか、符号とオフセットを確かめてください(tip drives zero)";
    NoTorques { joint: String }
        "{joint} is commanded a torque, and position servos take angles only",
        "{joint}にトルクが指令されましたが、位置サーボは角度しか受け付けません";
}
