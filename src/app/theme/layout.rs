//! What the width of the window leaves room for.

use super::sizes;

/// How much room there is, and what fits into it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Layout {
    /// Everything in one column, controls for fingers, the result in a bar at the bottom.
    Phone,
    /// The form beside one column of results.
    Tablet,
    /// The form beside two columns of results.
    Desktop,
    /// The form beside three columns of results.
    Wide,
}

/// Whether a window `height` points high is so low that bars would leave no room between them: a phone on its side with its keyboard, or
/// a page at 400 %. There everything scrolls as one piece.
pub fn is_low(height: f32) -> bool {
    height < sizes::LOW_HEIGHT
}

impl Layout {
    /// The layout for a window of this size. A low one has no room for columns that scroll each by itself.
    pub fn of(window: egui::Vec2) -> Self {
        match window.x {
            _ if is_low(window.y) => Self::Phone,
            w if w < 720.0 => Self::Phone,
            w if w < 1080.0 => Self::Tablet,
            w if w < 1600.0 => Self::Desktop,
            _ => Self::Wide,
        }
    }

    /// Columns of cards in the results.
    pub const fn columns(self) -> usize {
        match self {
            Self::Phone | Self::Tablet => 1,
            Self::Desktop => 2,
            Self::Wide => 3,
        }
    }

    /// Whether there is one column only.
    pub const fn is_narrow(self) -> bool {
        matches!(self, Self::Phone)
    }

    /// Between cards.
    pub const fn gap(self) -> f32 {
        match self {
            Self::Phone => sizes::GAP_PHONE,
            Self::Tablet | Self::Desktop => sizes::GAP,
            Self::Wide => sizes::GAP_WIDE,
        }
    }

    /// Height of a control.
    pub const fn control_height(self) -> f32 {
        match self {
            // A window that narrow is a phone or a tablet as often as not.
            Self::Phone | Self::Tablet => sizes::CONTROL_HEIGHT_TOUCH,
            Self::Desktop | Self::Wide => sizes::CONTROL_HEIGHT,
        }
    }

    /// The side of a button that is a sign, and the height of a tab.
    pub const fn icon_size(self) -> f32 {
        match self {
            Self::Phone | Self::Tablet => sizes::ICON_BUTTON_TOUCH,
            Self::Desktop | Self::Wide => sizes::CONTROL_HEIGHT,
        }
    }

    /// Width of the form beside the results.
    pub const fn form_width(self) -> f32 {
        match self {
            Self::Tablet => sizes::FORM_WIDTH_TABLET,
            Self::Wide => sizes::FORM_WIDTH_WIDE,
            _ => sizes::FORM_WIDTH,
        }
    }

    /// Left and right of a screen.
    pub const fn screen_margin(self) -> i8 {
        match self {
            Self::Phone => 16,
            Self::Tablet => 16,
            _ => 24,
        }
    }

    /// Left and right in the bars above and below the screen.
    pub const fn bar_margin(self) -> i8 {
        match self {
            Self::Phone | Self::Tablet => 16,
            _ => 24,
        }
    }

    /// Height of a control that stands in a line of text.
    pub const fn inline_control_height(self) -> f32 {
        match self {
            Self::Phone => sizes::CONTROL_HEIGHT_TOUCH,
            _ => 24.0,
        }
    }
}
