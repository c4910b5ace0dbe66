//! The command `tip`, run as users run it.

mod check;
#[cfg(unix)]
mod commands;
mod completions;
mod cycles;
mod dap;
#[cfg(target_os = "linux")]
mod drives;
mod emit;
#[cfg(target_os = "linux")]
mod endings;
#[cfg(unix)]
mod external;
#[cfg(target_os = "linux")]
mod failures;
#[cfg(target_os = "linux")]
mod faults;
#[cfg(target_os = "linux")]
mod figures;
mod files;
mod fix;
mod fmt;
#[cfg(unix)]
mod guides;
mod imported;
mod loader;
mod logged;
mod logs;
mod lsp;
mod messages;
mod migrate;
mod motion;
mod new;
#[cfg(unix)]
mod printable;
#[cfg(target_os = "linux")]
mod printed;
mod project;
mod quiet;
mod readme;
mod robot;
mod run;
mod sarif;
mod script;
#[cfg(target_os = "linux")]
mod serve;
#[cfg(target_os = "linux")]
mod servo_bus;
#[cfg(target_os = "linux")]
mod servo_commands;
#[cfg(target_os = "linux")]
mod steered;
mod stops;
mod support;
#[cfg(target_os = "linux")]
mod sweep;
#[cfg(target_os = "linux")]
mod teaching;
#[cfg(target_os = "linux")]
mod torque;
mod usage;
mod verify;
mod view;
#[cfg(target_os = "linux")]
mod watch;
