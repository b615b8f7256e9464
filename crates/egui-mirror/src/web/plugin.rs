//! The plugin: the two ends at which egui lets it in.

use wasm_bindgen::JsValue;
use web_sys::HtmlCanvasElement;

use super::announcer::Announcer;
use super::dom::Dom;
use super::events;
use super::gate::Gate;
use super::installed::{Installed, install, with, with_mut};
use super::options::Options;
use super::signals::{self, FOCUSED, QUEUE};
use super::timer::Timer;

/// The accessible mirror. There is one in a page.
#[derive(Clone, Copy, Debug)]
pub struct Mirror;

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
        let host = dom.host().element();
        let announcer = Announcer::new(dom.document(), host, || {
            let _ = with(|mirror| mirror.announcer.say_waiting(mirror.dom.page()));
        })?;
        let gate = Gate::new(host, || {
            let _ = with(|mirror| mirror.gate.close());
        });
        let pause = Timer::new(|| {
            with_mut(|mirror| {
                let news = mirror.dom.typing_paused();
                mirror.announcer.announce(news);
            });
        });
        let listeners = events::listen(&dom)?;
        install(Installed {
            dom,
            pause,
            announcer,
            gate,
            _listeners: listeners,
        });
        ctx.enable_accesskit();
        ctx.add_plugin(Plugin);
        Ok(())
    }
}

struct Plugin;

impl egui::Plugin for Plugin {
    fn debug_name(&self) -> &'static str {
        "accessible mirror"
    }

    fn input_hook(&mut self, _: &egui::Context, input: &mut egui::RawInput) {
        input.events.append(&mut QUEUE.take());
        if FOCUSED.get().is_some() {
            // To eframe the focus is elsewhere in the page. Without it no widget would show or use its focus.
            input.focused = true;
            input.events.retain(|event| !matches!(event, egui::Event::WindowFocused(false)));
        }
    }

    fn output_hook(&mut self, ctx: &egui::Context, output: &mut egui::FullOutput) {
        signals::pass_ended(ctx);
        // A pass that egui is going to repeat says nothing yet.
        let platform = &mut output.platform_output;
        let passes = ctx.options(|options| options.max_passes.get());
        let repeated = platform.requested_discard() && platform.num_completed_passes < passes;
        let Some(update) = platform.accesskit_update.take().filter(|_| !repeated) else {
            return;
        };
        with_mut(|mirror| {
            let news = mirror.dom.update(update);
            mirror.announcer.announce(news);
        });
    }
}
