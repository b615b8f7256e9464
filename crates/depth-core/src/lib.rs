#![doc = include_str!("../README.md")]

pub mod agreement;
pub mod angle;
mod arithmetic;
mod budget;
pub mod camera;
pub mod disparity;
pub mod field;
pub mod in_image;
pub mod judge;
pub mod measured;
pub mod method;
mod model;
pub mod monocular;
pub mod monte_carlo;
pub mod problem;
mod projected;
pub mod q_matrix;
pub mod quantity;
pub mod setup;
pub mod stereo;
pub mod stored;
pub mod two_points;
pub mod two_shots;
pub mod uncertainty;
pub mod unknown;
