//! Colors by what they mean: a theme or a page decides what each looks like.

/// What a shape is drawn in. One meaning a color: blue is stereo, orange is monocular, green and red are the verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ink {
    /// Text, the combined distance, and what belongs to no method.
    Text,
    /// Captions, and the labels of axes.
    Muted,
    /// What holds no longer: the last value while an input cannot be read.
    Stale,
    /// Behind that.
    StaleTint,
    /// Grid lines, and lines that only separate.
    Line,
    /// Axes, and the edges of things.
    Border,
    /// The ground of a card.
    Surface,
    /// A little darker than that: bands behind what is drawn.
    Band,
    /// The ground of a card that is laid over others, such as a tip.
    Tip,
    /// Stereo.
    Stereo,
    /// Behind it.
    StereoTint,
    /// A band around a line of stereo: stronger than [`Ink::StereoTint`].
    StereoBand,
    /// Text on [`Ink::Stereo`].
    OnStereo,
    /// Monocular, as a line or an area.
    Monocular,
    /// Monocular, as text.
    MonocularText,
    /// Behind it.
    MonocularTint,
    /// Disagreement, errors.
    Error,
    /// The largest share of a budget, …
    ShareFirst,
    /// … the second, …
    ShareSecond,
    /// … the third, …
    ShareThird,
    /// … and what is left.
    ShareRest,
}
