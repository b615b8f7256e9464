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
use depth_text::geometry::missing_for;
use depth_text::report;
use depth_text::sentences::{capital, needs};
use depth_text::style::Style;
use egui::Ui;

/// Draws range, tilt and ground plane.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    cards_ui(ui, cx, &[(Card::Range, range_ui), (Card::Tilt, tilt_ui), (Card::Ground, ground_ui)]);
}

/// Draws two photographs and two points.
pub fn of_two_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    cards_ui(ui, cx, &[(Card::TwoShots, two_shots_ui), (Card::TwoPoints, two_points_ui)]);
}

fn cards_ui(ui: &mut Ui, cx: &mut AppContext<'_>, all: &[(Card, Contents)]) {
    let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
    let cards: Vec<Card> = all.iter().map(|(card, _)| *card).collect();
    for row in cards.chunks(columns) {
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
    let assessment = cx.session.assessment();
    if let Some((origin, point)) = assessment.geometry.point {
        text::caption_ui(ui, format!("Z {}", report::point_origin(origin)));
        let rows = report::point(Style::WINDOW, &assessment.solution.problem, &point, cx.unit());
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

fn two_shots_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    fields_ui(ui, cx, Section::TwoShots);
    let assessment = cx.session.assessment();
    if let Some(shots) = &assessment.geometry.two_shots {
        let rows = report::two_shots(Style::WINDOW, &shots.solution, cx.unit());
        super::table::pairs_ui(ui, Section::TwoShots.name(), &rows);
        for remark in report::shots_remarks(assessment, shots) {
            text::caption_ui(ui, capital(&remark.to_string()));
        }
    }
    text::caption_ui(ui, Hint::TwoShots.to_string());
}

fn two_points_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    fields_ui(ui, cx, Section::TwoPoints);
    let missing = missing_for(Section::TwoPoints, &cx.session.inputs);
    if let Some(points) = &cx.session.assessment().geometry.two_points {
        let rows = report::two_points(Style::WINDOW, points, cx.unit());
        super::table::pairs_ui(ui, Section::TwoPoints.name(), &rows);
    } else if !missing.is_empty() {
        text::caption_ui(ui, capital(&format!("{}.", needs(&missing))));
    }
    text::caption_ui(ui, Hint::TwoPoints.to_string());
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
