#![doc = include_str!("../README.md")]

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
