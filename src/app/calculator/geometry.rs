//! What else the distance gives: the point in space and the range that a tape measures, a tilted target, and the ground
//! plane as a third method.

use super::card::Card;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::cards;
use crate::app::widgets::field::{self, Field};
use crate::app::widgets::text;
use depth_text::field::Section;
use depth_text::report;
use depth_text::style::Style;
use egui::Ui;

/// Draws the three cards.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
    let all: [(Card, Contents); 3] = [(Card::Range, range_ui), (Card::Tilt, tilt_ui), (Card::Ground, ground_ui)];
    for row in all.map(|(card, _)| card).chunks(columns) {
        cards::row_ui(ui, row, gap, |ui, card, row| {
            cards::card_ui(ui, card, card.title(), |ui| {
                for (_, contents_ui) in all.iter().filter(|(one, _)| *one == card) {
                    contents_ui(ui, cx);
                }
                cards::fill_height_ui(ui, row);
            });
        });
    }
}

/// Draws what is in a card.
type Contents = fn(&mut Ui, &mut AppContext<'_>);

fn range_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    fields_ui(ui, cx, Section::Point);
    if let Some((origin, point)) = cx.session.assessment().geometry.point {
        text::caption_ui(ui, format!("Z {}", report::point_origin(origin)));
        let rows = report::point(Style::WINDOW, &point, cx.unit());
        super::table::pairs_ui(ui, "Point and range", &rows);
    }
    text::caption_ui(ui, Hint::DepthOrRange.to_string());
}

fn tilt_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    fields_ui(ui, cx, Section::Target);
    if let Some(without) = cx.session.assessment().geometry.facing {
        let unit = cx.unit();
        text::caption_ui(ui, Hint::TiltIsUsed { without, unit }.to_string());
    }
    text::caption_ui(ui, Hint::TiltedTarget.to_string());
}

fn ground_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    fields_ui(ui, cx, Section::Ground);
    if let Some(ground) = &cx.session.assessment().geometry.ground {
        let rows = report::ground(Style::WINDOW, ground, cx.unit());
        super::table::pairs_ui(ui, "Ground plane", &rows);
    }
    text::caption_ui(ui, Hint::GroundPlane.to_string());
}

fn fields_ui(ui: &mut Ui, cx: &mut AppContext<'_>, section: Section) {
    for key in section.keys() {
        let (inputs, assessment) = cx.session.parts();
        let field = Field {
            key,
            entry: inputs.entry_mut(key),
            reading: assessment.reading(key),
            notes: assessment.notes.iter().filter(|note| note.key == key).collect(),
            with_sigma: true,
            helper: None,
            id: field::id(key),
            submits: false,
        };
        field.ui(ui, cx.commands);
        ui.add_space(theme::STEP);
    }
}
