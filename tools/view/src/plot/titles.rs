//! What the diagrams say, in both languages.

use tipc::message::Lang;

/// Of a diagram; joints count from 1.
#[derive(Clone, Copy)]
pub(super) enum Title {
    Page,
    Gait,
    FeetFromAbove,
    FeetFromTheSide,
    Fingertips,
    Angle(usize),
    Torque(usize),
    Force,
}

impl Title {
    /// Hands have fingers, other robots legs.
    pub(super) fn in_lang(self, lang: Lang, is_hand: bool) -> String {
        match lang {
            Lang::Japanese => self.japanese(if is_hand { "指" } else { "脚" }, is_hand),
            _ => self.english(if is_hand { "finger" } else { "leg" }, is_hand),
        }
    }

    fn english(self, limb: &str, is_hand: bool) -> String {
        match self {
            Title::Page => "Motion of a robot".to_owned(),
            Title::Gait if is_hand => "Contacts: fingertips that touch something".to_owned(),
            Title::Gait => "Gait diagram: feet on the ground".to_owned(),
            Title::FeetFromAbove => "Foot paths from above (world)".to_owned(),
            Title::FeetFromTheSide => "Foot paths from the side (world)".to_owned(),
            Title::Fingertips => "Fingertip paths".to_owned(),
            Title::Angle(joint) => format!("Angle of joint {joint} of each {limb}"),
            Title::Torque(joint) => format!("Torque of joint {joint} of each {limb}"),
            Title::Force if is_hand => "Force of each fingertip".to_owned(),
            Title::Force => "Load on each foot".to_owned(),
        }
    }

    fn japanese(self, limb: &str, is_hand: bool) -> String {
        match self {
            Title::Page => "ロボットの動作".to_owned(),
            Title::Gait if is_hand => "接触図 (何かに触れている指先)".to_owned(),
            Title::Gait => "歩容線図 (接地している脚)".to_owned(),
            Title::FeetFromAbove => "足先軌跡・上面図 (世界座標系)".to_owned(),
            Title::FeetFromTheSide => "足先軌跡・側面図 (世界座標系)".to_owned(),
            Title::Fingertips => "指先軌跡".to_owned(),
            Title::Angle(joint) => format!("各{limb}の第{joint}関節の角度"),
            Title::Torque(joint) => format!("各{limb}の第{joint}関節のトルク"),
            Title::Force if is_hand => "各指先の力".to_owned(),
            Title::Force => "各脚の荷重".to_owned(),
        }
    }
}

/// Of an axis.
#[derive(Clone, Copy)]
pub(super) enum Axis {
    Time,
    Angle,
    Torque,
    Force,
}

impl Axis {
    pub(super) fn in_lang(self, lang: Lang) -> &'static str {
        let [english, japanese] = match self {
            Axis::Time => ["time", "時間"],
            Axis::Angle => ["angle", "角度"],
            Axis::Torque => ["torque", "トルク"],
            Axis::Force => ["force", "力"],
        };
        match lang {
            Lang::Japanese => japanese,
            _ => english,
        }
    }
}
