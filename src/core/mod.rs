//! Floor 1: the mathematics. Plain structs and pure functions, SI units inside; no user interface, no files, no clock.

pub mod agreement;
pub mod angle;
pub mod camera;
pub mod disparity;
pub mod field;
pub mod measured;
pub mod monocular;
pub mod monte_carlo;
pub mod problem;
pub mod q_matrix;
pub mod quantity;
pub mod stereo;
pub mod uncertainty;
pub mod unknown;
