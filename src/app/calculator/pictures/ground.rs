//! The cards of the ground plane: from the side with the image, and from above. The point can be moved in all three.

use super::handle::{self, Slider};
use crate::app::calculator::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint};
use crate::app::theme;
use crate::app::widgets::{cards, chart, figure, picture};
use crate::core::quantity::Length;
use depth_figures::ground::{Above, ImageView, Model, SideView};
use depth_figures::{Ink, Point, Words};
use depth_text::field::Key;
use depth_text::{fields, number, report};
use egui::{Id, Rect, Response, Sense, Ui, UiBuilder, pos2, vec2};

/// Draws the card from the side, with the point in the image beside it, or below it where there is no room.
pub fn side_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let Some(model) = Model::new(cx.session.answered(), cx.unit()) else {
        picture::empty_card_ui(ui, Card::SideView, Card::SideView.title(), height, &Hint::NoSideView);
        return;
    };
    let size = cards::inner_size(ui, height);
    let has_room = size.x >= theme::SIDE_BY_SIDE_WIDTH;
    let image_width = if has_room {
        theme::IMAGE_VIEW_WIDTH
    } else {
        size.x.min(theme::IMAGE_VIEW_MAX)
    };
    let fonts = figure::Fonts(ui.painter());
    let image = ImageView::new(&model, image_width, &fonts);
    let beside = if has_room && image.is_some() {
        image_width + 2.0 * theme::GAP
    } else {
        0.0
    };
    let side = SideView::new(&model, [size.x - beside, size.y], &fonts);
    let caption = if has_room { &side.caption } else { &side.short_caption };
    let below = image
        .as_ref()
        .filter(|_| !has_room)
        .map_or(0.0, |image| image.figure.height + theme::GAP + theme::IMAGE_HEADING);
    let frame = cards::Frame {
        title: Card::SideView.title(),
        caption,
        height: Some(height + below),
    };
    frame.ui(ui, Card::SideView, |ui| {
        let (rect, response) = ui.allocate_exact_size(size + vec2(0.0, below), Sense::CLICK);
        figure::paint(ui, &side.figure, rect.min);
        describe(ui, cx, Card::SideView, &response);
        chart::menu_ui(&response, Card::SideView.title(), cx.commands);
        side_handle_ui(ui, cx, (&model, &side), rect);
        if let Some(image) = &image {
            image_words_ui(
                ui,
                image,
                if has_room {
                    rect.right_top() - vec2(image_width, 0.0)
                } else {
                    pos2(rect.left(), rect.bottom() - below + theme::GAP)
                },
            );
            let at = if has_room {
                pos2(rect.right() - image_width, rect.top() + theme::IMAGE_HEADING)
            } else {
                pos2(rect.left(), rect.bottom() - image.figure.height)
            };
            image_ui(ui, cx, image, at);
        }
    });
}

/// The point on the floor, seen from the side: moved, it has another row.
fn side_handle_ui(ui: &Ui, cx: &mut AppContext<'_>, (model, side): (&Model, &SideView), rect: Rect) {
    let Some(ground) = cx.session.assessment().geometry.ground.as_ref() else {
        return;
    };
    let ring = side.ring;
    if cx.session.assessment().reading(fields::FLOOR_ROW).is_none() {
        return;
    }
    let ahead = ground.ahead.value;
    let words = report::length(Some(ahead), cx.unit());
    let slider = Slider {
        name: "Point on the floor, straight ahead",
        value: ahead.m(),
        range: [0.0, 10.0 * ahead.m().abs()],
        words: &words,
    };
    let handle = handle::ui(ui, Id::unique("point in the side view"), on(rect, ring), &slider);
    let dragged = handle.dragged_to.map(|pointer| side.ahead_at(in_figure(rect, pointer)));
    let set = handle.set_to.map(Length::from_m);
    let stepped = (handle.steps != 0).then(|| Length::from_m(ahead.m() * (1.0 + f64::from(handle.steps) / 100.0)));
    if let Some(row) = stepped.or(set).or(dragged).and_then(|ahead| model.row_at(ahead)) {
        drag(cx, &[(fields::FLOOR_ROW, row)]);
    }
    finish(ui, cx, &handle, on(rect, ring));
}

/// The heading of the image, with its size, and below it what is to be said.
fn image_words_ui(ui: &mut Ui, image: &ImageView, at: egui::Pos2) {
    let width = image.figure.width;
    let line = Rect::from_min_size(at, vec2(width, theme::IMAGE_HEADING - theme::STEP));
    figure::line_ui(ui, line, &Words::strong(Card::Image.title(), Ink::Text));
    let palette = theme::palette(ui);
    let font = || theme::regular(theme::SMALL_SIZE);
    ui.painter().text(
        line.right_center(),
        egui::Align2::RIGHT_CENTER,
        &image.caption,
        font(),
        palette.muted,
    );
    let below = pos2(at.x, at.y + theme::IMAGE_HEADING + image.figure.height + 2.0 * theme::STEP);
    if below.y + theme::FIGURE_NOTE < ui.max_rect().bottom() {
        let words = format!("{} {}", image.note, Hint::RingsCanBeDragged);
        let galley = ui.painter().layout(words, font(), palette.muted, width);
        ui.painter().galley(below, galley, palette.muted);
    }
}

