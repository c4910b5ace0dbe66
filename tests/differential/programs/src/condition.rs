//! Conditions.

use crate::writer::Writer;
use tip_runtime::model::Family;
use tipc::language::flags;

impl Writer {
    pub(crate) fn condition(&mut self) -> String {
        if self.random.once_in(3) {
            let not = self.pick(&["", "!"]);
            format!("{not}{}", self.flag())
        } else {
            let relation = self.pick(&["==", "<>", "<", ">", "<=", ">="]);
            format!("{} {relation} {}", self.scalar(), self.scalar())
        }
    }

    fn flag(&mut self) -> String {
        let family = self.pick(&flags::families().collect::<Vec<_>>());
        let is_hand = self.robot.signature().family == Family::Hand;
        match self.random.below(5) {
            0 => {
                let known = flags::words().take(if is_hand { 3 } else { 2 });
                self.pick(&known.collect::<Vec<_>>()).to_owned()
            }
            _ if family == "SPECIAL_FLAG" => format!("{family}{}", self.random.below(10)),
            _ => {
                let (foot, joint) = (self.foot(), self.joint());
                let target = self.pick(&[foot, joint, "ALL".to_owned()]);
                format!("{family}{target}")
            }
        }
    }
}
