//! The plugin: the two ends at which egui lets it in.

use std::cell::RefCell;
use std::rc::Rc;

use egui::accesskit::Node;
use wasm_bindgen::JsValue;
use web_sys::{HtmlCanvasElement, HtmlElement};

use crate::dom::Dom;
use crate::events::{self, Listener, SIGNALS};

thread_local! {
    /// What belongs to the browser. A plugin must be `Send`, and nothing of the browser is.
    static INSTALLED: RefCell<Option<Installed>> = const { RefCell::new(None) };
}

struct Installed {
    dom: Dom,
    _listeners: Vec<Listener>,
}

/// The accessible mirror. There is one in a page.
#[derive(Clone, Copy, Debug)]
pub struct Mirror;

/// What an application may choose.
#[derive(Clone)]
pub struct Options {
    /// The element to build the page in; without one it is made beside the canvas, with the id `accessible-mirror`. It
    /// must have the same offset parent as the canvas, over which it is laid.
    pub host: Option<HtmlElement>,
    /// The value of HTML's `inputmode` for a text field, where its role does not say enough.
    pub input_mode: fn(&Node) -> Option<&'static str>,
    /// Called with what is clicked in the mirror, by a key or by assistive technology, while the browser handles the click: for
    /// what it allows only then. egui hears of a click in its next frame, which in Safari is too late for the clipboard. Returns
    /// whether that was all there is to do; if not, egui is told.
    pub clicked: Rc<dyn Fn(&Node) -> bool>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            host: None,
            input_mode: |_| None,
            clicked: Rc::new(|_| false),
        }
    }
}

impl Mirror {
    /// Installs it: enables AccessKit on `ctx` and registers the plugin. To be called once, when the application is
    /// created.
    ///
    /// # Errors
    /// What the browser says when an element cannot be made, or when the canvas is not in a document.
    pub fn install(ctx: &egui::Context, canvas: &HtmlCanvasElement) -> Result<(), JsValue> {
        Self::install_with(ctx, canvas, Options::default())
    }

    /// Installs it with `options`.
    ///
    /// # Errors
    /// As for [`Mirror::install`].
    pub fn install_with(ctx: &egui::Context, canvas: &HtmlCanvasElement, options: Options) -> Result<(), JsValue> {
        let dom = Dom::new(ctx.clone(), canvas, options)?;
        let listeners = events::listen(&dom)?;
        INSTALLED.set(Some(Installed {
            dom,
            _listeners: listeners,
        }));
        ctx.enable_accesskit();
        ctx.add_plugin(Plugin);
        Ok(())
    }

    /// The page as text, one line per element, as egui described it last: for tests and for bug reports.
    pub fn description() -> String {
        with(|dom| dom.page().to_string()).unwrap_or_default()
    }

    /// The AccessKit tree that egui gave last, as text, for a test that compares it with what the browser tells assistive
    /// technology. Nodes end with U+001E, what is said of one with U+001F: the `id` of its element, role, label, value,
    /// description, the elements that name it, states, and bounds in CSS pixels.
    pub fn tree() -> String {
        with(|dom| dom.tree()).unwrap_or_default()
    }

    /// The page as text, read back from the browser. It equals [`Mirror::description`], or the mirror has a fault.
    pub fn read_back() -> String {
        with(|dom| dom.read_back()).unwrap_or_default()
    }
}

/// Lends the page to a listener, unless it is being changed at this moment.
pub(crate) fn with<R>(look: impl FnOnce(&Dom) -> R) -> Option<R> {
    INSTALLED.with(|installed| Some(look(&installed.try_borrow().ok()?.as_ref()?.dom)))
}

struct Plugin;

impl egui::Plugin for Plugin {
    fn debug_name(&self) -> &'static str {
        "accessible mirror"
    }

    fn input_hook(&mut self, _: &egui::Context, input: &mut egui::RawInput) {
        SIGNALS.with(|signals| {
            input.events.append(&mut signals.queue.borrow_mut());
            if signals.focused.get().is_some() {
                // To eframe the focus is elsewhere in the page. Without it no widget would show or use its focus.
                input.focused = true;
                input.events.retain(|event| !matches!(event, egui::Event::WindowFocused(false)));
            }
        });
    }

    fn output_hook(&mut self, ctx: &egui::Context, output: &mut egui::FullOutput) {
        // A pass that egui is going to repeat says nothing yet.
        let platform = &mut output.platform_output;
        let passes = ctx.options(|options| options.max_passes.get());
        let repeated = platform.requested_discard() && platform.num_completed_passes < passes;
        let Some(update) = platform.accesskit_update.take().filter(|_| !repeated) else {
            return;
        };
        INSTALLED.with(|installed| {
            if let Ok(mut installed) = installed.try_borrow_mut()
                && let Some(installed) = installed.as_mut()
            {
                installed.dom.update(update);
            }
        });
    }
}
