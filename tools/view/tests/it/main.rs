//! The tests of recordings and pages, in one binary.

mod csv;
mod live;
mod mcap;
mod page;
mod plot;
mod recording;
