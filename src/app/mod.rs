//! Floor 3: the egui application, the same in a browser, in a window and under test.

mod about;
mod calculator;
mod command;
mod learn;
mod platform;
mod saved;
mod sheet;
mod shortcuts;
mod theme;
mod widgets;

use crate::core::problem::Field;
use crate::formats::inputs::{Inputs, Severity};
use crate::formats::{link, number, report};
use calculator::Calculator;
use command::{Command, Dialog};
use egui::accesskit::Role;
use egui::{Align, Button, CentralPanel, Frame, Margin, Panel, RichText, Stroke, ThemePreference, Ui, UiBuilder, vec2};
pub use platform::{COPY_RESULTS, Licenses, Platform};
use saved::{Saved, Screen, Settings};
use sheet::Sheet;
use theme::Layout;
pub use theme::SystemColors;
use widgets::foot::Foot;
use widgets::{quantity_field, text};

/// A sentence about what just happened, with what can be done about it.
#[derive(Debug)]
struct Notice {
    text: String,
    action: Option<(&'static str, Command)>,
}

/// The application.
pub struct App {
    platform: Box<dyn Platform>,
    sheet: Sheet,
    settings: Settings,
    /// What is in storage, to write only what changed.
    stored: Saved,
    /// What is in storage could not be read and is still there. Nothing is written over it.
    is_in_the_way: bool,
    history: History,
    calculator: Calculator,
    notice: Option<Notice>,
    /// What stands over the screen.
    dialog: Option<Dialog>,
    forced_colors: Option<SystemColors>,
    pending: Vec<Command>,
}

impl App {
    /// The application with the state that `platform` has stored.
    pub fn new(cc: &eframe::CreationContext<'_>, platform: Box<dyn Platform>) -> Self {
        let ctx = &cc.egui_ctx;
        theme::install(ctx);
        let (saved, unread) = match platform.load() {
            Ok(None) => (Saved::default(), None),
            Ok(Some(text)) => match Saved::from_text(&text) {
                Some(saved) => (saved, None),
                None => (
                    Saved::default(),
                    Some("What was stored last time could not be read, or is of another version, so the program starts fresh.".to_owned()),
                ),
            },
            Err(reason) => (Saved::default(), Some(reason)),
        };
        ctx.set_theme(saved.settings.theme);
        let mut app = Self {
            platform,
            sheet: Sheet::new(saved.inputs.clone()),
            settings: saved.settings.clone(),
            history: History::new(saved.inputs.clone()),
            stored: saved,
            calculator: Calculator::default(),
            notice: None,
            dialog: None,
            forced_colors: None,
            pending: Vec::new(),
            is_in_the_way: unread.is_some(),
        };
        if let Some(reason) = unread
            && let Err(obstacle) = app.make_room(&reason)
        {
            // Often the same.
            let obstacle = if obstacle == reason {
                String::new()
            } else {
                format!(" {obstacle}")
            };
            app.say(
                &format!(
                    "{reason}{obstacle} The program works, but forgets what you enter when it is closed: copy your results to keep them."
                ),
                None,
            );
        }
        app.focus_first_field(ctx);
        app
    }

    /// At a desk the first field is where one starts; on a phone it would open the keyboard unasked.
    fn focus_first_field(&self, ctx: &egui::Context) {
        let touch = ctx.input(|input| input.any_touches());
        if self.sheet.inputs.is_blank() && self.settings.screen == Screen::Calculator && !touch && ctx.content_rect().width() > 720.0 {
            ctx.memory_mut(|memory| memory.request_focus(quantity_field::id(Field::FocalLength)));
        }
    }

    /// Puts the results on the clipboard now, for a platform that allows it only while a click is being handled.
    pub fn copy_results(&mut self, ctx: &egui::Context) {
        self.carry_out(ctx, Command::CopyResults);
    }

