//! What can be put on the clipboard.

/// What can be put on the clipboard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Copyable {
    /// The results as text.
    Results,
    /// The Q matrix of the cameras in the form.
    QMatrix,
    /// One result, or a part of it.
    Value(String),
}

impl Copyable {
    const WITH_BUTTON: [Self; 2] = [Self::Results, Self::QMatrix];

    /// The author id, in the accessibility tree, of the button that calls [`App::copy`](super::App::copy) while the click is being
    /// handled.
    pub const fn author_id(&self) -> &'static str {
        match self {
            Self::Results => "copy results",
            Self::QMatrix => "copy q matrix",
            Self::Value(_) => "",
        }
    }

    /// What the button with this author id copies, if it is such a button.
    pub fn by_author_id(id: Option<&str>) -> Option<Self> {
        Self::WITH_BUTTON.into_iter().find(|what| id == Some(what.author_id()))
    }
}
