//! What stands there before anything is known: what the letters mean, and the example in the empty fields.

use super::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint, NoticeText};
use crate::app::theme;
use crate::app::widgets::cards::{self, Frame};
use crate::app::widgets::{field, figure, picture, text};
use depth_figures::letters;
use depth_text::field::Key;
use depth_text::report::strip::Mode;
use egui::{Button, Sense, Ui, UiBuilder, vec2};

/// Whether there is nothing yet to draw pictures of, nor was there.
pub fn is_shown(cx: &AppContext<'_>) -> bool {
    cx.mode() == Mode::Distance && !cx.session.has_answer() && !cx.session.had_answer()
}

/// The picture of what the letters mean, that of the field in use marked; in a card at least `height` high.
pub fn letters_ui(ui: &mut Ui, height: f32, has_doffs: bool) {
    let is_narrow = ui.available_width() < theme::DESCRIBED_TABLE_WIDTH;
    let frame = Frame {
        title: Card::Letters.title(),
        caption: if is_narrow { letters::SHORT_CAPTION } else { letters::CAPTION },
        height: None,
    };
    frame.ui(ui, Card::Letters, |ui| {
        let focused = ui.memory(|memory| memory.focused());
        let used = Key::form().find(|&key| focused == Some(field::id(key))).map(|key| key.symbol);
        let room = vec2(ui.available_width(), cards::figure_height(height));
        let fonts = figure::Fonts(ui.painter());
        let small = letters::figure(room.x, used, has_doffs, &fonts);
        // Larger on a large screen, and no wider for that.
        let times = (room.y / small.height).min(theme::LETTERS_LARGEST);
        let times = if times < theme::LETTERS_LARGER { 1.0 } else { times };
        let drawn = letters::figure(room.x / times, used, has_doffs, &fonts).scaled(times);
        let size = vec2(room.x, drawn.height.max(room.y));
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        figure::paint(ui, &drawn, rect.min);
        picture::describe(ui, &response, Card::Letters.title(), &Description::Letters);
    });
}

/// The example in words, and the button that takes its numbers: below them, or beside them in a card of this height.
pub fn example_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: Option<f32>) {
    let frame = Frame {
        title: Card::Example.title(),
        caption: "type to replace",
        height,
    };
    let words = Hint::ExampleInGray.to_string();
    frame.ui(ui, Card::Example, |ui| {
        if height.is_none() {
            text::paragraph_ui(ui, &words);
            ui.add_space(2.0 * theme::STEP);
            example_button_ui(ui, cx);
            return;
        }
        let place = ui.available_rect_before_wrap();
        let (left, right) = place.split_left_right_at_x(place.right() - theme::EXAMPLE_BUTTON_WIDTH - theme::NUMBER_GAP);
        let mut beside = ui.new_child(UiBuilder::new().id_salt("words").max_rect(left));
        text::paragraph_ui(&mut beside, &words);
        let button = right.with_min_x(right.left() + theme::NUMBER_GAP);
        let mut end = ui.new_child(UiBuilder::new().id_salt("button").max_rect(button));
        example_button_ui(&mut end, cx);
    });
}

fn example_button_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let size = vec2(theme::EXAMPLE_BUTTON_WIDTH, cx.layout.control_height());
    if ui.add_sized(size, Button::new("Use these numbers")).clicked() {
        let inputs = cx.session.inputs.with_examples();
        cx.commands.push(Command::Open(Box::new(inputs), NoticeText::FilledByExample));
    }
}
