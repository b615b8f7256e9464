//! Which HTML element, and which ARIA role, stands for which AccessKit role.
//!
//! A real HTML element is preferred wherever one exists, because browsers and screen readers know how it is operated.
//! Source: the mappings of WAI-ARIA 1.2 and of HTML-AAM 1.0.

use egui::Role;
use egui::accesskit::{Action, Node};

/// How a person uses an element: it decides what keys and events on it mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The browser turns both Enter and Space into a click.
    Button,
    /// A box or a radio button: the browser turns only Space into a click.
    Check,
    /// One line of text.
    Line,
    /// Several lines of text.
    Lines,
    /// One line that holds a number, with steps up and down.
    Stepper,
    /// A number on a track.
    Range,
    /// Anything else: the browser does nothing of its own.
    Other,
}

impl Kind {
    /// Is text typed into it?
    #[must_use]
    pub fn is_text(self) -> bool {
        matches!(self, Self::Line | Self::Lines | Self::Stepper)
    }
}

/// What surrounds a node, where that changes what the node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Within {
    /// Nothing special.
    Page,
    /// A list of options: egui draws its options as buttons.
    ListBox,
    /// A menu: egui draws its items as buttons.
    Menu,
}

/// The HTML form of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The name of the element.
    pub(crate) tag: &'static str,
    /// The `type` of an `<input>` or `<button>`.
    pub(crate) input_type: Option<&'static str>,
    /// The explicit role, where the element alone does not say it, or where its position would hide it.
    pub(crate) role: Option<&'static str>,
    /// How it is used.
    pub(crate) kind: Kind,
    /// Is its name the text inside it? Otherwise the name is an attribute.
    pub(crate) named_by_content: bool,
}

impl Shape {
    const fn new(tag: &'static str, role: Option<&'static str>, kind: Kind) -> Self {
        Self {
            tag,
            input_type: None,
            role,
            kind,
            named_by_content: false,
        }
    }

    /// A box whose name is an attribute.
    const fn part(role: &'static str) -> Self {
        Self::new("div", Some(role), Kind::Other)
    }

    /// An element whose name is the text inside it.
    const fn text(tag: &'static str, role: Option<&'static str>) -> Self {
        Self {
            named_by_content: true,
            ..Self::new(tag, role, Kind::Other)
        }
    }

    const fn button(role: Option<&'static str>) -> Self {
        Self {
            input_type: Some("button"),
            named_by_content: true,
            ..Self::new("button", role, Kind::Button)
        }
    }

    const fn input(input_type: &'static str, role: Option<&'static str>, kind: Kind) -> Self {
        Self {
            input_type: Some(input_type),
            ..Self::new("input", role, kind)
        }
    }
}

/// The HTML form of `node`, or `None` when it has no meaning of its own and only its children count.
pub(crate) fn shape(node: &Node, within: Within) -> Option<Shape> {
    let role = node.role();
    let is_nothing = matches!(
        role,
        Role::TextRun | Role::ScrollBar | Role::Caret | Role::LineBreak | Role::ListMarker
    );
    if is_nothing || is_bare(node) {
        return None;
    }
    let shape = words(node)
        .or_else(|| button(role, within))
        .or_else(|| input(role))
        .or_else(|| table_or_list(role))
        .or_else(|| section(role));
    Some(shape.unwrap_or(Shape::part("group")))
}

