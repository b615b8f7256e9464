//! What the listeners leave for the next frame. They may be called in the middle of a change to the page, so this is apart from it.

use std::cell::{Cell, RefCell};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};

thread_local! {
    /// Events for egui's next frame.
    pub(crate) static QUEUE: RefCell<Vec<egui::Event>> = const { RefCell::new(Vec::new()) };
    /// The element of the mirror that has the browser's focus.
    pub(crate) static FOCUSED: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// The element that has got it since the last frame: the browser scrolls to that.
    pub(crate) static ARRIVED: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// The elements that had it, the latest last.
    pub(crate) static VISITED: RefCell<Vec<NodeId>> = const { RefCell::new(Vec::new()) };
    /// The focus is being moved because egui moved its own.
    pub(crate) static QUIET: Cell<bool> = const { Cell::new(false) };
    /// The field that is being typed in: the last key was a moment ago.
    pub(crate) static TYPING: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// The field in which an input method is composing text.
    pub(crate) static COMPOSING: Cell<Option<NodeId>> = const { Cell::new(None) };
    /// Fields that were typed into since the last frame.
    pub(crate) static TOUCHED: RefCell<Vec<NodeId>> = const { RefCell::new(Vec::new()) };
    /// The requests to move the focus and to set a value that egui has not had in a pass yet, the latest last. The application may hold
    /// events back for later passes.
    static WAITING: RefCell<Vec<(NodeId, Action)>> = const { RefCell::new(Vec::new()) };
    /// The caret of the focused field may have moved.
    pub(crate) static CARET_MOVED: Cell<bool> = const { Cell::new(false) };
}

/// How many elements are remembered to go back to.
const MEMORY: usize = 16;

/// Remembers that an element has the browser's focus now.
pub(crate) fn focus_is_on(id: NodeId) {
    FOCUSED.set(Some(id));
    ARRIVED.set(Some(id));
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
    if matches!(action, Action::Focus | Action::SetValue) {
        WAITING.with_borrow_mut(|waiting| waiting.push((id, action)));
    }
    send(ctx, [egui::Event::AccessKitActionRequest(request)]);
}

/// Notes which requests egui has had in the pass that has just ended. Where nothing is going to happen in egui any more, none is waited
/// for: then the application has dropped it.
pub(crate) fn pass_ended(ctx: &egui::Context) {
    if !ctx.has_requested_repaint() {
        WAITING.take();
        return;
    }
    WAITING.with_borrow_mut(|waiting| {
        if waiting.is_empty() {
            return;
        }
        ctx.input(|input| {
            for event in &input.events {
                let egui::Event::AccessKitActionRequest(had) = event else {
                    continue;
                };
                let request = (had.target_node, had.action);
                if let Some(at) = waiting.iter().position(|other| *other == request) {
                    waiting.remove(at);
                }
            }
        });
    });
}

/// Is egui yet to be told what stands in this field?
pub(crate) fn has_value_waiting(id: NodeId) -> bool {
    WAITING.with_borrow(|waiting| waiting.contains(&(id, Action::SetValue)))
}

/// Where egui is yet to move its focus to.
pub(crate) fn waiting_focus() -> Option<NodeId> {
    WAITING.with_borrow(|waiting| {
        let mut latest_first = waiting.iter().rev();
        latest_first.find(|(_, action)| *action == Action::Focus).map(|(id, _)| *id)
    })
}
