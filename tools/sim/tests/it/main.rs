//! The tests of the simulator, in one binary.

mod debug;
mod described;
#[cfg(unix)]
mod external;
mod inputs;
mod interp;
mod lockstep;
mod mjcf;
mod mjcf_import;
mod motion;
mod published;
mod reach;
mod real;
mod run;
mod snapshot;
mod special;
mod urdf;
#[cfg(unix)]
mod verify;
