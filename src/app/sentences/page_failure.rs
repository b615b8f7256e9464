//! What covers the page where the program cannot go on.

use std::fmt::{self, Display, Formatter};

/// Why the page shows no program; its `Display` is what happened and what to do about it, in two lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PageFailure {
    /// An error in the program.
    Stopped,
    /// The browser gives it nothing to draw with.
    NotDrawing,
}

impl PageFailure {
    /// What happened.
    pub const fn what(self) -> &'static str {
        match self {
            Self::Stopped => "The program has stopped because of an error in it.",
            Self::NotDrawing => "The program arrived, but it could not start drawing.",
        }
    }

    /// What to do about it.
    pub const fn remedy(self) -> &'static str {
        match self {
            Self::Stopped => "Reload the page to go on.",
            Self::NotDrawing => {
                "Switch on hardware acceleration in the browser's settings, or use a current version of Firefox, Chrome, Edge or Safari."
            }
        }
    }
}

impl Display for PageFailure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.what(), self.remedy())
    }
}

#[cfg(test)]
mod tests {
    use super::PageFailure;
    use crate::app::sentences::snapshot::{assert_shown, every};

    #[test]
    fn every_failure_of_the_page_is_as_it_was_written() {
        let failures = every![PageFailure;
            PageFailure::Stopped => PageFailure::Stopped,
            PageFailure::NotDrawing => PageFailure::NotDrawing,
        ];
        assert_shown("page-failures", &failures);
    }
}
