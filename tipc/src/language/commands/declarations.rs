//! Declarations (T.I.P. 3.1 §7-10-1).

use super::Command;
use crate::language::Keyword;

pub(super) const ROWS: &[Command] = &[
    Command::keyword(Keyword::DefVar)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::DefPos)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::DefJoint)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::Define)
        .words("name constant")
        .no_step(),
];
