//! One HTML element, and how a node of the AccessKit tree becomes one.

use std::collections::BTreeMap;

use egui::Role;
use egui::accesskit::{Action, Live, Node, NodeId, Toggled};

use crate::aria::{self, Attributes};
use crate::number::bare_number;
use crate::roles::{self, Kind, Shape, Within};

/// The value of HTML's `inputmode` that the application wants for a text field, where its role does not say enough.
pub type InputMode = fn(&Node) -> Option<&'static str>;

/// Where an element lies, in CSS pixels, relative to the element around it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// From the left edge of the element around it.
    pub left: f64,
    /// From the top edge of the element around it.
    pub top: f64,
    /// At least 1.
    pub width: f64,
    /// At least 1.
    pub height: f64,
}

/// How the text of an element is painted, in CSS pixels relative to the element.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lettering {
    /// Where the first line begins.
    pub left: f64,
    /// Where the first line begins.
    pub top: f64,
    /// The width of all lines together.
    pub width: f64,
    /// The height of a line.
    pub line: f64,
    /// The number of lines.
    pub lines: usize,
}

/// What the application lets a person do with an element.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Allowed {
    /// Put the keyboard focus on it.
    pub focus: bool,
    /// Click it.
    pub click: bool,
    /// Step its value up or down.
    pub step: bool,
    /// Replace its value.
    pub set_value: bool,
}

/// One HTML element.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// The node that it stands for, in egui the id of the widget.
    pub id: NodeId,
    /// What the author of the application calls it, if anything (`Node::set_author_id`).
    pub author_id: Option<String>,
    /// The name of the HTML element.
    pub tag: &'static str,
    /// How a person uses it.
    pub kind: Kind,
    /// What the application lets a person do with it.
    pub allowed: Allowed,
    /// The accessible name in words, wherever it comes from.
    pub name: String,
    /// All attributes but `id` and `style`.
    pub attributes: BTreeMap<&'static str, String>,
    /// What is said of it beside its name and its value.
    pub description: Option<String>,
    /// The text inside an element that has no children.
    pub text: Option<String>,
    /// The content of an input: a property, not an attribute.
    pub value: Option<String>,
    /// The state of a check box or radio button: a property, not an attribute.
    pub checked: Option<Toggled>,
    /// Where it lies.
    pub place: Place,
    /// How its text is painted, where that is known.
    pub lettering: Option<Lettering>,
    /// How urgently the application wants it to be read aloud when it appears or changes.
    pub live: Option<Live>,
    /// The field that it describes, if it does.
    pub(crate) describes: Option<NodeId>,
    /// The elements inside it, in reading order.
    pub children: Vec<NodeId>,
}

impl Element {
    /// The element for `node`, without a place and without children.
    pub(crate) fn new(id: NodeId, node: &Node, shape: Shape, within: Within, input_mode: InputMode) -> Self {
        let value = node.value().unwrap_or_default();
        let is_value_its_name = shape.named_by_content && node.label().is_none();
        let name = node.label().unwrap_or(if is_value_its_name { value } else { "" }).to_owned();
        let allowed = allowed(node);
        let mut attributes = aria::attributes(node, shape, within);
        if !shape.named_by_content {
            attributes.set("aria-label", Some(name.as_str()).filter(|name| !name.is_empty()));
        }
        let stop = tab_index(shape.kind, allowed, node.is_disabled());
        // The arrow keys lead through an open list, not Tab. Source: ARIA Authoring Practices, "Combobox" and "Listbox".
        attributes.set("tabindex", stop.map(|stop| if within == Within::ListBox { "-1" } else { stop }));
        if shape.kind.is_text() {
            describe_typing(&mut attributes, node, input_mode);
        }
        let text = match shape.kind {
            Kind::Other if shape.named_by_content => Some(name.clone()),
            Kind::Button => Some(if shape.named_by_content { name.clone() } else { value.to_owned() }),
            _ => None,
        };
        Self {
            id,
            author_id: node.author_id().map(str::to_owned),
            tag: shape.tag,
            kind: shape.kind,
            allowed,
            name: name.clone(),
            attributes: attributes.0,
            description: node.description().filter(|words| *words != name).map(str::to_owned),
            text: text.filter(|text| !text.is_empty()),
            value: content(node, shape.kind),
            checked: (shape.kind == Kind::Check).then(|| node.toggled().unwrap_or(Toggled::False)),
            place: Place::default(),
            lettering: None,
            live: node.live(),
            describes: None,
            children: Vec::new(),
        }
    }

