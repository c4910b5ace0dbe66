//! Commands of one robot alone (T.I.P. 3.1 §7-11).

use super::{Arguments, Command, Limit, Moves, Robots, Targets, Values, outcome};
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::robot(Op::StandUp)
        .place("§7-11-1", "7.44")
        .does("Raises the body slowly.", "胴体をゆっくり持ち上げます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Any))
        .unit("mm")
        .moves(Moves::Robot)
        .only(Robots::TITAN)
        .until("all feet have arrived", "すべての足先が到着する")
        .fails(outcome::STAND),
    Command::robot(Op::SitDown)
        .place("§7-11-2", "7.44")
        .does("Lowers the body slowly.", "胴体をゆっくり下げます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Any))
        .unit("mm")
        .moves(Moves::Robot)
        .only(Robots::TITAN)
        .until("all feet have arrived", "すべての足先が到着する")
        .fails(outcome::STAND),
    Command::robot(Op::DetectFloor)
        .place("§7-11-3", "7.45")
        .does(
            "Searches the floor with feet or fingers.",
            "足または指で床を探ります。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::One,
            Limit::FloorType,
        ))
        .moves(Moves::Robot)
        .only(Robots::NAMED)
        .until(
            "every foot or finger feels the floor (T, type 3: no longer feels it)",
            "すべての足または指が床を検出する(Tがtype 3なら検出しなくなる)",
        )
        .fails(outcome::FLOOR),
    Command::robot(Op::DetectObject)
        .place("§7-11-4", "7.46")
        .does(
            "Closes the fingers until they touch an object.",
            "対象物に触れるまで指を閉じます。",
        )
        .takes(Arguments::setting(
            Targets::NONE,
            Values::One,
            Limit::ObjectType,
        ))
        .moves(Moves::Robot)
        .only(Robots::HAND)
        .until(
            "every finger feels the object",
            "すべての指が対象物に触れる",
        )
        .fails(outcome::OBJECT),
];
