//! The port: what the program needs from the machine it runs on.

use super::theme::SystemColors;

/// The author's id, in the tree for assistive technology, of the button for which there is [`App::copy_results`](super::App::copy_results).
pub const COPY_RESULTS: &str = "copy results";

/// What the program needs from the machine it runs on.
pub trait Platform {
    /// The stored state, if there is any.
    ///
    /// # Errors
    /// A sentence saying why storage cannot be used.
    fn load(&self) -> Result<Option<String>, String>;

    /// Stores `text` over what was stored.
    ///
    /// # Errors
    /// A sentence saying why not.
    fn save(&mut self, text: &str) -> Result<(), String>;

    /// Moves what is stored, which cannot be read, to where nothing is overwritten, now or later: it may be of a newer version.
    /// Returns where a person finds it, as the end of a sentence ("in the file …"), or nothing where nothing is stored.
    ///
    /// # Errors
    /// A sentence saying why not. What is stored is then still in its place.
    fn set_aside(&mut self) -> Result<Option<String>, String>;

    /// Starts putting `text` on the clipboard; the outcome comes later from [`Self::copied`].
    fn copy(&mut self, ctx: &egui::Context, text: String);

    /// The outcome of the last [`Self::copy`], once.
    fn copied(&mut self) -> Option<Result<(), String>>;

    /// Whether another tab or window has stored something since the last call.
    fn stored_elsewhere(&mut self) -> bool {
        false
    }

    /// The colours that a person has chosen for everything on the screen, if so.
    fn forced_colors(&mut self) -> Option<SystemColors> {
        None
    }

    /// The commit that the program was built from, where that is known.
    fn commit(&self) -> Option<String>;

    /// The licenses of the program and of everything in it.
    fn licenses(&self) -> Licenses;

    /// The part behind the `#` of a link that was followed to the program, once.
    fn link(&mut self) -> Option<String> {
        None
    }
}

/// Where the licenses of everything in the program are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Licenses {
    /// Here, as lines of text.
    #[cfg(not(target_arch = "wasm32"))]
    Text(&'static str),
    /// On a page with this address.
    Page(&'static str),
}
