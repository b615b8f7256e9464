//! What is shown of a note that does not fit into its line: a card over what follows, with the corrections that can be clicked.

use crate::app::command::Command;
use crate::app::theme;
use depth_text::note::{Fix, Note};
use egui::{Area, Button, Color32, Galley, Id, Order, Rect, RichText, Sense, Shape, Stroke, Ui, Vec2, vec2};
use std::sync::Arc;
use std::time::Duration;

/// What the card had in the last frame, while it is open.
#[derive(Clone, Copy)]
pub struct Open {
    pub card: Rect,
    /// The focus is on a correction: on the card or in the line.
    pub fix_has_focus: bool,
}

/// What is shown over what follows the line.
pub struct Card<'a> {
    /// What is said on it.
    pub texts: Vec<&'a Note>,
    pub fixes: Vec<(&'a Note, &'a Fix)>,
    /// The color of its border.
    pub color: Color32,
    /// Whether it is about the σ.
    pub is_of_sigma: bool,
    /// The field that it is about, and the line below that.
    pub field: Rect,
    pub line: Rect,
    /// How the corrections take a click and the key Tab.
    pub sense: Sense,
}

/// The measures of a card.
struct Measures {
    texts: Vec<Arc<Galley>>,
    texts_height: f32,
    /// The card.
    card: Rect,
}

impl Card<'_> {
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty() && self.fixes.is_empty()
    }

    /// Draws the card.
    pub fn ui(&self, ui: &Ui, id: Id, commands: &mut Vec<Command>) -> Open {
        let measures = self.measures(ui);
        let content = measures.card - theme::NOTE_CARD_MARGIN;
        // As large as the corrections: all around them the pointer meets what is below the card.
        let area = Area::new(id)
            .order(Order::Foreground)
            .fixed_pos(content.min + vec2(0.0, measures.texts_height))
            .constrain(false)
            .interactable(self.sense.is_focusable() && !self.fixes.is_empty())
            .sense(Sense::hover())
            .fade_in(false)
            .accessibility_parent(ui.unique_id());
        let height = fix_height(ui);
        let fix_has_focus = area
            .show(ui.ctx(), |ui| {
                self.paint(ui, &measures);
                ui.spacing_mut().interact_size = Vec2::ZERO;
                ui.set_max_width(content.width() + theme::STEP);
                ui.horizontal_wrapped(|ui| self.fixes_ui(ui, height, commands)).inner
            })
            .inner;
        Open {
            card: measures.card,
            fix_has_focus,
        }
    }

    fn fixes_ui(&self, ui: &mut Ui, height: f32, commands: &mut Vec<Command>) -> bool {
        let mut has_focus = false;
        for (note, fix) in &self.fixes {
            let name = RichText::new(fix.label()).size(theme::SMALL_SIZE);
            let response = ui.add(Button::new(name).sense(self.sense).min_size(vec2(0.0, height)));
            has_focus |= response.has_focus();
            if response.clicked() {
                commands.push(command(note, fix));
            }
        }
        has_focus
    }

    /// Where everything is: below the line, or above the field where there is no room below.
    fn measures(&self, ui: &Ui) -> Measures {
        let line = self.line;
        let width = line.width() - theme::NOTE_CARD_MARGIN.sum().x;
        let color = theme::palette(ui).text;
        let font = || theme::regular(theme::SMALL_SIZE);
        let texts: Vec<Arc<Galley>> = self
            .texts
            .iter()
            .map(|note| ui.painter().layout(note.message(), font(), color, width))
            .collect();
        let gap = theme::NOTE_CARD_GAP;
        let texts_height: f32 = texts.iter().map(|text| text.size().y + gap).sum();
        let spacing = ui.spacing().item_spacing;
        let padding = 2.0 * ui.spacing().button_padding.x;
        let (mut rows, mut x, mut widest) = (0.0, f32::INFINITY, 0.0_f32);
        for (_, fix) in &self.fixes {
            let button = ui.painter().layout_no_wrap(fix.label(), font(), color).size().x.ceil() + padding;
            if x + button > width {
                rows += 1.0;
                x = 0.0;
            }
            widest = widest.max(x + button);
            x += button + spacing.x;
        }
        let fixes_height = if rows > 0.0 {
            rows * (fix_height(ui) + spacing.y) - spacing.y
        } else {
            -gap
        };
        let height = theme::NOTE_CARD_MARGIN.sum().y + texts_height + fixes_height;
        // Texts go from one side of the field to the other.
        let width = if texts.is_empty() { widest } else { width } + theme::NOTE_CARD_MARGIN.sum().x;
        let room = ui.clip_rect().intersect(ui.ctx().content_rect());
        let below = Rect::from_min_size(line.left_bottom(), vec2(width, height));
        let above = Rect::from_min_size(self.field.left_top() - vec2(0.0, height + theme::STEP), below.size());
        let card = if below.bottom() > room.bottom() && above.top() >= room.top() {
            above
        } else {
            below
        };
        Measures { texts, texts_height, card }
    }

    /// The corner of the card that points at the field.
    fn tail_ui(&self, ui: &Ui, card: Rect, border: Stroke) {
        let is_below = card.top() >= self.line.center().y;
        let (edge, up) = if is_below { (card.top(), -1.0) } else { (card.bottom(), 1.0) };
        // Below the number that is wrong, or its σ.
        let at = if self.is_of_sigma {
            card.right() - theme::NOTE_TAIL_INSET
        } else {
            self.field.left() + theme::NOTE_TAIL_AT * self.field.width()
        };
        let tip = egui::pos2(at, edge + up * theme::NOTE_TAIL);
        let feet = [-theme::NOTE_TAIL, theme::NOTE_TAIL].map(|x| egui::pos2(tip.x + x, edge - up * border.width));
        let surface = theme::palette(ui).surface;
        let [left, right] = feet;
        ui.painter()
            .add(Shape::convex_polygon(vec![left, tip, right], surface, Stroke::NONE));
        let raised = vec2(0.0, up * border.width / 2.0);
        ui.painter().line(vec![left + raised, tip, right + raised], border);
    }

    fn paint(&self, ui: &Ui, measures: &Measures) {
        let palette = theme::palette(ui);
        let shadow = ui.visuals().popup_shadow.as_shape(measures.card, theme::CONTROL_RADIUS);
        let border = Stroke::new(theme::STRONG_LINE, self.color);
        ui.painter().add(shadow);
        ui.painter().rect(
            measures.card,
            theme::CONTROL_RADIUS,
            palette.surface,
            border,
            egui::StrokeKind::Inside,
        );
        self.tail_ui(ui, measures.card, border);
        let mut at = (measures.card - theme::NOTE_CARD_MARGIN).min;
        for text in &measures.texts {
            ui.painter().galley(at, Arc::clone(text), palette.text);
            at.y += text.size().y + theme::NOTE_CARD_GAP;
        }
    }
}

