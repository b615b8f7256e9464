//! Every size and distance that has a name, in points.

use egui::Margin;

/// The step that all distances are multiples of.
pub const STEP: f32 = 4.0;
/// Between cards, and from the cards to the edge of the window.
pub const GAP: f32 = 4.0 * STEP;
/// [`GAP`] on a phone.
pub const GAP_PHONE: f32 = 3.0 * STEP;
/// Between the navigation bar and a screen.
pub const SCREEN_TOP: i8 = 16;
/// Above and below the contents of the navigation bar.
pub const NAVIGATION_MARGIN: i8 = 8;
/// Above and below the notice.
pub const NOTICE_MARGIN: i8 = 6;
/// Above and below the result in the bar at the bottom.
pub const BAR_RESULT_MARGIN: i8 = 10;
/// Inside a card.
pub const CARD_PADDING: i8 = 16;
/// The corners of a card.
pub const CARD_RADIUS: u8 = 10;
/// The corners of a control.
pub const CONTROL_RADIUS: u8 = 6;
/// Height of a control for the mouse.
pub const CONTROL_HEIGHT: f32 = 36.0;
/// Height of a control for a finger.
pub const CONTROL_HEIGHT_TOUCH: f32 = 44.0;
/// Height of the line with the label of a field.
pub const LABEL_HEIGHT: f32 = 20.0;
/// From the heading of a section of the form to its first field.
pub const FIRST_FIELD_SPACE: f32 = 2.0;
/// Between the text of a field, its unit, and its σ.
pub const FIELD_PARTS_GAP: f32 = 6.0;
/// Height of the line below a field, with its hint or a note.
pub const NOTE_LINE_HEIGHT: f32 = 24.0;
/// [`NOTE_LINE_HEIGHT`] where a correction in it is for a finger.
pub const NOTE_LINE_HEIGHT_TOUCH: f32 = 32.0;
/// From a note to the correction in its line.
pub const NOTE_FIX_GAP: f32 = 12.0;
/// What a note has left in its line, if there is a correction too.
pub const NOTE_TEXT_MIN_WIDTH: f32 = 120.0;
/// Inside the card with the whole note.
pub const NOTE_CARD_MARGIN: Margin = Margin::symmetric(12, 8);
/// Between the texts on that card, and from them to the corrections.
pub const NOTE_CARD_GAP: f32 = 6.0;
/// Height of a correction on that card for the mouse.
pub const NOTE_FIX_HEIGHT: f32 = 28.0;
/// Height of one of a few choices that are all in sight, with a pointer.
pub const CHOICE_HEIGHT: f32 = 26.0;
/// Left and right of its text.
pub const CHOICE_PADDING: f32 = 7.0;
/// Between two of them.
pub const CHOICE_GAP: f32 = 2.0;
/// Height of the heading of a section of the form.
pub const HEADING_HEIGHT: f32 = 16.0;
/// How long that card is open before a click can meet its corrections, s.
pub const NOTE_CARD_DELAY: f64 = 0.3;
/// Inside a field.
pub const FIELD_MARGIN: Margin = Margin::symmetric(10, 4);
/// Inside the field for a σ.
pub const SIGMA_MARGIN: Margin = Margin::symmetric(8, 4);
/// Left of a unit that cannot be chosen.
pub const UNIT_INDENT: f32 = 11.0;
/// Left and right of what stands in place of a field.
pub const SOLVED_INDENT: f32 = 10.0;
/// Width of the choice of a unit beside a field.
pub const UNIT_WIDTH: f32 = 76.0;
/// Width of the field for a σ.
pub const SIGMA_WIDTH: f32 = 88.0;
/// Width of the form beside the results.
pub const FORM_WIDTH: f32 = 372.0;
/// [`FORM_WIDTH`] on a tablet.
pub const FORM_WIDTH_TABLET: f32 = 320.0;
/// Height of a picture.
pub const PICTURE_HEIGHT: f32 = 216.0;
/// From the sides of an empty picture to the hint in it, both sides together.
pub const EMPTY_PICTURE_MARGINS: f32 = 48.0;
/// The widest that hint grows.
pub const EMPTY_PICTURE_TEXT_WIDTH: f32 = 300.0;
/// The curve of a plot.
pub const CURVE_LINE: f32 = 2.5;
/// The radius of the point on a curve that can be moved.
pub const CURVE_POINT_RADIUS: f32 = 7.0;
/// From the middle of that point to its label beside it.
pub const CURVE_LABEL_GAP: f32 = 14.0;
/// From the middle of that point up to its label.
pub const CURVE_LABEL_RISE: f32 = 12.0;
/// Around the text of that label.
pub const CURVE_LABEL_PADDING: f32 = 2.0;
/// Height of the bar that is cut into the shares of the variance.
pub const BUDGET_BAR_HEIGHT: f32 = 20.0;
/// Height of a line of the legend below it.
pub const LEGEND_HEIGHT: f32 = 20.0;
/// The side of a mark in that legend.
pub const LEGEND_MARK: f32 = 12.0;
/// Height of a histogram with its labels.
pub const HISTOGRAM_HEIGHT: f32 = 120.0;
/// Height of the labels below a histogram.
pub const HISTOGRAM_LABELS_HEIGHT: f32 = 18.0;
/// Height of the bar that shows how much of a simulation is done.
pub const PROGRESS_HEIGHT: f32 = 8.0;
/// From the number that answers the question to its unit.
pub const RESULT_UNIT_GAP: f32 = 2.0;
/// Above and below the text in a cell of a table.
pub const CELL_PADDING: f32 = 7.0;
/// Between the columns of a table.
pub const COLUMN_GAP: f32 = 12.0;
/// A table narrower than this has small text.
pub const NARROW_TABLE_WIDTH: f32 = 480.0;
/// Inside a badge.
pub const BADGE_MARGIN: Margin = Margin::symmetric(9, 2);
/// Width of the ring around the focused widget.
pub const FOCUS_RING_WIDTH: f32 = 2.0;
/// Around the focused widget when it is scrolled into view.
pub const FOCUS_SCROLL_MARGIN: f32 = 12.0;
/// The widest the content grows.
pub const CONTENT_WIDTH: f32 = 1880.0;
/// The widest a column of text grows.
pub const TEXT_WIDTH: f32 = 720.0;
/// From the edges of the window to the contents of a dialog, both sides together.
pub const DIALOG_MARGINS: f32 = 72.0;
/// The widest the list of keys grows.
pub const KEYS_WIDTH: f32 = 460.0;
/// The widest a helper grows.
pub const HELPER_WIDTH: f32 = 440.0;
/// What of the height of the window the parts of a helper do not get that scroll.
pub const HELPER_FRAME_HEIGHT: f32 = 180.0;
/// Width of the choice among the formats of sensors.
pub const SENSOR_FORMATS_WIDTH: f32 = 200.0;
/// The widest the dialog About grows.
pub const ABOUT_WIDTH: f32 = 640.0;
/// What of the height of the window the text of the licenses does not get.
#[cfg(not(target_arch = "wasm32"))]
pub const ABOUT_FRAME_HEIGHT: f32 = 360.0;
/// The lowest that text gets: a few lines.
#[cfg(not(target_arch = "wasm32"))]
pub const LICENSES_MIN_HEIGHT: f32 = 96.0;
/// The button that closes a dialog.
pub const DIALOG_BUTTON_WIDTH: f32 = 96.0;
/// The highest a menu grows: all its choices, where the window allows.
pub const MENU_HEIGHT: f32 = 440.0;
/// Inside a menu.
pub const MENU_MARGIN: i8 = 6;

