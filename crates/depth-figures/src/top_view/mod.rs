//! The scene from above, to scale: cameras, lines of sight, object, both distances.

mod draw;
mod fit;
mod model;
mod options;
#[cfg(test)]
mod tests;
mod view;
mod write;

pub use model::{Model, Sight, Source};
pub use options::{Drag, Options};
pub use view::TopView;