/// When corrections came on the screen.
#[derive(Clone, Copy)]
struct Shown {
    /// Which they are.
    fixes: u64,
    /// The time of the frame that drew them first, s.
    drawn: f64,
    /// The time of the frame after that, s: since then they are on the screen.
    seen: Option<f64>,
}

/// How these corrections of the note `id`, which are drawn now, take a click and the key Tab: as what cannot have the focus, until somebody
/// can have seen them. Who clicks into a field while a correction appears over it means the field, and who types 110 and goes on with Tab does not mean
/// what was to be corrected about the 1, however long the frames are.
pub fn sense_of(ui: &Ui, id: Id, fixes: &[(&Note, &Fix)]) -> Sense {
    let key = id.with("corrections");
    if fixes.is_empty() {
        ui.data_mut(|data| data.remove::<Shown>(key));
        return Sense::CLICK;
    }
    let now = ui.input(|input| input.time);
    let fixes = egui::util::hash(fixes.iter().map(|(_, fix)| fix.label()).collect::<Vec<_>>());
    let before: Option<Shown> = ui.data(|data| data.get_temp(key));
    let same = before.filter(|shown| shown.fixes == fixes);
    let drawn = same.map_or(now, |shown| shown.drawn);
    let seen = same.and_then(|shown| shown.seen.or((now > drawn).then_some(now)));
    ui.data_mut(|data| data.insert_temp(key, Shown { fixes, drawn, seen }));
    let remaining = seen.map_or(theme::NOTE_CARD_DELAY, |since| since + theme::NOTE_CARD_DELAY - now);
    if remaining <= 0.0 {
        return Sense::click();
    }
    let wait = if seen.is_some() { remaining } else { 0.0 };
    ui.ctx().request_repaint_after(Duration::from_secs_f64(wait));
    Sense::CLICK
}

/// What a click on the correction `fix` of `note` asks for.
pub fn command(note: &Note, fix: &Fix) -> Command {
    match fix.way {
        Some(way) => Command::AskForWidth(way, fix.entry.clone()),
        None => Command::Fix(note.key, fix.entry.clone()),
    }
}

/// The height of a correction on the card.
fn fix_height(ui: &Ui) -> f32 {
    if ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH {
        theme::CONTROL_HEIGHT_TOUCH
    } else {
        theme::NOTE_FIX_HEIGHT
    }
}
