//! Conditions.

use crate::writer::Writer;
use tip_runtime::model::Family;
use tipc::language::commands::{FLAG_FAMILIES, FLAGS};

impl Writer {
    pub(crate) fn condition(&mut self) -> String {
        if self.dice.once_in(3) {
            let not = self.dice.pick(&["", "!"]);
            format!("{not}{}", self.flag())
        } else {
            let relation = self.dice.pick(&["==", "<>", "<", ">", "<=", ">="]);
            format!("{} {relation} {}", self.scalar(), self.scalar())
        }
    }

    fn flag(&mut self) -> String {
        let family = self.dice.pick(FLAG_FAMILIES);
        let is_hand = self.robot.signature().family == Family::Hand;
        match self.dice.below(5) {
            0 => {
                let known = if is_hand { FLAGS } else { &FLAGS[..2] };
                self.dice.pick(known).to_owned()
            }
            _ if family == "SPECIAL_FLAG" => format!("{family}{}", self.dice.below(10)),
            _ => {
                let (foot, joint) = (self.foot(), self.joint());
                let target = self.dice.pick(&[foot, joint, "ALL".to_owned()]);
                format!("{family}{target}")
            }
        }
    }
}
