//! The frame: navigation bar, screen, bars at the bottom, and dialogs.

use super::App;
use super::calculator::{self, Calculator};
use super::command::Command;
use super::context::AppContext;
use super::dialog::Dialog;
use super::notice::Notice;
use super::rigs::Rigs;
use super::saved::Screen;
use super::theme::{self, Layout};
use super::widgets::bottom_bar::BottomBar;
use super::{about, import, learn, navigation, presets, sensor_mode, shortcuts};
use egui::accesskit::Role;
use egui::{Align, CentralPanel, Frame, Margin, Panel, Stroke, Ui, UiBuilder};

impl App {
    /// Draws a frame and queues its commands for [`Self::update`].
    pub(super) fn frame_ui(&mut self, ui: &mut Ui) {
        let mut commands = Vec::from_iter(shortcuts::pressed(ui.ctx()));
        // On other screens nobody sees what they would do.
        if self.settings.screen == Screen::Rigs {
            commands.retain(|command| !matches!(command, Command::Undo | Command::Redo));
        }
        commands.extend(pasted_file(ui.ctx()));
        let ctx = ui.ctx().clone();
        let cx = &mut AppContext {
            egui: &ctx,
            layout: Layout::of(ctx.content_rect().size()),
            session: &mut self.session,
            settings: &mut self.settings,
            platform: &*self.platform,
            commands: &mut commands,
        };
        ui.spacing_mut().interact_size.y = cx.layout.control_height();
        if !cx.is_low() {
            let top = Panel::top("navigation").resizable(false);
            top.frame(bar(ui, cx.layout, theme::NAVIGATION_MARGIN))
                .show(ui, |ui| navigation::ui(ui, cx));
        }
        let bottom_bar = BottomBar::new(ui, "screen", (cx.settings.screen, cx.layout, self.notice.is_some()));
        bottom_bar.above_ui(ui, |ui| screen_ui(ui, cx, &mut self.calculator, &mut self.rigs));
        bottom_bar.below_ui(ui, |ui| bottom_ui(ui, cx, self.notice.as_ref()));
        if let Some(import) = &mut self.import {
            import::ui(ui, cx, import);
        }
        match self.dialog {
            Some(Dialog::Keys) => shortcuts::ui(ui, cx),
            Some(Dialog::About) => about::ui(ui, cx),
            Some(Dialog::Presets(destination)) => presets::cameras_ui(ui, cx, destination),
            Some(Dialog::CameraFacts(destination)) => self.camera_facts.ui(ui, cx, destination),
            Some(Dialog::SensorMode) => sensor_mode::ui(ui, cx, &mut self.mode),
            None => {}
        }
        match &self.chart_picture {
            Some(picture) => picture.shield_ui(ui),
            None => focus_ring(ui),
        }
        import::drop_hint_ui(ui);
        self.queue(&ctx, commands);
    }

    /// Queues `commands` for [`Self::update`].
    fn queue(&mut self, ctx: &egui::Context, mut commands: Vec<Command>) {
        // Copying cannot wait: some browsers allow it only while they handle the click, which is when eframe runs this pass.
        commands.retain(|command| {
            let Command::Copy(what) = command else { return true };
            self.copy(ctx, what.clone());
            false
        });
        if !commands.is_empty() {
            self.pending.append(&mut commands);
            ctx.request_repaint();
        }
        // What was typed in this frame is saved by the logic of the next.
        if !self.is_stored() {
            ctx.request_repaint();
        }
    }
}

/// A calibration file whose text was pasted where no field takes it.
fn pasted_file(ctx: &egui::Context) -> Option<Command> {
    if ctx.text_edit_focused() {
        return None;
    }
    ctx.input(|input| {
        input.events.iter().find_map(|event| match event {
            egui::Event::Paste(text) if import::is_file(text) => Some(Command::ReadText(text.clone())),
            _ => None,
        })
    })
}

fn screen_ui(ui: &mut Ui, cx: &mut AppContext<'_>, calculator: &mut Calculator, rigs: &mut Rigs) {
    let background = Frame::new().fill(theme::palette(ui).page).inner_margin(Margin {
        left: cx.layout.screen_margin(),
        right: cx.layout.screen_margin(),
        // The contents scroll from the line of the header on.
        top: 0,
        bottom: 0,
    });
    let screen = cx.settings.screen;
    let panel = UiBuilder::new()
        .accessibility_role(Role::TabPanel)
        .accessibility_label(screen.name());
    CentralPanel::no_frame().frame(background).show(ui, |ui| {
        ui.vertical_centered(|ui| {
            ui.set_max_width(ui.available_width().min(theme::CONTENT_WIDTH));
            ui.scope_builder(panel.layout(egui::Layout::top_down(Align::Min)), |ui| match screen {
                Screen::Calculator => calculator.ui(ui, cx),
                Screen::Rigs => rigs.ui(ui, cx),
                Screen::Learn => learn::ui(ui, cx),
            });
        });
    });
}

fn bottom_ui(ui: &mut Ui, cx: &mut AppContext<'_>, notice: Option<&Notice>) {
    if let Some(notice) = notice {
        separated_bar_ui(ui, cx, theme::NOTICE_MARGIN, |ui, cx| notice.ui(ui, cx));
    }
    if cx.layout == Layout::Phone && !cx.is_low() && cx.settings.screen == Screen::Calculator {
        separated_bar_ui(ui, cx, theme::BAR_RESULT_MARGIN, |ui, cx| calculator::result_bar_ui(ui, cx));
    }
}

/// A bar below a line.
fn separated_bar_ui<'a>(ui: &mut Ui, cx: &mut AppContext<'a>, vertical: i8, add_contents: impl FnOnce(&mut Ui, &mut AppContext<'a>)) {
    let drawn = bar(ui, cx.layout, vertical).show(ui, |ui| {
        ui.set_width(ui.available_width());
        add_contents(ui, cx);
    });
    let rect = drawn.response.rect;
    let line = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().hline(rect.x_range(), rect.top(), line);
}

/// A bar over the full width, above or below the screen.
fn bar(ui: &Ui, layout: Layout, vertical: i8) -> Frame {
    Frame::new()
        .fill(theme::palette(ui).surface)
        .inner_margin(Margin::symmetric(layout.bar_margin(), vertical))
}

/// Draws a ring around the focused widget: not every widget shows its focus by itself.
fn focus_ring(ui: &Ui) {
    // A text field shows it by its border.
    if ui.ctx().text_edit_focused() {
        return;
    }
    let focused = ui.memory(|memory| memory.focused()).and_then(|id| ui.ctx().read_response(id));
    // Neither while something outside egui has the focus, nor around what is scrolled out of view.
    let Some(response) = focused.filter(|response| response.has_focus() && response.interact_rect.is_positive()) else {
        return;
    };
    // Clipped to the visible part of the widget.
    let visible = response.interact_rect.expand(3.0 * theme::FOCUS_RING_WIDTH);
    let painter = ui.ctx().layer_painter(response.layer_id).with_clip_rect(visible);
    let ring = Stroke::new(theme::FOCUS_RING_WIDTH, theme::palette(ui).blue);
    let around = response.rect.expand(theme::FOCUS_RING_WIDTH);
    painter.rect_stroke(around, theme::CONTROL_RADIUS, ring, egui::StrokeKind::Outside);
}
