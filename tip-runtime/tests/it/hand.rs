//! The Hiroshima Hand: planar fingers, their forces and springs, the slider, searches by touch.

mod forces;
mod onward;
mod paths;
mod positions;
mod postures;
mod rig;
mod searches;
mod specials;
mod springs;
mod torques;
mod vibration;
