//! What else the distance gives: the point in space and the range that a tape measures, a tilted target, and the ground
//! plane as a third method.

use crate::app::context::AppContext;
use crate::app::widgets::number_field::{NumberField, Unit};
use crate::app::widgets::{cards, text};
use crate::core::quantity::Length;
use crate::formats::entry::{Entries, Entry};
use crate::formats::field::Key;
use crate::formats::geometry::Geometry;
use crate::formats::note::{Note, Part};
use crate::formats::{number, report};
use egui::Ui;

/// Draws the three cards.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry) {
    let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
    let cards: [Card; 3] = [range_ui, tilt_ui, ground_ui];
    for (number, row) in cards.chunks(columns).enumerate() {
        let id = egui::Id::unique(("geometry", columns, number));
        cards::row(ui, row, gap, |ui, card| card(ui, cx, geometry, id));
    }
}

type Card = fn(&mut Ui, &mut AppContext<'_>, &Geometry, egui::Id);

fn range_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry, row: egui::Id) {
    cards::card(ui, "Depth or range", |ui| {
        fields_ui(ui, &mut cx.settings.entries, &Geometry::POINT);
        if let Some(point) = geometry.point {
            let length = |length: Length| report::length(Some(length), cx.unit());
            super::table::pairs(
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
        notes_ui(ui, cx, geometry, &Geometry::POINT);
        text::caption(
            ui,
            "The distance of this program is the depth Z along the optical axis. A tape held at the lens measures the range R, which is longer away from the middle of the image.",
        );
        cards::fill_height(ui, row);
    });
}

fn tilt_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry, row: egui::Id) {
    cards::card(ui, "Tilted target", |ui| {
        fields_ui(ui, &mut cx.settings.entries, &Geometry::TILTED);
        if let Some((target, solved)) = geometry.tilted {
            let share = number::significant(solved.excess * 100.0, 2);
            super::table::pairs(
                ui,
                "Tilted target",
                &[
                    ("Monocular distance as computed", report::length(Some(target.apparent), cx.unit())),
                    ("Corrected for the tilt", report::length(Some(solved.depth), cx.unit())),
                    ("Too long without it by", format!("{share} %")),
                ],
            );
        }
        notes_ui(ui, cx, geometry, &Geometry::TILTED);
        text::caption(
            ui,
            "A target turned away by an angle looks narrower by its cosine, so the monocular method puts it too far away. The distance is that to the plane of the target’s middle, along the optical axis.",
        );
        cards::fill_height(ui, row);
    });
}

fn ground_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &Geometry, row: egui::Id) {
    cards::card(ui, "Ground plane, a third method", |ui| {
        fields_ui(ui, &mut cx.settings.entries, &Geometry::GROUND);
        if let Some(distance) = geometry.floor {
            let words = if distance.sigma.m() > 0.0 {
                report::with_sigma(distance.value, distance.sigma, cx.unit()).text(cx.unit())
            } else {
                report::length(Some(distance.value), cx.unit())
            };
            super::table::pairs(ui, "Ground plane", &[("Distance along the floor", words)]);
        }
        notes_ui(ui, cx, geometry, &Geometry::GROUND);
        text::caption(
            ui,
            "D = h / tan(θ + atan((v − cy) / fy)): where the ray of an image row meets a level floor. fy is taken to be fx. Needs neither a second camera nor a known size.",
        );
        cards::fill_height(ui, row);
    });
}

/// What is wrong with the fields `keys`. What is not one number is said at its field.
fn notes_ui(ui: &mut Ui, cx: &AppContext<'_>, geometry: &Geometry, keys: &[Key]) {
    let entries = &cx.settings.entries;
    let is_said = |said: &Note| said.part == Part::Value && number::read(&entries.entry(said.key).text).is_err();
    for note in geometry.notes.iter().filter(|note| keys.contains(&note.key) && !is_said(note)) {
        text::note(ui, note.severity, &note.message(), None);
    }
}

fn fields_ui(ui: &mut Ui, entries: &mut Entries, keys: &[Key]) {
    for &key in keys {
        let Entry { text, sigma, .. } = entries.entry_mut(key);
        let unit = key.spec().unit_symbol();
        let field = NumberField {
            name: key.spec().name,
            hint: "",
            example: key.spec().example(),
            unit: Unit::Fixed(unit),
            signed: unit == "°",
            sigma: key.has_sigma.then_some(sigma),
        };
        if key.has_sigma {
            field.ui(ui, text);
        } else {
            ui.push_id(key.as_str(), |ui| field.ui(ui, text));
        }
    }
}
