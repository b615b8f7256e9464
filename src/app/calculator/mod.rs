//! The calculator: the form, and everything that follows from it.

mod bars;
mod card;
mod curve;
mod form;
mod geometry;
mod helpers;
mod results;
mod simulations;
mod table;
mod top_view;
mod uncertainty;
mod unknown;

pub use results::bar_ui as result_bar_ui;

use super::command::Helper;
use super::context::AppContext;
use super::saved::{Settings, Ways};
use super::session::Session;
use super::theme::Layout;
use super::widgets::cards::{self, Row};
use super::widgets::{field, scroll, text};
use crate::core::problem::Method;
use crate::core::quantity::{Length, LengthUnit};
use card::Card;
use depth_text::assess::Assessment;
use depth_text::field::Section;
use depth_text::note::Severity;
use depth_text::report;
use depth_text::sentences::Statement;
use egui::{Align, Pos2, Rect, Ui, UiBuilder};

/// State of the screen between frames, beside the inputs.
#[derive(Debug, Default)]
pub struct Calculator {
    /// *Calculate Distance* was pressed: missing inputs are marked until something is typed.
    pub marked: bool,
    /// The helper that is open.
    pub helper: Option<Helper>,
    /// The result of the open helper.
    solved: helpers::Solved,
    reveal: Reveal,
    curve: curve::Curve,
    simulations: simulations::Simulations,
}

/// Whether the results are to be scrolled into view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Reveal {
    #[default]
    No,
    /// In the next frame.
    Wanted,
    /// The frame has been drawn.
    Done,
}

