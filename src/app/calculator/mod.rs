//! The calculator: the form, the answer, and the pictures of it.

mod answer;
mod bar;
mod budget;
mod card;
mod footer;
mod form;
mod helpers;
mod parts;
mod pictures;
mod remarks;
mod simulated;
mod simulations;
mod start;
mod strip;
mod table;
mod unknown;
mod value;

pub use bar::ui as result_bar_ui;
pub use card::Card;
pub use unknown::FIRST as FIRST_UNKNOWN;

use super::command::Helper;
use super::context::AppContext;
use super::navigation;
use super::presets;
use super::saved::{Settings, Ways};
use super::session::Session;
use super::theme::{self, Layout};
use super::widgets::{field, note_line, scroll};
use crate::core::problem::{Field, Method};
use depth_text::field::{Key, Section};
use depth_text::note::Severity;
use depth_text::report::strip::Mode;
use egui::{Align, Pos2, Rect, Ui, UiBuilder, pos2, vec2};

/// State of the screen between frames, beside the inputs.
#[derive(Debug, Default)]
pub struct Calculator {
    /// *Calculate Distance* was pressed: missing inputs are marked until something is typed.
    pub marked: bool,
    /// How often it was pressed with nothing to mark.
    asked: u32,
    /// The quantity that was solved for last.
    pub asked_before: Option<(Method, Field)>,
    /// The helper that is open.
    pub helper: Option<Helper>,
    /// The result of the open helper.
    solved: helpers::Solved,
    /// Whether the results are to be scrolled into view.
    reveal: Reveal,
    /// Whether the refinements are, that were just opened.
    reveal_refinements: Reveal,
    pictures: pictures::Pictures,
    simulations: simulations::Simulations,
}

/// Whether something is to be scrolled into view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Reveal {
    #[default]
    No,
    /// In the next frame.
    Wanted,
    /// The frame has been drawn.
    Done,
}

impl Reveal {
    /// Scrolls to `rect` if that is wanted.
    fn scroll(&mut self, ui: &Ui, rect: Rect, align: Option<Align>) {
        if *self != Self::No {
            ui.scroll_to_rect(rect, align);
            *self = Self::Done;
        }
    }
}

