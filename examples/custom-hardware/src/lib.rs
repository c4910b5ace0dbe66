//! A T.I.P. program on hardware of your own.
//!
//! [`bus::ServoBus`] is all that a robot must bring: it implements
//! [`Hardware`](tip_runtime::hardware::Hardware). Here it talks to simulated servos through an
//! in-memory link; with a serial port behind [`link::Link`] it would talk to real ones.
#![forbid(unsafe_code)]

pub mod bus;
pub mod description;
pub mod link;
pub mod options;
pub mod protocol;
pub mod record;
pub mod servo;
pub mod workshop;

tip_macros::include_tip!(pub "motions/feet.prg");
