//! How far away is it, and how sure can I be?
//!
//! The house, floor by floor; a floor uses only the floors below it:
//!
//! 1. [`core`], the crate `depth-core`: the mathematics.
//! 2. [`formats`], the crate `depth-text`: text in and out.
//! 3. `app`: the egui application, the same on every platform and under test.
//! 4. `cli`: the command line; it builds without floor 3.
//! 5. `platform`: the entry points of the web page and the desktop program.
//!
//! ```
//! use depth_calculator::core::measured::Measured;
//! use depth_calculator::core::problem::Problem;
//! use depth_calculator::core::quantity::{Length, LengthUnit, Pixels};
//!
//! let mug = Problem {
//!     focal_length: Some(Measured::exact(Pixels::new(700.0))),
//!     baseline: Some(Measured::exact(Length::new(10.0, LengthUnit::Centimeter))),
//!     disparity: Some(Measured::exact(Pixels::new(50.0))),
//!     ..Problem::default()
//! };
//! assert_eq!(mug.solve().stereo.distance(), Some(Length::from_m(1.4)));
//! ```

#[cfg(feature = "app")]
pub mod app;
#[cfg(all(feature = "cli", not(target_arch = "wasm32")))]
pub mod cli;
#[cfg(feature = "app")]
pub mod platform;

pub use depth_core as core;
pub use depth_text as formats;
