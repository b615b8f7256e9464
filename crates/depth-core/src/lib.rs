//! The mathematics of a distance: plain structs and pure functions, SI units inside; no text, no user interface, no files,
//! no clock, and no dependency but serde, which is optional.

pub mod agreement;
pub mod angle;
mod arithmetic;
mod budget;
pub mod camera;
pub mod disparity;
pub mod field;
pub mod judge;
pub mod measured;
pub mod method;
mod model;
pub mod monocular;
pub mod monte_carlo;
pub mod problem;
pub mod q_matrix;
pub mod quantity;
pub mod stereo;
pub mod uncertainty;
pub mod unknown;
