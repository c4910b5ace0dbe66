//! The one table of every key of a description, a scene or `tip.toml`. Unknown keys, suggestions, help texts and the table in docs/robots.md come from it.

use crate::code::Code;
use crate::language::Bilingual;
use crate::message::phrase::Table;

/// A table of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Keys above the first table.
    Robot,
    /// `[[joint]]`, or `[[leg.joint]]`.
    Joint,
    /// `[[leg]]`.
    Leg,
    /// `[body]`.
    Body,
    /// `[standards]`.
    Standards,
    /// `[forces]`.
    Forces,
    /// `[slider]`.
    Slider,
    /// `[[shape]]` of a joint or the body.
    Shape,
    /// `[bus]`.
    Bus,
    /// `[[drive]]`.
    Drive,
    /// Keys above the first table of a scene.
    Scene,
    /// `[floor]` of a scene.
    Floor,
    /// `[[object]]` of a scene.
    Object,
    /// `[[block]]` of a scene.
    Block,
    /// Keys above the first table of `tip.toml`.
    Project,
    /// `[[programs]]` of `tip.toml`.
    Programs,
}

impl Part {
    /// Every table of a description, in the order of the documentation.
    pub const ALL: &'static [Part] = &[
        Part::Robot,
        Part::Joint,
        Part::Leg,
        Part::Body,
        Part::Standards,
        Part::Forces,
        Part::Slider,
        Part::Shape,
        Part::Bus,
        Part::Drive,
    ];

    /// Every table of a scene, in the order of the documentation.
    pub const SCENE: &'static [Part] = &[Part::Scene, Part::Floor, Part::Object, Part::Block];

    /// Every table of `tip.toml`, in the order of the documentation.
    pub const PROJECT: &'static [Part] = &[Part::Project, Part::Programs];

    /// Returns the tables of the same file.
    pub(super) fn same_file(self) -> &'static [Part] {
        if Part::SCENE.contains(&self) {
            Part::SCENE
        } else if Part::PROJECT.contains(&self) {
            Part::PROJECT
        } else {
            Part::ALL
        }
    }

    /// Returns the code of what is wrong with its file.
    pub(super) fn code(self) -> Code {
        if Part::SCENE.contains(&self) {
            Code::Scene
        } else if Part::PROJECT.contains(&self) {
            Code::Project
        } else {
            Code::Description
        }
    }

    /// Returns its name in messages.
    pub(super) fn table(self) -> Table {
        match self {
            Part::Robot => Table::Robot,
            Part::Scene => Table::Scene,
            Part::Project => Table::Project,
            part => Table::Named { name: part.name() },
        }
    }

    /// Returns its name in the file; nothing for what is above the first table.
    pub const fn name(self) -> &'static str {
        match self {
            Part::Robot | Part::Scene | Part::Project => "",
            Part::Joint => "[[joint]]",
            Part::Leg => "[[leg]]",
            Part::Body => "[body]",
            Part::Standards => "[standards]",
            Part::Forces => "[forces]",
            Part::Slider => "[slider]",
            Part::Shape => "[[shape]]",
            Part::Bus => "[bus]",
            Part::Drive => "[[drive]]",
            Part::Floor => "[floor]",
            Part::Object => "[[object]]",
            Part::Block => "[[block]]",
            Part::Programs => "[[programs]]",
        }
    }

    /// Returns its keys.
    pub fn keys(self) -> impl Iterator<Item = &'static Key> {
        KEYS.iter().filter(move |key| key.part == self)
    }

    /// Returns the key of that name.
    pub(super) fn key(self, name: &str) -> Option<&'static Key> {
        self.keys().find(|key| key.name == name)
    }
}

/// A key of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Part of the file where it may appear.
    pub part: Part,
    /// Its name.
    pub name: &'static str,
    /// Form of its value.
    pub form: Bilingual,
    /// Default value; `None` if the key is required.
    pub default: Option<&'static str>,
    /// Meaning of the key.
    pub meaning: Bilingual,
}

