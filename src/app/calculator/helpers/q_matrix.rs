//! Everything that a Q matrix of `stereoRectify` holds: focal length, baseline, doffs and the principal point.

use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::copyable::Copyable;
use crate::app::sentences::{Hint, NoticeText};
use crate::app::theme;
use crate::app::widgets::field::{self, Field as FieldWidget};
use crate::app::widgets::text;
use crate::core::q_matrix::StereoGeometry;
use crate::core::quantity::{Length, LengthUnit};
use depth_text::entry::Entry;
use depth_text::fields;
use depth_text::note::{Issue, Note, Severity};
use depth_text::number::plain;
use depth_text::reading::Reading;
use depth_text::unit::Unit;
use egui::{Button, Id, RichText, TextEdit, Ui, vec2};

/// The size of a square of the board, where one was typed.
type Square<'a> = Option<&'a Result<Reading, Note>>;

/// Draws a field for the matrix, and for each unit of the baseline a button that fills in the form.
///
/// `read` is what was in the field when the frame began; `None` for nothing.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, read: Option<&Result<StereoGeometry, Issue>>, square: Square<'_>) {
    let palette = theme::palette(ui);
    let key = fields::Q_MATRIX;
    let name = ui.label(RichText::new(key.name).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
    let typed = &mut cx.settings.entries.entry_mut(key).text;
    let field = ui
        .add(
            TextEdit::multiline(typed)
                .id(field::id(key))
                .desired_rows(5)
                .desired_width(ui.available_width())
                .hint_text(RichText::new(key.example()).color(palette.muted)),
        )
        .labelled_by(name.id);
    text::caption_ui(ui, Hint::QMatrixForms.to_string());
    ui.add_space(theme::STEP);
    match read {
        Some(Ok(geometry)) => {
            geometry_ui(ui, cx, geometry, field.id);
            squares_ui(ui, cx, geometry, square);
        }
        Some(Err(issue)) => {
            text::note_ui(ui, Severity::Error, &issue.to_string(), field.id);
        }
        None => {}
    }
    copy_ui(ui, cx);
}

/// The matrix of what is in the form, or what is missing for it.
fn copy_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    if cx.session.inputs.is_blank() {
        return;
    }
    let missing = depth_text::q_matrix::missing_for_form(&cx.session.inputs);
    ui.add_space(theme::STEP);
    text::caption_ui(ui, Hint::QMatrixCopy { missing }.to_string());
    if depth_text::q_matrix::of_form(cx.session.assessment()).is_none() {
        return;
    }
    let copy = Command::Copy(Copyable::QMatrix);
    let height = ui.spacing().interact_size.y;
    let button = ui.add(Button::new(copy.text()).min_size(vec2(0.0, height)));
    ui.accesskit_node_builder(button.id, |node| node.set_author_id(Copyable::QMatrix.author_id()));
    if button.clicked() {
        cx.commands.push(copy);
    }
}

/// What the matrix in `field` says, and what it does not: the unit of the baseline.
fn geometry_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &StereoGeometry, field: Id) {
    let baseline = plain(geometry.baseline);
    ui.label(Hint::QMatrixContents { geometry: *geometry }.to_string());
    if geometry.swapped {
        text::note_ui(ui, Severity::Warning, &Issue::QMatrixSwapped.to_string(), field);
    }
    ui.add_space(theme::STEP);
    ui.label(
        Hint::QMatrixUnit {
            baseline: geometry.baseline,
        }
        .to_string(),
    );
    ui.horizontal_wrapped(|ui| {
        let height = ui.spacing().interact_size.y;
        for unit in baseline_units(geometry.baseline) {
            let label = format!("{baseline} {}", unit.symbol());
            if ui.add(Button::new(label).min_size(vec2(0.0, height))).clicked() {
                let baseline = Entry::new(plain(geometry.baseline), Some(unit));
                let filled = depth_text::q_matrix::filled_in(&cx.session.inputs, geometry, baseline);
                cx.commands.push(Command::Open(Box::new(filled), NoticeText::FilledByQMatrix));
            }
        }
    });
    ui.add_space(theme::STEP);
}

/// The units in which this may be the baseline of a pair of cameras: all of them if there is none.
fn baseline_units(baseline: f64) -> Vec<LengthUnit> {
    const BASELINES_M: std::ops::RangeInclusive<f64> = 1e-3..=1e3;
    let is_plausible = |unit: &LengthUnit| BASELINES_M.contains(&Length::new(baseline, *unit).m());
    let plausible: Vec<LengthUnit> = LengthUnit::ALL.into_iter().filter(is_plausible).collect();
    if plausible.is_empty() {
        LengthUnit::ALL.to_vec()
    } else {
        plausible
    }
}

/// The baseline in squares of the board, with the size of a square.
fn squares_ui(ui: &mut Ui, cx: &mut AppContext<'_>, geometry: &StereoGeometry, square: Square<'_>) {
    let key = fields::SQUARE_SIZE;
    text::caption_ui(ui, Hint::SquaresOfBoard.to_string());
    let reading = square.and_then(|read| read.as_ref().ok());
    let field = FieldWidget {
        key,
        reading,
        notes: square.and_then(|read| read.as_ref().err()).into_iter().collect(),
        entry: cx.settings.entries.entry_mut(key),
        with_sigma: false,
        helper: None,
        id: field::id(key),
        submits: false,
        following: None,
    };
    field.ui(ui, cx.commands);
    let height = ui.spacing().interact_size.y;
    let baseline = plain(geometry.baseline);
    let square = reading.and_then(|reading| Unit::square(Length::from_m(reading.value)));
    let label = square.map_or_else(|| format!("{baseline} squares"), |unit| format!("{baseline} {unit}"));
    let button = Button::new(label).min_size(vec2(0.0, height));
    if ui.add_enabled(square.is_some(), button).clicked()
        && let Some(unit) = square
    {
        let baseline = Entry::new(format!("{} {unit}", plain(geometry.baseline)), None);
        let filled = depth_text::q_matrix::filled_in(&cx.session.inputs, geometry, baseline);
        cx.commands.push(Command::Open(Box::new(filled), NoticeText::FilledByQMatrix));
    }
}

#[cfg(test)]
mod tests {
    use super::baseline_units;
    use crate::core::quantity::LengthUnit::{self, *};

    #[test]
    fn only_units_are_offered_in_which_two_cameras_may_stand_so_far_apart() {
        assert_eq!(baseline_units(120.0), [Millimeter, Centimeter, Meter, Inch, Foot, Yard]);
        assert_eq!(baseline_units(0.06), [Meter, Kilometer, Inch, Foot, Yard, Mile]);
        assert_eq!(baseline_units(1e30), LengthUnit::ALL);
    }
}
