//! Duration of a command, and its possible failures at runtime.

use super::{Command, Form, Limit, Values};
use crate::language::Bilingual;
use tip_runtime::command::{Port, Target};
use tip_runtime::fault::Fault;

/// Number of control cycles that a command takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycles {
    /// None: it is not a step.
    Zero,
    /// One; the program does not wait for what it sets off.
    One,
    /// At least one: the program stays until this holds.
    Until(Bilingual),
}

/// Parts that a command brings under control.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// Nothing new.
    Nothing,
    /// Its target.
    Target,
    /// The robot, whatever its target.
    Robot,
}

/// A runtime error, and when it happens.
pub type Failure = (Fault, Bilingual);

/// Nothing of its own.
pub(super) const NONE: &[Failure] = &[];

const NO_VALUE: Failure = (
    Fault::Unassigned(0),
    Bilingual::new(
        "a variable in it has no value yet",
        "使われている変数にまだ値がない",
    ),
);

/// It reads operands.
pub(super) const READS: &[Failure] = &[NO_VALUE];

pub(super) const REACH: &[Failure] = &[(
    Fault::OutOfReach(Target::Foot(1)),
    Bilingual::new(
        "the position, or the path to it, cannot be reached; under EMG_OFF the motion stops there",
        "その位置、またはそこまでの経路に届かない(EMG_OFFではそこで止まる)",
    ),
)];

pub(super) const TURN: &[Failure] = &[(
    Fault::OutOfReach(Target::Joint(1, 1)),
    Bilingual::new(
        "the angle is beyond the joint's limits; under EMG_OFF the joint stops there",
        "角度が関節の限界を超える(EMG_OFFではそこで止まる)",
    ),
)];

pub(super) const GLIDE: &[Failure] = &[
    (
        Fault::OutOfReach(Target::Foot(1)),
        Bilingual::new(
            "the foot reaches the end of its reach; under EMG_OFF it stops there",
            "足先が届く限界に達する(EMG_OFFではそこで止まる)",
        ),
    ),
    (
        Fault::JointLimit(1, 1),
        Bilingual::new(
            "a joint reaches its limit during the motion; under EMG_OFF it stops there",
            "動作中に関節が限界に達する(EMG_OFFではそこで止まる)",
        ),
    ),
];

pub(super) const SPIN: &[Failure] = &[(
    Fault::JointLimit(1, 1),
    Bilingual::new(
        "the joint reaches its limit; under EMG_OFF it stops there",
        "関節が限界に達する(EMG_OFFではそこで止まる)",
    ),
)];

pub(super) const UNCONTROLLED: &[Failure] = &[(
    Fault::InvalidMode,
    Bilingual::new(
        "no part of the foot or joint is under position or angle control",
        "その足や関節に、位置制御または角度制御の部分がない",
    ),
)];

pub(super) const STAND: &[Failure] = &[
    (
        Fault::InvalidMode,
        Bilingual::new(
            "a torque, force or spring controls a joint",
            "トルク、力、またはばねで制御されている関節がある",
        ),
    ),
    (
        Fault::OutOfReach(Target::Foot(1)),
        Bilingual::new(
            "a foot cannot reach that far; under EMG_OFF it stops there",
            "足先がそこまで届かない(EMG_OFFではそこで止まる)",
        ),
    ),
];

pub(super) const SWING: &[Failure] = &[(
    Fault::JointLimit(1, 1),
    Bilingual::new(
        "a joint that nothing stops swings past its limit; under EMG_OFF it is held there",
        "止めるもののない関節が限界を超える(EMG_OFFではそこで保持される)",
    ),
)];

pub(super) const FLOOR: &[Failure] = &[
    (
        Fault::Sensor(Port::Paw(1)),
        Bilingual::new(
            "a sole's sensor reads nonsense",
            "足裏のセンサの値がおかしい",
        ),
    ),
    (
        Fault::OutOfReach(Target::Foot(1)),
        Bilingual::new(
            "a foot reaches the end of its reach before it feels the floor",
            "床を検出する前に足先が届く限界に達する",
        ),
    ),
    NOTHING_THERE,
];