impl Key {
    /// Returns the unit of its numbers; empty if they have none.
    pub fn unit(&self) -> &'static str {
        let form = self.form.english;
        match form.split_once(" in ") {
            Some((_, unit)) => unit.split_once(',').map_or(unit, |(unit, _)| unit),
            None if form.starts_with("[deg") => "deg",
            None => "",
        }
    }
}

macro_rules! keys {
    ($(
        $part:ident $name:literal, $form:literal / $form_ja:literal, $default:expr, $meaning:literal / $meaning_ja:literal;
    )*) => {
        /// Every key.
        pub const KEYS: &[Key] = &[$( Key {
            part: Part::$part,
            name: $name,
            form: Bilingual { english: $form, japanese: $form_ja },
            default: $default,
            meaning: Bilingual { english: $meaning, japanese: $meaning_ja },
        }, )*];
    };
}

keys! {
    Robot "name", "a text" / "文字列", None, "what programs, messages and traces call the robot: letters, digits, blanks, `-`, `_`, `.`" / "プログラム、メッセージ、トレースで使うロボットの名前(英数字、空白、`-`、`_`、`.`)";
    Robot "joint", "a list of [[joint]] tables" / "[[joint]]表の並び", Some("none"), "the joints of every leg that has none of its own, from base to foot" / "独自の関節を持たない全ての脚の関節(根元から足先の順)";
    Robot "leg", "a list of [[leg]] tables" / "[[leg]]表の並び", None, "the legs, F1 first: 1 to 9, each with the same number of joints" / "脚(F1から順に1本から9本まで。関節数はすべて同じ)";
    Robot "initial", "[deg, …], a number for each joint" / "[deg, …](関節ごとに1つの数値)", Some("the middle of each joint's limits"), "the initial posture of every leg that has none of its own" / "独自の初期姿勢を持たない全ての脚の初期姿勢";
    Robot "inverse", "\"yaw-pitch-pitch\", \"roll-pitch-pitch\", \"planar\" or \"least-squares\"" / "\"yaw-pitch-pitch\"、\"roll-pitch-pitch\"、\"planar\"、\"least-squares\" のいずれか", Some("the first of the four that fits the legs"), "how joint angles follow from a foot's position" / "足先の位置から関節角度を求める方法";
    Robot "body", "a [body] table" / "[body]表", Some("none: the robot is bolted down"), "the body of a robot that walks" / "歩行ロボットの胴体";
    Robot "standards", "a [standards] table" / "[standards]表", Some("the values below"), "what parameter commands set, at its standard value" / "パラメータ設定コマンドの標準値";
    Robot "forces", "a [forces] table" / "[forces]表", Some("none: no command of torque, force or compliance"), "that the robot senses and gives torques" / "ロボットがトルクを計測し、発生できること";
    Robot "slider", "a [slider] table" / "[slider]表", Some("none: no `FLOOR`"), "a slider that carries the floor" / "床を載せて動くスライダ";
    Robot "periods", "[min, max] in ms" / "ms単位の[最小, 最大]", Some("[1, 1000]"), "the sampling times that it accepts" / "受け付けるサンプリング時間";
    Robot "contact", "a number in V" / "V単位の数値", Some("0.25"), "the reading of a sole from which its foot stands on something" / "足裏センサがこの値以上なら接地とみなす";
    Robot "lamps", "a whole number, 0 to 255" / "0から255までの整数", Some("16"), "how many lamps and relays it has" / "ランプとリレーの数";
    Robot "may_touch", "a list of pairs such as [\"link12\", \"body\"], 32 at most" / "[\"link12\", \"body\"] のような組の並び(32組まで)", Some("none"), "parts that may touch: no collisions of them are reported" / "触れてもよい部分の組(干渉として報告しない)";
    Robot "bus", "a [bus] table" / "[bus]表", Some("none: the robot is only simulated"), "the bus of the real robot's servos" / "実機のサーボをつなぐバス";
    Robot "drive", "a list of [[drive]] tables" / "[[drive]]表の並び", Some("none"), "the servo of each joint, where there is a bus" / "バスがある場合の各関節のサーボ";

    Joint "axis", "\"x\", \"-y\", … or [x, y, z]" / "\"x\"、\"-y\" など、または [x, y, z]", None, "the axis of the joint, right-handed, in the frame of the link before" / "前のリンクの座標系で表した関節の軸(右ねじの向き)";
    Joint "link", "[x, y, z] in mm" / "mm単位の[x, y, z]", None, "from this joint to the next, or to the foot, at angle 0" / "角度0のときの、この関節から次の関節(または足先)までのベクトル";
    Joint "limits", "[min, max] in deg" / "度単位の[最小, 最大]", Some("[-180, 180]"), "the working limits" / "可動範囲";
    Joint "outer", "[min, max] in deg" / "度単位の[最小, 最大]", Some("5 beyond the limits"), "the limits of the potentiometer, beyond which nothing may move" / "ポテンショメータの限界(これを超えて動いてはならない)";
    Joint "mass", "a number in kg" / "kg単位の数値", Some("0.1"), "the mass of the link" / "リンクの質量";
    Joint "centre", "[x, y, z] in mm" / "mm単位の[x, y, z]", Some("the middle of the link"), "the link's centre of mass, from the joint, at angle 0" / "角度0のときの、関節から見たリンクの重心";
    Joint "inertia", "[xx, yy, zz, xy, xz, yz] in kg·m²" / "kg·m²単位の[xx, yy, zz, xy, xz, yz]", Some("a uniform rod's"), "the link's tensor of inertia about its centre of mass, at angle 0, along x, y and z of the robot frame; elements and signs are those of URDF" / "角度0のときの、重心まわりのリンクの慣性テンソル(ロボット座標系のx、y、z軸。要素と符号はURDFと同じ)";
    Joint "radius", "a number in mm" / "mm単位の数値", Some("that of a shape along the link, else 5 % of its length"), "the radius of the link, a capsule, where it may meet other links and the body" / "リンクをカプセルとみなすときの半径(ほかのリンクや胴体との干渉の判定に使う)";
    Joint "torque", "a number in N·m" / "N·m単位の数値", Some("10"), "the most that the motor gives" / "モータの最大トルク";

    Joint "shape", "a list of [[joint.shape]] tables" / "[[joint.shape]]表の並び", Some("drawn as a rod with a ball at its joint"), "what exported files show of the link, and collide with; simulations look at its radius only" / "書き出すファイルに載せるリンクの形状(本ツールのシミュレーションで使うのは半径のみ)";

    Leg "base", "[x, y, z] in mm" / "mm単位の[x, y, z]", None, "the first joint in the robot frame" / "ロボット座標系での最初の関節の位置";
    Leg "turn", "a number in deg" / "度単位の数値", Some("0"), "turns the joints about z, counterclockwise seen from above" / "関節全体をz軸まわりに回す角度(上から見て反時計回り)";
    Leg "mirror", "letters of \"x\", \"y\", \"z\"" / "\"x\"、\"y\"、\"z\" を組み合わせた文字列", Some("\"\""), "then mirrors them: \"x\" makes a right leg a left one; equal angles are mirrored postures" / "その後の鏡映(\"x\" で右脚が左脚になる。同じ角度は鏡映の姿勢になる)";
    Leg "initial", "[deg, …], a number for each joint" / "[deg, …](関節ごとに1つの数値)", Some("that of the robot"), "the initial posture" / "初期姿勢";
    Leg "joint", "a list of [[leg.joint]] tables" / "[[leg.joint]]表の並び", Some("the [[joint]] tables of the robot"), "the joints of this leg, from base to foot" / "この脚の関節(根元から足先の順)";

    Body "x", "[min, max] in mm" / "mm単位の[最小, 最大]", None, "the extent of the body along x" / "x方向の胴体の範囲";
    Body "y", "[min, max] in mm" / "mm単位の[最小, 最大]", None, "along y" / "y方向";
    Body "z", "[min, max] in mm" / "mm単位の[最小, 最大]", None, "along z; the lower end is the belly" / "z方向(下端が腹)";
    Body "mass", "a number in kg" / "kg単位の数値", Some("1"), "the mass without legs" / "脚を除いた質量";
    Body "centre", "[x, y, z] in mm" / "mm単位の[x, y, z]", Some("the origin"), "the centre of mass without legs" / "脚を除いた重心";
    Body "inertia", "[xx, yy, zz, xy, xz, yz] in kg·m²" / "kg·m²単位の[xx, yy, zz, xy, xz, yz]", Some("a uniform box's"), "the tensor of inertia without legs, about the centre of mass" / "脚を除いた、重心まわりの慣性テンソル";

    Body "shape", "a list of [[body.shape]] tables" / "[[body.shape]]表の並び", Some("a box of these extents"), "what exported files show of the body, and collide with; no simulation here looks at it" / "書き出すファイルに載せる胴体の形状(本ツールのシミュレーションでは使わない)";

    Standards "v_max", "a number in mm/s" / "mm/s単位の数値", Some("300"), "`V_MAX`" / "`V_MAX`";
    Standards "a_max", "a number in mm/s²" / "mm/s²単位の数値", Some("600"), "`A_MAX`" / "`A_MAX`";
    Standards "omega_max", "a number in deg/s" / "deg/s単位の数値", Some("90"), "`OMEGA_MAX`" / "`OMEGA_MAX`";
    Standards "omega_dot_max", "a number in deg/s²" / "deg/s²単位の数値", Some("360"), "`OMEGA_DOT_MAX`" / "`OMEGA_DOT_MAX`";
    Standards "just_position", "a number in mm" / "mm単位の数値", Some("2"), "`JUST_POSITION`" / "`JUST_POSITION`";
    Standards "just_angle", "a number in deg" / "度単位の数値", Some("1"), "`JUST_ANGLE`" / "`JUST_ANGLE`";
    Standards "near_position", "a number in mm" / "mm単位の数値", Some("10"), "`NEAR_POSITION`" / "`NEAR_POSITION`";
    Standards "near_angle", "a number in deg" / "度単位の数値", Some("5"), "`NEAR_ANGLE`" / "`NEAR_ANGLE`";
    Standards "period", "a number in ms" / "ms単位の数値", Some("20"), "the sampling time" / "サンプリング時間";

    Forces "unit", "\"N·m\" or \"mN·m\"" / "\"N·m\" または \"mN·m\"", Some("\"N·m\""), "the unit of every torque that is commanded or sensed" / "指令および計測されるトルクの単位";
    Forces "torque_max", "a torque, a number" / "トルクの数値", Some("the torque of the strongest joint"), "`TORQUE_MAX`" / "`TORQUE_MAX`";
    Forces "angle_stiffness", "torque per deg, a number" / "1度あたりのトルクの数値", Some("2 N·m/deg"), "`ANGLE_STIFFNESS`" / "`ANGLE_STIFFNESS`";
    Forces "position_stiffness", "a number in N/mm" / "N/mm単位の数値", Some("1"), "`POSITION_STIFFNESS`, along each axis" / "各軸方向の `POSITION_STIFFNESS`";

    Slider "initial", "[x, y, z] in mm" / "mm単位の[x, y, z]", None, "where it stands at first" / "最初の位置";
    Slider "x", "[min, max] in mm" / "mm単位の[最小, 最大]", Some("it stays"), "how far it goes along x" / "x方向に動く範囲";
    Slider "y", "[min, max] in mm" / "mm単位の[最小, 最大]", Some("it stays"), "along y" / "y方向";
    Slider "z", "[min, max] in mm" / "mm単位の[最小, 最大]", Some("it stays"), "along z" / "z方向";

    Shape "block", "[x, y, z] in mm" / "mm単位の[x, y, z]", Some("`cylinder` or `sphere` must be there"), "that it is a block with these sides" / "この寸法の直方体であること";
    Shape "cylinder", "[radius, length] in mm" / "mm単位の[半径, 長さ]", Some("`block` or `sphere` must be there"), "that it is a cylinder, along z" / "z方向の円柱であること";
    Shape "sphere", "a number in mm" / "mm単位の数値", Some("`block` or `cylinder` must be there"), "that it is a sphere of this radius" / "この半径の球であること";
    Shape "at", "[x, y, z] in mm" / "mm単位の[x, y, z]", Some("the origin"), "its middle: from the joint, at angle 0, or in the robot frame" / "中心の位置(角度0のときの関節から見た位置。胴体ではロボット座標系)";
    Shape "turned", "[roll, pitch, yaw] in deg" / "度単位の[ロール, ピッチ, ヨー]", Some("[0, 0, 0]"), "how it is turned about x, then y, then z of the robot frame" / "ロボット座標系のx軸、y軸、z軸の順に回した角度";

    Bus "port", "a text" / "文字列", Some("the option `--port` must be there"), "the serial port, such as \"/dev/ttyUSB0\"; \"simulated\" for servos without hardware" / "シリアルポート(例: \"/dev/ttyUSB0\")。\"simulated\" なら実機なしの模擬サーボ";
    Bus "servo", "a text" / "文字列", Some("every drive has a `model`"), "the model of every drive that has none of its own" / "`model` のない全ての駆動軸のサーボ型名";
    Bus "baud", "a whole number, 9600 to 4500000" / "9600から4500000までの整数", Some("1000000"), "the speed of the bus, bits per second; LX servos have 115200" / "バスの通信速度(ビット毎秒)。LXサーボは115200";
    Bus "latency", "a number in ms" / "ms単位の数値", Some("4"), "the most that adapter and driver add to an answer" / "アダプタとドライバによる応答の遅れの上限";
    Bus "answers", "\"each\" or \"together\"" / "\"each\" または \"together\"", Some("each"), "whether servos of Dynamixel protocol 2 answer one after the other or in one frame" / "Dynamixelプロトコル2のサーボが1台ずつ応答するか、まとめて1フレームで応答するか";
    Bus "silence", "a whole number, 0 to 1000" / "0から1000までの整数", Some("5"), "how many cycles old a servo's last answer may be before the emergency stop; its angle stands for the missing ones" / "サーボの最後の応答から許す周期数(その間は最後の角度を使い、超えると非常停止)";
    Bus "temperature", "a number in °C" / "°C単位の数値", Some("65"), "the hottest that a servo may be" / "サーボの温度の上限";
    Bus "voltage", "[min, max] in V" / "V単位の[最小, 最大]", Some("[6, 15]"), "the supply voltage that the servos may measure" / "サーボが測る電源電圧の範囲";
    Bus "overload", "[load, s]" / "[負荷, 秒]", Some("[0.9, 0.5]"), "how much of the stall torque a joint may need for longer than this time" / "関節の負荷(停動トルクに対する割合)の上限と、超えてよい時間";
    Bus "lag", "[deg, s]" / "[度, 秒]", Some("[25, 0.5]"), "how far a joint may stay behind its command for longer than this time" / "関節が指令から遅れてよい角度と、超えてよい時間";
    Bus "start", "a number in deg/s" / "deg/s単位の数値", Some("30"), "how fast joints move to the initial posture before the program starts" / "プログラム開始前に初期姿勢へ動く速さ";
    Bus "at_end", "\"hold\" or \"relax\"" / "\"hold\" または \"relax\"", Some("hold"), "what the servos do when the program has ended" / "プログラム終了後のサーボの動作";
    Bus "in_emergency", "\"hold\" or \"relax\"" / "\"hold\" または \"relax\"", Some("hold"), "what the servos do in an emergency" / "非常停止時のサーボの動作";
    Bus "collisions", "\"stop\" or \"warn\"" / "\"stop\" または \"warn\"", Some("stop"), "reaction to a command to a posture in which two parts of the robot overlap: the emergency stop before it is sent, or a warning" / "ロボットの部分どうしが重なる姿勢が指令されたときの動作(送信前に非常停止、または警告)";
    Bus "hold_to_drive", "true or false" / "trueまたはfalse", Some("true"), "whether the page of `tip serve --hardware` drives the robot only while a button is held" / "`tip serve --hardware` のページで、ボタンを押している間だけ操縦できるかどうか";
    Bus "driver_silence", "[pause, halt, emergency] in s" / "秒単位の[一時停止, 停止要求, 非常停止]", Some("[0.3, 3, 10]"), "how long that page may be silent before the robot pauses with its sticks at rest, before the program is asked to halt, and before the emergency stop (3600 at most); with `hold_to_drive = false` it does not pause" / "操縦するページからの通信が途絶えてから、スティックを中立にして一時停止するまで、プログラムに停止を要求するまで、非常停止するまでの時間(最大3600。`hold_to_drive = false` では一時停止しない)";

    Drive "joint", "a text" / "文字列", None, "the joint: J11 to J99, leg and joint" / "関節(J11からJ99。脚と関節の番号)";
    Drive "id", "a whole number, 0 to 252" / "0から252までの整数", None, "the servo's identity on the bus" / "バス上のサーボのID";
    Drive "model", "a text" / "文字列", Some("`servo` of the bus"), "the servo's model, such as \"AX-12\", \"XL430-W250\", \"STS3215\" or \"LX-16A\"" / "サーボの型名(例: \"AX-12\"、\"XL430-W250\"、\"STS3215\"、\"LX-16A\")";
    Drive "sign", "1 or -1" / "1または-1", Some("1"), "which way the motor turns when the joint's angle grows" / "関節角度が増えるときのモータの回転方向";
    Drive "offset", "a number in deg" / "度単位の数値", Some("0"), "the motor angle, from the middle of its travel, when the joint is at 0; `tip drives zero` finds it" / "関節角度0のときの、可動範囲の中央から測ったモータ角度(`tip drives zero` で求める)";
    Drive "gear", "a number" / "数値", Some("1"), "turns of the motor for each turn of the joint" / "関節1回転あたりのモータの回転数";
    Drive "limits", "[min, max] in deg" / "度単位の[最小, 最大]", Some("the limits of the joint"), "the joint angles that are commanded" / "指令する関節角度の範囲";
    Drive "speed", "a number in deg/s" / "deg/s単位の数値", Some("180"), "the fastest that the joint is commanded" / "関節に指令する速さの上限";
    Drive "torque", "a number, 1 at most" / "1以下の数値", Some("1"), "the torque limit, as a part of the servo's full torque; LX servos have none" / "トルク制限(サーボの最大トルクに対する割合)。LXサーボにはない";

    Scene "plant", "\"quasi-static\" or \"dynamic\"" / "\"quasi-static\" または \"dynamic\"", Some("quasi-static"), "how a walking robot is simulated; the option `--plant` wins" / "歩行ロボットのシミュレーション方法(`--plant` オプションが優先)";
    Scene "floor", "a [floor] table" / "[floor]表", Some("level, friction 0.5"), "what carries the objects, or a walking robot" / "物体や歩行ロボットを載せる床";
    Scene "object", "a list of [[object]] tables" / "[[object]]表の並び", Some("none"), "what a hand may grasp: 4 at most" / "ハンドが把持する物体(4個まで)";

    Scene "block", "a list of [[block]] tables" / "[[block]]表の並び", Some("none"), "steps and obstacles for a walking robot with mass: 8 at most; with one it has mass, unless `plant` says otherwise" / "質量のある歩行ロボット用の段差と障害物(8個まで。1個でもあれば、`plant` で指定しない限り質量ありになる)";

    Floor "height", "a number in mm" / "mm単位の数値", Some("0"), "above the slider of a hand" / "ハンドのスライダからの高さ";
    Floor "slope", "[x, y], mm for each mm" / "1 mmあたりのmmで表した[x, y]", Some("[0, 0]"), "how it rises; under a hand along x only" / "傾き(ハンドではx方向のみ)";
    Floor "friction", "a number" / "数値", Some("0.5"), "its coefficient of friction; feet of quasi-static robots do not slip" / "摩擦係数(質量なしの歩行ロボットの足は滑らない)";

    Object "size", "[width, height] in mm" / "mm単位の[幅, 高さ]", Some("`radius` must be there"), "that it is a box, or an upright cylinder" / "直方体または直立した円柱であること";
    Object "radius", "a number in mm" / "mm単位の数値", Some("`size` must be there"), "that it is a disc: a cylinder that lies along z" / "円板(z方向に寝た円柱)であること";
    Object "mass", "a number in kg, 0.001 or more" / "kg単位の数値(0.001以上)", None, "its mass" / "質量";
    Object "friction", "a number" / "数値", Some("0.5"), "its coefficient of friction; where two things touch the smaller one counts" / "摩擦係数(接触する2つのうち小さい方が効く)";
    Object "x", "a number in mm" / "mm単位の数値", Some("0"), "where its centre is at first" / "最初の中心の位置";
    Object "y", "a number in mm" / "mm単位の数値", Some("it stands on the floor"), "where its centre is at first" / "最初の中心の位置";
    Object "angle", "a number in deg" / "度単位の数値", Some("0"), "how far it is turned at first, from x to y" / "最初の回転角(xからyへ)";

    Block "x", "[min, max] in mm" / "mm単位の[最小, 最大]", None, "from where to where it goes along x, in the world" / "世界座標系でのx方向の範囲";
    Block "y", "[min, max] in mm" / "mm単位の[最小, 最大]", None, "along y" / "y方向";
    Block "height", "a number in mm" / "mm単位の数値", None, "its upper side, above the world's origin" / "世界座標の原点から測った上面の高さ";

    Project "robot", "a robot's name, or a description's \"FILE.toml\"" / "ロボットの名前、または記述ファイルのパス \"FILE.toml\"", Some("titan8"), "the robot of the programs in this folder and below" / "このフォルダ以下のプログラムのロボット";
    Project "encoding", "\"auto\", \"utf-8\" or \"shift_jis\"" / "\"auto\"、\"utf-8\"、\"shift_jis\" のいずれか", Some("auto"), "how their files spell text" / "ファイルの文字コード";
    Project "scene", "\"cylinder\", or a scene's \"FILE.toml\"" / "\"cylinder\"、または環境ファイルのパス \"FILE.toml\"", Some("a level floor"), "what surrounds the robot when they run" / "実行時のロボットの周囲";
    Project "programs", "a list of [[programs]] tables" / "[[programs]]表の並び", Some("none"), "programs with settings of their own; of several that mean a program the last one counts" / "独自の設定を持つプログラム(複数が当てはまるときは最後のものが有効)";

    Programs "files", "a pattern: `*` is any name, `**` any folders" / "パターン(`*` は任意の名前、`**` は任意のフォルダ)", None, "which programs, by their paths from this folder on" / "このフォルダからのパスで表したプログラムの範囲";
    Programs "robot", "a robot's name, or a description's \"FILE.toml\"" / "ロボットの名前、または記述ファイルのパス \"FILE.toml\"", Some("that of all programs"), "their robot" / "そのロボット";
    Programs "encoding", "\"auto\", \"utf-8\" or \"shift_jis\"" / "\"auto\"、\"utf-8\"、\"shift_jis\" のいずれか", Some("that of all programs"), "how their files spell text" / "ファイルの文字コード";
    Programs "scene", "\"cylinder\", or a scene's \"FILE.toml\"" / "\"cylinder\"、または環境ファイルのパス \"FILE.toml\"", Some("that of all programs"), "what surrounds the robot when they run" / "実行時のロボットの周囲";
}
