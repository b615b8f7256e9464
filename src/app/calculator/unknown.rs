//! Solving for another quantity than the distance: which one, what is given, and the answer in place of its field.

use super::parts::{Part, field_ui, heading_ui, part_ui, sigma_heading_ui};
use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::theme;
use crate::app::widgets::field::{self, Lines};
use crate::app::widgets::segments::{self, Segments};
use crate::app::widgets::{choice, joined, symbols};
use crate::core::problem::{Field, Method};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::report::strip::Value;
use egui::{Align2, Rect, Sense, Ui, vec2};

/// What is offered first.
pub const FIRST: (Method, Field) = (Method::Stereo, Field::Disparity);

/// What can be solved for.
const OFFERED: [Field; 6] = [
    Field::FocalLength,
    Field::Baseline,
    Field::Disparity,
    Field::Doffs,
    Field::ImageWidth,
    Field::RealWidth,
];

/// Draws the form that solves for another quantity than the distance. With `marked`, what is missing is said there too.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) {
    let Some((method, unknown)) = cx.session.inputs.unknown else {
        return;
    };
    let line = heading_ui(ui, "Solve for", None);
    choice_ui(ui, cx, (method, unknown));
    ui.add_space(theme::ABOVE_HEADING + theme::STEP);
    let given = heading_ui(ui, "Given", None);
    sigma_heading_ui(ui, given, false);
    let is_given = |key: &Key| *key != unknown && (cx.session.inputs.shows(*key) || key.section.is_none());
    let needed = Method::fields(method).map(Key::from).into_iter();
    let offset = (method == Method::Stereo).then_some(fields::DOFFS);
    let given: Vec<Key> = [fields::DISTANCE]
        .into_iter()
        .chain(needed)
        .chain(offset)
        .filter(is_given)
        .collect();
    for key in given {
        part_ui(ui, Part::Field(key.as_str()), |ui| field_ui(ui, cx, key, marked));
        ui.add_space(theme::FIELD_GAP);
    }
    ui.add_space(theme::ABOVE_HEADING - theme::FIELD_GAP);
    let section = match method {
        Method::Stereo => Section::Stereo,
        Method::Monocular => Section::Monocular,
    };
    let _ = heading_ui(ui, "Answer", Some(section).filter(|_| unknown != Field::FocalLength));
    answer_ui(ui, cx, unknown.into());
    ui.add_space(2.0 * theme::STEP);
    // By which method: two give a focal length. Behind the fields in the order of the focus.
    if unknown == Field::FocalLength {
        part_ui(ui, Part::Late, |ui| method_ui(ui, cx, line));
    }
}

/// The choice of the quantity.
fn choice_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, unknown): (Method, Field)) {
    let height = 2.0 * field::height(ui);
    let (whole, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let names = OFFERED.map(|field| match field {
        Field::FocalLength => "Focal length",
        Field::Baseline => "Baseline",
        Field::Disparity => "Disparity",
        Field::Doffs => "doffs",
        Field::ImageWidth => "Size in image",
        _ => "Real size",
    });
    let cells = segments::grid(whole, 3, 2);
    let all = Segments {
        written: None,
        group: "Solve for",
        names: &names,
        chosen: OFFERED.iter().position(|&field| field == unknown),
    };
    let now = all.ui(ui, &cells).and_then(|now| OFFERED.get(now)).copied();
    if let Some(field) = now {
        let by = Method::ALL.into_iter().find(|by| by.unknowns().any(|one| one == field));
        let method = if field == Field::FocalLength {
            method
        } else {
            by.unwrap_or(method)
        };
        cx.session.inputs.unknown = Some((method, field));
        cx.commands.push(Command::Settle);
    }
    segments::border_ui(ui, whole, &cells);
}

fn method_ui(ui: &mut Ui, cx: &mut AppContext<'_>, line: Rect) {
    if let Some((method, _)) = &mut cx.session.inputs.unknown
        && choice::ui(ui, line, "Method", &Method::ALL, method)
    {
        cx.commands.push(Command::Settle);
    }
}

/// What stands where there is no number.
const NONE: &str = "–";

/// The answer in place of its field; a dash where something is lacking.
fn answer_ui(ui: &mut Ui, cx: &mut AppContext<'_>, key: Key) {
    let palette = theme::palette(ui);
    let key = cx.session.inputs.worded(key);
    let lines = Lines::allocate(ui);
    let _ = field::label_ui(ui, lines.label, key, key.input.and_then(Helper::at), cx.commands);
    let cells = joined::Cells::of(lines.control, true, true);
    let color = symbols::color(palette, key);
    let tint = if color == palette.orange_text {
        palette.orange_tint
    } else {
        palette.blue_tint
    };
    ui.painter().rect_filled(cells.whole, theme::CONTROL_RADIUS, tint);
    let edge = cells.whole.with_max_x(cells.whole.left() + theme::THICK_LINE);
    ui.painter().rect_filled(edge, 0.0, color);
    let answer = cx.answer();
    let said_value = answer.value.text();
    let (number, sigma, unit) = match answer.value {
        Value::Number {
            number,
            sigma,
            power,
            unit,
        } => (number + &power, sigma, unit.map_or_else(String::new, |unit| unit.to_string())),
        _ => (String::from(NONE), None, key.unit_symbol().to_owned()),
    };
    let write = |cell: Rect, align: Align2, text: &str, is_strong: bool| {
        let inset = vec2(theme::CELL_INDENT, 0.0);
        let inside = cell.shrink2(inset);
        let font = if is_strong {
            theme::strong(theme::BODY_SIZE)
        } else {
            theme::regular(theme::BODY_SIZE)
        };
        let color = if is_strong { palette.text } else { palette.muted };
        ui.painter().text(align.pos_in_rect(&inside), align, text, font, color);
    };
    write(cells.value, Align2::LEFT_CENTER, "=", false);
    // Not a live region: the strip says the same.
    let said = ui.interact(cells.whole, ui.scope_id().with("answer"), Sense::hover());
    write(cells.value, Align2::RIGHT_CENTER, &number, true);
    if let Some(cell) = cells.unit {
        write(cell, Align2::LEFT_CENTER, &unit, false);
    }
    if let (Some(cell), Some(sigma)) = (cells.sigma, &sigma) {
        write(cell, Align2::LEFT_CENTER, "±", false);
        write(cell, Align2::RIGHT_CENTER, sigma, true);
    }
    said.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &said_value));
    let font = theme::regular(theme::SMALL_SIZE);
    let formula = symbols::job(palette, &answer.formula, &egui::TextFormat::simple(font, palette.muted), false);
    let galley = ui.painter().layout_job(formula);
    let at = lines.note.left_center() - vec2(0.0, galley.size().y / 2.0);
    ui.painter().galley(at, galley, palette.muted);
}
