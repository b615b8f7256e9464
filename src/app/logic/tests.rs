use super::*;
use crate::app::platform::{Licenses, Platform};
use crate::app::theme::{Colors, SystemColors};
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use depth_jobs::{Attachment, Job, Run};
use egui::{Color32, Theme};

/// A machine on which these things have happened.
struct Machine(Vec<Event>);

impl Platform for Machine {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        Ok(None)
    }
    fn save(&mut self, _text: &str) -> Result<(), PlatformError> {
        Ok(())
    }
    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        Ok(None)
    }
    fn copy(&mut self, _ctx: &egui::Context, _text: String) {}
    fn save_file(&mut self, _ctx: &egui::Context, _name: &str, _contents: FileContents) {}
    fn open_files(&mut self, _ctx: &egui::Context) {}
    fn start(&mut self, _ctx: &egui::Context, _run: Run, _job: Job, _attachments: Vec<Attachment>) {}
    fn cancel(&mut self, _ctx: &egui::Context, _run: Run) {}
    fn print(&mut self) -> bool {
        false
    }
    fn today(&self) -> String {
        "November 25, 2026".to_owned()
    }
    fn address(&self) -> String {
        "https://example.org/".to_owned()
    }
    fn events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.0)
    }
    fn seconds(&self) -> f64 {
        0.0
    }
    fn commit(&self) -> Option<String> {
        None
    }
    fn licenses(&self) -> Licenses {
        Licenses::Page("")
    }
}

/// The application after `events`.
fn after(events: Vec<Event>) -> (egui::Context, App) {
    let ctx = egui::Context::default();
    let cc = eframe::CreationContext::_new_kittest(ctx.clone());
    let mut app = App::new(&cc, Box::new(Machine(events)));
    app.update(&ctx);
    (ctx, app)
}

fn said(app: &App) -> Option<&NoticeText> {
    app.notice.as_ref().map(|notice| &notice.text)
}

#[test]
fn what_happens_last_is_said_last() {
    let (_, app) = after(vec![Event::Copied(Ok(())), Event::Copied(Err(PlatformError::NoClipboard))]);
    assert_eq!(said(&app), Some(&NoticeText::NotCopied(PlatformError::NoClipboard)));
}

#[test]
fn what_comes_from_the_clipboard_is_pasted_and_a_refusal_is_said() {
    let (ctx, app) = after(vec![Event::Pasted(Ok("700".to_owned()))]);
    assert!(ctx.input(|input| input.events.contains(&egui::Event::Paste("700".to_owned()))));
    assert_eq!(said(&app), None);
    let refusal = PlatformError::PasteDenied { reason: "No.".to_owned() };
    let (_, app) = after(vec![Event::Pasted(Err(refusal.clone()))]);
    assert_eq!(said(&app), Some(&NoticeText::NotPasted(refusal)));
}

#[test]
fn what_was_typed_and_pressed_in_the_last_frame_is_saved_when_the_window_closes() {
    let (ctx, mut app) = after(Vec::new());
    app.session.inputs.entry_mut(Field::Disparity).text = "50".to_owned();
    app.pending.push(Command::ShowResultsIn(LengthUnit::Foot));
    app.finish(&ctx);
    assert_eq!(app.stored.inputs.entry(Field::Disparity).text, "50");
    assert_eq!(app.stored.settings.result_unit, LengthUnit::Foot);
}

#[test]
fn a_link_that_names_nothing_changes_nothing_and_leaves_the_notice() {
    let (_, app) = after(vec![Event::Copied(Ok(())), Event::Link("#section".to_owned())]);
    assert_eq!(said(&app), Some(&NoticeText::Copied(Copyable::Results)));
    assert!(app.session.inputs.is_blank());
}

#[test]
fn chosen_colors_take_the_place_of_both_themes_until_none_are_chosen() {
    let colors = SystemColors {
        canvas: Color32::BLACK,
        canvas_text: Color32::WHITE,
        link_text: Color32::YELLOW,
        highlight: Color32::BLUE,
        button_border: Color32::WHITE,
    };
    let background = |ctx: &egui::Context| [Theme::Light, Theme::Dark].map(|theme| ctx.style_of(theme).visuals.panel_fill);
    let (ctx, _) = after(vec![Event::Colors(Colors::Chosen(colors))]);
    assert_eq!(background(&ctx), [Color32::BLACK; 2]);
    let (ctx, _) = after(vec![Event::Colors(Colors::Chosen(colors)), Event::Colors(Colors::Usual)]);
    assert_eq!(background(&ctx), background(&after(Vec::new()).0));
}
