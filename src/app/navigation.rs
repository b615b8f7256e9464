//! The bar at the top: the name of the program, a tab for each screen, the list of keys, light or dark. A new screen is one entry of
//! [`Screen::ALL`]: there is room for six.

use super::command::Command;
use super::context::AppContext;
use super::dialog::Dialog;
use super::saved::{PROGRAM, Screen};
use super::theme;
use super::widgets::{choice, menu, scroll, text};
use egui::accesskit::Role;
use egui::{Align2, Button, Popup, Rect, RichText, Sense, Stroke, ThemePreference, Ui, UiBuilder, pos2, vec2};

/// How the screens are offered in the room that there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Offer {
    /// A tab each.
    All,
    /// A tab for each other screen: the one that is shown needs none.
    Others,
    /// A button that names the screen and opens a menu of all.
    Menu,
}

impl Offer {
    /// The offer for tabs of these `widths`, of which that at `shown` is of the screen that is shown.
    fn that_fits(widths: &[f32], shown: usize, room: f32) -> Self {
        let all: f32 = widths.iter().sum();
        let others = all - widths.get(shown).copied().unwrap_or_default();
        match room {
            room if all <= room => Self::All,
            room if others <= room && widths.len() <= 2 => Self::Others,
            _ => Self::Menu,
        }
    }
}

/// Draws the contents of the bar.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    ui.horizontal(|ui| {
        program_ui(ui, cx.settings.screen);
        let side = cx.layout.icon_size();
        let gap = ui.spacing().item_spacing.x;
        ui.add_space(2.0 * theme::STEP - gap / 2.0);
        let room = ui.available_width() - 2.0 * side - 2.0 * gap;
        let widths = Screen::ALL.map(|screen| tab_width(ui, screen));
        let shown = Screen::ALL.iter().position(|&one| one == cx.settings.screen).unwrap_or(0);
        let offer = Offer::that_fits(&widths, shown, room);
        // A right-to-left layout would reverse the order in which Tab and screen readers reach the buttons.
        let space = |ui: &mut Ui, taken: f32| ui.add_space((room - taken).max(0.0));
        match offer {
            Offer::All => {
                tabs_ui(ui, cx, &Screen::ALL);
                space(ui, widths.iter().sum());
            }
            Offer::Others => {
                let others = Screen::ALL.into_iter().filter(|screen| *screen != cx.settings.screen);
                let others: Vec<Screen> = others.collect();
                space(ui, others.iter().map(|&screen| tab_width(ui, screen)).sum());
                tabs_ui(ui, cx, &others);
            }
            Offer::Menu => {
                let width = tab_width(ui, cx.settings.screen) + theme::ARROW_WIDTH;
                let is_named = width <= room;
                space(ui, if is_named { width } else { side });
                menu_ui(ui, cx, is_named);
            }
        }
        buttons_ui(ui, cx, side);
    });
}

/// The column of a screen, which scrolls: with this bar at its top where the window is low.
pub fn column_ui<'a>(ui: &mut Ui, cx: &mut AppContext<'a>, id: &str, add_contents: impl FnOnce(&mut Ui, &mut AppContext<'a>)) {
    scroll::column_ui(ui, id, |ui| {
        if cx.is_low() {
            self::ui(ui, cx);
            ui.add_space(cx.layout.gap());
        }
        add_contents(ui, cx);
    });
}

/// The name of the program: the heading of the calculator, which is said when that is shown again. Other screens have their own.
fn program_ui(ui: &mut Ui, screen: Screen) {
    let (font, color) = (theme::strong(theme::TITLE_SIZE), theme::palette(ui).text);
    if screen == Screen::Calculator {
        let heading = text::heading_ui(ui, PROGRAM, 1, font, color);
        text::announce(ui, &heading);
    } else {
        ui.label(RichText::new(PROGRAM).font(font).color(color));
    }
}

fn buttons_ui(ui: &mut Ui, cx: &mut AppContext<'_>, side: f32) {
    ui.spacing_mut().button_padding.x = theme::STEP;
    let is_framed = !cx.layout.is_narrow();
    let keys = Button::new(RichText::new("?").font(theme::strong(theme::BODY_SIZE))).frame_when_inactive(is_framed);
    let show_keys = Command::ShowDialog(Some(Dialog::Keys));
    let response = ui.add(keys.min_size(vec2(side, side))).accessible_name(show_keys.text());
    if response.on_hover_text("Keys and About").clicked() {
        cx.commands.push(show_keys);
    }
    theme_choice_ui(ui, cx, side, is_framed);
}

/// The width of the tab of `screen`, whether it is chosen or not.
fn tab_width(ui: &Ui, screen: Screen) -> f32 {
    let font = theme::strong(theme::BODY_SIZE);
    let galley = ui
        .painter()
        .layout_no_wrap(screen.name().to_owned(), font, egui::Color32::PLACEHOLDER);
    (galley.size().x + 2.0 * theme::TAB_PADDING).ceil()
}

