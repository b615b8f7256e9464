//! Every color, size and distance that has a name, once, and the style and fonts that egui is given.

mod fonts;
mod layout;
mod palette;
mod sizes;
mod style;
mod system_colors;

pub use fonts::{INTER, regular, strong};
pub use layout::{Layout, is_low};
pub use palette::{Palette, palette};
pub use sizes::*;
pub use style::{card, color, install};
pub use system_colors::{Colors, SystemColors};