/// What is read.
fn words(node: &Node) -> Option<Shape> {
    Some(match node.role() {
        Role::Label | Role::Paragraph | Role::Strong | Role::Emphasis | Role::Mark | Role::Abbr | Role::Legend => Shape::text("span", None),
        Role::Heading => Shape::text(heading(node.level()), None),
        Role::Link => Shape::text("a", Some("link")),
        Role::Caption | Role::FigureCaption => Shape::text("div", Some("caption")),
        Role::Code => Shape::text("code", None),
        Role::Blockquote => Shape::text("blockquote", None),
        Role::Time => Shape::text("time", None),
        Role::Tooltip => Shape::text("div", Some("tooltip")),
        Role::Term => Shape::text("div", Some("term")),
        Role::Definition => Shape::text("div", Some("definition")),
        Role::Note | Role::Comment => Shape::text("div", Some("note")),
        Role::Math => Shape::part("math"),

        Role::Status => Shape::text("div", Some("status")),
        Role::Alert => Shape::text("div", Some("alert")),
        Role::Log => Shape::text("div", Some("log")),
        Role::Timer => Shape::text("div", Some("timer")),
        Role::Marquee => Shape::text("div", Some("marquee")),
        _ => return None,
    })
}

/// What is clicked.
fn button(role: Role, within: Within) -> Option<Shape> {
    Some(match (role, within) {
        (Role::Button | Role::DefaultButton, Within::ListBox) => Shape::button(Some("option")),
        (Role::Button | Role::DefaultButton, Within::Menu) => Shape::button(Some("menuitem")),
        (Role::Button | Role::DefaultButton | Role::ColorWell | Role::DisclosureTriangle, _) => Shape::button(None),
        (Role::Tab, _) => Shape::button(Some("tab")),
        (Role::MenuItem, _) => Shape::button(Some("menuitem")),
        (Role::MenuItemCheckBox, _) => Shape::button(Some("menuitemcheckbox")),
        (Role::MenuItemRadio, _) => Shape::button(Some("menuitemradio")),
        (Role::ListBoxOption | Role::MenuListOption, _) => Shape::button(Some("option")),
        (Role::TreeItem, _) => Shape::text("div", Some("treeitem")),
        // Its content is the value; the name stands beside it.
        (Role::ComboBox, _) => Shape {
            named_by_content: false,
            ..Shape::button(Some("combobox"))
        },
        _ => return None,
    })
}

/// What is filled in, ticked or set, and what shows a number in the same way.
fn input(role: Role) -> Option<Shape> {
    Some(match role {
        Role::CheckBox => Shape::input("checkbox", None, Kind::Check),
        Role::Switch => Shape::input("checkbox", Some("switch"), Kind::Check),
        Role::RadioButton => Shape::input("radio", None, Kind::Check),
        Role::Slider => Shape::input("range", None, Kind::Range),
        Role::SpinButton => Shape::input("text", Some("spinbutton"), Kind::Stepper),
        Role::EditableComboBox => Shape::input("text", Some("combobox"), Kind::Line),
        Role::SearchInput => Shape::input("text", Some("searchbox"), Kind::Line),
        Role::PasswordInput => Shape::input("password", None, Kind::Line),
        Role::MultilineTextInput => Shape::new("textarea", None, Kind::Lines),
        // Not the types "number", "date" and so on: they refuse text that the application accepts ("1,5", "12 mm").
        Role::TextInput
        | Role::NumberInput
        | Role::EmailInput
        | Role::PhoneNumberInput
        | Role::UrlInput
        | Role::DateInput
        | Role::DateTimeInput
        | Role::WeekInput
        | Role::MonthInput
        | Role::TimeInput => Shape::input("text", None, Kind::Line),

        Role::ProgressIndicator => Shape::part("progressbar"),
        Role::Meter => Shape::part("meter"),
        Role::Splitter => Shape::part("separator"),
        _ => return None,
    })
}

