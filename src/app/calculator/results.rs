//! The result cards: the distance by each method whose inputs are complete, and both combined.

use super::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::unit_choice::length_unit_choice_ui;
use crate::app::widgets::{cards, text};
use crate::core::measured::Measured;
use crate::core::problem::Method;
use crate::core::quantity::LengthUnit;
use depth_text::assess::{Assessment, Unknown};
use depth_text::field::Key;
use depth_text::names::Named as _;
use depth_text::number::NO_NUMBER;
use depth_text::report;
use depth_text::sentences::{Statement, capital};
use depth_text::style::Style;
use egui::accesskit::Role;
use egui::{RichText, Ui, UiBuilder};

/// The results in one line: a name and a value each, that to be used alone where there is one; "–.– m" where there is none.
pub fn headline(assessment: &Assessment, unit: LengthUnit) -> Vec<(Option<&'static str>, String)> {
    if let Some(unknown) = &assessment.unknown {
        let value = report::unknown(Style::WINDOW, unknown, unit).unwrap_or_else(|| NO_NUMBER.to_owned());
        return vec![(Some(Key::from(unknown.field).symbol), value)];
    }
    if let Some(combined) = assessment.solution.combined {
        return vec![(Some(Card::Combined.title()), report::length(Some(combined.value), unit))];
    }
    let of_method = |method: Method| {
        let distance = assessment.distance(method)?;
        Some((Some(method.name()), report::length(Some(distance), unit)))
    };
    let found: Vec<_> = Method::ALL.into_iter().filter_map(of_method).collect();
    if found.is_empty() {
        vec![(None, report::length(None, unit))]
    } else {
        found
    }
}

/// The contents of the bar that keeps the result in sight on a phone.
pub fn bar_ui(ui: &mut Ui, cx: &AppContext<'_>) {
    let palette = theme::palette(ui);
    let assessment = cx.session.assessment();
    ui.horizontal_wrapped(|ui| {
        for (name, value) in headline(assessment, cx.unit()) {
            if let Some(name) = name {
                ui.label(RichText::new(name).color(palette.muted));
            }
            ui.label(RichText::new(value).font(theme::strong(theme::BAR_RESULT_SIZE)).color(palette.text));
            ui.add_space(2.0 * theme::STEP);
        }
        let verdict = Statement::comparison(assessment).filter(|_| assessment.solution.combined.is_none());
        if let Some(words) = verdict.and_then(|statement| statement.verdict()) {
            ui.label(RichText::new(words).color(palette.red));
        }
    });
}

/// Draws the result cards.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    heading_ui(ui, cx);
    let (layout, unit) = (cx.layout, cx.unit());
    let assessment = cx.session.assessment();
    let solution = &assessment.solution;
    let has_distance = |method| assessment.distance(method).is_some();
    if let Some(unknown) = &assessment.unknown {
        card_ui(ui, Card::Solved(assessment.worded(unknown.field)), |ui| {
            solved_ui(ui, assessment, unknown, unit)
        });
    } else if !Method::ALL.into_iter().any(has_distance) {
        card_ui(ui, Card::NoResult, |ui| empty_ui(ui, cx));
        return;
    }
    let is_solved = |method| assessment.unknown.as_ref().is_some_and(|unknown| unknown.method == method);
    let is_refused = |method| assessment.refusal(method).is_some() && !is_solved(method);
    let shows = |&method: &Method| has_distance(method) || is_refused(method);
    let mut shown: Vec<Card> = Method::ALL.into_iter().filter(shows).map(Card::Distance).collect();
    let agreement = Statement::comparison(assessment);
    shown.extend((solution.combined.is_some() || agreement.is_some()).then_some(Card::Combined));
    let columns = if layout.columns() == 1 { 1 } else { shown.len().max(1) };
    for row in shown.chunks(columns) {
        cards::row_ui(ui, row, layout.gap(), |ui, card, row| {
            card_ui(ui, card, |ui| {
                match card {
                    Card::Distance(method) => result_ui(ui, assessment, method, unit),
                    _ => combined_ui(ui, assessment, unit),
                }
                cards::fill_height_ui(ui, row);
            });
        });
    }
}

/// The heading, and the choice of the unit.
fn heading_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let palette = theme::palette(ui);
    ui.horizontal(|ui| {
        text::heading_ui(ui, "Results", 2, theme::strong(theme::RESULTS_HEADING_SIZE), palette.text);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let mut chosen = cx.unit();
            ui.spacing_mut().interact_size.y = cx.layout.heading_control_height();
            length_unit_choice_ui(ui, "unit of the results", "Unit of the results", &mut chosen, theme::UNIT_WIDTH);
            if chosen != cx.unit() {
                cx.commands.push(Command::ShowResultsIn(chosen));
            }
            text::caption_ui(ui, "in");
        });
    });
}

/// The weighted mean of both distances, and whether they agree. Where they contradict each other there is no number.
fn combined_ui(ui: &mut Ui, assessment: &Assessment, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let solution = &assessment.solution;
    let agreement = Statement::comparison(assessment);
    let (front, back) = match agreement {
        Some(Statement::Agree { .. }) => (palette.green, palette.green_tint),
        Some(Statement::HardlyAgree { .. }) => (palette.orange_text, palette.orange_tint),
        Some(Statement::Disagree { .. } | Statement::Contradict { .. }) => (palette.red, palette.red_tint),
        _ => (palette.muted, palette.highlight),
    };
    let verdict = agreement.and_then(|statement| statement.verdict());
    text::badge_ui(ui, verdict.unwrap_or(Card::Combined.title()), front, back);
    if let Some(combined) = solution.combined {
        let [value, unit] = report::measured_parts(combined, unit);
        number_ui(ui, &value, &unit, "Combined distance");
        text::caption_ui(ui, capital(&Statement::Combined.to_string()));
    }
    if let Some(statement) = agreement.filter(|statement| !matches!(statement, Statement::Agree { .. })) {
        let response = ui.label(RichText::new(statement.to_string()).size(theme::SMALL_SIZE).color(palette.text));
        if solution.combined.is_none() {
            text::announce(ui, &response);
        }
    }
    for suspect in assessment.suspects().iter().take(3) {
        text::caption_ui(ui, format!("• {}", Statement::suspect(assessment, suspect)));
    }
}

