//! What a call is answered with.

use serde::Serialize;

/// An answer.
pub(super) struct Reply {
    /// For standard output, line ends included.
    pub(super) text: String,
    /// For standard error, a sentence each.
    pub(super) warnings: Vec<String>,
}

impl Reply {
    /// `answer` in JSON, with a line end behind it.
    pub(super) fn json(answer: &impl Serialize) -> Result<Self, String> {
        let text = serde_json::to_string_pretty(answer).map_err(|error| error.to_string())?;
        Ok(Self::without_warnings(text + "\n"))
    }

    pub(super) const fn without_warnings(text: String) -> Self {
        Self {
            text,
            warnings: Vec::new(),
        }
    }
}
