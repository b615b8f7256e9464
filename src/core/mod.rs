//! Floor 1: the mathematics. Plain structs and pure functions, SI units inside; no user interface, no files, no clock.

pub mod monocular;
pub mod problem;
pub mod quantity;
pub mod stereo;
