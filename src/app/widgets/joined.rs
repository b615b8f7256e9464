//! The joined control of a quantity: value, unit and σ in one border, divided by hairlines. What is drawn here means nothing;
//! [`field`](super::field) does.

use crate::app::theme;
use egui::text_edit::TextEditOutput;
use egui::{Align2, Color32, CornerRadius, Frame, Id, Margin, Pos2, Rect, RichText, Stroke, StrokeKind, TextEdit, Ui, UiBuilder, vec2};

/// Where the parts of a control are.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    /// The whole control.
    pub whole: Rect,
    /// The value.
    pub value: Rect,
    /// The unit, where there is one.
    pub unit: Option<Rect>,
    /// σ, where it is asked for.
    pub sigma: Option<Rect>,
}

impl Cells {
    /// Divides `whole`.
    pub fn of(whole: Rect, has_unit: bool, has_sigma: bool) -> Self {
        let is_narrow = whole.width() < theme::NARROW_FIELD_WIDTH;
        let (unit_width, sigma_width) = if is_narrow {
            (theme::UNIT_WIDTH_NARROW, theme::SIGMA_WIDTH_NARROW)
        } else {
            (theme::UNIT_WIDTH, theme::SIGMA_WIDTH)
        };
        let mut rest = whole;
        let mut cut = |wanted: bool, width: f32| {
            wanted.then(|| {
                let (left, right) = rest.split_left_right_at_x(rest.right() - width);
                rest = left;
                right
            })
        };
        let sigma = cut(has_sigma, sigma_width);
        let unit = cut(has_unit, unit_width);
        Self {
            whole,
            value: rest,
            unit,
            sigma,
        }
    }

    /// The places of the hairlines.
    fn dividers(&self) -> impl Iterator<Item = f32> {
        [self.unit, self.sigma].into_iter().flatten().map(|cell| cell.left())
    }
}

/// From the left edge of `cell` to what stands in it.
pub fn indent(cell: Rect) -> f32 {
    if cell.width() <= theme::UNIT_WIDTH_NARROW {
        theme::CELL_INDENT_NARROW
    } else {
        theme::CELL_INDENT
    }
}

/// The ground of the control, below its texts; `is_lit`, where its number is pointed at elsewhere.
pub fn ground_ui(ui: &Ui, cells: &Cells, is_lit: bool) {
    let palette = theme::palette(ui);
    ui.painter().rect_filled(cells.whole, theme::CONTROL_RADIUS, palette.field);
    if is_lit {
        let rounded = CornerRadius {
            nw: theme::CONTROL_RADIUS,
            sw: theme::CONTROL_RADIUS,
            ..CornerRadius::ZERO
        };
        ui.painter().rect_filled(cells.value, rounded, palette.blue_tint);
    }
}

/// The border of the control and its hairlines, above its texts: in the `color` of what is wrong with it, or of the focus.
pub fn border_ui(ui: &Ui, cells: &Cells, color: Option<Color32>, has_focus: bool) {
    let palette = theme::palette(ui);
    let hairline = Stroke::new(theme::THIN_LINE, palette.line);
    let inside = cells.whole.shrink(theme::THIN_LINE);
    for x in cells.dividers() {
        ui.painter().vline(x, inside.y_range(), hairline);
    }
    let stroke = match (color, has_focus) {
        (Some(color), true) => Stroke::new(theme::FOCUS_RING_WIDTH, color),
        (Some(color), false) => Stroke::new(theme::STRONG_LINE, color),
        (None, true) => Stroke::new(theme::FOCUS_RING_WIDTH, palette.blue),
        (None, false) => Stroke::new(theme::THIN_LINE, palette.border),
    };
    ui.painter()
        .rect_stroke(cells.whole, theme::CONTROL_RADIUS, stroke, StrokeKind::Inside);
}

/// A number in `cell`, aligned at the right, with an id and an example that is shown while it is empty.
pub fn text_ui(ui: &mut Ui, cell: Rect, text: &mut String, shown: (Id, &str)) -> TextEditOutput {
    aligned_text_ui(ui, cell, text, shown, Align2::RIGHT_CENTER)
}

/// The same with words, which begin at the left.
pub fn words_ui(ui: &mut Ui, cell: Rect, text: &mut String, shown: (Id, &str)) -> TextEditOutput {
    aligned_text_ui(ui, cell, text, shown, Align2::LEFT_CENTER)
}

fn aligned_text_ui(ui: &mut Ui, cell: Rect, text: &mut String, (id, example): (Id, &str), align: Align2) -> TextEditOutput {
    let palette = theme::palette(ui);
    let mut ui = ui.new_child(UiBuilder::new().id_salt(id).max_rect(cell));
    ui.set_clip_rect(ui.clip_rect().intersect(cell));
    ui.spacing_mut().interact_size.y = cell.height();
    TextEdit::singleline(text)
        .id(id)
        .frame(Frame::NONE.inner_margin(Margin::symmetric(
            if cell.width() < theme::NARROW_CELL_WIDTH {
                theme::CELL_MARGIN_NARROW
            } else {
                theme::CELL_MARGIN
            },
            0,
        )))
        .hint_text(RichText::new(example).color(palette.muted))
        .align(align)
        .desired_width(cell.width())
        .min_size(cell.size())
        .return_key(None)
        .show(&mut ui)
}

/// The sign before σ.
pub fn plus_minus_ui(ui: &Ui, cell: Rect) {
    let at = Pos2::new(cell.left() + indent(cell), cell.center().y);
    let font = theme::regular(theme::SMALL_SIZE);
    ui.painter().text(at, Align2::LEFT_CENTER, "±", font, theme::palette(ui).muted);
}

/// The inside of a `cell` in which something is chosen: the control that is put into it has no border of its own.
pub fn choice_cell(ui: &mut Ui, cell: Rect) -> Ui {
    let mut ui = ui.new_child(
        UiBuilder::new()
            .id_salt("choice")
            .max_rect(cell.shrink2(vec2(theme::THIN_LINE, theme::THIN_LINE))),
    );
    let widgets = &mut ui.visuals_mut().widgets;
    for visuals in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active, &mut widgets.open] {
        visuals.bg_stroke = Stroke::NONE;
        visuals.corner_radius = CornerRadius::ZERO;
    }
    ui.spacing_mut().button_padding.x = indent(cell) - theme::THIN_LINE;
    ui.spacing_mut().interact_size.y = cell.height() - 2.0 * theme::THIN_LINE;
    ui.spacing_mut().icon_width = theme::ARROW_WIDTH;
    ui
}