/// Tables, lists and their parts. The roles are repeated, because a positioned table, row or list is no longer one to every
/// browser.
fn table_or_list(role: Role) -> Option<Shape> {
    Some(match role {
        Role::Table | Role::ListGrid => Shape::new("table", Some("table"), Kind::Other),
        Role::Grid => Shape::new("table", Some("grid"), Kind::Other),
        Role::TreeGrid => Shape::new("table", Some("treegrid"), Kind::Other),
        Role::RowGroup => Shape::new("tbody", Some("rowgroup"), Kind::Other),
        Role::Row => Shape::new("tr", Some("row"), Kind::Other),
        Role::ColumnHeader => Shape::text("th", Some("columnheader")),
        Role::RowHeader => Shape::text("th", Some("rowheader")),
        Role::Cell => Shape::text("td", Some("cell")),
        Role::GridCell => Shape::text("td", Some("gridcell")),
        Role::List | Role::DescriptionList => Shape::new("ul", Some("list"), Kind::Other),
        Role::ListItem => Shape::text("li", Some("listitem")),
        _ => return None,
    })
}

/// Pictures, and what groups other elements.
fn section(role: Role) -> Option<Shape> {
    Some(match role {
        Role::Image | Role::Canvas | Role::GraphicsObject | Role::GraphicsSymbol | Role::SvgRoot => Shape::part("img"),
        Role::Figure | Role::GraphicsDocument => Shape::part("figure"),
        Role::ListBox => Shape::part("listbox"),
        Role::Menu | Role::MenuListPopup => Shape::part("menu"),
        Role::MenuBar => Shape::part("menubar"),
        Role::Tree => Shape::part("tree"),
        Role::TabList => Shape::part("tablist"),
        Role::TabPanel => Shape::part("tabpanel"),
        Role::RadioGroup => Shape::part("radiogroup"),
        Role::Toolbar => Shape::part("toolbar"),
        Role::Dialog | Role::Window => Shape::part("dialog"),
        Role::AlertDialog => Shape::part("alertdialog"),
        Role::Article => Shape::new("article", None, Kind::Other),
        Role::Feed => Shape::part("feed"),
        Role::Main => Shape::new("main", None, Kind::Other),
        Role::Navigation => Shape::new("nav", None, Kind::Other),
        Role::Banner => Shape::part("banner"),
        Role::ContentInfo => Shape::part("contentinfo"),
        Role::Complementary => Shape::new("aside", None, Kind::Other),
        Role::Form => Shape::part("form"),
        Role::Search => Shape::part("search"),
        Role::Document => Shape::part("document"),
        Role::Application => Shape::part("application"),
        Role::Region | Role::Pane => Shape::part("region"),
        _ => return None,
    })
}

/// A container, or something unknown, that nobody named and nobody can operate.
fn is_bare(node: &Node) -> bool {
    let container = matches!(
        node.role(),
        Role::GenericContainer
            | Role::Group
            | Role::LayoutTable
            | Role::LayoutTableCell
            | Role::LayoutTableRow
            | Role::Pane
            | Role::Region
            | Role::RootWebArea
            | Role::ScrollView
            | Role::Section
            | Role::TitleBar
            | Role::Unknown
            | Role::Window
    );
    container
        && node.label().is_none_or(str::is_empty)
        && node.labelled_by().is_empty()
        && node.live().is_none()
        && !node.supports_action(Action::Focus)
}

fn heading(level: Option<usize>) -> &'static str {
    match level {
        Some(1) => "h1",
        Some(3) => "h3",
        Some(4) => "h4",
        Some(5) => "h5",
        Some(6..) => "h6",
        _ => "h2",
    }
}

/// The on-screen keyboard that suits a text field: a value of HTML's `inputmode`.
///
/// Not the number keyboard for a number that may be negative or stand with a unit: on an iPhone it has neither a minus nor letters. A
/// field says that it takes neither by a least value that is not negative.
pub(crate) fn input_mode(node: &Node) -> Option<&'static str> {
    match node.role() {
        Role::NumberInput | Role::SpinButton => {
            let is_bare = node.min_numeric_value().is_some_and(|least| least >= 0.0);
            Some(if is_bare { "decimal" } else { "text" })
        }
        Role::EmailInput => Some("email"),
        Role::PhoneNumberInput => Some("tel"),
        Role::UrlInput => Some("url"),
        Role::SearchInput => Some("search"),
        _ => None,
    }
}
