//! Messages about descriptions of robots, and about scenes.

use super::Text;
use super::list::List;
use super::phrase::{Joints, Kind, Table};
use super::say::Letter;
use crate::language::Bilingual;
use tip_runtime::command::Target;

messages! {
    /// Messages of the reader of descriptions and scenes.
    Describing;

    // Any table of the file.
    NotToml { error: Text } "{error}", "{error}";
    DescriptionsAreToml
        "the file is TOML: `key = value`, `[table]`, `[[one of many tables]]`",
        "ファイルはTOML形式です: `key = value`、`[table]`、`[[one of many tables]]`";
    Lacks { table: Table, key: &'static str }
        "{table} lacks `{key}`",
        "{table}に `{key}` がありません";
    KeyMeans { key: &'static str, form: Bilingual, meaning: Bilingual }
        "`{key}` is {form}: {meaning}",
        "`{key}` には{form}を書きます。意味は「{meaning}」です";
    KeyIs { key: String, form: Bilingual }
        "`{key}` is {form}",
        "`{key}` には{form}を書きます";
    NoKey { table: Table, key: String }
        "{table} has no key `{key}`",
        "{table}に `{key}` というキーはありません";
    BelongsTo { key: String, table: Table }
        "`{key}` belongs to {table}",
        "`{key}` は{table}のキーです";
    KeysOf { table: Table, keys: List }
        "the keys of {table} are {keys}",
        "{table}のキーは{keys}です";
    NumbersBelongHere { wanted: usize, found: usize }
        "{wanted} numbers belong here, and there are {found}",
        "ここには数値が{wanted}個必要ですが、{found}個あります";
    Above { min: f64, max: f64 }
        "{min} is above {max}",
        "{min}が{max}より大きくなっています";
    CannotBeThis { key: String }
        "`{key}` cannot be this",
        "`{key}` にこの値は使えません";
    NoFile { file: String }
        "there is no file `{file}`: paths begin at the folder of tip.toml",
        "`{file}` というファイルはありません。パスはtip.tomlのあるフォルダから書きます";
    OutOfReach { most: f64 }
        "a number from -{most} to {most} belongs here",
        "ここには-{most}から{most}までの数値を書きます";
    NotBelowZero
        "it cannot be below 0",
        "負の値は使えません";
    TooSmall { least: f64 }
        "no size is below {least} mm",
        "寸法は{least} mm以上です";
    Flat { least: f64 }
        "the first number and the second are less than {least} mm apart: what is there has a size, measure it",
        "1つ目と2つ目の数の差が{least} mm未満です。大きさのあるものなので、実測してください";
    AboveZero
        "it must be above 0",
        "0より大きい値が必要です";
    WrongKind { kind: Kind }
        "{kind} cannot stand here",
        "ここに{kind}は書けません";

    // The robot's name.
    NeedsName
        "a robot needs a name",
        "ロボットには名前が必要です";
    BlankAtEnd
        "a name neither begins nor ends with a blank",
        "名前の始めと終わりに空白は置けません";
    NameTooLong { most: usize }
        "a name has {most} characters at most",
        "名前は{most}文字までです";
    NotInName { character: Letter }
        "{character} cannot be part of a name",
        "名前の中に{character}は使えません";
    KnownRobot
        "this is the name of a built-in robot",
        "これはコンパイラに組み込まれたロボットの名前です";

    // Legs and joints.
    NumberOfLegs { most: usize, found: usize }
        "a robot has 1 to {most} legs, and here are {found}",
        "脚は1本から{most}本までですが、{found}本あります";
    NoJoints { leg: usize }
        "leg F{leg} has no joints",
        "脚F{leg}に関節がありません";
    DescribeJoints
        "describe them under [[joint]], for every leg, or under [[leg.joint]], for this one",
        "全ての脚に共通なら[[joint]]に、この脚だけなら[[leg.joint]]に書いてください";
    NoLength { leg: usize }
        "leg F{leg} has no length",
        "脚F{leg}の長さが0です";
    OneLinkNotZero
        "the link of one joint at least is not [0, 0, 0]",
        "少なくとも1つの関節のlinkは[0, 0, 0]以外にします";
    OtherNumberOfJoints { leg: usize, joints: Joints, first: usize }
        "leg F{leg} has {joints}, F1 has {first}",
        "脚F{leg}は{joints}、F1は{first}関節です";
    SameNumberOfJoints
        "every leg needs the same number of joints: the language names them J1…Jn",
        "関節の数は全ての脚で同じにします。言語の中ではJ1…Jnと呼びます";
    NumberOfJoints { most: usize, found: usize }
        "a leg has 1 to {most} joints, and here are {found}",
        "1本の脚の関節は1個から{most}個までですが、{found}個あります";
    OuterContainsLimits { min: f64, max: f64 }
        "the outer limits must contain the working limits {min} to {max}",
        "外側の限界は動作範囲{min}から{max}を含む必要があります";
    NoDirection
        "an axis of length 0 has no direction",
        "長さ0の軸には向きがありません";
    NoCoordinate { letter: Letter }
        "{letter} is not a coordinate, or appears twice",
        "{letter}は座標ではないか、二度書かれています";
    OtherNumberOfAngles { angles: usize, joints: Joints }
        "the initial posture has {angles} angles, the leg has {joints}",
        "初期姿勢の角度は{angles}個ですが、脚は{joints}です";
    InitialOutside { angle: f64, joint: usize, min: f64, max: f64 }
        "the initial angle {angle} of joint {joint} is outside its limits {min} to {max}",
        "関節{joint}の初期角度{angle}が、限界{min}から{max}の外にあります";
    JointsOfLeg { leg: usize, wanted: &'static str }
        "the joints of leg F{leg} {wanted}",
        "脚F{leg}の関節: {wanted}";

    // Settings.
    SamplingTimes { min: f64, max: f64 }
        "the robot accepts sampling times of {min} to {max} ms only",
        "このロボットで使えるサンプリング時間は{min}から{max} msまでです";
    NoBodysInertia
        "no rigid body has this inertia: none of its principal moments is below 0, or above the other two together",
        "このような慣性テンソルの剛体はありません。主慣性モーメントは0以上で、どの1つも残り2つの和を超えません";
    NoPair
        "two parts belong here",
        "ここには2つの部分を書きます";
    TooManyPairs { most: usize }
        "no robot has more than {most} pairs",
        "組は{most}個までです";
    TouchesItself { part: String }
        "{part} stands here twice: a pair is two different parts",
        "{part}が2回あります。組は異なる2つの部分です";
    NoNumberOfLamps
        "this cannot be a number of lamps",
        "これはランプの個数になりません";
    SliderOutside { at: f64 }
        "the slider starts at {at}, which is outside",
        "スライダの初期位置{at}が範囲の外にあります";

    // Drives.
    DrivesNeedBus
        "drives need a [bus]",
        "駆動軸には[bus]表が必要です";
    NoSuchJoint
        "the robot has no joint of this name",
        "この名前の関節はありません";
    TwoDrives
        "this joint has a drive already",
        "この関節の駆動軸は既にあります";
    NoDrive { joint: Target }
        "joint {joint} has no [[drive]]",
        "関節{joint}の[[drive]]がありません";
    SameIdentity { id: usize, joint: Target }
        "two servos of one bus cannot have the identity {id}: that of {joint} has it",
        "1つのバスに同じID {id} のサーボは置けません。{joint}のサーボが使っています";
    OneIdentityEach
        "give each servo its own `id`; `tip drives id` writes one into a servo that is alone on the bus",
        "サーボごとに別の `id` にしてください。サーボへの書き込みは、1台だけつないで `tip drives id` で行います";
    OneFamilyEach
        "all servos of one bus are of one family, because their frames differ",
        "フレーム形式が異なるため、1つのバスには1つの系列だけをつなぎます";
    NoSuchServo { known: List }
        "no servo model has this name; there are {known}",
        "この名前のサーボはありません。使えるのは{known}です";
    OtherFamily { family: &'static str, first: &'static str }
        "servos of {family} and {first} cannot share a bus",
        "{family}と{first}のサーボは1つのバスに混ぜられません";
    NoModel
        "the drive needs a `model`, or the bus a `servo`",
        "駆動軸の `model` か、バスの `servo` が必要です";
    NoSign
        "a sign is 1 or -1",
        "符号は1か-1です";
    NotWhole { least: f64, most: f64 }
        "a whole number from {least} to {most} belongs here",
        "ここには{least}から{most}までの整数を書きます";
    NotBetween { least: f64, most: f64 }
        "a number from {least} to {most} belongs here",
        "ここには{least}から{most}までの数を書きます";
    BeyondJoint { min: f64, max: f64 }
        "the joint itself goes from {min} to {max} deg only",
        "関節自体の範囲は{min}から{max}度までです";
    StartsOutside { angle: f64 }
        "the initial posture has this joint at {angle} deg, which is outside",
        "初期姿勢でのこの関節の角度{angle}度が範囲の外にあります";
    BeyondTravel { angle: f64, min: f64, max: f64 }
        "the motor would have to turn to {angle} deg, and goes from {min} to {max} deg",
        "モータが{angle}度まで回る必要がありますが、範囲は{min}から{max}度です";

    // Shapes.
    NoForm
        "a shape needs `block`, `cylinder` or `sphere`",
        "形状には `block`、`cylinder`、`sphere` のどれかが必要です";
    SeveralForms
        "a shape has only one of `block`, `cylinder` and `sphere`",
        "1つの形状に書けるのは `block`、`cylinder`、`sphere` のうち1つだけです";
    Forms
        "a block has `block = [x, y, z]`, a cylinder `cylinder = [radius, length]`, a sphere `sphere = radius`, in mm",
        "直方体は `block = [x, y, z]`、円柱は `cylinder = [半径, 長さ]`、球は `sphere = 半径` で、単位はmmです";

    // Scenes.
    BothShapes
        "an object cannot have both `size` and `radius`",
        "物体に `size` と `radius` の両方は書けません";
    NoShape
        "an object needs `size` or `radius`",
        "物体には `size` か `radius` が必要です";
    Shapes
        "a box has `size = [width, height]`, a disc `radius`, in mm",
        "箱は `size = [幅, 高さ]`、円板は `radius` で、単位はmmです";
    Simulated { error: Text } "{error}", "{error}";
    TakeOneAway
        "take one of them away",
        "どちらか一方を消してください";
    RadiusUnit
        "`radius` is in mm",
        "`radius` の単位はmmです";
    SizeUnit
        "`size` is in mm",
        "`size` の単位はmmです";
    MassUnit
        "`mass` is in kg",
        "`mass` の単位はkgです";
    OnlyNumbers
        "only numbers belong here",
        "ここには数値だけを書きます";
}