    fn carry_out(&mut self, ctx: &egui::Context, command: Command) {
        if let Command::Follow(fragment) = &command {
            let mut inputs = self.sheet.inputs.clone();
            // One that names nothing changes nothing.
            if link::apply(fragment, &mut inputs) {
                self.carry_out(ctx, Command::Open(Box::new(inputs), "The link filled in the fields that it names."));
            }
            return;
        }
        if !matches!(
            command,
            Command::DragDisparity(_) | Command::CopyResults | Command::Show(_) | Command::Theme(_)
        ) {
            self.history.settle(&self.sheet.inputs);
        }
        if !matches!(command, Command::Settle | Command::Theme(_)) {
            self.notice = None;
        }
        match command {
            Command::Settle | Command::Dismiss | Command::Follow(_) => {}
            Command::Calculate => self.calculate(ctx),
            Command::Reset => {
                if self.sheet.inputs.is_blank() {
                    self.sheet.inputs = Inputs::default();
                    self.say("There was nothing to clear.", None);
                } else {
                    self.sheet.inputs = Inputs::default();
                    self.say("All fields are cleared.", Some(("Undo", Command::Undo)));
                }
                self.calculator.marked = false;
            }
            Command::Open(inputs, said) => {
                let replaced = !self.sheet.inputs.is_blank();
                self.sheet.inputs = *inputs;
                self.settings.screen = Screen::Calculator;
                self.calculator.reveal_results = Layout::of_width(ctx.content_rect().width()) == Layout::Phone;
                self.calculator.helper = None;
                self.say(said, replaced.then_some(("Undo", Command::Undo)));
            }
            Command::Undo => match self.history.undo() {
                Some(inputs) => {
                    self.sheet.inputs = inputs;
                    self.say("Undone.", Some(("Redo", Command::Redo)));
                }
                None => self.say("There is nothing to undo.", None),
            },
            Command::Redo => match self.history.redo() {
                Some(inputs) => {
                    self.sheet.inputs = inputs;
                    self.say("Done again.", Some(("Undo", Command::Undo)));
                }
                None => self.say("There is nothing to do again.", None),
            },
            Command::CopyResults => {
                let text = report::report(&self.sheet.inputs, self.sheet.assessment(), self.settings.result_unit);
                self.platform.copy(ctx, text);
            }
            Command::Fix(field, entry) => {
                *self.sheet.inputs.entry_mut(field) = entry;
                self.sheet.inputs.tidy(field);
                self.calculator.helper = None;
                ctx.memory_mut(|memory| memory.request_focus(quantity_field::id(field)));
            }
            Command::DragDisparity(disparity) => self.sheet.inputs.entry_mut(Field::Disparity).text = number::plain(disparity),
            Command::ShowDialog(dialog) => self.dialog = dialog,
            Command::Help(helper) => self.calculator.helper = helper,
            Command::PrincipalPoint(cx, cy) => calculator::geometry::set_principal_point(&mut self.settings.texts, cx, cy),
            Command::ShowGeometry(shown) => self.settings.shows_geometry = shown,
            Command::Show(screen) => self.settings.screen = screen,
            Command::ShowResultsIn(unit) => self.settings.result_unit = unit,
            Command::Theme(theme) => {
                self.settings.theme = theme;
                ctx.set_theme(theme);
            }
        }
        self.sheet.refresh();
        ctx.request_repaint();
    }

    fn calculate(&mut self, ctx: &egui::Context) {
        self.calculator.marked = true;
        let errors = self
            .sheet
            .assessment()
            .notes
            .iter()
            .filter(|note| note.severity == Severity::Error)
            .map(|note| note.field);
        let missing = self.sheet.inputs.missing();
        let first = errors.chain(missing.iter().map(|note| note.field)).min();
        match first {
            Some(field) => ctx.memory_mut(|memory| memory.request_focus(quantity_field::id(field))),
            None => self.calculator.reveal_results = Layout::of_width(ctx.content_rect().width()) == Layout::Phone,
        }
    }

