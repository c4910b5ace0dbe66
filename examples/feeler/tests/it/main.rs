//! The tests of the example.

mod feeler;
