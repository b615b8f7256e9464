//! Tables with accessible roles: a named table, rows and cells.

use crate::app::theme;
use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{Label, Rect, Response, Sense, Stroke, Ui, UiBuilder, pos2, vec2};

/// One cell of a row.
#[derive(Debug)]
pub struct Cell {
    /// Its text.
    pub text: LayoutJob,
    /// `Role::Cell`, `Role::RowHeader` or `Role::ColumnHeader`.
    pub role: Role,
    /// Numbers are aligned at the right, so that they can be compared.
    pub align_right: bool,
}

/// A table named `name`; `add_rows` calls [`row_ui`].
pub fn table_ui(ui: &mut Ui, name: &str, add_rows: impl FnOnce(&mut Ui)) -> Response {
    let builder = UiBuilder::new().accessibility_role(Role::Table).accessibility_label(name);
    let scope = ui.scope_builder(builder, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        add_rows(ui);
    });
    scope.response
}

/// A cell at its place in a row.
pub struct Placed {
    /// Its text.
    pub text: LayoutJob,
    /// `Role::Cell`, `Role::RowHeader` or `Role::ColumnHeader`.
    pub role: Role,
    /// From the left edge of the row to its text.
    pub left: f32,
    /// What is shown while the pointer rests on it; may be empty.
    pub tooltip: String,
    /// What assistive technology reads instead, where the text is shortened.
    pub said: Option<String>,
}

/// A row `height` high of cells at their places, over a line of this color.
pub fn placed_row_ui(ui: &mut Ui, height: f32, cells: Vec<Placed>, line: egui::Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let mut row = ui.new_child(UiBuilder::new().accessibility_role(Role::Row).max_rect(rect));
    for cell in cells {
        let galley = ui.painter().layout_job(cell.text);
        let top = rect.center().y - galley.size().y / 2.0;
        let place = Rect::from_min_size(pos2(rect.left() + cell.left, top), galley.size());
        let label = row
            .new_child(UiBuilder::new().accessibility_role(cell.role).max_rect(place))
            .add(Label::new(galley));
        if let Some(said) = cell.said {
            ui.accesskit_node_builder(label.id, |node| node.set_value(said));
        }
        if !cell.tooltip.is_empty() {
            label.on_hover_text(cell.tooltip);
        }
    }
    ui.painter()
        .hline(rect.x_range(), rect.bottom(), Stroke::new(theme::THIN_LINE, line));
}

/// A row of `cells`, each with its share of the width, over a thin line.
pub fn row_ui(ui: &mut Ui, cells: Vec<Cell>, shares: &[f32]) {
    let palette = theme::palette(ui);
    let total: f32 = shares.iter().sum();
    let full = ui.available_width();
    let mut x = 0.0;
    let mut placed = Vec::new();
    let mut height = 0.0_f32;
    let last = cells.len().saturating_sub(1);
    for (index, (mut cell, share)) in cells.into_iter().zip(shares).enumerate() {
        let width = full * share / total;
        // Behind the last column is the edge of the card.
        let gap = if index == last { 0.0 } else { theme::COLUMN_GAP };
        cell.text.wrap.max_width = (width - gap).max(1.0);
        let galley = ui.painter().layout_job(cell.text);
        height = height.max(galley.size().y);
        let left = if cell.align_right { x + width - gap - galley.size().x } else { x };
        placed.push((cell.role, left, galley));
        x += width;
    }
    let (rect, _) = ui.allocate_exact_size(vec2(full, height + 2.0 * theme::CELL_PADDING), Sense::hover());
    let mut row = ui.new_child(UiBuilder::new().accessibility_role(Role::Row).max_rect(rect));
    for (role, left, galley) in placed {
        let place = Rect::from_min_size(pos2(rect.left() + left, rect.top() + theme::CELL_PADDING), galley.size());
        row.new_child(UiBuilder::new().accessibility_role(role).max_rect(place))
            .add(Label::new(galley));
    }
    ui.painter()
        .hline(rect.x_range(), rect.bottom(), Stroke::new(theme::THIN_LINE, palette.line));
}
