//! A T.I.P. program on hardware of your own: position servos on a bus.
#![forbid(unsafe_code)]

pub mod bus;
pub mod servos;

tip_macros::include_tip!(pub "motions/feet.prg");