/// Between blocks of text that is read at length.
pub const READING_BLOCK_GAP: f32 = 10.0;
/// Left of the items of a list.
pub const LIST_INDENT: f32 = 24.0;
/// Inside a quotation.
pub const QUOTE_MARGIN: Margin = Margin {
    left: 14,
    right: 10,
    top: 10,
    bottom: 2,
};
/// Width of the bar beside a quotation.
pub const QUOTE_BAR_WIDTH: f32 = 3.0;
/// Inside the box of a formula.
pub const FORMULA_MARGIN: Margin = Margin::symmetric(16, 12);

/// Borders, and lines that only separate.
pub const THIN_LINE: f32 = 1.0;
/// Lines of sight.
pub const SIGHT_LINE: f32 = 1.2;
/// Whiskers, markers in pictures, and the border of what is wrong.
pub const STRONG_LINE: f32 = 1.5;
/// The object in a picture, and the ring around a point that can be moved.
pub const THICK_LINE: f32 = 3.0;
/// The corners of a badge.
pub const BADGE_RADIUS: u8 = 10;
/// The corners of the span in which the object may be.
pub const SPAN_RADIUS: f32 = 5.0;
/// The corners of a mark in a legend, and of what stands behind a label in a picture.
pub const MARK_RADIUS: f32 = 3.0;
/// The corners of the smallest things in a picture.
pub const SMALL_MARK_RADIUS: f32 = 2.0;
/// The corners of the bar beside a quotation.
pub const QUOTE_BAR_RADIUS: f32 = 1.5;

