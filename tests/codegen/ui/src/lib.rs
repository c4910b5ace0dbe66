//! A crate of its own, so that its test programs build the bare vocabulary and no robot. They invoke the macros by one of
//! its own, too.
#![no_std]

#[doc(hidden)]
pub use tip_macros;

/// Includes a program for a robot, both by the caller's paths, and the robot's model.
#[macro_export]
macro_rules! motion {
    ($program:literal as $name:ident on $robot:literal as $model:ident) => {
        $crate::tip_macros::include_tip!(pub $program as $name, robot = $robot);
        $crate::tip_macros::include_robot!(pub $robot as $model);
        $crate::tip_macros::tip!(pub Inline, "3.1\ninline\nREL_PTP F6 0 0 20\nEND", robot = $robot);
    };
}

/// Includes a program that is this crate's own.
#[macro_export]
macro_rules! own_motion {
    ($name:ident) => {
        $crate::tip_macros::include_tip!(pub "passed_on.prg" as $name);
    };
}
