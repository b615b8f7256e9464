//! Results for somewhere else: one file a format.

mod answer;
mod exporter;
mod html;
mod text;

pub use exporter::{Exporter, PROGRAM, Provenance, Results};
pub use html::{Figure, Html};
pub use text::Text;
