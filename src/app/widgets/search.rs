//! A list in which something is found by typing.

use super::{joined, text, text_menu};
use crate::app::command::Command;
use crate::app::theme;
use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{Id, Key, Modifiers, Rect, Response, Sense, Stroke, Ui, vec2};

/// A row of the list.
pub struct Row {
    /// What it is called.
    pub title: String,
    /// What else is said of it, below.
    pub detail: String,
    /// Other words by which it is found.
    pub words: &'static str,
}

impl Row {
    /// Whether each word of `typed` is in it.
    fn matches(&self, typed: &str) -> bool {
        let all = plain(&format!("{} {} {}", self.title, self.detail, self.words));
        plain(typed).split_whitespace().all(|word| all.contains(word))
    }
}

/// In small letters, and sizes as people type them: 640x480.
fn plain(text: &str) -> String {
    text.to_ascii_lowercase().replace(" × ", "x").replace(['×', '*'], "x")
}

/// A list named `name`.
pub struct Search<'a> {
    pub id: &'static str,
    pub name: &'a str,
    /// What could be typed.
    pub example: &'a str,
    /// How high the list may be.
    pub height: f32,
    /// Whether the focus comes into the field when it opens: not where that opens a keyboard.
    pub takes_focus: bool,
}

impl Search<'_> {
    /// Draws the field and the rows that match it. Returns the place of the row that was chosen now, by a click or by Enter for the first.
    pub fn ui(&self, ui: &mut Ui, rows: &[Row], commands: &mut Vec<Command>) -> Option<usize> {
        let id = Id::unique(("search", self.id));
        let frame = ui.ctx().cumulative_frame_nr();
        // What was typed is forgotten with the dialog, however it was closed.
        let last = ui
            .data(|data| data.get_temp::<(u64, String)>(id))
            .filter(|(last, _)| frame <= last + 1);
        let is_new = last.is_none();
        let mut typed = last.map(|(_, typed)| typed).unwrap_or_default();
        let field = self.field_ui(ui, &mut typed, id);
        text_menu::ui(&field, &mut typed, commands);
        if is_new && self.takes_focus {
            field.request_focus();
        }
        let matching: Vec<usize> = (0..).zip(rows).filter(|(_, row)| row.matches(&typed)).map(|(at, _)| at).collect();
        let takes_enter = field.has_focus() || field.lost_focus();
        let is_entered = takes_enter && !typed.trim().is_empty() && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
        ui.data_mut(|data| data.insert_temp(id, (frame, typed)));
        let count = match matching.len() {
            0 => format!("None of {} has all these words.", rows.len()),
            count => format!("{count} of {}", rows.len()),
        };
        let said = text::caption_ui(ui, count);
        text::announce(ui, &said);
        ui.add_space(theme::STEP);
        let mut chosen = matching.first().copied().filter(|_| is_entered);
        super::scroll::up_to_ui(ui, self.height, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for at in matching {
                let Some(row) = rows.get(at) else { continue };
                if row_ui(ui, row, id.with(at)).clicked() {
                    chosen = Some(at);
                }
            }
        });
        chosen
    }

    fn field_ui(&self, ui: &mut Ui, typed: &mut String, id: Id) -> Response {
        let height = ui.spacing().interact_size.y;
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
        let cells = joined::Cells::of(rect, false, false);
        joined::ground_ui(ui, &cells, false);
        let output = joined::words_ui(ui, rect, typed, (id.with("typed"), self.example));
        let response = output.response.response.clone().accessible_name(self.name);
        ui.accesskit_node_builder(response.id, |node| node.set_role(Role::SearchInput));
        joined::border_ui(ui, &cells, None, response.has_focus());
        response
    }
}

/// A row: a button over the full width.
fn row_ui(ui: &mut Ui, row: &Row, id: Id) -> Response {
    let palette = theme::palette(ui);
    let width = ui.available_width();
    let mut job = LayoutJob::default();
    job.append(&row.title, 0.0, TextFormat::simple(theme::strong(theme::BODY_SIZE), palette.text));
    job.append("\n", 0.0, TextFormat::simple(theme::regular(theme::SMALL_SIZE), palette.muted));
    job.append(
        &row.detail,
        0.0,
        TextFormat::simple(theme::regular(theme::SMALL_SIZE), palette.muted),
    );
    job.wrap.max_width = width - 2.0 * theme::STEP;
    let galley = ui.painter().layout_job(job);
    let height = (galley.size().y + 2.0 * theme::CELL_PADDING).max(ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let response = ui.interact(rect, id, Sense::click());
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    }
    let at = Rect::from_center_size(rect.center(), vec2(width - 2.0 * theme::STEP, galley.size().y)).min;
    ui.painter().galley(at, galley, palette.text);
    ui.painter()
        .hline(rect.x_range(), rect.bottom(), Stroke::new(theme::THIN_LINE, palette.line));
    let said = format!("{}. {}", row.title, row.detail);
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Button, true, &said));
    response.on_hover_cursor(egui::CursorIcon::PointingHand)
}

#[cfg(test)]
mod tests {
    use super::Row;

    #[test]
    fn what_is_typed_finds_by_words_in_any_order_and_sizes_in_any_spelling() {
        let row = Row {
            title: "RealSense D435i, 640 × 480 px".to_owned(),
            detail: "378.806 px, 49.864 mm. One unit".to_owned(),
            words: "realsense-d435i",
        };
        for typed in ["", "d435", "640 realsense", "640x480", "640×480", "D435I one unit", "640 × 480"] {
            assert!(row.matches(typed), "{typed}");
        }
        for typed in ["d455", "640x360", "d435i kitti"] {
            assert!(!row.matches(typed), "{typed}");
        }
    }
}
