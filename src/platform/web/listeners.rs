//! Listens to events of the browser that eframe does not handle, as long as the page is open.

use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;

use super::inbox::Inbox;
use super::page;
use crate::app::{Colors, Event, SystemColors};

/// Adds the events of the browser to `inbox`, and at once the link with which the page was opened and the forced colors.
pub(super) fn listen(ctx: &egui::Context, inbox: &Inbox) {
    let Some(window) = web_sys::window() else { return };
    listen_to_links(&window, inbox);
    listen_to_history(&window, inbox);
    listen_to_colors(&window, inbox);
    follow_reduced_motion(&window, ctx);
}

/// A link followed within the page changes only its fragment.
fn listen_to_links(window: &web_sys::Window, inbox: &Inbox) {
    let add = {
        let inbox = inbox.clone();
        move || {
            if let Some(fragment) = link() {
                inbox.add(Event::Link(fragment));
            }
        }
    };
    add();
    on(window, "hashchange", move |_| add());
}

/// The person goes back or forward among the screens, which the history has by their names.
fn listen_to_history(window: &web_sys::Window, inbox: &Inbox) {
    let (inbox, history) = (inbox.clone(), window.history());
    on(window, "popstate", move |_| {
        let state = history.as_ref().ok().and_then(|history| history.state().ok()?.as_string());
        if let Some(name) = state {
            inbox.add(Event::Screen(name));
        }
    });
}

fn listen_to_colors(window: &web_sys::Window, inbox: &Inbox) {
    inbox.add(Event::Colors(colors()));
    // Other forced colors can be dark or light as well, and some browsers send only that event.
    for query in [FORCED, MORE_CONTRAST, "(prefers-color-scheme: dark)"] {
        if let Ok(Some(query)) = window.match_media(query) {
            let inbox = inbox.clone();
            on(&query, "change", move |_| inbox.add(Event::Colors(colors())));
        }
    }
}

/// Switches animations off while the person prefers reduced motion.
fn follow_reduced_motion(window: &web_sys::Window, ctx: &egui::Context) {
    const REDUCED: &str = "(prefers-reduced-motion: reduce)";
    let (ctx, usual) = (ctx.clone(), ctx.style_of(egui::Theme::Light));
    let follow = move || {
        let is_reduced = page::matches(REDUCED);
        ctx.all_styles_mut(|style| {
            style.animation_time = if is_reduced { 0.0 } else { usual.animation_time };
            style.scroll_animation = if is_reduced {
                egui::style::ScrollAnimation::none()
            } else {
                usual.scroll_animation
            };
        });
    };
    follow();
    if let Ok(Some(query)) = window.match_media(REDUCED) {
        on(&query, "change", move |_| follow());
    }
}

/// Calls `act` for each `event` below `target` before anybody below hears of it.
pub(super) fn on_its_way(target: &web_sys::EventTarget, event: &str, act: impl FnMut(web_sys::Event) + 'static) {
    add_listener(target, event, true, Closure::new(act));
}

/// Calls `act` for each `event` of `target`.
pub(super) fn on(target: &web_sys::EventTarget, event: &str, act: impl FnMut(web_sys::Event) + 'static) {
    add_listener(target, event, false, Closure::new(act));
}

fn add_listener(target: &web_sys::EventTarget, event: &str, before: bool, listener: Closure<dyn FnMut(web_sys::Event)>) {
    let function = listener.as_ref().unchecked_ref();
    if target.add_event_listener_with_callback_and_bool(event, function, before).is_err() {
        log::warn!("The page cannot listen to {event}.");
    }
    listener.forget();
}

/// The part behind the `#` of the page's address, once.
fn link() -> Option<String> {
    let location = web_sys::window()?.location();
    let fragment = location.hash().ok()?;
    if fragment.is_empty() {
        return None;
    }
    // Removed from the address, so that a reload does not apply it again; `replace` adds no entry to the history.
    location.replace("#").ok()?;
    Some(fragment)
}

const FORCED: &str = "(forced-colors: active)";
const MORE_CONTRAST: &str = "(prefers-contrast: more)";

/// What the person wants of the colors, as far as the browser says.
fn colors() -> Colors {
    let chosen = page::matches(FORCED).then(system_colors).flatten();
    match chosen {
        Some(colors) => Colors::Chosen(colors),
        None if page::matches(MORE_CONTRAST) => Colors::MoreContrast,
        None => Colors::Usual,
    }
}

/// The system colors, read from the computed style of a temporary element.
fn system_colors() -> Option<SystemColors> {
    let window = web_sys::window()?;
    let document = window.document()?;
    let probe: web_sys::HtmlElement = document.create_element("span").ok()?.dyn_into().ok()?;
    document.body()?.append_child(&probe).ok()?;
    let color = |name: &str| {
        // With `forced-color-adjust: auto` the computed color would be that of the text.
        probe.style().set_css_text(&format!("forced-color-adjust:none;color:{name}"));
        let style = window.get_computed_style(&probe).ok()??;
        style.get_property_value("color").ok()
    };
    let colors = SystemColors::from_css(color);
    probe.remove();
    colors
}
