//! What a call is answered with.

/// An answer.
pub(super) struct Reply {
    /// For standard output, line ends included.
    pub(super) text: String,
    /// For standard error, a sentence each.
    pub(super) warnings: Vec<String>,
}

impl Reply {
    pub(super) const fn without_warnings(text: String) -> Self {
        Self {
            text,
            warnings: Vec::new(),
        }
    }
}
