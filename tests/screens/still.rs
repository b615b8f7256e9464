//! Nothing moves while somebody types: whatever is typed, key by key, all that is there before and after a key keeps its place.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, Program, W_IMG, W_REAL, type_sigma};
use egui::accesskit::{NodeId, Role};
use egui::{Event, Key, Modifiers, Rect, Vec2, vec2};
use egui_kittest::Node;
use egui_kittest::kittest::NodeT as _;
use std::collections::BTreeMap;

/// The fields of a distance.
const FIELDS: [&str; 5] = [FX, B, D, W_IMG, W_REAL];
/// Random edits from each of the three states.
const EDITS: u32 = 70;
/// Points by which rounding may move something.
const ROUNDING: f32 = 0.51;

/// What is typed over what a field has.
const TEXTS: [&str; 24] = [
    "700",
    "0.1",
    "50",
    "1400.25",
    "1e-12",
    "123456789012",
    "9e9",
    "0",
    "-12",
    "1,000",
    "1.000,5",
    "abc",
    "1 1/8 in",
    "50 ± 0.5 px",
    "10 cm",
    "3 %",
    "±",
    "5'11\"",
    "0.75 mrad",
    "7 parsec",
    "1e999",
    "−",
    ".",
    " ",
];

/// A simple generator (Knuth's MMIX): the same edits on every machine.
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % count
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

/// Where something is, and what it says.
#[derive(Clone, Debug)]
struct Thing {
    role: Role,
    text: String,
    rect: Rect,
    /// Whether it stands in a row of numbers or words that are as wide as they are: a line of the strip, the table.
    flows: bool,
}

/// What is on the screen but for the control of the field `edited`.
fn things(program: &Program, edited: &str) -> BTreeMap<NodeId, Thing> {
    let mut all = BTreeMap::new();
    for node in program.harness.root().children_recursive() {
        let inner = node.accesskit_node();
        let role = inner.role();
        let text = inner.label().or_else(|| inner.value()).unwrap_or_default();
        let is_edited = text == edited || text.ends_with(&format!(" of {edited}"));
        let is_correction = text.starts_with("Use ") || text.starts_with("Multiply ");
        // A text run is a part of its text; a slider stands where its value is.
        let is_part = matches!(role, Role::TextRun | Role::Slider);
        if is_edited || is_correction || is_part || inner.raw_bounds().is_none() || is_pushed(&node) {
            continue;
        }
        let flows = flows(&node);
        let thing = Thing {
            role,
            text,
            rect: node.rect(),
            flows,
        };
        all.insert(inner.locate().0, thing);
    }
    all
}

/// The cards at the end of everything, that come and go with what there is to say: each is pushed by those above it.
const LAST: [&str; 4] = ["Remarks", "How it works", "Stereo, simulated", "Monocular, simulated"];

fn is_pushed(node: &Node<'_>) -> bool {
    let mut above = std::iter::successors(node.parent(), Node::parent);
    above.any(|node| {
        let node = node.accesskit_node();
        node.role() == Role::Region && node.label().is_some_and(|name| LAST.contains(&name.as_str()))
    })
}

/// Whether what stands left of a node may be wider by a key: in the second and later parts of a line of the strip, and in the table,
/// whose numbers stand at their decimal points.
fn flows(node: &Node<'_>) -> bool {
    let mut above = std::iter::successors(node.parent(), Node::parent);
    above.any(|node| matches!(node.accesskit_node().role(), Role::Table | Role::Region))
        && matches!(node.accesskit_node().role(), Role::Label | Role::Link)
}

/// What of `before` is elsewhere in `after`, in words.
fn moved(before: &BTreeMap<NodeId, Thing>, after: &BTreeMap<NodeId, Thing>) -> Vec<String> {
    let both = before.iter().filter_map(|(id, old)| Some((old, after.get(id)?)));
    let moved = both.filter(|(old, new)| !is_in_place(old, new));
    moved
        .map(|(old, new)| format!("{:?} {:?} → {:?}: {} → {}", old.role, old.text, new.text, old.rect, new.rect))
        .collect()
}

