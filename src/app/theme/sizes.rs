//! Every size and distance that has a name, in points.

use egui::Margin;

/// The step that all distances are multiples of.
pub const STEP: f32 = 4.0;
/// Between cards, and from the cards to the edge of the window.
pub const GAP: f32 = 4.0 * STEP;
/// [`GAP`] on a wide screen.
pub const GAP_WIDE: f32 = 6.0 * STEP;
/// [`GAP`] on a phone.
pub const GAP_PHONE: f32 = 3.0 * STEP;
/// Above and below the contents of a column that scrolls.
pub const SCREEN_TOP: f32 = 16.0;
/// The lowest that a part of a dialog gets that scrolls: a field with its label and what is said of it.
pub const SCROLL_LEAST: f32 = 112.0;
/// What a bar takes that scrolls a column, at its right.
pub const SCROLL_GUTTER: f32 = 10.0;
/// The part of the middle column in what the form leaves on a wide screen.
pub const MIDDLE_SHARE: f32 = 0.558;
/// Width of the button that takes the example.
pub const EXAMPLE_BUTTON_WIDTH: f32 = 176.0;
/// Above and below the contents of the navigation bar.
pub const NAVIGATION_MARGIN: i8 = 9;
/// Above and below the notice.
pub const NOTICE_MARGIN: i8 = 6;
/// Above and below the result in the bar at the bottom.
pub const BAR_RESULT_MARGIN: i8 = 10;
/// Inside a card.
pub const CARD_PADDING: i8 = 15;
/// The corners of a card.
pub const CARD_RADIUS: u8 = 8;
/// The corners of a control.
pub const CONTROL_RADIUS: u8 = 6;
/// Height of a control for the mouse.
pub const CONTROL_HEIGHT: f32 = 36.0;
/// Height of the control of a quantity, for the mouse.
pub const FIELD_HEIGHT: f32 = 32.0;
/// Height of the lines above and below a field, where what is in them is for a finger.
pub const LINE_HEIGHT_TOUCH: f32 = 24.0;
/// From the label of a field to its control.
pub const LABEL_GAP: f32 = 2.0;
/// A field narrower than this, as one that stands beside another, has narrower parts.
pub const NARROW_FIELD_WIDTH: f32 = 240.0;
/// The narrowest form in which fields stand in pairs.
pub const PAIR_WIDTH: f32 = 352.0;
/// Inside the parts of a field, left and right.
pub const CELL_MARGIN: i8 = 10;
/// [`CELL_MARGIN`] in a part narrower than [`NARROW_CELL_WIDTH`].
pub const CELL_MARGIN_NARROW: i8 = 6;
/// See [`CELL_MARGIN_NARROW`].
pub const NARROW_CELL_WIDTH: f32 = 80.0;
/// From the left edge of a part of a field to its sign or unit.
pub const CELL_INDENT: f32 = 11.0;
/// [`CELL_INDENT`] in a narrow part.
pub const CELL_INDENT_NARROW: f32 = 7.0;
/// Width of the unit in a narrow field.
pub const UNIT_WIDTH_NARROW: f32 = 50.0;
/// Width of σ in a narrow field.
pub const SIGMA_WIDTH_NARROW: f32 = 64.0;
/// The arrow of a list.
pub const ARROW_WIDTH: f32 = 9.0;
/// The mark before a note: the room that it takes, its radius, and the size of its sign.
pub const NOTE_MARK_WIDTH: f32 = 18.0;
/// See [`NOTE_MARK_WIDTH`].
pub const NOTE_MARK_RADIUS: f32 = 5.5;
/// See [`NOTE_MARK_WIDTH`].
pub const NOTE_MARK_SIZE: f32 = 9.0;
/// The corner of the card of a note that points at its field.
pub const NOTE_TAIL: f32 = 5.0;
/// Where that corner points, as a part of the width of the field: into its number.
pub const NOTE_TAIL_AT: f32 = 0.33;
/// The same from the right edge, where its σ is meant.
pub const NOTE_TAIL_INSET: f32 = 40.0;
/// The narrowest a menu is.
pub const MENU_WIDTH: f32 = 132.0;
/// Height of a control for a finger.
pub const CONTROL_HEIGHT_TOUCH: f32 = 44.0;
/// Height of the line with the label of a field.
pub const LABEL_HEIGHT: f32 = 20.0;
/// Height of the line below a field, with its hint or a note.
pub const NOTE_LINE_HEIGHT: f32 = 22.0;
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
pub const CHOICE_HEIGHT: f32 = 20.0;
/// Left and right of its text.
pub const CHOICE_PADDING: f32 = 7.0;
/// Height of the heading of a section of the form.
pub const HEADING_HEIGHT: f32 = 16.0;
/// [`HEADING_HEIGHT`] where something in its line is for a finger.
pub const HEADING_HEIGHT_TOUCH: f32 = 30.0;
/// Above such a heading.
pub const ABOVE_HEADING: f32 = 8.0;
/// Between two fields.
pub const FIELD_GAP: f32 = 2.0;
/// Below the choice of what is asked for.
pub const BELOW_MODES: f32 = 12.0;
/// Above the buttons of the form.
pub const ABOVE_BUTTONS: f32 = 2.0;
/// Width of the button that copies the results.
pub const COPY_WIDTH: f32 = 113.0;
/// Width of the button that clears the form.
pub const RESET_WIDTH: f32 = 63.0;
/// The narrowest form in which all ways of asking are written out.
pub const NAMES_WIDTH: f32 = 300.0;
/// The narrowest form in which the buttons stand in one row.
pub const BUTTON_ROW_WIDTH: f32 = 340.0;
/// The mark before what opens a part.
pub const DISCLOSURE_WIDTH: f32 = 11.0;
/// Links in the form.
pub const LINK_SIZE: f32 = 13.0;
/// How long corrections are on the screen before a click or the key Tab can meet them, s.
pub const NOTE_CARD_DELAY: f64 = 0.3;
/// Width of the choice of a unit beside a field.
pub const UNIT_WIDTH: f32 = 72.0;
/// Width of the field for a σ.
pub const SIGMA_WIDTH: f32 = 104.0;
/// Width of the form beside the results.
pub const FORM_WIDTH: f32 = 400.0;
/// [`FORM_WIDTH`] on a wide screen.
pub const FORM_WIDTH_WIDE: f32 = 450.0;
/// The side of a button that is a sign, for a finger.
pub const ICON_BUTTON_TOUCH: f32 = 40.0;
/// Left and right of the name of a screen in its tab.
pub const TAB_PADDING: f32 = 12.0;
/// [`FORM_WIDTH`] on a tablet.
pub const FORM_WIDTH_TABLET: f32 = 344.0;
/// From the sides of an empty picture to the hint in it, both sides together.
pub const EMPTY_PICTURE_MARGINS: f32 = 48.0;
/// The widest that hint grows.
pub const EMPTY_PICTURE_TEXT_WIDTH: f32 = 300.0;
/// Height of a histogram with its axis.
pub const HISTOGRAM_HEIGHT: f32 = 150.0;
/// Height of the bar that shows how much of a simulation is done.
pub const PROGRESS_HEIGHT: f32 = 8.0;
/// Above and below the text in a cell of a table.
pub const CELL_PADDING: f32 = 7.0;
/// Between the columns of a table.
pub const COLUMN_GAP: f32 = 12.0;
/// Height of a badge, and left and right in it.
pub const BADGE_HEIGHT: f32 = 18.0;
/// See [`BADGE_HEIGHT`].
pub const BADGE_PADDING: f32 = 9.0;
/// Width of the ring around the focused widget.
pub const FOCUS_RING_WIDTH: f32 = 2.0;
/// Around the focused widget when it is scrolled into view.
pub const FOCUS_SCROLL_MARGIN: f32 = 12.0;
/// The widest the content grows.
pub const CONTENT_WIDTH: f32 = 2512.0;
/// The widest a column of text grows.
pub const TEXT_WIDTH: f32 = 720.0;
/// Around the words that say what can be dropped.
pub const DROP_MARGIN: Margin = Margin::symmetric(16, 12);
/// From the edges of the window to the contents of a dialog, both sides together.
pub const DIALOG_MARGINS: f32 = 72.0;
/// The height of a window in which every dialog is whole; in a lower one it scrolls.
pub const DIALOG_WHOLE_HEIGHT: f32 = 640.0;
/// Windows lower than this scroll as one piece.
pub const LOW_HEIGHT: f32 = 400.0;
/// The widest the list of keys grows.
pub const KEYS_WIDTH: f32 = 460.0;
/// The widest a helper grows.
pub const HELPER_WIDTH: f32 = 440.0;
/// What of the height of the window the parts of a helper do not get that scroll.
pub const HELPER_FRAME_HEIGHT: f32 = 180.0;
/// Width of the choice among common numbers for a field.
pub const COMMON_WIDTH: f32 = 200.0;
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
/// Whiskers, markers in pictures, and the border of what is wrong.
pub const STRONG_LINE: f32 = 1.5;
/// The object in a picture, and the ring around a point that can be moved.
pub const THICK_LINE: f32 = 3.0;
/// The corners of a mark in a legend, and of what stands behind a label in a picture.
pub const MARK_RADIUS: f32 = 3.0;
/// The corners of the bar beside a quotation.
pub const QUOTE_BAR_RADIUS: f32 = 1.5;

