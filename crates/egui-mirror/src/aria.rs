//! The ARIA and HTML attributes that say what state a node is in.

use std::collections::BTreeMap;

use egui::Role;
use egui::accesskit::{AriaCurrent, AutoComplete, HasPopup, Invalid, Live, Node, Orientation, SortDirection, Toggled};

use crate::roles::{Kind, Shape, Within};

/// Attributes by name.
#[derive(Default)]
pub(crate) struct Attributes(pub(crate) BTreeMap<&'static str, String>);

impl Attributes {
    pub(crate) fn set(&mut self, name: &'static str, value: Option<impl Into<String>>) {
        if let Some(value) = value {
            self.0.insert(name, value.into());
        }
    }

    fn flag(&mut self, name: &'static str, on: bool) {
        self.set(name, on.then_some("true"));
    }

    fn number(&mut self, name: &'static str, number: Option<impl ToString>) {
        self.set(name, number.map(|number| number.to_string()));
    }
}

/// All that can be said of `node` by itself: not its name, and nothing about other elements.
pub(crate) fn attributes(node: &Node, shape: Shape, within: Within) -> Attributes {
    let mut attributes = Attributes::default();
    attributes.set("type", shape.input_type);
    attributes.set("role", shape.role);
    states(&mut attributes, node, shape);
    table_and_list(&mut attributes, node);
    choice(&mut attributes, node, shape, within);
    numbers(&mut attributes, node, shape.kind);
    attributes
}

fn states(attributes: &mut Attributes, node: &Node, shape: Shape) {
    attributes.flag("aria-disabled", node.is_disabled());
    attributes.flag("aria-required", node.is_required());
    attributes.flag("aria-readonly", node.is_read_only() && !shape.kind.is_text());
    attributes.flag("aria-busy", node.is_busy());
    attributes.flag("aria-modal", node.is_modal());
    attributes.flag("aria-multiselectable", node.is_multiselectable());
    attributes.flag("aria-atomic", node.is_live_atomic());
    // What is live otherwise is said by the announcer.
    attributes.set("aria-live", node.live().filter(|live| *live == Live::Off).map(|_| "off"));
    attributes.set("aria-expanded", node.is_expanded().map(|expanded| expanded.to_string()));
    attributes.set("aria-invalid", node.invalid().map(invalid));
    attributes.set("aria-orientation", node.orientation().map(orientation));
    attributes.set("aria-haspopup", node.has_popup().map(has_popup));
    attributes.set("aria-sort", node.sort_direction().map(sort));
    attributes.set("aria-current", node.aria_current().map(current));
    attributes.set("aria-autocomplete", node.auto_complete().map(auto_complete));
    attributes.set("aria-keyshortcuts", node.keyboard_shortcut());
    attributes.set("aria-roledescription", node.role_description());
    attributes.set("lang", node.language());
    attributes.set("href", node.url().filter(|_| shape.tag == "a"));
}

/// Where in a table, list or outline it is, and how large that is.
fn table_and_list(attributes: &mut Attributes, node: &Node) {
    attributes.number("aria-setsize", node.size_of_set());
    attributes.number("aria-posinset", node.position_in_set());
    attributes.number("aria-rowcount", node.row_count());
    attributes.number("aria-colcount", node.column_count());
    attributes.number("aria-rowindex", node.row_index());
    attributes.number("aria-colindex", node.column_index());
    attributes.number("rowspan", node.row_span());
    attributes.number("colspan", node.column_span());
    match node.role() {
        Role::ColumnHeader => attributes.set("scope", Some("col")),
        Role::RowHeader => attributes.set("scope", Some("row")),
        Role::Heading => attributes.number("aria-level", node.level().filter(|level| *level > 6)),
        _ => attributes.number("aria-level", node.level()),
    }
}

/// Whether it is chosen, ticked or pressed.
fn choice(attributes: &mut Attributes, node: &Node, shape: Shape, within: Within) {
    let on = node.toggled();
    match (shape.role, shape.kind) {
        (_, Kind::Check) => (),
        (Some("menuitemcheckbox" | "menuitemradio"), _) => attributes.set("aria-checked", on.map(toggled)),
        (Some("option" | "tab" | "row" | "treeitem" | "gridcell"), _) => {
            let chosen = node.is_selected().or_else(|| on.map(|on| on == Toggled::True));
            attributes.set("aria-selected", chosen.map(|chosen| chosen.to_string()));
        }
        // A menu item that egui draws as a button can be on or off.
        (Some("menuitem"), _) if within == Within::Menu && on.is_some() => {
            attributes.set("role", Some("menuitemcheckbox"));
            attributes.set("aria-checked", on.map(toggled));
        }
        (_, Kind::Button) => attributes.set("aria-pressed", on.map(toggled)),
        _ => attributes.set("aria-selected", node.is_selected().map(|chosen| chosen.to_string())),
    }
}

fn numbers(attributes: &mut Attributes, node: &Node, kind: Kind) {
    let (min, max, now) = (node.min_numeric_value(), node.max_numeric_value(), node.numeric_value());
    if kind == Kind::Range {
        attributes.number("min", min);
        attributes.number("max", max);
        // Without it only whole numbers could be shown.
        attributes.set("step", Some("any"));
    } else if !kind.is_text() || kind == Kind::Stepper {
        attributes.number("aria-valuemin", min);
        attributes.number("aria-valuemax", max);
        attributes.number("aria-valuenow", now);
    } else {
        return;
    }
    if now.is_some() {
        attributes.set("aria-valuetext", node.value());
    }
}

fn invalid(invalid: Invalid) -> &'static str {
    match invalid {
        Invalid::True => "true",
        Invalid::Grammar => "grammar",
        Invalid::Spelling => "spelling",
    }
}

fn orientation(orientation: Orientation) -> &'static str {
    match orientation {
        Orientation::Horizontal => "horizontal",
        Orientation::Vertical => "vertical",
    }
}

fn has_popup(popup: HasPopup) -> &'static str {
    match popup {
        HasPopup::Menu => "menu",
        HasPopup::Listbox => "listbox",
        HasPopup::Tree => "tree",
        HasPopup::Grid => "grid",
        HasPopup::Dialog => "dialog",
    }
}

fn sort(direction: SortDirection) -> &'static str {
    match direction {
        SortDirection::Ascending => "ascending",
        SortDirection::Descending => "descending",
        SortDirection::Other => "other",
    }
}

fn current(current: AriaCurrent) -> &'static str {
    match current {
        AriaCurrent::False => "false",
        AriaCurrent::True => "true",
        AriaCurrent::Page => "page",
        AriaCurrent::Step => "step",
        AriaCurrent::Location => "location",
        AriaCurrent::Date => "date",
        AriaCurrent::Time => "time",
    }
}

fn auto_complete(auto_complete: AutoComplete) -> &'static str {
    match auto_complete {
        AutoComplete::Inline => "inline",
        AutoComplete::List => "list",
        AutoComplete::Both => "both",
    }
}

fn toggled(toggled: Toggled) -> &'static str {
    match toggled {
        Toggled::False => "false",
        Toggled::True => "true",
        Toggled::Mixed => "mixed",
    }
}