/// The number that answers the question.
pub const RESULT_SIZE: f32 = 34.0;
/// The unit behind it.
pub const RESULT_UNIT_SIZE: f32 = 18.0;
/// The result in the bar at the bottom.
pub const BAR_RESULT_SIZE: f32 = 18.0;
/// Headings that egui draws.
pub const HEADING_SIZE: f32 = 20.0;
/// The name of the program, and the heading of a dialog.
pub const TITLE_SIZE: f32 = 17.0;
/// A sign that is all of a button.
pub const ICON_SIZE: f32 = 17.0;
/// The heading of the results.
pub const RESULTS_HEADING_SIZE: f32 = 16.0;
/// The heading of a card.
pub const CARD_HEADING_SIZE: f32 = 13.5;
/// Hints, captions and labels in pictures.
pub const SMALL_SIZE: f32 = 12.5;
/// Text.
pub const BODY_SIZE: f32 = 14.5;
/// Text that is read at length.
pub const READING_SIZE: f32 = 15.5;
/// Formulas in it.
pub const READING_FORMULA_SIZE: f32 = 16.0;
/// Its headings of levels 1, 2, and 3 and below: the size of the text, and the space above.
pub const READING_HEADINGS: [(f32, f32); 3] = [(26.0, 0.0), (20.0, 20.0), (16.5, 10.0)];

/// The picture of the scene from above.
pub mod top_view {
    /// Between the edge of the picture, or of its inset, and what is in it.
    pub const PADDING: f32 = 4.0;
    /// Below the cameras.
    pub const BELOW_CAMERAS: f32 = 26.0;
    /// Above the object.
    pub const ABOVE_OBJECT: f32 = 22.0;
    /// Cameras that would be drawn closer together than this are enlarged in an inset.
    pub const CLOSE_CAMERAS: f32 = 24.0;
    /// The strokes of a line of sight.
    pub const DASH: f32 = 4.0;
    /// Between them.
    pub const DASH_GAP: f32 = 3.0;
    /// Half of the width of the span in which the object may be.
    pub const SPAN_HALF_WIDTH: f32 = 5.0;
    /// The radius of the object.
    pub const OBJECT_RADIUS: f32 = 4.5;
    /// From the object to its label.
    pub const OBJECT_LABEL_GAP: f32 = 10.0;
    /// From the bottom of the picture up to the middle of the baseline's label.
    pub const BASELINE_LABEL_RISE: f32 = 9.0;
    /// Around the text of a label.
    pub const LABEL_PADDING: f32 = 1.0;

    /// The width and the height of a camera's body.
    pub const CAMERA_WIDTH: f32 = 15.0;
    /// See [`CAMERA_WIDTH`].
    pub const CAMERA_HEIGHT: f32 = 9.0;
    /// From the center of projection down to the middle of the body.
    pub const CAMERA_DROP: f32 = 7.0;
    /// From the center of projection up to the tip of the lens.
    pub const LENS_TIP: f32 = 1.0;
    /// From the center of projection down to the base of the lens, and to both sides of it.
    pub const LENS_BASE: f32 = 4.0;

    /// The widest the inset grows.
    pub const INSET_WIDTH: f32 = 132.0;
    /// Its height.
    pub const INSET_HEIGHT: f32 = 92.0;
    /// From its bottom up to the cameras.
    pub const INSET_CAMERAS_RISE: f32 = 34.0;
    /// From its top down to the ends of the lines of sight.
    pub const INSET_SIGHT_DROP: f32 = 20.0;
    /// From its top down to the middle of its title.
    pub const INSET_TITLE_DROP: f32 = 10.0;
    /// From its bottom up to the middle of the baseline's label.
    pub const INSET_LABEL_RISE: f32 = 11.0;

    /// From the lower right corner of the picture to the bar of the scale.
    pub const SCALE_MARGIN: f32 = 8.0;
    /// The ends of that bar.
    pub const SCALE_TICK: f32 = 5.0;
    /// From that bar up to the middle of its label.
    pub const SCALE_LABEL_RISE: f32 = 12.0;
}
