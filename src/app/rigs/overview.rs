//! The list of rigs, and the buttons that add to it.

use super::list::letter;
use super::rig::{MOST, Rig};
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::dialog::{Destination, Dialog};
use crate::app::theme;
use crate::app::widgets::{choice, text};
use depth_text::fields;
use depth_text::reading;
use egui::accesskit::{Role, Toggled};
use egui::text::LayoutJob;
use egui::{Button, Rect, Response, RichText, Sense, Stroke, Ui, UiBuilder, pos2, vec2};

/// Draws them.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let heading = text::heading_ui(ui, "Rigs", 1, theme::strong(theme::CARD_HEADING_SIZE), theme::palette(ui).text);
    text::announce(ui, &heading);
    ui.add_space(theme::STEP);
    if cx.settings.rigs.all.is_empty() {
        text::paragraph_ui(
            ui,
            "Keep the cameras that you work with: open a calibration file, drop one on the window, choose one that everybody knows, or type the numbers in. Nothing leaves this computer.",
        );
    } else {
        list_ui(ui, cx);
    }
    ui.add_space(2.0 * theme::STEP);
    buttons_ui(ui, cx);
    if !cx.settings.rigs.has_room() {
        ui.add_space(theme::STEP);
        text::caption_ui(ui, format!("There is room for {MOST}: remove one to add another."));
    }
}

fn list_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let group = UiBuilder::new()
        .accessibility_role(Role::RadioGroup)
        .accessibility_label("Rig that is shown");
    ui.scope_builder(group, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let count = cx.settings.rigs.all.len();
        // Only what was shown when it was drawn can get the focus, so it comes a frame after the key.
        let coming = egui::Id::unique("the focus comes to a rig");
        let comes = ui.data_mut(|data| data.remove_temp::<bool>(coming)).is_some();
        let mut focused = None;
        for at in 0..count {
            let Some(row) = row_ui(ui, cx, at) else { continue };
            if comes && cx.settings.rigs.shown == at {
                row.request_focus();
            }
            if row.has_focus() {
                focused = Some((at, row.id));
            }
        }
        if let Some((at, id)) = focused
            && let steps = choice::steps(ui, id)
            && steps != 0
            && let Some(next) = (at + count).checked_add_signed(steps)
        {
            cx.commands.push(Command::ShowRig(next % count));
            ui.data_mut(|data| data.insert_temp(coming, true));
        }
    });
}

/// A rig of the list: one stop of the key Tab for all of them, among them by the arrow keys.
fn row_ui(ui: &mut Ui, cx: &mut AppContext<'_>, at: usize) -> Option<Response> {
    let rig = cx.settings.rigs.all.get(at)?;
    let palette = theme::palette(ui);
    let is_shown = cx.settings.rigs.shown == at;
    let facts = facts(rig);
    let full = ui.available_width();
    let color = palette.rig(at);
    let named = |width: f32| {
        let mut job = LayoutJob::default();
        job.append("● ", 0.0, egui::TextFormat::simple(theme::regular(theme::BODY_SIZE), color));
        job.append(
            &format!("{} ", letter(at)),
            0.0,
            egui::TextFormat::simple(theme::strong(theme::BODY_SIZE), color),
        );
        job.append(
            rig.shown_name(),
            0.0,
            egui::TextFormat::simple(theme::regular(theme::BODY_SIZE), palette.text),
        );
        job.wrap.max_width = width;
        job
    };
    let right = ui
        .painter()
        .layout_no_wrap(facts.clone(), theme::strong(theme::BODY_SIZE), palette.text);
    let room = full - right.size().x - 5.0 * theme::STEP;
    let left = ui.painter().layout_job(named(room.max(theme::RIG_NAME_WIDTH)));
    let height = (left.size().y + 2.0 * theme::CELL_PADDING).max(cx.layout.control_height());
    let sense = if is_shown { Sense::click() } else { Sense::CLICK };
    let (rect, response) = ui.allocate_exact_size(vec2(full, height), sense);
    if is_shown || response.hovered() {
        ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    }
    let inside = rect.shrink2(vec2(theme::STEP, 0.0));
    ui.painter()
        .galley(pos2(inside.left(), inside.center().y - left.size().y / 2.0), left, palette.text);
    let at_right = pos2(inside.right() - right.size().x, inside.center().y - right.size().y / 2.0);
    ui.painter().with_clip_rect(inside).galley(at_right, right, palette.text);
    line_ui(ui, rect, is_shown);
    response.widget_info(|| egui::WidgetInfo::labeled(Role::RadioButton, true, format!("{} {}, {facts}", letter(at), rig.shown_name())));
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::RadioButton);
        node.set_toggled(if is_shown { Toggled::True } else { Toggled::False });
    });
    if response.clicked() {
        cx.commands.push(Command::ShowRig(at));
    }
    Some(response.on_hover_cursor(egui::CursorIcon::PointingHand))
}

fn line_ui(ui: &Ui, rect: Rect, is_shown: bool) {
    let palette = theme::palette(ui);
    let stroke = if is_shown {
        Stroke::new(theme::STRONG_LINE, palette.text)
    } else {
        Stroke::new(theme::THIN_LINE, palette.line)
    };
    ui.painter().hline(rect.x_range(), rect.bottom(), stroke);
}

/// Baseline and focal length, as far as they are known: "120 mm · 700 px".
pub fn facts(rig: &Rig) -> String {
    let of = |key: depth_text::field::Key| {
        let read = reading::read(key, rig.inputs.entry(key)).ok()??;
        Some(format!(
            "{} {}",
            read.number_text,
            read.unit.map_or("px", depth_text::unit::Unit::symbol)
        ))
    };
    let known: Vec<String> = [fields::BASELINE, fields::FOCAL_LENGTH].into_iter().filter_map(of).collect();
    if known.is_empty() {
        "no numbers yet".to_owned()
    } else {
        known.join(" · ")
    }
}

fn buttons_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let height = cx.layout.control_height();
    let has_room = cx.settings.rigs.has_room();
    let has_rigs = !cx.settings.rigs.all.is_empty();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
        let mut button_ui = |command: Command, is_enabled: bool| {
            let button = Button::new(RichText::new(command.text())).min_size(vec2(0.0, height));
            if ui.add_enabled(is_enabled, button).clicked() {
                cx.commands.push(command);
            }
        };
        button_ui(Command::ShowImport, true);
        button_ui(Command::ShowDialog(Some(Dialog::Presets(Destination::Rig))), has_room);
        button_ui(Command::AddRig(Box::default()), has_room);
        if has_rigs {
            button_ui(Command::ExportRigs, true);
        }
    });
}
