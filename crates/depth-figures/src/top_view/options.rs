//! How the scene is drawn.

/// What can be done with the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drag {
    /// Nothing: it is on paper.
    #[default]
    No,
    /// The ring can be dragged.
    Pointer,
    /// The ring can also be moved by keys.
    PointerAndKeys,
}

/// How it is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// What the note says about dragging.
    pub drag: Drag,
    /// The [scale](super::TopView::per_meter) to keep. A window keeps the one at the start while something is dragged, as a scale that fits
    /// anew would move the picture away below the pointer.
    pub hold: Option<f64>,
}
