//! Recovery from broken statements, and the words of their diagnostics.
//!
//! The parser reads a statement from left to right and calls these functions where it cannot go on. They return a fault
//! that names what to write instead, or the role that the statement keeps among the blocks. Most of them recognise
//! words of other languages: BASIC, C, Python. Rules of T.I.P. do not belong here.

pub(super) mod brace;
pub(super) mod characters;
pub(super) mod comment;
pub(super) mod condition;
pub(super) mod control;
pub(super) mod declaration;
pub(super) mod equation;
pub(super) mod label;
pub(super) mod operand;
pub(super) mod statement;
pub(super) mod unknown;
