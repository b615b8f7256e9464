//! The pictures of the answer, and where they stand.

mod curve;
mod ground;
mod handle;
mod rows;
pub mod tip;
mod top_view;

use super::card::Card;
use super::{start, table};
use crate::app::context::AppContext;
use crate::app::theme::{self, Layout};
use crate::app::widgets::cards;
use crate::core::problem::Field;
use depth_text::report::strip::Mode;
use egui::Ui;

/// What the pictures keep between frames.
#[derive(Debug, Default)]
pub struct Pictures {
    curve: curve::CurveCard,
    top_view: top_view::TopViewCard,
}

/// The cards of `mode` in rows of two, in reading order.
const fn rows(mode: Mode) -> &'static [&'static [Card]] {
    match mode {
        Mode::Distance => &[&[Card::Bars, Card::Curve], &[Card::TopView, Card::Table]],
        Mode::Quantity => &[&[Card::Gains, Card::InverseCurve], &[Card::TopView, Card::Table]],
        Mode::Ground => &[&[Card::SideView], &[Card::Floor, Card::Table]],
        Mode::TwoShots | Mode::TwoPoints => &[&[Card::Table]],
    }
}

/// Whether a wide screen has a third column in `mode`.
pub const fn has_last_column(mode: Mode) -> bool {
    rows(mode).len() > 1
}

/// The height of a column. Not what is left of it by a notice, which comes and goes.
fn column_height(ui: &Ui) -> f32 {
    ui.ctx().content_rect().height() - theme::HEADER_HEIGHT - 2.0 * theme::SCREEN_TOP
}

/// How high the rows of cards are when all of them fill a column, which the strip shares.
fn heights(ui: &Ui, gap: f32, count: usize) -> [f32; 2] {
    let [upper, lower] = theme::PICTURE_ROWS;
    let spare = column_height(ui) - theme::STRIP_HEIGHT - gap * 2.0 - upper - lower;
    if count < 2 {
        return [upper, lower];
    }
    // Both grow alike, up to where they are as large as anybody needs.
    let more = (spare / 2.0).clamp(0.0, theme::PICTURE_GROWTH).floor();
    [upper + more, lower + more]
}

impl Pictures {
    /// Draws the cards below the answer; on a wide screen the others are in [the last column](Self::last_column_ui).
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let (layout, gap) = (cx.layout, cx.layout.gap());
        if start::is_shown(cx) {
            let rest = column_height(ui) - theme::STRIP_HEIGHT - gap;
            let has_doffs = !cx.session.inputs.lacks(Field::Doffs);
            start::letters_ui(ui, if layout.columns() > 1 { rest } else { 0.0 }, has_doffs);
            return;
        }
        let rows = rows(cx.mode());
        if layout == Layout::Wide {
            self.middle_column_ui(ui, cx);
            return;
        }
        let heights = if layout == Layout::Desktop {
            heights(ui, gap, rows.len())
        } else {
            theme::PICTURE_ROWS
        };
        for (row, height) in rows.iter().zip(heights) {
            if layout.columns() > 1 {
                cards::row_ui(ui, row, gap, |ui, card| self.card_ui(ui, cx, card, height));
            } else {
                for &card in *row {
                    self.card_ui(ui, cx, card, height);
                }
            }
        }
    }

    /// The first row of cards below each other, on a wide screen.
    fn middle_column_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let gap = cx.layout.gap();
        let rows = rows(cx.mode());
        let Some(first) = rows.first() else { return };
        let [upper, lower] = theme::PICTURE_ROWS;
        let rest = column_height(ui) - theme::STRIP_HEIGHT - gap;
        for (index, &card) in first.iter().enumerate() {
            let height = match (first.len(), index) {
                // A view from the side is wider than it is high.
                (1, _) => rest.clamp(lower, theme::SIDE_VIEW_MAX),
                (_, 0) => upper,
                _ => (rest - upper - gap).clamp(lower, theme::PICTURE_MAX),
            };
            self.card_ui(ui, cx, card, height);
        }
    }

    /// What the column at the right of a wide screen holds.
    pub fn last_column_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let [_, lower] = theme::PICTURE_ROWS;
        let rest = column_height(ui) - cx.layout.gap() - theme::TABLE_HEIGHT;
        for &card in rows(cx.mode()).iter().skip(1).copied().flatten() {
            let height = if card == Card::Table {
                theme::TABLE_HEIGHT
            } else {
                rest.clamp(lower, theme::PICTURE_MAX)
            };
            self.card_ui(ui, cx, card, height);
        }
    }

    fn card_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, card: Card, height: f32) {
        match card {
            Card::Bars => rows::bars_ui(ui, cx, height),
            Card::Gains => rows::gains_ui(ui, cx, height),
            Card::Curve | Card::InverseCurve => self.curve.ui(ui, cx, card, height),
            Card::SideView => ground::side_ui(ui, cx, height),
            Card::Floor => ground::above_ui(ui, cx, height),
            Card::TopView => self.top_view.ui(ui, cx, height),
            Card::Table => table::ui(ui, cx, height),
            _ => {}
        }
    }
}
