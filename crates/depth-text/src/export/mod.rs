//! Results for somewhere else: one file a format.

mod exporter;
mod text;

pub use exporter::{Exporter, Results};
pub use text::Text;
