//! A segmented control: a few choices that are all in sight, joined in one border.

use super::choice;
use crate::app::theme;
use egui::accesskit::{Role, Toggled};
use egui::{Rect, Sense, Stroke, StrokeKind, Ui, UiBuilder, pos2, vec2};

/// A choice among `names`, of which that at `chosen` holds; none where another control holds it.
pub struct Segments<'a> {
    /// What is chosen among, for assistive technology.
    pub group: &'a str,
    /// The choices, in reading order.
    pub names: &'a [&'a str],
    /// What is written in their place where there is little room; `None` for the names.
    pub written: Option<&'a [&'a str]>,
    /// The one that holds.
    pub chosen: Option<usize>,
}

impl Segments<'_> {
    /// The widths that the names need in one row that is `width` wide.
    pub fn widths(&self, ui: &Ui, width: f32) -> Vec<f32> {
        let needed = |name: &&str| {
            let font = theme::strong(theme::SMALL_SIZE);
            ui.painter()
                .layout_no_wrap((*name).to_owned(), font, theme::palette(ui).text)
                .size()
                .x
        };
        let needed: Vec<f32> = self.names.iter().map(needed).collect();
        let count = f32::from(u16::try_from(needed.len()).unwrap_or(u16::MAX).max(1));
        let spare = (width - needed.iter().sum::<f32>()) / count;
        needed.into_iter().map(|needed| needed + spare).collect()
    }

    /// Draws the choices in `cells`: one stop of the key Tab, among them by the arrow keys. Returns the one that was chosen now.
    pub fn ui(&self, ui: &mut Ui, cells: &[Rect]) -> Option<usize> {
        let place = UiBuilder::new()
            .id_salt(self.group)
            .accessibility_role(Role::RadioGroup)
            .accessibility_label(self.group)
            .max_rect(cells.iter().fold(Rect::NOTHING, |all, cell| all.union(*cell)));
        let ui = ui.new_child(place);
        let coming = ui.scope_id().with("the focus comes");
        let comes = ui.data_mut(|data| data.remove_temp::<bool>(coming)).is_some();
        let mut now = None;
        let mut focused = None;
        let first = self.chosen.unwrap_or(0);
        for (index, (name, &cell)) in self.names.iter().zip(cells).enumerate() {
            let is_chosen = self.chosen == Some(index);
            let sense = if index == first { Sense::click() } else { Sense::CLICK };
            let response = ui.interact(cell, ui.scope_id().with(index), sense);
            ground_ui(&ui, cell, is_chosen || response.hovered());
            let written = self.written.and_then(|written| written.get(index)).unwrap_or(name);
            name_ui(&ui, cell, written, is_chosen);
            response.widget_info(|| egui::WidgetInfo::labeled(Role::RadioButton, true, *name));
            ui.accesskit_node_builder(response.id, |node| {
                node.set_toggled(if is_chosen { Toggled::True } else { Toggled::False });
            });
            if response.clicked() {
                now = Some(index);
            }
            if index == first && comes {
                response.request_focus();
            }
            if response.has_focus() {
                focused = Some((index, response.id));
            }
            response.on_hover_cursor(egui::CursorIcon::PointingHand);
        }
        if let Some((index, id)) = focused
            && let steps = choice::steps(&ui, id)
            && steps != 0
            && let Some(next) = (index + self.names.len()).checked_add_signed(steps)
        {
            now = Some(next % self.names.len());
            ui.data_mut(|data| data.insert_temp(coming, true));
        }
        now.filter(|now| self.chosen != Some(*now))
    }
}

/// The ground of a segment, lit up where it is chosen or pointed at.
pub fn ground_ui(ui: &Ui, cell: Rect, is_lit: bool) {
    if is_lit {
        let ground = cell.shrink(theme::THIN_LINE);
        ui.painter()
            .rect_filled(ground, theme::CONTROL_RADIUS - 1, theme::palette(ui).highlight);
    }
}

/// The name of a segment in the middle of `cell`.
pub fn name_ui(ui: &Ui, cell: Rect, name: &str, is_chosen: bool) {
    let palette = theme::palette(ui);
    let (font, color) = if is_chosen {
        (theme::strong(theme::SMALL_SIZE), palette.text)
    } else {
        (theme::regular(theme::SMALL_SIZE), palette.muted)
    };
    ui.painter().text(cell.center(), egui::Align2::CENTER_CENTER, name, font, color);
    if is_chosen {
        // Where colors are forced, all grounds are the same.
        let line = cell.shrink2(vec2(2.0 * theme::STEP, 0.0));
        if palette.highlight == palette.surface {
            let stroke = Stroke::new(theme::FOCUS_RING_WIDTH, palette.text);
            ui.painter().hline(line.x_range(), line.bottom() - theme::STEP, stroke);
        }
    }
}

/// The border of segments over `whole`, and the hairlines at the left of all `cells` but those at its edges.
pub fn border_ui(ui: &Ui, whole: Rect, cells: &[Rect]) {
    let palette = theme::palette(ui);
    let hairline = Stroke::new(theme::THIN_LINE, palette.line);
    for cell in cells {
        if cell.left() > whole.left() + 1.0 {
            ui.painter().vline(cell.left(), cell.y_range(), hairline);
        }
        if cell.top() > whole.top() + 1.0 {
            ui.painter().hline(cell.x_range(), cell.top(), hairline);
        }
    }
    let border = Stroke::new(theme::THIN_LINE, palette.border);
    ui.painter().rect_stroke(whole, theme::CONTROL_RADIUS, border, StrokeKind::Inside);
}

/// Cells of one row, from the left edge of `row`, with these widths.
pub fn row(row: Rect, widths: &[f32]) -> Vec<Rect> {
    let mut left = row.left();
    let cell = |width: &f32| {
        let cell = Rect::from_min_max(pos2(left, row.top()), pos2(left + width, row.bottom()));
        left += width;
        cell
    };
    widths.iter().map(cell).collect()
}

/// Cells of a grid over `whole` with `columns` columns and `rows` rows, row by row.
pub fn grid(whole: Rect, columns: u16, rows: u16) -> Vec<Rect> {
    let size = vec2(whole.width() / f32::from(columns.max(1)), whole.height() / f32::from(rows.max(1)));
    let cell = |index: u16| {
        let (column, row) = (index % columns.max(1), index / columns.max(1));
        let offset = vec2(f32::from(column) * size.x, f32::from(row) * size.y);
        Rect::from_min_size(whole.min + offset, size)
    };
    (0..columns * rows).map(cell).collect()
}
