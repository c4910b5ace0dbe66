//! Recovery: what a broken statement was to be, and how that is said.
//!
//! The parser reads a statement straight on, and asks here where it cannot go on. The answer is a fault in the user's
//! words, with what to write instead, or the role that the statement keeps among the blocks. Most guesses are at what
//! another language writes: BASIC, C, Python. Rules of the language do not belong here.

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