/// A tab for each of `screens`: one stop of the key Tab, among them by the arrow keys.
fn tabs_ui(ui: &mut Ui, cx: &mut AppContext<'_>, screens: &[Screen]) {
    let list = UiBuilder::new().accessibility_role(Role::TabList).accessibility_label("Screens");
    ui.scope_builder(list, |ui| {
        let height = cx.layout.icon_size();
        let width = screens.iter().map(|&screen| tab_width(ui, screen)).sum();
        let (row, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
        let mut left = row.left();
        let mut focused = None;
        let coming = egui::Id::unique("the focus comes to a tab");
        let comes = ui.data_mut(|data| data.remove_temp::<bool>(coming)).is_some();
        let has_shown = screens.contains(&cx.settings.screen);
        for (index, &screen) in screens.iter().enumerate() {
            let width = tab_width(ui, screen);
            let rect = Rect::from_min_size(pos2(left, row.top()), vec2(width, height));
            left += width;
            let is_shown = screen == cx.settings.screen;
            let is_stop = is_shown || !has_shown && index == 0;
            let sense = if is_stop { Sense::click() } else { Sense::CLICK };
            let response = ui.interact(rect, egui::Id::unique(("tab", screen.name())), sense);
            tab_ui(ui, rect, screen.name(), (is_shown, response.hovered()));
            response.widget_info(|| egui::WidgetInfo::labeled(Role::Tab, true, screen.name()));
            ui.accesskit_node_builder(response.id, |node| node.set_selected(is_shown));
            if is_stop && comes {
                response.request_focus();
            }
            if response.has_focus() {
                focused = Some((index, response.id));
            }
            if response.clicked() {
                cx.commands.push(Command::Show(screen));
            }
            response.on_hover_cursor(egui::CursorIcon::PointingHand);
        }
        if let Some((index, id)) = focused
            && let steps = choice::steps(ui, id)
            && steps != 0
            && let Some(next) = (index + screens.len()).checked_add_signed(steps)
            && let Some(&screen) = screens.get(next % screens.len())
        {
            cx.commands.push(Command::Show(screen));
            ui.data_mut(|data| data.insert_temp(coming, true));
        }
    });
}

fn tab_ui(ui: &Ui, rect: Rect, name: &str, (is_shown, is_hovered): (bool, bool)) {
    let palette = theme::palette(ui);
    if is_shown || is_hovered {
        ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    }
    let (font, color) = if is_shown {
        (theme::strong(theme::BODY_SIZE), palette.text)
    } else {
        (theme::regular(theme::BODY_SIZE), palette.muted)
    };
    ui.painter().text(rect.center(), Align2::CENTER_CENTER, name, font, color);
    // Where colors are forced, all grounds are the same.
    if is_shown && palette.highlight == palette.surface {
        let stroke = Stroke::new(theme::FOCUS_RING_WIDTH, palette.text);
        ui.painter().hline(rect.x_range(), rect.bottom(), stroke);
    }
}

/// The screens in a menu, whose button names the one that is shown where there is room for that.
fn menu_ui(ui: &mut Ui, cx: &mut AppContext<'_>, is_named: bool) {
    let height = cx.layout.icon_size();
    let name = cx.settings.screen.name();
    let words = if is_named { format!("{name} ▾") } else { "▾".to_owned() };
    let button = Button::new(RichText::new(words).font(theme::strong(theme::BODY_SIZE))).frame_when_inactive(false);
    let response = ui.add(button.min_size(vec2(if is_named { 0.0 } else { height }, height)));
    let is_open = Popup::is_id_open(ui.ctx(), Popup::default_response_id(&response));
    ui.accesskit_node_builder(response.id, |node| {
        node.set_has_popup(egui::accesskit::HasPopup::Menu);
        node.set_expanded(is_open);
        node.set_label(format!("Screens: {name}"));
    });
    let entries = Screen::ALL.map(|screen| (screen.name(), None));
    let screen = menu::ui(&response, height, &entries).and_then(|at| Screen::ALL.get(at));
    cx.commands.extend(screen.map(|&screen| Command::Show(screen)));
}

fn theme_choice_ui(ui: &mut Ui, cx: &mut AppContext<'_>, side: f32, is_framed: bool) {
    let button = Button::new(RichText::new("◐").size(theme::ICON_SIZE)).frame_when_inactive(is_framed);
    let response = ui.add(button.min_size(vec2(side, side)));
    let choices = [ThemePreference::System, ThemePreference::Light, ThemePreference::Dark].map(Command::Theme);
    let is_chosen = |command: &Command| *command == Command::Theme(cx.settings.theme);
    let entries = choices.each_ref().map(|choice| (choice.text(), Some(is_chosen(choice))));
    let chosen = menu::ui(&response, cx.layout.control_height(), &entries).and_then(|at| choices.get(at));
    cx.commands.extend(chosen.cloned());
    let _ = response.accessible_name("Light or dark").on_hover_text("Light or dark");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As wide as "Calculator", "Rigs", "Doctor", "Batch", "Pictures" and "Learn" are.
    const SIX: [f32; 6] = [96.0, 54.0, 72.0, 66.0, 82.0, 62.0];

    #[test]
    fn six_screens_are_tabs_where_they_fit_and_a_menu_where_they_do_not() {
        let room = |window: f32| window - 2.0 * 16.0 - 133.0 - 2.0 * 40.0 - 24.0;
        assert_eq!(Offer::that_fits(&SIX, 0, room(768.0)), Offer::All);
        assert_eq!(Offer::that_fits(&SIX, 0, room(390.0)), Offer::Menu);
        assert_eq!(Offer::that_fits(&[96.0, 62.0], 0, room(390.0)), Offer::Others);
        assert_eq!(Offer::that_fits(&[96.0, 62.0], 0, room(480.0)), Offer::All);
    }
}
