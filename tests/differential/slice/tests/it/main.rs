//! Random programs, the comparison of both engines, and a slice of the campaign.

mod lockstep;
mod programs;
mod slice;