impl Calculator {
    /// Draws the screen: the form beside its results, or on a phone above them.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let gap = cx.layout.gap();
        if cx.layout == Layout::Phone {
            scroll::column_ui(ui, "calculator", |ui| {
                ui.spacing_mut().item_spacing.y = gap;
                self.form_ui(ui, cx);
                self.results_ui(ui, cx);
            });
        } else {
            let all = ui.available_rect_before_wrap();
            let (left, right) = all.split_left_right_at_x(all.left() + cx.layout.form_width());
            let column = |ui: &mut Ui, rect, id, add_contents: &mut dyn FnMut(&mut Ui)| {
                let top_down = egui::Layout::top_down(Align::Min);
                ui.scope_builder(UiBuilder::new().max_rect(rect).layout(top_down), |ui| {
                    scroll::column_ui(ui, id, |ui| {
                        ui.spacing_mut().item_spacing.y = gap;
                        add_contents(ui);
                    });
                });
            };
            column(ui, left, "form", &mut |ui| self.form_ui(ui, cx));
            column(ui, right.with_min_x(right.left() + gap), "results", &mut |ui| {
                self.results_ui(ui, cx)
            });
        }
        if let Some(helper) = self.helper {
            helpers::ui(ui, cx, helper, &self.solved);
        }
    }

    /// Goes on with the simulations, which take longer than a frame.
    pub fn logic(&mut self, cx: &mut AppContext<'_>) {
        if self.reveal == Reveal::Done {
            self.reveal = Reveal::No;
        }
        if let Some(helper) = self.helper {
            let zero = cx.session.assessment().solution.problem.zero;
            self.solved = helpers::Solved::new(helper, cx.settings, zero.unwrap_or(Length::from_m(0.0)));
        }
        let time = simulations::Time {
            // After a rest egui says how long a frame will be, not how long the rest was.
            frame_s: f64::from(cx.egui.input(|input| input.stable_dt)),
            clock: &|| cx.platform.seconds(),
        };
        if self.simulations.advance(cx.session.assessment(), &time) {
            cx.egui.request_repaint();
        }
    }

    /// Marks every problem, and goes to the first, or to the results where there is none. A hidden part with the first is shown.
    pub fn calculate(&mut self, ctx: &egui::Context, session: &Session, settings: &mut Settings) {
        self.marked = true;
        let assessment = session.assessment();
        let errors = assessment.notes.iter().filter(|note| note.severity == Severity::Error);
        let first = errors.chain(&assessment.missing).map(|note| note.key).min();
        match first {
            Some(key) => {
                settings.shows_geometry |= key.section.is_some_and(Section::is_geometry);
                settings.shows_two |= key.section.is_some_and(Section::is_of_two);
                ctx.memory_mut(|memory| memory.request_focus(field::id(key)));
            }
            None => self.reveal_results(ctx),
        }
    }

    /// Opens the helper for the focal length at the way with this key.
    pub fn open_way(&mut self, ways: &mut Ways, way: &str) {
        helpers::choose(ways, Helper::FocalLength, way);
        self.helper = Some(Helper::FocalLength);
    }

    /// Scrolls to the results on a phone, where the form may hide them.
    pub fn reveal_results(&mut self, ctx: &egui::Context) {
        let is_phone = Layout::of_width(ctx.content_rect().width()) == Layout::Phone;
        self.reveal = if is_phone { Reveal::Wanted } else { Reveal::No };
    }

    /// Draws the form, and brings the results up to date with it.
    fn form_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        form::ui(ui, cx, self.marked);
        if cx.session.refresh() {
            // Somebody is typing, and knows that the rest is missing.
            self.marked = false;
        }
    }

    fn results_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let top = ui.cursor().min;
        results::ui(ui, cx);
        self.scroll_to_results(ui, top);
        uncertainty::ui(ui, cx, &self.simulations);
        if cx.settings.shows_geometry {
            geometry::ui(ui, cx);
        }
        if cx.settings.shows_two {
            geometry::of_two_ui(ui, cx);
        }
        self.pictures_ui(ui, cx);
        ui.add_space(cx.layout.gap());
    }

    fn scroll_to_results(&mut self, ui: &Ui, top: Pos2) {
        if self.reveal != Reveal::No {
            let rect = Rect::from_min_max(top, ui.min_rect().max);
            ui.scroll_to_rect(rect, Some(Align::Min));
            self.reveal = Reveal::Done;
        }
    }

    fn pictures_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
        let pictures: &[Card] = match cx.layout {
            Layout::Wide => &[Card::Bars, Card::Curve, Card::TopView],
            _ => &[Card::Bars, Card::Curve, Card::Intermediate, Card::TopView],
        };
        for row in pictures.chunks(columns) {
            cards::row_ui(ui, row, gap, |ui, card, row| self.card_ui(ui, cx, card, row));
        }
        if cx.layout == Layout::Wide {
            cards::row_ui(ui, &[Card::Intermediate, Card::Table], gap, |ui, card, row| match card {
                Card::Table => table::ui(ui, cx.session.assessment(), cx.unit()),
                card => self.card_ui(ui, cx, card, row),
            });
        } else {
            table::ui(ui, cx.session.assessment(), cx.unit());
        }
    }

    fn card_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, card: Card, row: Row) {
        let unit = cx.unit();
        let assessment = cx.session.assessment();
        let solution = &assessment.solution;
        cards::card_ui(ui, card, card.title(), |ui| {
            match card {
                Card::Bars => bars::ui(ui, solution, unit),
                Card::Curve => self.curve.ui(ui, solution, unit, cx.commands),
                Card::TopView => top_view::ui(ui, assessment, unit),
                _ => intermediate_ui(ui, assessment, unit),
            }
            cards::fill_height_ui(ui, row);
        });
    }
}

fn intermediate_ui(ui: &mut Ui, assessment: &Assessment, unit: LengthUnit) {
    let solution = &assessment.solution;
    let length = |length| report::length(length, unit);
    let width_px = solution.estimated_width_px.map_or_else(
        || depth_text::number::NO_NUMBER.to_owned(),
        |width| depth_text::number::significant(width.px(), report::DIGITS),
    );
    let estimated_width = report::estimated_width_name(solution.problem.object, unit);
    let of_method = |method| (report::distance_name(method), length(solution.outcome(method).distance()));
    let combined = solution
        .combined
        .map(|combined| (report::COMBINED_DISTANCE, length(Some(combined.value))));
    let widths = [
        (report::estimated_width_px_name(solution.problem.object), format!("{width_px} px")),
        (estimated_width.as_str(), length(solution.estimated_width)),
    ];
    let rows: Vec<_> = widths.into_iter().chain(Method::ALL.map(of_method)).chain(combined).collect();
    table::pairs_ui(ui, Card::Intermediate.title(), &rows);
    text::caption_ui(ui, Statement::widths(assessment).to_string());
}
