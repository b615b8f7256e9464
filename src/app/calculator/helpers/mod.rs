//! The helper dialogs, which compute an input from other numbers: the choice of a way, its fields, and the button that uses the result.

mod q_matrix;

use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::dialog::{DialogFrame, close_button};
use crate::app::saved::Ways;
use crate::app::theme;
use crate::app::widgets::number_field::{NumberField, Unit};
use crate::app::widgets::{scroll, text};
use crate::core::camera::SENSOR_FORMATS;
use crate::core::problem::Field;
use crate::formats::fields;
use crate::formats::inputs::Severity;
use crate::formats::number::{self, plain, significant};
use crate::formats::ways::{DISPARITIES, FOCAL_LENGTHS, Way};
use egui::{Button, ComboBox, RichText, Stroke, Ui, vec2};

const fn title(helper: Helper) -> &'static str {
    match helper {
        Helper::FocalLength => "Where does the focal length come from?",
        Helper::Disparity => "What is known of the disparity?",
    }
}

/// Its name in what is stored.
const fn key(helper: Helper) -> &'static str {
    match helper {
        Helper::FocalLength => "fx",
        Helper::Disparity => "d",
    }
}

const fn ways(helper: Helper) -> &'static [Way] {
    match helper {
        Helper::FocalLength => FOCAL_LENGTHS,
        Helper::Disparity => DISPARITIES,
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
            let way = way_choice_ui(ui, helper, &mut cx.settings.ways);
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
fn way_choice_ui(ui: &mut Ui, helper: Helper, chosen_ways: &mut Ways) -> Option<&'static Way> {
    let named = |way: &'static Way| (way.key, way.name);
    let q_matrix = (helper == Helper::FocalLength).then_some((fields::Q_MATRIX.as_str(), Q_MATRIX));
    let choices: Vec<(&'static str, &'static str)> = ways(helper).iter().map(named).chain(q_matrix).collect();
    let stored = chosen_ways.get(key(helper));
    let mut chosen = choices
        .iter()
        .find(|(key, _)| stored.is_some_and(|stored| stored == key))
        .or(choices.first())
        .copied()
        .unwrap_or_default();
    let before = chosen;
    ComboBox::from_id_salt(("way", key(helper)))
        .width(ui.available_width())
        .selected_text(chosen.1)
        .show_ui(ui, |ui| {
            for &choice in &choices {
                if ui.selectable_value(&mut chosen, choice, choice.1).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("What is known");
    if chosen != before {
        chosen_ways.insert(key(helper).to_owned(), chosen.0.to_owned());
    }
    ui.add_space(2.0 * theme::STEP);
    Way::named(ways(helper), chosen.0)
}

fn way_ui(ui: &mut Ui, cx: &mut AppContext<'_>, way: &Way) {
    for &key in way.asks {
        let typed = &mut cx.settings.entries.entry_mut(key).text;
        NumberField {
            name: key.name,
            hint: "",
            example: key.example(),
            unit: Unit::Fixed(key.unit_symbol()),
            signed: way.target == Field::Disparity,
            sigma: None,
        }
        .ui(ui, typed);
        if key == fields::SENSOR_WIDTH {
            sensor_formats_ui(ui, typed);
        }
    }
    text::caption(ui, way.remark);
    ui.add_space(theme::STEP);
    let symbol = way.target.symbol;
    let result = way.compute(&cx.settings.entries);
    let usable = result.as_ref().ok().copied().flatten();
    let label = usable.map_or_else(
        || format!("Use as {symbol}"),
        |value| format!("Use {symbol} = {} px", significant(value, 6)),
    );
    // What is not one number is said at its field.
    if let Err(note) = &result
        && number::read(&cx.settings.entries.entry(note.key).text).is_ok()
    {
        text::note(ui, Severity::Error, &note.message(), None);
    }
    if use_button(ui, &label, usable.is_some())
        && let Some(value) = usable
    {
        cx.commands.push(Command::Fix(way.target, way.entry(value)));
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