impl Calculator {
    /// Draws the screen: the form beside the answer and its pictures, or on a phone above them.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let gap = cx.layout.gap();
        if cx.layout == Layout::Phone {
            navigation::column_ui(ui, cx, "calculator", |ui, cx| {
                ui.spacing_mut().item_spacing.y = gap;
                self.form_ui(ui, cx);
                self.results_ui(ui, cx);
                self.details_ui(ui, cx);
                simulated::ui(ui, cx, &self.simulations);
            });
        } else {
            self.columns_ui(ui, cx, gap);
        }
        match self.helper {
            Some(Helper::Size) => presets::sizes_ui(ui, cx),
            Some(helper) => helpers::ui(ui, cx, helper, &self.solved),
            None => {}
        }
    }

    /// The columns beside each other, each scrolling by itself. Their edges are the same on every screen of this width.
    fn columns_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, gap: f32) {
        let all = ui.available_rect_before_wrap();
        let form_right = all.left() + cx.layout.form_width();
        let rest = all.right() - form_right - gap;
        // At the start, too: the first answer moves nothing.
        let has_last = cx.layout == Layout::Wide && pictures::has_last_column(cx.mode());
        let last_left = if has_last {
            form_right + gap + ((rest - gap) * theme::MIDDLE_SHARE).floor() + gap
        } else {
            f32::INFINITY
        };
        let between = |left: f32, right: f32| Rect::from_min_max(pos2(left, all.top()), pos2(right, all.bottom()));
        column_ui(ui, between(all.left(), form_right), "form", gap, |ui| {
            self.form_ui(ui, cx);
            self.details_ui(ui, cx);
        });
        if has_last && start::is_shown(cx) {
            let strip_width = last_left - gap - form_right - gap;
            column_ui(ui, between(form_right + gap, all.right()), "results", gap, |ui| {
                self.start_ui(ui, cx, strip_width)
            });
            return;
        }
        let middle_right = (last_left - gap).min(all.right());
        column_ui(ui, between(form_right + gap, middle_right), "results", gap, |ui| {
            self.results_ui(ui, cx)
        });
        if has_last {
            column_ui(ui, between(last_left, all.right()), "details", gap, |ui| {
                self.pictures.last_column_ui(ui, cx)
            });
        }
    }

    /// The start on a wide screen: the strip where it stays, beside it the example, and the picture of the letters across both columns.
    fn start_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, strip_width: f32) {
        let place = ui.available_rect_before_wrap();
        let row = Rect::from_min_size(place.min, vec2(place.width(), theme::STRIP_HEIGHT));
        let strip = row.with_max_x(row.left() + strip_width);
        ui.scope_builder(UiBuilder::new().id_salt("strip").max_rect(strip), |ui| {
            strip::ui(ui, cx, self.asked)
        });
        let example = row.with_min_x(strip.right() + cx.layout.gap());
        let mut beside = ui.new_child(UiBuilder::new().id_salt("example").max_rect(example));
        start::example_ui(&mut beside, cx, Some(theme::STRIP_HEIGHT));
        self.pictures.ui(ui, cx);
    }

    /// Goes on with the simulations, which take longer than a frame.
    pub fn logic(&mut self, cx: &mut AppContext<'_>) {
        for reveal in [&mut self.reveal, &mut self.reveal_refinements] {
            if *reveal == Reveal::Done {
                *reveal = Reveal::No;
            }
        }
        if let Some(helper) = self.helper {
            self.solved = helpers::Solved::new(helper, cx.settings, cx.session.assessment());
        }
        let time = simulations::Time {
            // After a rest egui says how long a frame will be, not how long the rest was.
            frame_s: f64::from(cx.egui.input(|input| input.stable_dt)),
            clock: &|| cx.platform.seconds(),
        };
        if self.simulations.advance(cx.session.assessment(), &time) {
            cx.egui.request_repaint();
        }
    }

    /// Marks every problem, and goes to the first, or to the results where there is none. A hidden part with the first is shown.
    pub fn calculate(&mut self, ctx: &egui::Context, session: &Session, settings: &mut Settings) {
        self.marked = true;
        let assessment = session.assessment();
        let errors = assessment.notes.iter().filter(|note| note.severity == Severity::Error);
        let missing = assessment
            .missing
            .iter()
            .filter(|_| settings.mode(&session.inputs).is_of_distance());
        let first = errors.chain(missing).map(|note| note.key).min();
        match first {
            Some(key) => {
                // Who is there already would hear nothing.
                note_line::say_again(ctx, field::id(key));
                self.go_to(ctx, key, session, settings);
            }
            None => {
                self.asked = self.asked.wrapping_add(1);
                self.reveal_results(ctx);
            }
        }
    }

    /// Moves the focus to the field `key`, and shows the part of the form that it is in.
    pub fn go_to(&mut self, ctx: &egui::Context, key: Key, session: &Session, settings: &mut Settings) {
        if let Some(mode) = key.section.and_then(Mode::of_section)
            && settings.mode(&session.inputs) != mode
            && session.inputs.unknown.is_none()
        {
            settings.chosen_mode = mode;
        }
        if matches!(key.section, Some(Section::Point | Section::Target)) && settings.mode(&session.inputs).is_of_distance() {
            settings.shows_refinements = true;
        }
        ctx.memory_mut(|memory| memory.request_focus(field::id(key)));
    }

    /// Shows or hides the refinements, and scrolls to them.
    pub fn show_refinements(&mut self, settings: &mut Settings, shown: bool) {
        settings.shows_refinements = shown;
        self.reveal_refinements = if shown { Reveal::Wanted } else { Reveal::No };
    }

    /// Opens the helper for the focal length at the way with this key.
    pub fn open_way(&mut self, ways: &mut Ways, way: &str) {
        helpers::choose(ways, Helper::FocalLength, way);
        self.helper = Some(Helper::FocalLength);
    }

    /// Scrolls to the results on a phone, where the form may hide them.
    pub fn reveal_results(&mut self, ctx: &egui::Context) {
        let is_phone = Layout::of(ctx.content_rect().size()) == Layout::Phone;
        self.reveal = if is_phone { Reveal::Wanted } else { Reveal::No };
    }

    /// Draws the form, and brings the results up to date with it.
    fn form_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        if let Some(refinements) = form::ui(ui, cx, self.marked) {
            self.reveal_refinements.scroll(ui, refinements, None);
        }
        if cx.session.refresh() {
            // Somebody is typing, and knows that the rest is missing.
            self.marked = false;
        }
    }

    /// The answer and its pictures.
    fn results_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let top: Pos2 = ui.cursor().min;
        strip::ui(ui, cx, self.asked);
        self.pictures.ui(ui, cx);
        // On a phone they come last: they come and go.
        if cx.layout != Layout::Phone {
            simulated::ui(ui, cx, &self.simulations);
        }
        let rect = Rect::from_min_max(top, ui.min_rect().max);
        self.reveal.scroll(ui, rect, Some(Align::Min));
    }

    /// What stands below the form: the example, or where the uncertainty comes from, and what is left to say.
    fn details_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        if start::is_shown(cx) {
            // A wide screen has it beside the strip.
            if cx.layout != Layout::Wide {
                start::example_ui(ui, cx, None);
            }
            return;
        }
        budget::ui(ui, cx);
        remarks::ui(ui, cx);
        remarks::how_ui(ui, cx);
    }
}

fn column_ui(ui: &mut Ui, rect: Rect, id: &str, gap: f32, add_contents: impl FnOnce(&mut Ui)) {
    let top_down = egui::Layout::top_down(Align::Min);
    ui.scope_builder(UiBuilder::new().max_rect(rect).layout(top_down), |ui| {
        scroll::column_ui(ui, id, |ui| {
            ui.spacing_mut().item_spacing.y = gap;
            add_contents(ui);
        });
    });
}
