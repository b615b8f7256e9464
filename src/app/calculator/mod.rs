//! The calculator: the form, and everything that follows from it.

mod bars;
mod curve;
mod form;
pub mod geometry;
mod helpers;
mod results;
mod table;
mod top_view;
mod uncertainty;
mod unknown;

use super::command::{Command, Helper};
use super::saved::Settings;
use super::session::Session;
use super::theme::{self, Layout};
use super::widgets::{cards, quantity_field, scroll, text};
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::{Assessment, Severity};
use crate::formats::report;
use egui::{Align, Id, RichText, Ui};

/// What the screen remembers between frames beside the inputs.
#[derive(Debug, Default)]
pub struct Calculator {
    /// *Calculate Distance* was asked for: missing inputs are marked until something is typed.
    pub marked: bool,
    /// Bring the results into view in the next frame.
    pub reveal_results: bool,
    /// The helper that is open.
    pub helper: Option<Helper>,
    curve: curve::Curve,
    simulations: uncertainty::Simulations,
}

impl Calculator {
    /// Draws the screen. The session is refreshed after the form, so that the results belong to what is in it now.
    pub fn show(&mut self, ui: &mut Ui, layout: Layout, session: &mut Session, settings: &mut Settings, commands: &mut Vec<Command>) {
        let gap = layout.gap();
        match layout {
            Layout::Phone => {
                scroll::column(ui, "calculator", |ui| {
                    ui.spacing_mut().item_spacing.y = gap;
                    self.form(ui, layout, session, settings, commands);
                    self.results(ui, layout, session, settings, commands);
                });
            }
            Layout::Tablet | Layout::Desktop | Layout::Wide => {
                let all = ui.available_rect_before_wrap();
                let (left, right) = all.split_left_right_at_x(all.left() + layout.form_width());
                let column = |ui: &mut Ui, rect, id, add_contents: &mut dyn FnMut(&mut Ui)| {
                    let top_down = egui::Layout::top_down(Align::Min);
                    ui.scope_builder(egui::UiBuilder::new().max_rect(rect).layout(top_down), |ui| {
                        scroll::column(ui, id, |ui| {
                            ui.spacing_mut().item_spacing.y = gap;
                            add_contents(ui);
                        });
                    });
                };
                column(ui, left, "form", &mut |ui| self.form(ui, layout, session, settings, commands));
                column(ui, right.with_min_x(right.left() + gap), "results", &mut |ui| {
                    self.results(ui, layout, session, settings, commands);
                });
            }
        }
        if let Some(helper) = self.helper {
            helpers::show(ui, layout, helper, &session.inputs, &mut settings.texts, commands);
        }
    }

    /// Marks every problem, and goes to the first, or on a phone to the results where there is none.
    pub fn calculate(&mut self, ctx: &egui::Context, session: &Session) {
        self.marked = true;
        let errors = session
            .assessment()
            .notes
            .iter()
            .filter(|note| note.severity == Severity::Error)
            .map(|note| note.field);
        let missing = session.inputs.missing();
        let first = errors.chain(missing.iter().map(|note| note.field)).min();
        match first {
            Some(field) => ctx.memory_mut(|memory| memory.request_focus(quantity_field::id(field))),
            None => self.reveal_results = Layout::of_width(ctx.content_rect().width()) == Layout::Phone,
        }
    }

    /// Goes on with what takes longer than a frame. Returns whether another frame is wanted.
    pub fn simulate(&mut self, assessment: &Assessment) -> bool {
        self.simulations.advance(assessment)
    }

    fn form(&mut self, ui: &mut Ui, layout: Layout, session: &mut Session, settings: &Settings, commands: &mut Vec<Command>) {
        let (inputs, assessment) = session.parts();
        form::show(ui, layout, inputs, assessment, self.marked, settings.shows_geometry, commands);
        if session.refresh() {
            // Something is being typed: what is still missing is no news any more.
            self.marked = false;
        }
    }

