//! The frame: navigation at the top, a screen, bars at the bottom, and dialogs over them.

use super::App;
use super::command::Command;
use super::dialog::Dialog;
use super::saved::Screen;
use super::theme::{self, Layout, Palette};
use super::widgets::bottom_bar::BottomBar;
use super::{about, calculator, learn, navigation, shortcuts};
use egui::{Align, CentralPanel, Frame, Margin, Panel, Stroke, Ui};

impl App {
    /// Draws a frame, and keeps what it asks for until [`Self::update`] carries it out.
    pub(super) fn frame_ui(&mut self, ui: &mut Ui) {
        let layout = Layout::of_width(ui.available_width());
        let palette = theme::palette(ui);
        let mut commands = Vec::from_iter(shortcuts::pressed(ui.ctx()));
        ui.spacing_mut().interact_size.y = layout.control_height();
        let top = Panel::top("navigation").resizable(false).frame(bar(palette, layout, 8));
        top.show(ui, |ui| {
            navigation::ui(ui, layout, self.settings.screen, self.settings.theme, &mut commands);
        });
        let bottom_bar = BottomBar::new(ui, "screen");
        bottom_bar.above(ui, |ui| self.screen_ui(ui, layout, &mut commands));
        bottom_bar.below(ui, |ui| self.bottom_ui(ui, layout, &mut commands));
        match self.dialog {
            Some(Dialog::Keys) => shortcuts::list(ui, layout, &mut commands),
            Some(Dialog::About) => about::show(ui, layout, &*self.platform, &mut commands),
            None => {}
        }
        focus_ring(ui);
        self.keep(ui.ctx(), commands);
    }

    fn screen_ui(&mut self, ui: &mut Ui, layout: Layout, commands: &mut Vec<Command>) {
        let background = Frame::new().fill(theme::palette(ui).page).inner_margin(Margin {
            left: layout.screen_margin(),
            right: layout.screen_margin(),
            top: 16,
            bottom: 0,
        });
        CentralPanel::no_frame().frame(background).show(ui, |ui| {
            ui.vertical_centered(|ui| {
                ui.set_max_width(ui.available_width().min(theme::CONTENT_WIDTH));
                ui.with_layout(egui::Layout::top_down(Align::Min), |ui| match self.settings.screen {
                    Screen::Learn => learn::show(ui, layout, commands),
                    Screen::Calculator => self.calculator.show(ui, layout, &mut self.session, &mut self.settings, commands),
                });
            });
        });
    }

    fn bottom_ui(&self, ui: &mut Ui, layout: Layout, commands: &mut Vec<Command>) {
        let palette = theme::palette(ui);
        let separated = |ui: &mut Ui, vertical, add_contents: &mut dyn FnMut(&mut Ui)| {
            let drawn = bar(palette, layout, vertical).show(ui, |ui| {
                ui.set_width(ui.available_width());
                add_contents(ui);
            });
            let rect = drawn.response.rect;
            let line = ui.visuals().widgets.noninteractive.bg_stroke;
            ui.painter().hline(rect.x_range(), rect.top(), line);
        };
        if let Some(notice) = &self.notice {
            separated(ui, 6, &mut |ui| notice.ui(ui, layout, commands));
        }
        if layout == Layout::Phone && self.settings.screen == Screen::Calculator {
            separated(ui, 10, &mut |ui| {
                calculator::result_bar(ui, self.session.assessment(), self.settings.result_unit);
            });
        }
    }

    /// Keeps `commands` for [`Self::update`].
    fn keep(&mut self, ctx: &egui::Context, mut commands: Vec<Command>) {
        // At once: some browsers allow it only while they handle the click, and that of a pointer is when eframe runs this pass.
        if commands.contains(&Command::CopyResults) {
            commands.retain(|command| *command != Command::CopyResults);
            self.copy_results(ctx);
        }
        if !commands.is_empty() {
            self.pending.append(&mut commands);
            ctx.request_repaint();
        }
        // What was typed in this pass is stored in the next.
        if !self.is_stored() {
            ctx.request_repaint();
        }
    }
}

/// A bar over the full width, above or below the screen.
fn bar(palette: &Palette, layout: Layout, vertical: i8) -> Frame {
    Frame::new()
        .fill(palette.surface)
        .inner_margin(Margin::symmetric(layout.bar_margin(), vertical))
}

/// Draws a ring around what has the keyboard: not every widget shows its focus by itself.
fn focus_ring(ui: &Ui) {
    const WIDTH: f32 = 2.0;
    // A field has its own border for that.
    if ui.ctx().text_edit_focused() {
        return;
    }
    let focused = ui.memory(|memory| memory.focused()).and_then(|id| ui.ctx().read_response(id));
    // Not while something else in the window has it, nor around what is scrolled out of sight.
    let Some(response) = focused.filter(|response| response.has_focus() && response.interact_rect.is_positive()) else {
        return;
    };
    // Only as much as can be seen of it where it is scrolled.
    let visible = response.interact_rect.expand(3.0 * WIDTH);
    let painter = ui.ctx().layer_painter(response.layer_id).with_clip_rect(visible);
    let ring = Stroke::new(WIDTH, theme::palette(ui).blue);
    painter.rect_stroke(response.rect.expand(WIDTH), theme::CONTROL_RADIUS, ring, egui::StrokeKind::Outside);
}