    fn say(&mut self, text: &str, action: Option<(&'static str, Command)>) {
        self.notice = Some(Notice {
            text: text.to_owned(),
            action,
        });
    }

    fn is_stored(&self) -> bool {
        self.stored.inputs == self.sheet.inputs && self.stored.settings == self.settings
    }

    /// Moves away what could not be read, for `reason`, and says where it is.
    fn make_room(&mut self, reason: &str) -> Result<(), String> {
        if self.is_in_the_way {
            let kept = self.platform.set_aside()?;
            self.is_in_the_way = false;
            if let Some(place) = kept {
                self.say(&format!("{reason} The old text is kept {place}."), None);
            }
        }
        Ok(())
    }

    /// Writes what changed. A failure is said once.
    fn store(&mut self) {
        if self.is_stored() {
            return;
        }
        self.stored = Saved {
            inputs: self.sheet.inputs.clone(),
            settings: self.settings.clone(),
        };
        let outcome = self
            .make_room("There is room again for what you enter.")
            .and_then(|()| self.stored.to_text())
            .and_then(|text| self.platform.save(&text));
        if let Err(reason) = outcome {
            self.say(
                &format!("{reason} What you enter now may be gone after a restart: copy your results to keep them."),
                None,
            );
        }
    }
}

impl eframe::App for App {
    #[cfg(target_arch = "wasm32")]
    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }

    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        if let Some(fragment) = self.platform.link() {
            self.carry_out(ctx, Command::Follow(fragment));
        }
        for command in std::mem::take(&mut self.pending) {
            self.carry_out(ctx, command);
        }
        match self.platform.copied() {
            Some(Ok(())) => self.say("Results copied to the clipboard.", None),
            Some(Err(reason)) => self.say(&reason, None),
            None => {}
        }
        let forced = self.platform.forced_colors();
        if forced != self.forced_colors {
            self.forced_colors = forced;
            theme::force(ctx, forced);
        }
        if self.platform.stored_elsewhere() {
            self.say(
                "Another tab changed what is stored. Both go on; what is changed last is what a reload brings back. To keep these numbers, change something here, or copy them.",
                None,
            );
        }
        if self.calculator.simulate(self.sheet.assessment()) {
            ctx.request_repaint();
        }
        self.store();
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let layout = Layout::of_width(ui.available_width());
        let palette = theme::palette(ui);
        let mut commands = Vec::from_iter(shortcuts::pressed(ui.ctx()));
        ui.spacing_mut().interact_size.y = layout.control_height();

        let bar = |vertical| {
            Frame::new()
                .fill(palette.surface)
                .inner_margin(Margin::symmetric(if layout == Layout::Phone { 12 } else { 20 }, vertical))
        };
        Panel::top("navigation").resizable(false).frame(bar(8)).show(ui, |ui| {
            navigation(ui, layout, self.settings.screen, self.settings.theme, &mut commands);
        });
        let margin = if layout == Layout::Phone { 8 } else { 20 };
        let background = Frame::new().fill(palette.page).inner_margin(Margin {
            left: margin,
            right: margin,
            top: 16,
            bottom: 0,
        });
        let foot = Foot::of(ui, "screen");
        foot.above(ui, |ui| {
            CentralPanel::no_frame().frame(background).show(ui, |ui| {
                ui.vertical_centered(|ui| {
                    ui.set_max_width(ui.available_width().min(theme::CONTENT_WIDTH));
                    ui.with_layout(egui::Layout::top_down(Align::Min), |ui| match self.settings.screen {
                        Screen::Learn => learn::show(ui, layout, &mut commands),
                        Screen::Calculator => {
                            self.calculator.show(ui, layout, &mut self.sheet, &mut self.settings, &mut commands);
                        }
                    });
                });
            });
        });
        foot.below(ui, |ui| {
            let separator = ui.visuals().widgets.noninteractive.bg_stroke;
            let bar = |ui: &mut Ui, vertical, add_contents: &mut dyn FnMut(&mut Ui)| {
                let drawn = bar(vertical).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    add_contents(ui);
                });
                let rect = drawn.response.rect;
                ui.painter().hline(rect.x_range(), rect.top(), separator);
            };
            if let Some(notice) = &self.notice {
                bar(ui, 6, &mut |ui| notice_bar(ui, notice, layout, &mut commands));
            }
            if layout == Layout::Phone && self.settings.screen == Screen::Calculator {
                bar(ui, 10, &mut |ui| {
                    calculator::result_bar(ui, self.sheet.assessment(), self.settings.result_unit);
                });
            }
        });
        match self.dialog {
            Some(Dialog::Keys) => shortcuts::list(ui, layout, &mut commands),
            Some(Dialog::About) => about::show(ui, layout, &*self.platform, &mut commands),
            None => {}
        }
        focus_ring(ui);
        // At once: some browsers allow it only while they handle the click, and that of a pointer is when eframe runs this pass.
        if commands.iter().any(|command| matches!(command, Command::CopyResults)) {
            commands.retain(|command| !matches!(command, Command::CopyResults));
            self.copy_results(ui.ctx());
        }
        if !commands.is_empty() {
            self.pending.append(&mut commands);
            ui.ctx().request_repaint();
        }
        // What was typed in this pass is stored in the next.
        if !self.is_stored() {
            ui.ctx().request_repaint();
        }
    }
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

