//! The tests of recordings and pages, in one binary.

mod live;
mod page;
mod recording;
