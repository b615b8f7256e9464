//! Every sentence that refuses, warns, hints or judges, as the `Display` of an enum with its facts: what people type
//! ([`Issue`](crate::note::Issue)), what follows from it ([`Statement`]), and what only the command line says ([`CommandLine`]).
//!
//! All of them are shown by the snapshots in `tests/sentences` of the program.

mod camera;
mod command_line;
mod description;
mod headline;
mod issue;
mod page;
mod phrase;
mod statement;
mod words;

pub use camera::CameraWords;
pub use command_line::CommandLine;
pub use description::Description;
pub use page::Page;
pub use phrase::Phrase;
pub use statement::{Pair, Statement};
pub use words::{capital, lower, needs, percent, quoted, shares, short_name, sigmas, sizes};