fn navigation(ui: &mut Ui, layout: Layout, screen: Screen, theme_preference: ThemePreference, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let tabs = |ui: &mut Ui, commands: &mut Vec<Command>| {
        ui.scope_builder(
            UiBuilder::new().accessibility_role(Role::TabList).accessibility_label("Screens"),
            |ui| {
                ui.horizontal(|ui| {
                    for choice in Screen::ALL {
                        let selected = choice == screen;
                        let text = if selected {
                            RichText::new(choice.name())
                                .font(theme::strong(theme::BODY_SIZE))
                                .color(palette.text)
                        } else {
                            RichText::new(choice.name()).color(palette.muted)
                        };
                        let fill = if selected { palette.highlight } else { palette.surface };
                        let tab = ui.add(
                            Button::new(text)
                                .fill(fill)
                                .stroke(Stroke::NONE)
                                .min_size(vec2(0.0, layout.control_height())),
                        );
                        ui.accesskit_node_builder(tab.id, |node| {
                            node.set_role(Role::Tab);
                            node.set_selected(selected);
                        });
                        if tab.clicked() {
                            commands.push(Command::Show(choice));
                        }
                    }
                });
            },
        );
    };
    ui.horizontal(|ui| {
        text::heading(ui, "Depth Calculator", 1, theme::strong(17.0), palette.text);
        if layout != Layout::Phone {
            ui.add_space(8.0);
            tabs(ui, commands);
        }
        // Not from the right, which would have them read in the other order than they stand in.
        let side = layout.control_height();
        ui.spacing_mut().button_padding.x = theme::STEP;
        ui.add_space((ui.available_width() - 2.0 * side - ui.spacing().item_spacing.x).max(0.0));
        let keys = Button::new("?").min_size(vec2(side, side));
        if ui.add(keys).accessible_name("Keys").clicked() {
            commands.push(Command::ShowDialog(Some(Dialog::Keys)));
        }
        theme_choice(ui, layout, theme_preference, commands);
    });
    if layout == Layout::Phone {
        tabs(ui, commands);
    }
}

fn theme_choice(ui: &mut Ui, layout: Layout, preference: ThemePreference, commands: &mut Vec<Command>) {
    let height = layout.control_height();
    let button = Button::new(RichText::new("◐").size(17.0)).min_size(vec2(height, height));
    let response = egui::containers::menu::MenuButton::from_button(button)
        .ui(ui, |ui| {
            ui.spacing_mut().interact_size.y = height;
            for (choice, name) in [
                (ThemePreference::System, "As the system"),
                (ThemePreference::Light, "Light"),
                (ThemePreference::Dark, "Dark"),
            ] {
                if ui.selectable_label(preference == choice, name).clicked() {
                    commands.push(Command::Theme(choice));
                    ui.close();
                }
            }
        })
        .0;
    let _ = response.accessible_name("Light or dark");
}

fn notice_bar(ui: &mut Ui, notice: &Notice, layout: Layout, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        let said = ui.label(&notice.text);
        text::announce(ui, &said);
        let button = |name: &str| Button::new(name).min_size(vec2(0.0, layout.control_height()));
        if let Some((name, action)) = &notice.action
            && ui.add(button(name)).clicked()
        {
            commands.push(action.clone());
        }
        if ui.add(button("Close").frame(false)).clicked() {
            commands.push(Command::Dismiss);
        }
    });
}

/// Finished states of the inputs, for undo and redo.
#[derive(Debug)]
struct History {
    now: Inputs,
    past: Vec<Inputs>,
    future: Vec<Inputs>,
}

impl History {
    /// Nobody goes back further.
    const DEPTH: usize = 200;

    const fn new(now: Inputs) -> Self {
        Self {
            now,
            past: Vec::new(),
            future: Vec::new(),
        }
    }

    /// `inputs` are a finished state: what changed since the last one is one step.
    fn settle(&mut self, inputs: &Inputs) {
        if *inputs != self.now {
            self.past.push(std::mem::replace(&mut self.now, inputs.clone()));
            self.future.clear();
            if self.past.len() > Self::DEPTH {
                self.past.remove(0);
            }
        }
    }

    fn undo(&mut self) -> Option<Inputs> {
        let before = self.past.pop()?;
        self.future.push(std::mem::replace(&mut self.now, before));
        Some(self.now.clone())
    }

    fn redo(&mut self) -> Option<Inputs> {
        let after = self.future.pop()?;
        self.past.push(std::mem::replace(&mut self.now, after));
        Some(self.now.clone())
    }
}
