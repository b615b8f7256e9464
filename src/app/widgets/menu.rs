//! Menus and lists that open: their entries, and the keys that lead to and through them.

use crate::app::{menu_key, theme};
use egui::{AsIdSalt, Button, ComboBox, Event, EventFilter, Id, IdSalt, Key, Modifiers, Popup, Response, Ui, vec2};

/// Makes `ui` the inside of a menu.
fn style(ui: &mut Ui) {
    ui.set_min_width(theme::MENU_WIDTH);
    ui.spacing_mut().item_spacing.y = 0.0;
}

/// The entries of a menu, while they are drawn.
pub struct Items<'a> {
    pub ui: &'a mut Ui,
    drawn: Entries,
}

impl Items<'_> {
    /// An entry named `name`, which closes the menu. Returns whether it was chosen.
    pub fn item_ui(&mut self, name: &str, is_enabled: bool) -> bool {
        let response = entry_ui(self.ui, Button::new(name).frame_when_inactive(false), is_enabled);
        if is_enabled {
            self.drawn.add(&response, name, false);
        }
        response.clicked()
    }
}

/// The menu that `owner` opens where it is right-clicked, pressed for long, or has the focus with the menu key pressed: with the entries
/// that `add` draws. Opened by the key, it has the focus while it is open.
pub fn context_ui(owner: &Response, add: impl FnOnce(&mut Items<'_>)) {
    let ctx = &owner.ctx;
    let is_drawn = Popup::context_menu(owner).show(|ui| {
        style(ui);
        let mut items = Items {
            ui,
            drawn: Entries::default(),
        };
        add(&mut items);
        // Whatever a click is not on gives the focus away again while it is heard.
        if menu_key::opened_from(ctx).is_some() && !ctx.input(|input| input.pointer.any_click()) {
            items.drawn.lead_focus(items.ui, owner.id);
        }
    });
    let was_drawn = || ctx.data(|data| data.get_temp::<Vec<Id>>(drawn_key(owner.id)).is_some());
    if is_drawn.is_none() && was_drawn() {
        take_focus_back(owner, menu_key::opened_from(ctx).unwrap_or(owner.id));
    }
}

fn entry_ui(ui: &mut Ui, button: Button<'_>, is_enabled: bool) -> Response {
    // A menu makes all its entries as wide as the widest.
    let size = vec2(0.0, ui.spacing().interact_size.y.min(theme::CONTROL_HEIGHT_TOUCH));
    let response = ui.add_enabled(is_enabled, button.min_size(size));
    if response.clicked() {
        ui.close();
    }
    response
}

/// The menu of the button `owner`, while it is open, with entries `height` high: their names, and whether each is the one that is
/// chosen, where one can be. Returns the entry that was chosen now.
pub fn ui(owner: &Response, height: f32, entries: &[(&str, Option<bool>)]) -> Option<usize> {
    let shown = Popup::menu(owner).show(|ui| {
        style(ui);
        ui.spacing_mut().interact_size.y = height;
        let mut drawn = Entries::default();
        let mut chosen = None;
        for (at, (name, is_chosen)) in entries.iter().enumerate() {
            let button = match *is_chosen {
                Some(is_chosen) => Button::selectable(is_chosen, *name),
                None => Button::new(*name).frame_when_inactive(false),
            };
            let response = entry_ui(ui, button, true);
            if response.clicked() {
                chosen = Some(at);
            }
            drawn.add(&response, name, *is_chosen == Some(true));
        }
        drawn.lead_focus(ui, owner.id);
        chosen
    });
    take_focus_back(owner, owner.id);
    shown.and_then(|shown| shown.inner)
}

/// A choice among `names` in a list that opens, itself named `name`: `width` wide, with the text `shown` while it is closed.
pub struct List<'a> {
    pub name: &'a str,
    pub shown: &'a str,
    pub width: f32,
    pub names: &'a [String],
    /// The place of the one that is chosen.
    pub chosen: Option<usize>,
}

