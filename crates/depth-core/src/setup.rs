//! How the two cameras stand, and what of the object is measured.

/// How the two cameras of a pair stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Pair {
    /// Side by side: the disparity is a difference of columns and belongs to fx.
    #[default]
    Horizontal,
    /// One above the other: the disparity is a difference of rows and belongs to fy.
    Vertical,
}

impl Pair {
    /// Both, the usual one first.
    pub const ALL: [Self; 2] = [Self::Horizontal, Self::Vertical];

    /// Its name in links and on the command line. Never changes.
    ///
    /// ```
    /// assert_eq!(depth_core::setup::Pair::Vertical.key(), "vertical");
    /// ```
    pub const fn key(self) -> &'static str {
        match self {
            Self::Horizontal => "horizontal",
            Self::Vertical => "vertical",
        }
    }
}

/// What of the object is measured, in the image and in the world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Object {
    /// Its width: columns and fx.
    #[default]
    Width,
    /// Its height: rows and fy.
    Height,
    /// The diameter of a ball in the middle of the image, whose outline is wider than the diameter where it is near; fx.
    Ball,
}

impl Object {
    /// All of them, the usual one first.
    pub const ALL: [Self; 3] = [Self::Width, Self::Height, Self::Ball];

    /// Its name in links and on the command line. Never changes.
    ///
    /// ```
    /// assert_eq!(depth_core::setup::Object::Ball.key(), "ball");
    /// ```
    pub const fn key(self) -> &'static str {
        match self {
            Self::Width => "width",
            Self::Height => "height",
            Self::Ball => "ball",
        }
    }
}
