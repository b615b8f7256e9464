//! The foot of the form: the buttons, the examples, and what opens the refinements.

use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::copyable::Copyable;
use crate::app::sentences::NoticeText;
use crate::app::theme;
use crate::app::widgets::text;
use depth_text::form::Example;
use depth_text::report::strip::Mode;
use egui::{Button, RichText, Sense, Stroke, Ui, vec2};

/// Draws the foot of the form of `mode`.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, mode: Mode) {
    ui.add_space(theme::ABOVE_BUTTONS);
    buttons_ui(ui, cx, mode);
    ui.add_space(2.0 * theme::STEP);
    links_ui(ui, cx, mode);
}

fn calculate_name(cx: &AppContext<'_>, mode: Mode) -> String {
    match cx.session.inputs.unknown {
        Some((_, field)) if mode == Mode::Quantity => format!("Calculate {}", cx.session.inputs.worded(field).label),
        _ => Command::Calculate.text().to_owned(),
    }
}

fn buttons_ui(ui: &mut Ui, cx: &mut AppContext<'_>, mode: Mode) {
    let height = cx.layout.control_height();
    let palette = theme::palette(ui);
    let gap = 2.0 * theme::STEP;
    let name = calculate_name(cx, mode);
    let calculate = Button::new(RichText::new(name).font(theme::strong(theme::BODY_SIZE)).color(palette.on_blue))
        .fill(palette.blue)
        .stroke(Stroke::new(theme::THIN_LINE, palette.blue));
    let others = [Command::Copy(Copyable::Results), Command::Reset];
    let full = ui.available_width();
    let is_narrow = cx.layout.is_narrow() || full < theme::BUTTON_ROW_WIDTH;
    let widths = if is_narrow {
        [(full - gap) / 2.0; 2]
    } else {
        [theme::COPY_WIDTH, theme::RESET_WIDTH]
    };
    if is_narrow {
        if ui.add_sized(vec2(full, height), calculate).clicked() {
            cx.commands.push(Command::Calculate);
        }
        ui.add_space(gap);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            others_ui(ui, cx, others, widths);
        });
        return;
    }
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        let width = full - widths.iter().map(|width| width + gap).sum::<f32>();
        if ui.add_sized(vec2(width, height), calculate).clicked() {
            cx.commands.push(Command::Calculate);
        }
        others_ui(ui, cx, others, widths);
    });
}

fn others_ui(ui: &mut Ui, cx: &mut AppContext<'_>, others: [Command; 2], widths: [f32; 2]) {
    let palette = theme::palette(ui);
    for (command, width) in others.into_iter().zip(widths) {
        let is_useful = match command {
            Command::Reset => !cx.session.inputs.is_blank(),
            _ => cx.session.has_answer(),
        };
        let color = if is_useful { palette.text } else { palette.muted };
        let border = if is_useful { palette.border } else { palette.line };
        let button = Button::new(RichText::new(command.text()).color(color)).stroke(Stroke::new(theme::THIN_LINE, border));
        let button = ui.add_sized(vec2(width, cx.layout.control_height()), button);
        if let Command::Copy(what) = &command {
            ui.accesskit_node_builder(button.id, |node| node.set_author_id(what.author_id()));
        }
        if button.clicked() {
            cx.commands.push(command.clone());
        }
        if command == Command::Copy(Copyable::Results) {
            button.on_hover_text("The answers, the table and a link that opens them again");
        }
    }
}

fn links_ui(ui: &mut Ui, cx: &mut AppContext<'_>, mode: Mode) {
    // These have neither examples nor refinements.
    if matches!(mode, Mode::TwoShots | Mode::TwoPoints) {
        return;
    }
    let height = cx.layout.inline_control_height();
    let full = ui.available_width();
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let is_stacked = full < theme::BUTTON_ROW_WIDTH || cx.layout.is_narrow();
    ui.allocate_ui_with_layout(vec2(full, height), layout, |ui| {
        ui.spacing_mut().item_spacing.x = 3.0 * theme::STEP;
        if mode.is_of_distance() && !is_stacked {
            refine_ui(ui, cx, height);
        }
        let examples: Vec<Example> = Example::ALL
            .into_iter()
            .filter(|example| example.is_of_ground() == (mode == Mode::Ground))
            .collect();
        let words = if examples.len() == 1 { "Example" } else { "Examples" };
        // From the right edge; a right-to-left layout would turn the order of Tab around.
        let width_of = |words: &str| {
            let galley = ui
                .painter()
                .layout_no_wrap(words.to_owned(), theme::regular(theme::LINK_SIZE), egui::Color32::PLACEHOLDER);
            galley.size().x
        };
        let needed: f32 = examples
            .iter()
            .map(|example| width_of(example.short_name()) + 3.0 * theme::STEP)
            .sum::<f32>()
            + width_of(words);
        let has_room = needed <= ui.available_width();
        let needed = if has_room {
            needed
        } else {
            needed - width_of(words) - 3.0 * theme::STEP
        };
        ui.add_space((ui.available_width() - needed).max(0.0));
        if has_room {
            ui.label(RichText::new(words).size(theme::LINK_SIZE).color(theme::palette(ui).muted));
        }
        for example in examples {
            let link = text::link_ui(ui, example.short_name(), height).accessible_name(example.name());
            if link.clicked() {
                cx.commands
                    .push(Command::Open(Box::new(example.inputs()), NoticeText::FilledByExample));
            }
        }
    });
    // What it opens follows right below it.
    if mode.is_of_distance() && is_stacked {
        ui.allocate_ui_with_layout(vec2(full, height), layout, |ui| refine_ui(ui, cx, height));
    }
}

/// What shows or hides the refinements: one name, and whether they are shown.
fn refine_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let shown = cx.settings.shows_refinements;
    let is_filled = !shown && cx.session.inputs.has_refinements();
    let command = Command::ShowRefinements(!shown);
    // What is hidden counts all the same.
    let name = if is_filled {
        format!("{} (filled in)", command.text())
    } else {
        command.text().to_owned()
    };
    let palette = theme::palette(ui);
    ui.spacing_mut().item_spacing.x = 0.0;
    let (mark, _) = ui.allocate_exact_size(vec2(theme::DISCLOSURE_WIDTH, height), Sense::hover());
    let at = mark.left_center();
    let [half, tip] = [theme::DISCLOSURE_HALF, theme::DISCLOSURE_TIP];
    let corners = if shown {
        [vec2(0.0, -tip / 2.0), vec2(2.0 * half, -tip / 2.0), vec2(half, tip / 2.0)]
            .map(|corner| at + corner)
            .to_vec()
    } else {
        [vec2(0.0, -half), vec2(tip, 0.0), vec2(0.0, half)]
            .map(|corner| at + corner)
            .to_vec()
    };
    ui.painter().add(egui::Shape::convex_polygon(corners, palette.blue, Stroke::NONE));
    let link = text::link_ui(ui, &name, height);
    ui.spacing_mut().item_spacing.x = 3.0 * theme::STEP;
    ui.accesskit_node_builder(link.id, |node| node.set_expanded(shown));
    if link.clicked() {
        cx.commands.push(command);
    }
}