impl List<'_> {
    /// Draws it, and returns the place of the name that was chosen now.
    pub fn ui(&self, ui: &mut Ui, id: impl AsIdSalt) -> (Response, Option<usize>) {
        let id = IdSalt::new(id);
        // As egui names the button of a `ComboBox`, which it tells only afterwards.
        let owner = ui.make_persistent_id(IdSalt::new(id));
        let combo = ComboBox::from_id_salt(id).width(self.width).selected_text(self.shown);
        let mut now = None;
        let response = combo
            .wrap_mode(egui::TextWrapMode::Extend)
            .show_ui(ui, |ui| {
                let mut drawn = Entries::default();
                // Closed explicitly: egui does so only for a click of the pointer. And a frame later: the focus goes back to a button that
                // says what was chosen, not what was before.
                let closes = chosen_key(owner);
                if ui.data_mut(|data| data.remove_temp::<bool>(closes)).is_some() {
                    ui.close();
                }
                for (at, name) in self.names.iter().enumerate() {
                    let entry = ui.selectable_label(self.chosen == Some(at), name);
                    if entry.clicked() {
                        now = Some(at);
                        ui.data_mut(|data| data.insert_temp(closes, true));
                        ui.ctx().request_repaint();
                    }
                    drawn.add(&entry, name, self.chosen == Some(at));
                }
                drawn.lead_focus(ui, owner);
            })
            .response
            .accessible_name(self.name);
        take_focus_back(&response, response.id);
        let now = now.or_else(|| self.chosen_by_keys(ui, &response));
        (response, now)
    }

    /// What the keys do with the closed list, which has the focus: ↓ and ↑ open it, also with Alt, and a letter chooses the next name
    /// that begins with it.
    fn chosen_by_keys(&self, ui: &Ui, owner: &Response) -> Option<usize> {
        if !owner.has_focus() {
            return None;
        }
        keep_arrows(ui, owner.id);
        let opens = [Key::ArrowDown, Key::ArrowUp]
            .into_iter()
            .flat_map(|key| [(Modifiers::NONE, key), (Modifiers::ALT, key)])
            .any(|(modifiers, key)| ui.input_mut(|input| input.consume_key(modifiers, key)));
        if opens {
            // As egui names the list of a `ComboBox`, which it does not tell.
            Popup::open_id(ui.ctx(), owner.id.with("popup"));
            return None;
        }
        let letter = typed_letter(ui)?;
        let names: Vec<String> = self.names.iter().map(|name| name.to_ascii_lowercase()).collect();
        next_with(&letter, &names, self.chosen.unwrap_or(names.len().saturating_sub(1)))
    }
}

/// The entries of a list or menu that is open.
#[derive(Default)]
struct Entries {
    ids: Vec<Id>,
    /// In small letters.
    names: Vec<String>,
    /// The place of the one that is chosen.
    chosen: usize,
}

impl Entries {
    /// The next one.
    fn add(&mut self, entry: &Response, name: &str, is_chosen: bool) {
        if is_chosen {
            self.chosen = self.ids.len();
        }
        self.ids.push(entry.id);
        self.names.push(name.to_ascii_lowercase());
    }

    /// Puts the focus on the chosen entry when the list of `owner` has just opened, and leads it through the entries by the arrow keys,
    /// Home, End and letters.
    fn lead_focus(self, ui: &Ui, owner: Id) {
        let before = ui.data_mut(|data| {
            let before = data.get_temp::<Vec<Id>>(drawn_key(owner));
            data.insert_temp(drawn_key(owner), self.ids.clone());
            before
        });
        let to = if before.is_none() {
            Some(self.chosen)
        } else {
            let focused = ui.memory(|memory| memory.focused());
            let at = self.ids.iter().position(|id| Some(*id) == focused);
            at.and_then(|at| self.led_to(ui, at))
        };
        if let Some(id) = to.and_then(|to| self.ids.get(to)) {
            ui.memory_mut(|memory| memory.request_focus(*id));
        }
    }

    /// Where the keys lead from the entry at `at`, which has the focus.
    fn led_to(&self, ui: &Ui, at: usize) -> Option<usize> {
        let last = self.ids.len().checked_sub(1)?;
        keep_arrows(ui, *self.ids.get(at)?);
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if pressed(Key::ArrowDown) {
            return Some(if at == last { 0 } else { at + 1 });
        }
        if pressed(Key::ArrowUp) {
            return Some(at.checked_sub(1).unwrap_or(last));
        }
        if pressed(Key::Home) {
            return Some(0);
        }
        if pressed(Key::End) {
            return Some(last);
        }
        next_with(&typed_letter(ui)?, &self.names, at)
    }
}

/// Gives the focus back to `to` when the list of `owner` has closed, unless it is elsewhere by now.
fn take_focus_back(owner: &Response, to: Id) {
    let ctx = &owner.ctx;
    if Popup::is_id_open(ctx, Popup::default_response_id(owner)) || ComboBox::is_open(ctx, owner.id) {
        return;
    }
    ctx.data_mut(|data| data.remove_temp::<bool>(chosen_key(owner.id)));
    let Some(drawn) = ctx.data_mut(|data| data.remove_temp::<Vec<Id>>(drawn_key(owner.id))) else {
        return;
    };
    if ctx.memory(|memory| memory.focused()).is_none_or(|focused| drawn.contains(&focused)) {
        ctx.memory_mut(|memory| memory.request_focus(to));
    }
}

fn chosen_key(owner: Id) -> Id {
    owner.with("something was chosen")
}

fn drawn_key(owner: Id) -> Id {
    owner.with("entries")
}

/// Keeps egui from leading the focus elsewhere with an arrow.
fn keep_arrows(ui: &Ui, id: Id) {
    let arrows = EventFilter {
        vertical_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
}

/// A letter that was typed now, as a small one.
fn typed_letter(ui: &Ui) -> Option<String> {
    ui.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::Text(text) if text.chars().all(char::is_alphabetic) => Some(text.to_ascii_lowercase()),
            _ => None,
        })
    })
}

/// The place of the next of the `names` behind `at` that begins with `letter`; after the last comes the first.
fn next_with(letter: &str, names: &[String], at: usize) -> Option<usize> {
    let (before, behind) = names.split_at_checked(at + 1)?;
    let begins = |name: &String| name.starts_with(letter);
    let found = behind.iter().position(begins).map(|place| at + 1 + place);
    found.or_else(|| before.iter().position(begins))
}
