//! Program and model come from the same description.
use tip_runtime::model::Model;
use tip_runtime::program::Program;

tip_macros::tip!(Lift, "3.1\nlift\nREL_PTP F6 0 0 20\nEND", robot = "hexapod.toml");
tip_macros::include_robot!(pub(crate) "hexapod.toml" as SIX_LEGS);

// A published robot has a name instead of a file.
tip_macros::tip!(Rise, "3.1\nrise\nREL_PTP F6 0 0 20\nEND", robot = phantomx);
tip_macros::include_robot!("phantomx");

const MODEL: Model<6, 3> = SIX_LEGS;

fn main() {
    assert_eq!(Lift::new().signature(), MODEL.signature());
    assert_eq!(MODEL.check(), Ok(()));
    assert_eq!(MODEL.legs[0].joints[0].link, [-50.0, 0.0, 0.0]);
    assert_eq!(Rise::new().signature(), PHANTOMX.signature());
}