fn is_in_place(old: &Thing, new: &Thing) -> bool {
    let differs = |a: f32, b: f32| (a - b).abs() > ROUNDING;
    let (was, is) = (old.rect, new.rect);
    // A picture is as high as it has rows.
    if old.role == Role::Image {
        return !differs(was.left(), is.left()) && !differs(was.top(), is.top()) && !differs(was.right(), is.right());
    }
    if differs(was.center().y, is.center().y) {
        return false;
    }
    // Another text is as wide as it is, from its left or its right edge; one that follows it in its line stands behind it.
    let is_aligned = !differs(was.left(), is.left()) || old.text != new.text && !differs(was.right(), is.right());
    let is_as_large = !differs(was.right(), is.right()) && !differs(was.top(), is.top());
    old.flows || is_aligned && (old.text != new.text || is_as_large)
}

fn key_event(key: Key, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

/// The keys of one random edit: what was there is kept, shortened or replaced.
fn keys(dice: &mut Dice) -> Vec<Event> {
    let typed = |text: &str| text.chars().map(|letter| Event::Text(letter.to_string())).collect::<Vec<_>>();
    let end = key_event(Key::End, Modifiers::NONE);
    let back = key_event(Key::Backspace, Modifiers::NONE);
    let all = key_event(Key::A, Modifiers::COMMAND);
    match dice.below(4) {
        0 => [vec![end], vec![back; 1 + dice.below(3)]].concat(),
        1 => [vec![end], typed(dice.one_of(&["0", "5", ".", "e3", " cm", "%", "x", "/3"]))].concat(),
        2 => vec![all, back],
        _ => [vec![all], typed(dice.one_of(&TEXTS))].concat(),
    }
}

/// Presses a key, and says what moved: by the key, and between the first frame after it and the last.
fn press(program: &mut Program, field: &str, event: Event) -> [Vec<String>; 2] {
    let before = things(program, field);
    program.harness.input_mut().events.push(event);
    program.harness.step();
    let first = things(program, field);
    program.harness.run();
    let last = things(program, field);
    [moved(&before, &first), moved(&first, &last)]
}

/// Does so many random edits, and says what moved.
fn edit(program: &mut Program, edits: u32, seed: u64) -> Vec<String> {
    let mut dice = Dice(seed);
    let (mut keys_pressed, mut found) = (0, Vec::new());
    for _ in 0..edits {
        let value = dice.one_of(&FIELDS);
        let field = if dice.below(3) == 0 {
            format!("Uncertainty of {value}")
        } else {
            value.to_owned()
        };
        program.input(&field).focus();
        program.harness.run();
        for event in keys(&mut dice) {
            keys_pressed += 1;
            let what = match &event {
                Event::Key { key, .. } => format!("{key:?}"),
                event => format!("{event:?}"),
            };
            let [by_key, afterwards] = press(program, value, event);
            found.extend(by_key.into_iter().map(|thing| format!("{what} in {field}: {thing}")));
            found.extend(
                afterwards
                    .into_iter()
                    .map(|thing| format!("after the first frame of {what} in {field}: {thing}")),
            );
        }
    }
    println!("{keys_pressed} keys, {} things moved", found.len());
    found
}

/// A form with everything in it.
fn fill(program: &mut Program) {
    program.mug();
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.30");
    for (field, sigma) in [(FX, "2"), (B, "0.5"), (D, "0.5"), (W_IMG, "2"), (W_REAL, "0.01")] {
        type_sigma(program, field, sigma);
    }
}

fn check(size: Vec2, (edits, seed): (u32, u64), prepare: impl Fn(&mut Program)) {
    let mut program = Program::on(Machine::default(), size);
    prepare(&mut program);
    let moved = edit(&mut program, edits, seed);
    let shown = moved.iter().take(200).cloned().collect::<Vec<_>>().join("\n");
    assert!(moved.is_empty(), "{} things moved, of which\n{shown}", moved.len());
}

#[test]
fn nothing_moves_while_an_empty_form_is_filled_in() {
    check(DESKTOP, (EDITS, 1), |_| {});
}

#[test]
fn nothing_moves_while_a_full_form_is_edited() {
    check(DESKTOP, (EDITS, 2), fill);
}

#[test]
fn nothing_moves_while_a_form_with_an_error_is_edited() {
    check(DESKTOP, (EDITS, 3), |program| {
        fill(program);
        program.type_into(D, "-12");
    });
}

#[test]
fn nothing_moves_on_a_phone_while_a_full_form_is_edited() {
    check(vec2(390.0, 4000.0), (EDITS / 2, 4), fill);
}

#[test]
fn nothing_moves_on_a_wide_screen_while_a_full_form_is_edited() {
    check(vec2(1920.0, 1080.0), (EDITS / 2, 5), fill);
}
