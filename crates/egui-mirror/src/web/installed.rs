//! The one mirror of the page, where listeners and timers find it.

use std::cell::RefCell;

use super::announcer::Announcer;
use super::dom::Dom;
use super::gate::Gate;
use super::listener::Listener;
use super::timer::Timer;

thread_local! {
    /// What belongs to the browser. A plugin must be `Send`, and nothing of the browser is.
    static INSTALLED: RefCell<Option<Installed>> = const { RefCell::new(None) };
}

/// All parts of the mirror.
pub(crate) struct Installed {
    pub(crate) dom: Dom,
    pub(crate) announcer: Announcer,
    pub(crate) gate: Gate,
    /// Ends when nobody has typed for a while.
    pub(crate) pause: Timer,
    /// They listen as long as this lives.
    pub(crate) _listeners: Vec<Listener>,
}

/// Replaces the mirror that there was, if any.
pub(crate) fn install(mirror: Installed) {
    INSTALLED.set(Some(mirror));
}

/// Lends the mirror to a listener, unless it is being changed at this moment.
pub(crate) fn with<R>(look: impl FnOnce(&Installed) -> R) -> Option<R> {
    INSTALLED.with(|installed| Some(look(installed.try_borrow().ok()?.as_ref()?)))
}

/// Lends the mirror to be changed.
pub(crate) fn with_mut(change: impl FnOnce(&mut Installed)) {
    INSTALLED.with(|installed| {
        if let Ok(mut installed) = installed.try_borrow_mut()
            && let Some(installed) = installed.as_mut()
        {
            change(installed);
        }
    });
}
