//! What else is to be said: about the answers, and how the way works that is asked for.

use super::card::Card;
use super::strip::colors;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::{cards, text};
use depth_text::report::strip::{Cell, Mode, Quality};
use egui::Ui;

/// How the way works that is asked for, and what the refinements do.
pub fn how_ui(ui: &mut Ui, cx: &AppContext<'_>) {
    let hints: &[Hint] = match cx.mode() {
        Mode::Ground => &[Hint::GroundPlane],
        Mode::TwoShots => &[Hint::TwoShots],
        Mode::TwoPoints => &[Hint::TwoPoints],
        Mode::Distance | Mode::Quantity if cx.settings.shows_refinements => &[Hint::DepthOrRange, Hint::TiltedTarget],
        Mode::Distance | Mode::Quantity => &[],
    };
    if hints.is_empty() {
        return;
    }
    let card = Card::How;
    let frame = cards::Frame {
        title: card.title(),
        caption: "",
        height: None,
    };
    frame.ui(ui, card, |ui| {
        for hint in hints {
            text::paragraph_ui(ui, &hint.to_string());
        }
    });
}

/// What else is to be said of the answers, where there is anything.
pub fn ui(ui: &mut Ui, cx: &AppContext<'_>) {
    let strip = cx.strip();
    // That both agree is said by the badge.
    let agrees = |cell: &&Cell| cell.badge.is_some_and(|badge| badge.quality == Quality::Good);
    // Why there is no distance is said at the field.
    let is_refused = |cell: &&Cell| cell.lines.iter().any(|line| line.is_refusal);
    let has_some = |cell: &&Cell| !cell.remarks.is_empty() && !agrees(cell) && !is_refused(cell);
    let cells: Vec<&Cell> = strip.cells.iter().filter(has_some).collect();
    if cells.is_empty() {
        return;
    }
    let card = Card::Remarks;
    let frame = cards::Frame {
        title: card.title(),
        caption: "",
        height: None,
    };
    frame.ui(ui, card, |ui| {
        for cell in &cells {
            if cells.len() > 1 {
                let [_, color] = colors(theme::palette(ui), cell.tone);
                text::heading_ui(ui, &cell.title, 3, theme::strong(theme::LINK_SIZE), color);
            }
            for remark in &cell.remarks {
                text::paragraph_ui(ui, remark);
            }
        }
    });
}
