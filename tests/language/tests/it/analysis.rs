//! Results of the analysis against runs.

mod assignment;
mod cycles;
mod programs;
mod watched;
