//! Every sentence that refuses, warns, hints or judges, as the `Display` of an enum with its facts: what people type
//! ([`Issue`](crate::note::Issue)), what follows from it ([`Statement`]), and what only the command line says ([`CommandLine`]).
//!
//! All of them are shown by the snapshots in `tests/sentences` of the program.

mod command_line;
mod issue;
mod statement;

pub use command_line::CommandLine;
pub use statement::Statement;

use std::fmt::Write as _;

/// Declares an enum and the list of its variants' names, against which a test can see that none is forgotten.
macro_rules! variants {
    ($(#[$meta:meta])* pub enum $name:ident {
        $($(#[$doc:meta])* $variant:ident $({ $($fact:ident: $type:ty),* $(,)? })?),* $(,)?
    }) => {
        $(#[$meta])*
        #[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
        pub enum $name {
            $($(#[$doc])* $variant $({ $($fact: $type),* })?),*
        }

        impl $name {
            /// The names of all variants.
            pub const NAMES: &[&str] = &[$(stringify!($variant)),*];
        }
    };
}
pub(crate) use variants;

/// `text` with a capital first letter.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

/// `text` between quotation marks, cut where it is too long to quote.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 24;
    let mut quoted = String::from("“");
    for (count, c) in text.trim().chars().enumerate() {
        if count == LONGEST {
            quoted.push('…');
            break;
        }
        quoted.push(if c.is_control() { ' ' } else { c });
    }
    let _ = quoted.write_char('”');
    quoted
}
