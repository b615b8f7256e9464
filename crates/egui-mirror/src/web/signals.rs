//! What the listeners leave for the next frame. They may be called in the middle of a change to the page, so this is apart from it.

use std::cell::{Cell, RefCell};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};

thread_local! {
    /// Events for egui's next frame.
    pub(crate) static QUEUE: RefCell<Vec<egui::Event>> = const { RefCell::new(Vec::new()) };
    /// The element of the mirror that has the browser's focus.
    pub(crate) static FOCUSED: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// The elements that had it, the latest last.
    pub(crate) static VISITED: RefCell<Vec<NodeId>> = const { RefCell::new(Vec::new()) };
    /// The focus is being moved because egui moved its own.
    pub(crate) static QUIET: Cell<bool> = const { Cell::new(false) };
    /// Escape was pressed: the next Tab goes to what follows the application.
    pub(crate) static LEAVING: Cell<bool> = const { Cell::new(false) };
    /// The field in which an input method is composing text.
    pub(crate) static COMPOSING: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// Fields that were typed into since the last frame.
    pub(crate) static TOUCHED: RefCell<Vec<NodeId>> = const { RefCell::new(Vec::new()) };
    /// The caret of the focused field may have moved.
    pub(crate) static CARET_MOVED: Cell<bool> = const { Cell::new(false) };
}

/// How many elements are remembered to go back to.
const MEMORY: usize = 16;

/// Remembers that an element has the browser's focus now.
pub(crate) fn focus_is_on(id: NodeId) {
    FOCUSED.set(Some(id));
    VISITED.with_borrow_mut(|visited| {
        visited.retain(|other| *other != id);
        visited.push(id);
        if visited.len() > MEMORY {
            visited.remove(0);
        }
    });
}

/// Gives egui events in its next frame.
pub(crate) fn send(ctx: &egui::Context, events: impl IntoIterator<Item = egui::Event>) {
    QUEUE.with_borrow_mut(|queue| queue.extend(events));
    ctx.request_repaint();
}

/// Asks egui to do something with a node in its next frame.
pub(crate) fn act(ctx: &egui::Context, id: NodeId, action: Action, data: Option<ActionData>) {
    let request = ActionRequest {
        action,
        target_tree: TreeId::ROOT,
        target_node: id,
        data,
    };
    send(ctx, [egui::Event::AccessKitActionRequest(request)]);
}
