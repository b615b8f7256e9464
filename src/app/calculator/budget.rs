//! The card that says where the uncertainty comes from.

use super::card::Card;
use crate::app::context::AppContext;
use crate::app::sentences::Description;
use crate::app::theme::Layout;
use crate::app::widgets::{cards, chart, figure, picture};
use depth_figures::budget::Budget;
use depth_text::report::strip::Mode;
use egui::{Sense, Ui, vec2};

/// Draws the card, where there is any σ.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let budget = match cx.mode() {
        Mode::Distance => Budget::new(cx.session.assessment(), Some(cx.session.last()), cx.unit()),
        Mode::Quantity => cx.solved_with_sources().map(|solved| Budget::solved(&solved)).unwrap_or_default(),
        Mode::Ground => cx.ground_with_sources().map(|solved| Budget::solved(&solved)).unwrap_or_default(),
        Mode::TwoShots | Mode::TwoPoints => Budget::default(),
    };
    if budget.blocks.is_empty() {
        return;
    }
    let is_detailed = cx.layout == Layout::Wide || cx.mode() != Mode::Distance;
    let frame = cards::Frame {
        title: Card::Budget.title(),
        caption: if is_detailed { "contribution, share" } else { "" },
        height: None,
    };
    frame.ui(ui, Card::Budget, |ui| {
        let drawn = budget.layout(ui.available_width(), is_detailed, &figure::Fonts(ui.painter()));
        let (rect, response) = ui.allocate_exact_size(vec2(drawn.width, drawn.height), Sense::CLICK);
        figure::paint(ui, &drawn, rect.min);
        let shares: Vec<String> = budget.blocks.iter().map(depth_figures::budget::Block::in_words).collect();
        picture::describe(
            ui,
            &response,
            Card::Budget.title(),
            &Description::Budget {
                shares: &shares.join(". "),
            },
        );
        chart::menu_ui(&response, Card::Budget.title(), cx.commands);
    });
}
