//! The helper dialogs, which compute an input from other numbers: the choice of a way, its fields, and the button that uses the result.

mod q_matrix;
mod ways;

use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::dialog::{DialogFrame, close_button};
use crate::app::saved::Texts;
use crate::app::theme;
use crate::app::widgets::number_field::{NumberField, Unit};
use crate::app::widgets::{scroll, text};
use crate::core::camera::SENSOR_FORMATS;
use crate::core::problem::Field;
use crate::formats::inputs::{Entry, Severity};
use crate::formats::number::{self, plain, significant};
use egui::{Button, ComboBox, RichText, Stroke, Ui, vec2};
use ways::Way;

const fn title(helper: Helper) -> &'static str {
    match helper {
        Helper::FocalLength => "Where does the focal length come from?",
        Helper::Disparity => "What is known of the disparity?",
    }
}

/// The Q matrix is listed with the ways to a focal length, though it gives more than that.
const Q_MATRIX: &str = "A Q matrix of stereoRectify";

/// Draws the helper over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, helper: Helper) {
    let frame = DialogFrame {
        id: "helper",
        title: title(helper),
        max_width: 440.0,
    };
    let cancel = Command::Help(None);
    let response = frame.show(ui, |ui| {
        ui.spacing_mut().interact_size.y = cx.layout.control_height();
        ui.add_space(2.0 * theme::STEP);
        scroll::up_to(ui, ui.ctx().content_rect().height() - 180.0, |ui| {
            let way = way_choice_ui(ui, helper, &mut cx.settings.texts);
            match way {
                Some(way) => way_ui(ui, cx, way),
                None => q_matrix::ui(ui, cx),
            }
        });
        ui.add_space(theme::STEP);
        close_button(ui, cancel.text(), cx.layout)
    });
    if response.inner || response.should_close() {
        cx.commands.push(cancel);
    }
}

/// The choice among the ways of `helper`. Returns the chosen one; `None` is the Q matrix.
fn way_choice_ui(ui: &mut Ui, helper: Helper, texts: &mut Texts) -> Option<&'static Way> {
    let key = format!("way: {helper:?}");
    let names: Vec<&'static str> = ways::of(helper)
        .iter()
        .map(|way| way.name)
        .chain((helper == Helper::FocalLength).then_some(Q_MATRIX))
        .collect();
    let mut chosen = texts
        .get(&key)
        .and_then(|stored| names.iter().find(|name| *name == stored))
        .or(names.first())
        .copied()
        .unwrap_or_default();
    let before = chosen;
    ComboBox::from_id_salt(&key)
        .width(ui.available_width())
        .selected_text(chosen)
        .show_ui(ui, |ui| {
            for &name in &names {
                if ui.selectable_value(&mut chosen, name, name).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("What is known");
    if chosen != before {
        texts.insert(key, chosen.to_owned());
    }
    ui.add_space(2.0 * theme::STEP);
    ways::of(helper).iter().find(|way| way.name == chosen)
}

fn way_ui(ui: &mut Ui, cx: &mut AppContext<'_>, way: &Way) {
    let mut numbers = Vec::new();
    for ask in way.asks {
        let typed = cx.settings.texts.entry(ask.name.to_owned()).or_default();
        NumberField {
            name: ask.name,
            hint: "",
            example: ask.example,
            unit: Unit::Fixed(ask.unit),
            signed: way.field == Field::Disparity,
            sigma: None,
        }
        .ui(ui, typed);
        if ask.name == ways::SENSOR_WIDTH.name {
            sensor_formats_ui(ui, typed);
        }
        if let Ok(number::Typed { number, unit: None, .. }) = number::read(typed) {
            numbers.push(number);
        }
    }
    text::caption(ui, way.remark);
    ui.add_space(theme::STEP);
    let symbol = way.field.symbol();
    let result = if numbers.len() == way.asks.len() {
        (way.compute)(&numbers)
    } else {
        Err(String::new())
    };
    let usable = result.as_ref().ok().filter(|value| value.is_finite());
    let label = usable.map_or_else(
        || format!("Use as {symbol}"),
        |value| format!("Use {symbol} = {} px", significant(*value, 6)),
    );
    if let Err(reason) = &result
        && !reason.is_empty()
    {
        text::note(ui, Severity::Error, reason, None);
    }
    if use_button(ui, &label, usable.is_some())
        && let Some(value) = usable
    {
        cx.commands.push(Command::Fix(way.field, Entry::new(plain(*value), None)));
    }
}

fn sensor_formats_ui(ui: &mut Ui, typed: &mut String) {
    ComboBox::from_id_salt("sensor formats")
        .selected_text("Common formats…")
        .width(200.0)
        .show_ui(ui, |ui| {
            for format in &SENSOR_FORMATS {
                let name = format!("{}: {} × {} mm", format.name, plain(format.width_mm), plain(format.height_mm));
                if ui.selectable_label(false, name).clicked() {
                    *typed = plain(format.width_mm);
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("Common sensor formats");
    ui.add_space(2.0 * theme::STEP);
}

fn use_button(ui: &mut Ui, label: &str, enabled: bool) -> bool {
    let height = ui.spacing().interact_size.y;
    let palette = theme::palette(ui);
    let button = Button::new(RichText::new(label).font(theme::strong(theme::BODY_SIZE)).color(palette.on_blue))
        .fill(palette.blue)
        .stroke(Stroke::NONE)
        .min_size(vec2(0.0, height));
    ui.add_enabled(enabled, button).clicked()
}
