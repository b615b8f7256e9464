//! Every size and distance that has a name, in points.

/// The step that all distances are multiples of.
pub const STEP: f32 = 4.0;
/// Between cards, and from the cards to the edge of the window.
pub const GAP: f32 = 4.0 * STEP;
/// [`GAP`] on a phone.
pub const GAP_PHONE: f32 = 3.0 * STEP;
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
/// The widest the content grows.
pub const CONTENT_WIDTH: f32 = 1880.0;
/// The widest a column of text grows.
pub const TEXT_WIDTH: f32 = 720.0;
/// From the edges of the window to the contents of a dialog, both sides together.
pub const DIALOG_MARGINS: f32 = 72.0;
/// The button that closes a dialog.
pub const DIALOG_BUTTON_WIDTH: f32 = 96.0;
/// The highest a menu grows: all its choices, where the window allows.
pub const MENU_HEIGHT: f32 = 440.0;
/// Inside a menu.
pub const MENU_MARGIN: i8 = 6;

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
/// The quantity that was solved for, where it is not the distance.
pub const SOLVED_SIZE: f32 = 26.0;
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
/// Its headings of levels 1, 2, and 3 and below.
pub const READING_HEADING_SIZES: [f32; 3] = [26.0, 20.0, 16.5];