    /// The value of an attribute.
    #[must_use]
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.get(name).map(String::as_str)
    }

    /// The explicit ARIA role.
    pub(crate) fn role(&self) -> Option<&str> {
        self.attribute("role")
    }

    /// Is it a dialog, of whatever kind?
    pub(crate) fn is_dialog(&self) -> bool {
        self.role().is_some_and(|role| role.contains("dialog"))
    }

    /// Whether its description is for those who come to it: that of a text is for whoever hears it as news.
    pub(crate) fn has_about(&self) -> bool {
        self.description.is_some() && (self.attributes.contains_key("tabindex") || self.attributes.contains_key("role"))
    }

    /// Can one become the other by a change of attributes? A check box that becomes a text field would keep its tick.
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(crate) fn is_same_element(&self, other: &Self) -> bool {
        self.tag == other.tag && self.attributes.get("type") == other.attributes.get("type")
    }
}

/// The `id` of the HTML element that stands for a node.
#[must_use]
pub fn element_id(id: NodeId) -> String {
    format!("mirror-{:x}", id.0)
}

/// The `id` of the HTML element with the description of a node.
pub(crate) fn about_id(id: NodeId) -> String {
    format!("about-{:x}", id.0)
}

/// The node that an HTML element with this `id` stands for.
#[cfg(any(test, target_arch = "wasm32"))]
pub(crate) fn node_id(element_id: &str) -> Option<NodeId> {
    u64::from_str_radix(element_id.strip_prefix("mirror-")?, 16).ok().map(NodeId)
}

fn allowed(node: &Node) -> Allowed {
    let enabled = !node.is_disabled();
    Allowed {
        focus: node.supports_action(Action::Focus),
        click: node.supports_action(Action::Click) && enabled,
        step: node.supports_action(Action::Increment) || node.supports_action(Action::Decrement),
        set_value: node.supports_action(Action::SetValue) && enabled && !node.is_read_only(),
    }
}

/// In the Tab order is what egui has in its own. Something disabled keeps its place in the page and in the reading
/// order and does not lose the focus it has (`aria-disabled`, not `disabled`), but Tab passes it by.
fn tab_index(kind: Kind, allowed: Allowed, disabled: bool) -> Option<&'static str> {
    match (kind, allowed.focus && !disabled) {
        (Kind::Other, true) => Some("0"),
        (Kind::Other, false) if allowed.focus => Some("-1"),
        (Kind::Other, false) => None,
        // Safari leaves buttons and check boxes out of the Tab order unless they ask.
        (_, true) => Some("0"),
        (_, false) => Some("-1"),
    }
}

/// What a browser has to know of a field that text is typed into.
fn describe_typing(attributes: &mut Attributes, node: &Node, input_mode: InputMode) {
    let mode = input_mode(node).or_else(|| roles::input_mode(node));
    attributes.set("inputmode", mode);
    attributes.set("placeholder", node.placeholder().filter(|hint| !hint.is_empty()));
    attributes.set("autocomplete", Some("off"));
    attributes.set("spellcheck", Some("false"));
    if matches!(node.role(), Role::NumberInput | Role::SpinButton) {
        // The unit behind a number is neither a name nor a word.
        attributes.set("autocapitalize", Some("off"));
        attributes.set("autocorrect", Some("off"));
    }
    if node.is_disabled() || node.is_read_only() {
        attributes.set("readonly", Some(""));
    }
}

/// The content of an input.
fn content(node: &Node, kind: Kind) -> Option<String> {
    let value = node.value().unwrap_or_default();
    match kind {
        // egui tells only how long a password is. What is typed stays where it is typed, until egui clears it.
        Kind::Line if node.role() == Role::PasswordInput => value.is_empty().then(String::new),
        Kind::Line | Kind::Lines => Some(value.to_owned()),
        Kind::Stepper => Some(bare_number(value).to_owned()),
        Kind::Range => node.numeric_value().map(|number| number.to_string()),
        Kind::Button | Kind::Check | Kind::Other => None,
    }
}