    fn results(&mut self, ui: &mut Ui, layout: Layout, session: &Session, settings: &mut Settings, commands: &mut Vec<Command>) {
        let unit = settings.result_unit;
        let assessment = session.assessment();
        let inputs_unit = session.inputs.unknown.and_then(|(_, field)| session.inputs.unit(field));
        let gap = layout.gap();
        let solution = &assessment.solution;
        let top = ui.cursor().min;
        results::show(ui, layout, assessment, inputs_unit, unit, commands);
        if std::mem::take(&mut self.reveal_results) {
            let rect = egui::Rect::from_min_max(top, ui.min_rect().max);
            ui.scroll_to_rect(rect, Some(Align::Min));
        }
        uncertainty::show(ui, solution, &self.simulations, unit, layout.columns(), gap);
        if settings.shows_geometry {
            geometry::show(
                ui,
                solution,
                unit,
                &mut settings.texts,
                layout.control_height(),
                layout.columns(),
                gap,
            );
        }
        let curve = &mut self.curve;
        let mut card = |ui: &mut Ui, which: Card, row: Id| {
            cards::card(ui, which.title(), |ui| {
                match which {
                    Card::Bars => bars::ui(ui, solution, unit),
                    Card::Curve => curve.show(ui, solution, unit, commands),
                    Card::TopView => top_view::show(ui, solution, unit),
                    Card::Intermediate => intermediate(ui, assessment),
                }
                cards::fill_height(ui, row);
            });
        };
        let columns = layout.columns();
        let pictures: &[Card] = match layout {
            Layout::Wide => &[Card::Bars, Card::Curve, Card::TopView],
            _ => &[Card::Bars, Card::Curve, Card::Intermediate, Card::TopView],
        };
        for (number, row) in pictures.chunks(columns).enumerate() {
            let id = Id::unique(("row of cards", layout.columns(), number));
            cards::row(ui, row, gap, |ui, &which| card(ui, which, id));
        }
        if layout == Layout::Wide {
            let id = Id::unique("intermediate and table");
            cards::row(ui, &[Some(Card::Intermediate), None], gap, |ui, which| match which {
                Some(which) => card(ui, *which, id),
                None => table::show(ui, solution),
            });
        } else {
            table::show(ui, solution);
        }
        ui.add_space(gap);
    }
}

#[derive(Clone, Copy)]
enum Card {
    Bars,
    Curve,
    Intermediate,
    TopView,
}

impl Card {
    const fn title(self) -> &'static str {
        match self {
            Self::Bars => bars::TITLE,
            Self::Curve => curve::TITLE,
            Self::Intermediate => "Intermediate values",
            Self::TopView => top_view::TITLE,
        }
    }
}

fn intermediate(ui: &mut Ui, assessment: &Assessment) {
    let solution = &assessment.solution;
    let metres = |length| report::length(length, LengthUnit::Metre);
    let width_px = solution.estimated_width_px.map_or_else(
        || crate::formats::number::NO_NUMBER.to_owned(),
        |width| crate::formats::number::significant(width.px(), report::DIGITS),
    );
    table::pairs(
        ui,
        "Intermediate values",
        &[
            (report::ESTIMATED_WIDTH_PX, format!("{width_px} px")),
            (report::ESTIMATED_WIDTH_M, metres(solution.estimated_width)),
            ("Object distance (D, stereo)", metres(solution.stereo.distance())),
            ("Object distance (D, monocular)", metres(solution.monocular.distance())),
        ],
    );
    text::caption(ui, report::width_check(solution));
}

/// The bar that keeps the result in sight on a phone.
pub fn result_bar(ui: &mut Ui, assessment: &Assessment, unit: LengthUnit) {
    let palette = theme::palette(ui);
    ui.horizontal_wrapped(|ui| {
        let said = results::headline(&assessment.solution, unit);
        for (name, value) in said {
            if let Some(name) = name {
                ui.label(RichText::new(name).color(palette.muted));
            }
            ui.label(RichText::new(value).font(theme::strong(theme::BAR_RESULT_SIZE)).color(palette.text));
            ui.add_space(2.0 * theme::STEP);
        }
    });
}
