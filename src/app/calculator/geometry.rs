//! What else the distance gives: the point in space and the range that a tape measures, a tilted target, and the ground
//! plane as a third method.

use super::card::Card;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::field::{self, Field};
use crate::app::widgets::{cards, text};
use crate::core::quantity::Length;
use depth_text::field::Key;
use depth_text::geometry::Geometry;
use depth_text::{number, report};
use egui::Ui;

/// Draws the three cards.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry) {
    let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
    for row in [Card::Range, Card::Tilt, Card::Ground].chunks(columns) {
        cards::row_ui(ui, row, gap, |ui, card, row| {
            cards::card_ui(ui, card, card.title(), |ui| {
                match card {
                    Card::Range => range_ui(ui, cx, geometry),
                    Card::Tilt => tilt_ui(ui, cx, geometry),
                    _ => ground_ui(ui, cx, geometry),
                }
                cards::fill_height_ui(ui, row);
            });
        });
    }
}

fn range_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry) {
    fields_ui(ui, cx, geometry, &Geometry::POINT, Card::Range);
    if let Some(point) = geometry.point {
        let length = |length: Length| report::length(Some(length), cx.unit());
        super::table::pairs_ui(
            ui,
            "Point and range",
            &[
                ("X, to the right", length(point.x)),
                ("Y, down", length(point.y)),
                ("Z, depth along the axis", length(point.z)),
                ("R, range from the lens", length(point.range)),
            ],
        );
    }
    text::caption_ui(ui, Hint::DepthOrRange.to_string());
}

fn tilt_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry) {
    fields_ui(ui, cx, geometry, &Geometry::TILTED, Card::Tilt);
    if let Some((target, solved)) = geometry.tilted {
        let share = number::significant(solved.excess * 100.0, 2);
        super::table::pairs_ui(
            ui,
            Card::Tilt.title(),
            &[
                ("Monocular distance as computed", report::length(Some(target.apparent), cx.unit())),
                ("Corrected for the tilt", report::length(Some(solved.depth), cx.unit())),
                ("Too long without it by", format!("{share} %")),
            ],
        );
    }
    text::caption_ui(ui, Hint::TiltedTarget.to_string());
}

fn ground_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry) {
    fields_ui(ui, cx, geometry, &Geometry::GROUND, Card::Ground);
    if let Some(distance) = geometry.floor {
        let words = if distance.sigma.m() > 0.0 {
            report::with_sigma(distance.value, distance.sigma, cx.unit()).text(cx.unit())
        } else {
            report::length(Some(distance.value), cx.unit())
        };
        super::table::pairs_ui(ui, "Ground plane", &[("Distance along the floor", words)]);
    }
    text::caption_ui(ui, Hint::GroundPlane.to_string());
}

/// The fields of a card. The card is part of their ids, as a field can be on two cards.
fn fields_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry, keys: &[Key], card: Card) {
    for &key in keys {
        let field = Field {
            key,
            entry: cx.settings.entries.entry_mut(key),
            reading: geometry.readings.iter().find(|reading| reading.key == key),
            notes: geometry.notes.iter().filter(|note| note.key == key).collect(),
            with_sigma: key.has_sigma,
            helper: None,
            id: field::id(key).with(card),
            submits: false,
        };
        field.ui(ui, cx.commands);
        ui.add_space(theme::STEP);
    }
}