/// The quantity that was solved for.
fn solved_ui(ui: &mut Ui, assessment: &Assessment, unknown: &Unknown, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let name = assessment.worded(unknown.field).name;
    text::badge_ui(ui, &format!("{}: {name}", unknown.method.name()), palette.green, palette.green_tint);
    match report::unknown_in_parts(unknown, unit) {
        Some([value, unit]) => {
            number_ui(ui, &value, &unit, name);
            remarks_ui(ui, assessment, unknown.method);
        }
        None => {
            number_ui(ui, NO_NUMBER, "", name);
            let why = report::why_unsolved(assessment, unknown);
            text::caption_ui(ui, why.map_or_else(String::new, |why| capital(&why)));
        }
    }
}

/// A card without a heading, as a region that assistive technology can jump to.
fn card_ui(ui: &mut Ui, card: Card, add_contents: impl FnOnce(&mut Ui)) {
    let builder = UiBuilder::new()
        .id_salt(card)
        .accessibility_role(Role::Region)
        .accessibility_label(card.title());
    ui.scope_builder(builder, |ui| {
        theme::card(theme::palette(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            add_contents(ui);
        });
    });
}

fn number_ui(ui: &mut Ui, value: &str, unit: &str, name: &str) {
    let palette = theme::palette(ui);
    // One label, so that "1.400 m" is read aloud, found and copied as a whole.
    let mut job = egui::text::LayoutJob::default();
    job.append(
        value,
        0.0,
        egui::TextFormat::simple(theme::strong(theme::RESULT_SIZE), palette.text),
    );
    let mut small = egui::TextFormat::simple(theme::regular(theme::RESULT_UNIT_SIZE), palette.muted);
    // Text of two sizes is aligned at the bottom of the line; the taller line lifts the small one to the same baseline.
    small.line_height = Some(theme::RESULT_UNIT_SIZE * 1.21 + (theme::RESULT_SIZE - theme::RESULT_UNIT_SIZE) * 0.48);
    if !unit.is_empty() {
        job.append(&format!(" {unit}"), theme::RESULT_UNIT_GAP, small);
    }
    let response = ui.label(job);
    text::announce(ui, &response);
    ui.accesskit_node_builder(response.id, |node| node.set_description(name));
}

fn result_ui(ui: &mut Ui, assessment: &Assessment, method: Method, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let solution = &assessment.solution;
    let (front, back) = text::badge_colors(palette, method);
    text::badge_ui(ui, method.name(), front, back);
    let distance = assessment.distance(method);
    if let Some(refusal) = assessment.refusal(method).filter(|_| distance.is_none()) {
        // The field is marked and says so aloud already.
        ui.label(RichText::new(refusal.message()).size(theme::SMALL_SIZE).color(palette.red));
        return;
    }
    let name = format!("{} distance", method.name());
    match (distance, solution.uncertainty(method)) {
        (Some(distance), Some(uncertainty)) => {
            let [value, with_sigma] = report::measured_parts(Measured::new(distance, uncertainty.sigma), unit);
            number_ui(ui, &value, &with_sigma, &name);
            let cause = Statement::main_cause(assessment, uncertainty).map_or_else(String::new, |cause| format!(" · {cause}"));
            text::caption_ui(ui, format!("{}{cause}", report::interval(uncertainty, unit)));
        }
        _ => {
            let [value, unit] = report::length_parts(distance, unit);
            number_ui(ui, &value, &unit, &name);
        }
    }
    if method == Method::Stereo
        && let Some(range) = report::one_pixel_range(solution, unit)
    {
        text::caption_ui(ui, Hint::OnePixel { range }.to_string());
    }
    remarks_ui(ui, assessment, method);
    text::caption_ui(ui, report::formula(solution, method));
    if let Some(formula) = report::formula_with_numbers(assessment, method, unit) {
        ui.label(RichText::new(formula).size(theme::SMALL_SIZE).color(palette.text));
    }
}

fn remarks_ui(ui: &mut Ui, assessment: &Assessment, method: Method) {
    for remark in report::remarks(assessment, method) {
        text::caption_ui(ui, capital(&remark.to_string()));
    }
}

/// Without a distance: of each method, why, or what it needs.
fn empty_ui(ui: &mut Ui, cx: &AppContext<'_>) {
    number_ui(ui, NO_NUMBER, cx.unit().symbol(), "Distance");
    let (inputs, assessment) = (&cx.session.inputs, cx.session.assessment());
    let refusal = |method| assessment.refusal(method).filter(|_| inputs.is_begun(method));
    let [stereo, monocular] = Method::ALL.map(refusal);
    if let Some(both) = stereo.filter(|_| stereo == monocular) {
        // Once is enough.
        text::caption_ui(ui, both.message());
        return;
    }
    for method in Method::ALL {
        let missing = inputs.missing_for(method);
        let words = match refusal(method) {
            Some(refusal) => format!("{}: {}", method.name(), refusal.message()),
            None if inputs.is_begun(method) && !missing.is_empty() => Hint::StillNeeds { method, missing }.to_string(),
            None => Hint::MethodNeeds {
                method,
                formula: report::formula(&assessment.solution, method),
            }
            .to_string(),
        };
        text::caption_ui(ui, words);
    }
}
