//! "Stereo against monocular", and what an answer gains when one input is known exactly.

use super::tip;
use crate::app::calculator::card::Card;
use crate::app::context::AppContext;
use crate::app::sentences::Description;
use crate::app::widgets::{cards, chart, figure, picture};
use depth_figures::bars::Bars;
use depth_figures::{Ink, Words};
use egui::{Sense, Ui, vec2};

/// Draws the card of both distances.
pub fn bars_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let solution = &cx.session.assessment().solution;
    let bars = Bars::new(solution, Some(&cx.session.last().solution), cx.unit());
    let description = Description::Bars { solution, unit: cx.unit() }.to_string();
    ui_of(ui, cx, (Card::Bars, &bars), height, &description);
}

/// Draws the card of what an answer gains.
pub fn gains_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let Some(solved) = cx.solved_with_sources() else {
        picture::empty_card_ui(ui, Card::Gains, Card::Gains.title(), height, &crate::app::sentences::Hint::NoGains);
        return;
    };
    let bars = Bars::gains(&solved);
    let rows = bars.in_words();
    let description = Description::Gains { rows: &rows }.to_string();
    ui_of(ui, cx, (Card::Gains, &bars), height, &description);
}

fn ui_of(ui: &mut Ui, cx: &mut AppContext<'_>, (card, bars): (Card, &Bars), height: f32, description: &str) {
    let inner = cards::inner_size(ui, height);
    let drawn = bars.layout(inner.x, inner.y, &figure::Fonts(ui.painter()));
    let frame = cards::Frame {
        title: card.title(),
        caption: &drawn.caption,
        height: Some(height),
    };
    frame.ui(ui, card, |ui| {
        let (rect, response) = ui.allocate_exact_size(inner, Sense::CLICK);
        figure::paint(ui, &drawn.figure, rect.min);
        picture::describe(ui, &response, card.title(), &description);
        chart::menu_ui(&response, card.title(), cx.commands);
        let stops = drawn.rows.iter().filter_map(|row| {
            let at = rect.min + row.point.map(|point| vec2(point.x, point.y))?;
            let mut lines = vec![row.name.clone()];
            lines.extend(row.tip.iter().map(|line| Words::new(line.as_str(), Ink::Text)));
            Some(tip::Stop {
                hit: figure::place(row.hit, rect.min),
                at,
                lines: if row.tip.is_empty() { Vec::new() } else { lines },
            })
        });
        // Up is a step on: the first row is the highest value of the cursor.
        tip::cursor_ui(ui, &response, card.title(), tip::Start::Last, stops.rev().collect());
    });
}