/// The point in the image: moved, it has another row and column.
fn image_ui(ui: &mut Ui, cx: &mut AppContext<'_>, image: &ImageView, at: egui::Pos2) {
    let place = Rect::from_min_size(at, vec2(image.figure.width, image.figure.height));
    let mut inside = ui.new_child(UiBuilder::new().id_salt("image").max_rect(place));
    let ui = &mut inside;
    let (rect, response) = ui.allocate_exact_size(place.size(), Sense::CLICK);
    figure::paint(ui, &image.figure, rect.min);
    picture::describe(ui, &response, Card::Image.title(), &Description::InImage);
    let assessment = cx.session.assessment();
    let [Some(u), Some(v)] = [fields::FLOOR_COLUMN, fields::FLOOR_ROW].map(|key| assessment.reading(key).map(|reading| reading.value))
    else {
        return;
    };
    let words = format!("{} px to the right, {} px down", number::plain(u), number::plain(v));
    let slider = Slider {
        name: "Point in the image, row",
        value: v,
        range: [0.0, 2.0 * v],
        words: &words,
    };
    let ring = on(rect, image.ring);
    let handle = handle::ui(ui, Id::unique("point in the image"), ring, &slider);
    let dragged = handle.dragged_to.map(|pointer| image.pixel_at(in_figure(rect, pointer)));
    let stepped = (handle.steps != 0).then(|| [u, v + f64::from(handle.steps)]);
    if let Some([u, v]) = stepped.or(handle.set_to.map(|v| [u, v])).or(dragged) {
        drag(cx, &[(fields::FLOOR_COLUMN, u), (fields::FLOOR_ROW, v)]);
    }
    finish(ui, cx, &handle, ring);
}

/// Draws the card from above.
pub fn above_ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let Some(model) = Model::new(cx.session.answered(), cx.unit()) else {
        picture::empty_card_ui(ui, Card::Floor, Card::Floor.title(), height, &Hint::NoSideView);
        return;
    };
    let size = cards::inner_size(ui, height) - vec2(0.0, theme::FIGURE_NOTE);
    let above = Above::new(&model, [size.x, size.y], &figure::Fonts(ui.painter()));
    let frame = cards::Frame {
        title: Card::Floor.title(),
        caption: &above.caption,
        height: Some(height),
    };
    frame.ui(ui, Card::Floor, |ui| {
        let (rect, response) = ui.allocate_exact_size(size, Sense::CLICK);
        figure::paint(ui, &above.figure, rect.min);
        describe(ui, cx, Card::Floor, &response);
        chart::menu_ui(&response, Card::Floor.title(), cx.commands);
        let (line, _) = ui.allocate_exact_size(vec2(size.x, theme::FIGURE_NOTE), Sense::hover());
        figure::line_ui(ui, line, &Words::new(above.note.as_str(), Ink::Muted));
    });
}

fn describe(ui: &Ui, cx: &AppContext<'_>, card: Card, response: &Response) {
    let Some(ground) = cx.session.answered().geometry.ground.as_ref() else {
        return;
    };
    let [ahead, right, along] = [Some(ground.ahead), ground.right, Some(ground.distance)]
        .map(|length| report::length(length.map(|length| length.value), cx.unit()));
    let description = if card == Card::Floor {
        Description::Floor {
            ahead: &ahead,
            right: &right,
        }
    } else {
        Description::SideView {
            ahead: &ahead,
            along: &along,
        }
    };
    picture::describe(ui, response, card.title(), &description);
}

/// Moves the point, to a tenth of a pixel.
fn drag(cx: &mut AppContext<'_>, moved: &[(Key, f64)]) {
    for &(key, value) in moved {
        let rounded = number::rounded_to(value, 0.1);
        if cx.session.assessment().reading(key).is_some_and(|reading| reading.value != rounded) {
            cx.commands.push(Command::Drag(key, rounded));
        }
    }
}

fn finish(ui: &Ui, cx: &mut AppContext<'_>, handle: &handle::Handle, at: egui::Pos2) {
    if handle.is_active() {
        handle::halo(ui, at);
    }
    if handle.is_settled() {
        cx.commands.push(Command::Settle);
    }
}

fn on(rect: Rect, point: Point) -> egui::Pos2 {
    rect.min + vec2(point.x, point.y)
}

fn in_figure(rect: Rect, at: egui::Pos2) -> Point {
    Point::new(at.x - rect.left(), at.y - rect.top())
}