/// The number that answers the question.
pub const RESULT_SIZE: f32 = 20.0;
/// The result in the bar at the bottom.
pub const BAR_RESULT_SIZE: f32 = 18.0;
/// Headings that egui draws.
pub const HEADING_SIZE: f32 = 20.0;
/// The name of the program, and the heading of a dialog.
pub const TITLE_SIZE: f32 = 16.0;
/// A sign that is all of a button.
pub const ICON_SIZE: f32 = 17.0;
/// The heading of a card.
pub const CARD_HEADING_SIZE: f32 = 14.0;
/// Hints, captions and labels in pictures.
pub const SMALL_SIZE: f32 = 12.0;
/// What has no room gets no smaller than this.
pub const SMALLEST_SIZE: f32 = 10.0;
/// Text.
pub const BODY_SIZE: f32 = 14.0;
/// Text that is read at length.
pub const READING_SIZE: f32 = 15.5;
/// Formulas in it.
pub const READING_FORMULA_SIZE: f32 = 16.0;
/// Its headings of levels 1, 2, and 3 and below: the size of the text, and the space above.
pub const READING_HEADINGS: [(f32, f32); 3] = [(26.0, 0.0), (20.0, 20.0), (16.5, 10.0)];

/// The line with the heading of a card, …
pub const CARD_HEADING_HEIGHT: f32 = 20.0;
/// … and what is below it.
pub const BELOW_CARD_HEADING: f32 = 8.0;
/// Height of the strip with the answers.
pub const STRIP_HEIGHT: f32 = 128.0;
/// Height of one answer where they stand below each other.
pub const STRIP_CELL_HEIGHT: f32 = 118.0;
/// The narrowest strip in which the answers stand side by side.
pub const STRIP_WIDTH: f32 = 640.0;
/// Heights of the upper and the lower row of cards with pictures; they grow with the window.
pub const PICTURE_ROWS: [f32; 2] = [280.0, 372.0];
/// How much the rows of cards with pictures may grow in a higher window.
pub const PICTURE_GROWTH: f32 = 160.0;
/// The highest a card with a picture grows.
pub const PICTURE_MAX: f32 = 760.0;
/// From so many times as large on the picture of the letters is drawn larger than on a desk: for less it is not worth being narrower.
pub const LETTERS_LARGER: f32 = 1.2;
/// How large it gets at most.
pub const LETTERS_LARGEST: f32 = 1.9;
/// The highest that a view from the side gets.
pub const SIDE_VIEW_MAX: f32 = 540.0;
/// Height of the table of inputs and outputs on a wide screen.
pub const TABLE_HEIGHT: f32 = 426.0;
/// The least and the greatest height of its rows.
pub const ROW_HEIGHT: f32 = 20.0;
/// See [`ROW_HEIGHT`].
pub const ROW_HEIGHT_MAX: f32 = 30.0;
/// The size of its text.
pub const TABLE_SIZE: f32 = 13.0;
/// What a number has at least before its decimal point, and from there on, and the same of a σ.
pub const WHOLE_WIDTH: f32 = 28.0;
/// See [`WHOLE_WIDTH`].
pub const PART_WIDTH: f32 = 36.0;
/// See [`WHOLE_WIDTH`].
pub const SIGMA_WHOLE_WIDTH: f32 = 10.0;
/// Between the columns of numbers.
pub const NUMBER_GAP: f32 = 14.0;
/// The column of units.
pub const UNIT_COLUMN_WIDTH: f32 = 26.0;
/// The narrowest table in which descriptions stand.
pub const DESCRIBED_TABLE_WIDTH: f32 = 520.0;
/// The room for descriptions.
pub const DESCRIPTION_WIDTH: f32 = 182.0;
/// A tip over a picture: the height of a line, what is around its text, how far it is from what it is about.
pub const TIP_LINE: f32 = 18.0;
/// See [`TIP_LINE`].
pub const TIP_PADDING: egui::Vec2 = egui::vec2(12.0, 6.0);
/// See [`TIP_LINE`].
pub const TIP_DISTANCE: f32 = 14.0;
/// The ring around a point of a chart that is pointed at.
pub const RING_RADIUS: f32 = 11.0;
/// The ring around a point that can be moved, while it is used.
pub const HANDLE_HALO: f32 = 13.0;
/// In the strip: the middle of the title, …
pub const STRIP_TITLE: f32 = 10.0;
/// … of the value, …
pub const STRIP_VALUE: f32 = 40.0;
/// … and of both lines, from the top of its contents.
pub const STRIP_LINES: [f32; 2] = [69.0, 87.0];
/// Height of such a line.
pub const STRIP_LINE_HEIGHT: f32 = 17.0;
/// Height of the value.
pub const STRIP_VALUE_HEIGHT: f32 = 34.0;
/// The choice of the unit in the strip.
pub const STRIP_UNIT_HEIGHT: f32 = 24.0;
/// See [`STRIP_UNIT_HEIGHT`].
pub const STRIP_UNIT_WIDTH: f32 = 58.0;
/// The titles in the strip.
pub const STRIP_TITLE_SIZE: f32 = 13.0;
/// The dot before such a title.
pub const DOT_RADIUS: f32 = 4.5;
/// From the left edge of that dot to the title.
pub const AFTER_DOT: f32 = 16.0;
/// The number of the headline.
pub const HEADLINE_SIZE: f32 = 26.0;
/// What stands in place of a number.
pub const SENTENCE_SIZE: f32 = 16.0;
/// The line below a picture.
pub const FIGURE_NOTE: f32 = 22.0;
/// The lines of a paragraph of small text.
pub const PARAGRAPH_LINE: f32 = 20.0;
/// Height of the bar at the top.
pub const HEADER_HEIGHT: f32 = 55.0;
/// Height of the contents of the bar at the foot of a phone.
pub const BAR_HEIGHT: f32 = 44.0;
/// The line of the title in it.
pub const BAR_TITLE_HEIGHT: f32 = 20.0;
/// The button in it.
pub const BAR_BUTTON_WIDTH: f32 = 110.0;
/// The room for the answer in it.
pub const BAR_ANSWER_WIDTH: f32 = 162.0;
/// The narrowest card in which the image stands beside the side view, …
pub const SIDE_BY_SIDE_WIDTH: f32 = 640.0;
/// … how wide it is there, and how wide below it at most.
pub const IMAGE_VIEW_WIDTH: f32 = 208.0;
/// See [`IMAGE_VIEW_WIDTH`].
pub const IMAGE_VIEW_MAX: f32 = 326.0;
/// The line above the image of the ground plane.
pub const IMAGE_HEADING: f32 = 24.0;
/// What opens a part of the form: half of the base of its triangle, and its height.
pub const DISCLOSURE_HALF: f32 = 4.0;
/// See [`DISCLOSURE_HALF`].
pub const DISCLOSURE_TIP: f32 = 4.5;
/// The arrow of a menu, and from the right edge of its button to its middle.
pub const ARROW: egui::Vec2 = egui::vec2(8.0, 5.0);
/// See [`ARROW`].
pub const ARROW_INSET: f32 = 12.0;
/// How far letters reach out of their line in the strip.
pub const STRIP_BLEED: f32 = 2.0;
/// The dots below a number that leads to its field.
pub const DOT_LINE: f32 = 1.5;
/// The size of a subscript, as a part of that of the text, and the height of its line, which lets it hang below the text.
pub const SUBSCRIPT_SIZE: f32 = 0.76;
/// See [`SUBSCRIPT_SIZE`].
pub const SUBSCRIPT_LINE: f32 = 0.95;

