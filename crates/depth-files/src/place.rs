//! Where in the files something stands.

/// A line of one of the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// Which of the files that were given, counted from 0.
    pub file: usize,
    /// Counted from 1; 0 in a file that has no lines.
    pub line: usize,
}

/// Where in the files a number comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Origin {
    /// Which of the files that were given, counted from 0.
    pub file: usize,
    /// Counted from 1; 0 in a file that has no lines.
    pub line: usize,
    /// How it was derived, by the names that the file uses: `K`, `baseline`, `P2[0][3] / P2[0][0]`.
    pub how: String,
}

impl Place {
    /// The origin of a number that stands here.
    pub(crate) fn origin(self, how: impl Into<String>) -> Origin {
        let Self { file, line } = self;
        Origin {
            file,
            line,
            how: how.into(),
        }
    }
}

impl Origin {
    /// Where it stands.
    pub const fn place(&self) -> Place {
        let Self { file, line, .. } = *self;
        Place { file, line }
    }
}
