//! Generated code has to compile here: without prelude, without the standard library, with every
//! warning denied, the runtime under another name, and the names that it might lean on taken.
#![no_std]
#![no_implicit_prelude]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, unused_qualifications, unreachable_pub)]
#![deny(missing_debug_implementations, clippy::all, clippy::pedantic)]

/// Code that a build script generated.
pub mod generated {
    ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/ok.rs"));
    ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/option.rs"));
    ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/some.rs"));
    ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/hostile.rs"));
}

/// Code that the macros generated.
pub mod included {
    ::motion_macros::include_tip!(pub "../motions/option.prg" as Some, runtime = ::robot);
    ::motion_macros::include_robot!(pub "../motions/some.toml" as NOTHING, runtime = ::robot);
    ::motion_macros::tip!(pub Flow, "3.1\nflow\nLOOP:\nGOTO\nEND", runtime = ::robot);
}

/// A scope in which other things bear the names of Rust's and of the runtime's.
pub mod hostile {
    /// Not the crate.
    pub mod core {}
    /// Not the crate.
    pub mod robot {}
    /// Not the module.
    pub mod ops {}
    /// Not the type.
    #[derive(::core::fmt::Debug)]
    pub struct Option;
    /// Not the type.
    #[derive(::core::fmt::Debug)]
    pub struct Result;
    /// Not the variant.
    #[derive(::core::fmt::Debug)]
    pub struct None;
    /// Not the type.
    #[derive(::core::fmt::Debug)]
    pub struct Value;
    /// Not the trait.
    pub trait Program {}
    /// Not the type.
    #[derive(::core::fmt::Debug)]
    pub struct Model;
    ::motion_macros::include_tip!(pub "../motions/option.prg" as Walk, runtime = ::robot);
    ::motion_macros::include_robot!(pub "../motions/some.toml", runtime = ::robot);
}

/// The robots are robots.
pub const ROBOTS: [&::robot::model::Model<2, 1>; 3] =
    [&generated::SOME, &included::NOTHING, &hostile::SOME];

/// The program types are programs, and constructible where nothing runs.
pub const PROGRAMS: [&dyn ::robot::program::Program; 6] = [
    &generated::Ok::new(),
    &generated::Option::new(),
    &generated::HostileCompileErrorLive::new(),
    &included::Some::new(),
    &included::Flow::new(),
    &hostile::Walk::new(),
];