/// The pictures of the report.
pub mod paper {
    /// How wide a column of pictures is: two of them with a gap fill a page of A4, in CSS pixels.
    pub const COLUMN: f32 = 325.0;
    /// How high the rows of a comparison are, …
    pub const ROWS_HEIGHT: f32 = 172.0;
    /// … and a curve or a view: both rows of pictures and the table fit a page of Letter, with little to spare.
    pub const VIEW_HEIGHT: f32 = 165.0;
    /// The same of the ground plane, whose table is longer.
    pub const GROUND_HEIGHT: f32 = 136.0;
}

/// The widest the dialogs with what everybody knows grow.
pub const PRESETS_WIDTH: f32 = 560.0;
/// What of the height of the window their lists do not get.
pub const PRESETS_FRAME_HEIGHT: f32 = 250.0;
/// The widest the dialog with the facts of a camera grows.
pub const CAMERA_WIDTH: f32 = 640.0;
/// What of the height of the window its fields do not get, beside what is said of them.
pub const CAMERA_FRAME_HEIGHT: f32 = 200.0;
/// The dialog with what calibration files say.
pub const IMPORT_WIDTH: f32 = 720.0;
/// What of that dialog does not scroll, and what is around it.
pub const IMPORT_FRAME_HEIGHT: f32 = 190.0;
/// The columns of its table: what, value, where it stands.
pub const IMPORT_SHARES: [f32; 3] = [1.0, 1.5, 1.5];
/// The name of a rig is broken into lines no shorter than this.
pub const RIG_NAME_WIDTH: f32 = 100.0;
/// The first column of the rigs side by side, in columns of rigs.
pub const RIG_HEADER_SHARE: f32 = 1.2;
