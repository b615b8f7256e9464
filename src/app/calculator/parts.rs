//! What the forms of all modes are made of: headings, fields, and parts with ids of their own.

use crate::app::command::Helper;
use crate::app::context::AppContext;
use crate::app::theme;
use crate::app::widgets::field::{self, Field};
use crate::app::widgets::{symbols, text};
use depth_text::entry::Entry;
use depth_text::field::{Key, Section};
use depth_text::reading;
use egui::{Rect, Sense, Ui, UiBuilder, vec2};

/// The heading of a part of the form, in the color of `section`. Returns what is left of its line.
pub fn heading_ui(ui: &mut Ui, name: &str, section: Option<Section>) -> Rect {
    let palette = theme::palette(ui);
    let has_choice = matches!(section, Some(Section::Stereo | Section::Monocular));
    let is_for_fingers = ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH;
    let height = if has_choice && is_for_fingers {
        theme::HEADING_HEIGHT_TOUCH
    } else {
        theme::HEADING_HEIGHT
    };
    let (line, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let color = section.and_then(|section| section.keys().next()).map_or(palette.muted, |key| {
        let color = symbols::color(palette, key);
        if color == palette.text { palette.muted } else { color }
    });
    let place = UiBuilder::new()
        .id_salt(name)
        .max_rect(line)
        .layout(egui::Layout::left_to_right(egui::Align::Center));
    let mut inside = ui.new_child(place);
    let heading = text::heading_ui(&mut inside, name, 2, theme::strong(theme::SMALL_SIZE), color);
    ui.add_space(theme::LABEL_GAP);
    line.with_min_x(heading.rect.right() + theme::STEP)
}

/// The words over the column of σ, in the line of a heading.
pub fn sigma_heading_ui(ui: &Ui, line: Rect, is_pair: bool) {
    let palette = theme::palette(ui);
    let width = if is_pair { theme::SIGMA_WIDTH_NARROW } else { theme::SIGMA_WIDTH };
    let indent = if is_pair { theme::CELL_INDENT_NARROW } else { theme::CELL_INDENT };
    let at = line.right_center() - vec2(width - indent, 0.0);
    let font = theme::regular(theme::SMALL_SIZE);
    ui.painter().text(at, egui::Align2::LEFT_CENTER, "± is 1 σ", font, palette.muted);
}

/// Draws a field of the form. Returns the line of its label.
pub fn field_ui(ui: &mut Ui, cx: &mut AppContext<'_>, key: Key, marked: bool) -> Rect {
    let helper = key
        .input
        .and_then(Helper::at)
        .filter(|_| ui.available_width() >= theme::NARROW_FIELD_WIDTH);
    let (inputs, assessment) = cx.session.parts();
    let missing = assessment.missing.iter().find(|note| marked && note.key == key);
    let value_note = assessment.note(key).or(missing);
    let before = inputs.entry(key).clone();
    let field = Field {
        key: inputs.worded(key),
        reading: assessment.reading(key),
        notes: value_note.into_iter().chain(assessment.sigma_note(key)).collect(),
        with_sigma: true,
        helper,
        id: field::id(key),
        submits: true,
        following: None,
        entry: inputs.entry_mut(key),
    };
    let line = field.ui(ui, cx.commands);
    let value = |entry: &Entry| Some(reading::read(key, entry).ok()??.value);
    let now = inputs.entry(key);
    // Not where only a space or a σ was added, nor while it cannot be read.
    if now.text != before.text && value(now).is_some() && value(now) != value(&before) {
        inputs.edited(key);
    }
    line
}

/// A part of the form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// A section.
    Section(Section),
    /// A field, by its key.
    Field(&'static str),
    /// What comes behind the fields.
    Late,
    /// The buttons.
    Buttons,
    /// What refines a distance.
    Refinements,
}

/// Draws a part of the form in a scope with an id of its own. Otherwise an error that appears would change the ids of all widgets
/// after it, and with them the nodes that a screen reader knows.
pub fn part_ui<R>(ui: &mut Ui, part: Part, add_contents: impl FnOnce(&mut Ui) -> R) -> R {
    let builder = UiBuilder::new().scope_id(egui::Id::unique(("part of the form", part)));
    ui.scope_builder(builder, add_contents).inner
}
