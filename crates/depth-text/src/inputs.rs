//! What a screen needs of the form, in one place.

pub use crate::assess::{Assessment, Unknown};
pub use crate::entry::{Entries, Entry};
pub use crate::form::{Example, Inputs};
pub use crate::note::{Fix, Note, Part, Severity};