pub(super) const OBJECT: &[Failure] = &[NOTHING_THERE];

const NOTHING_THERE: Failure = (
    Fault::JointLimit(1, 1),
    Bilingual::new(
        "a joint reaches its limit because nothing is there to touch",
        "触れるものがなく、関節が限界に達する",
    ),
);

pub(super) const INPUT: &[Failure] = &[(
    Fault::Sensor(Port::Knob(1)),
    Bilingual::new("the input reads nonsense", "入力の値がおかしい"),
)];

pub(super) const COUNT: &[Failure] = &[
    NO_VALUE,
    (
        Fault::Domain,
        Bilingual::new(
            "the increment is 0, or a sum is too large for a number",
            "増分が0、または和が大きすぎて数で表せない",
        ),
    ),
];

pub(super) const CALLS: &[Failure] = &[(
    Fault::TooDeep,
    Bilingual::new("ten calls are open already", "すでに10段の呼び出し中である"),
)];

pub(super) const BRANCHES: &[Failure] = &[
    NO_VALUE,
    (
        Fault::TooDeep,
        Bilingual::new(
            "GOSUB: ten calls are open already",
            "GOSUB: すでに10段の呼び出し中である",
        ),
    ),
];

pub(super) const RETURNS: &[Failure] = &[(
    Fault::InvalidReturn,
    Bilingual::new("no call is open", "呼び出し中でない"),
)];

pub(super) const RUNNING: &[Failure] = &[(
    Fault::InvalidMode,
    Bilingual::new("the thread runs already", "スレッドがすでに動いている"),
)];

pub(super) const ITSELF: &[Failure] = &[(
    Fault::InvalidMode,
    Bilingual::new("the thread waits for itself", "スレッドが自分自身を待つ"),
)];

pub(super) const LOCKED: &[Failure] = &[(
    Fault::InvalidMode,
    Bilingual::new(
        "a joint that it names is locked",
        "指定した関節がロックされている",
    ),
)];

pub(super) const NATIVE: &[Failure] = &[(
    Fault::Domain,
    Bilingual::new(
        "no native code has this number, or it refuses the values",
        "その番号のネイティブコードがない、または値を受け付けない",
    ),
)];

impl Command {
    /// Returns every runtime error of its own step.
    pub fn failures(&self) -> Vec<Failure> {
        let operands = if self.reads() { READS } else { NONE };
        let limit = self.limit().map(|when| (Fault::Domain, when));
        let own = self.failures.iter().copied();
        operands.iter().copied().chain(limit).chain(own).collect()
    }

    /// Returns which values stop the program.
    pub fn limit(&self) -> Option<Bilingual> {
        let Form::Robot(arguments) = self.form else {
            return None;
        };
        match arguments.limit {
            Limit::Any => None,
            Limit::NotNegative => Some(Bilingual::new("below 0", "0未満")),
            Limit::Positive => Some(Bilingual::new("0 and below", "0以下")),
            Limit::Percent => Some(Bilingual::new("0 and below, above 100", "0以下、100超")),
            Limit::Period | Limit::Frequency => Some(Bilingual::new(
                "outside the robot's range",
                "ロボットの範囲外",
            )),
            Limit::Lamp => Some(Bilingual::new(
                "a device that is not fitted",
                "取り付けられていない装置",
            )),
            Limit::FloorType => Some(Bilingual::new(
                "T: not 1–3; H: not 1–2",
                "T: 1～3以外、H: 1～2以外",
            )),
            Limit::ObjectType => Some(Bilingual::new("not 1–3", "1～3以外")),
            Limit::Timer => Some(Bilingual::new("outside 0…7", "0～7以外")),
            Limit::Steps => Some(Bilingual::new("outside 1…255", "1～255以外")),
            Limit::Angles => Some(Bilingual::new(
                "outside the joint's own limits, or no range",
                "関節本来の可動範囲外、または下限が上限以上",
            )),
        }
    }

    fn reads(&self) -> bool {
        match self.form {
            Form::Robot(arguments) => arguments.values != Values::None,
            Form::Special => true,
            Form::Teach(_) | Form::AdIn | Form::KeyIn | Form::Words(_) => false,
        }
    }
}
