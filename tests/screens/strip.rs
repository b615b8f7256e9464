//! The strip of the answer, however long its numbers are.

use crate::machine::Machine;
use crate::program::{B, D, FX, Program, W_IMG, W_REAL, type_sigma};
use egui::accesskit::Role;
use egui::{Rangef, Rect, vec2};
use egui_kittest::Node;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const TITLES: [&str; 3] = ["Stereo", "Monocular", "Combined"];
const WIDTHS: [f32; 4] = [390.0, 768.0, 1280.0, 1920.0];

/// Values as people will not type them, each with a σ: fx, b, d, w_img, w_real.
const LONG: [[[&str; 2]; 5]; 5] = [
    [["700", "2"], ["1e-12", "1e-13"], ["50", "0.5"], ["150", "2"], ["1e-12", "3e-13"]],
    [["1e9", "1e7"], ["1e9", "1e7"], ["1", "0.01"], ["1", "0.01"], ["1e9", "1e7"]],
    [
        ["123456.789012", "0.000001"],
        ["123456789.012", "0.001"],
        ["0.123456789012", "1e-9"],
        ["1.23456789012", "1e-9"],
        ["987654321.012", "0.001"],
    ],
    [
        ["700", "9999"],
        ["100", "123456"],
        ["50", "200"],
        ["150", "1e6"],
        ["0.3", "12345.678"],
    ],
    [["700", ""], ["100", ""], ["50", "0.5"], ["150", ""], ["3.1", ""]],
];

/// What is painted in a cell: the texts of its nodes, and the choice of the unit.
fn parts(cell: &Node<'_>) -> Vec<(String, Rect)> {
    let shown = cell.children_recursive().filter_map(|node| {
        let inner = node.accesskit_node();
        let is_part = matches!(inner.role(), Role::Label | Role::Heading | Role::Link | Role::ComboBox);
        let text = inner.value().or_else(|| inner.label()).unwrap_or_default();
        (is_part && inner.raw_bounds().is_some() && !text.is_empty()).then(|| (text, node.rect()))
    });
    shown.collect()
}

/// From the edge of a cell to what stands in it.
const PADDING: f32 = 16.0;

fn heading(program: &Program, title: &str) -> Rect {
    let cell = program.harness.get_by_role_and_label(Role::Region, title);
    cell.get_by_role(Role::Heading).rect()
}

/// From where to where each cell goes: from its title to that of the next or, as the unit stands at its end, to the end of the strip.
fn cells(program: &Program) -> [Rangef; 3] {
    let unit = program.harness.get_by_role_and_label(Role::ComboBox, "Unit of the results");
    let end = unit.rect().right() + PADDING;
    let dot = 12.0;
    let lefts = TITLES.map(|title| heading(program, title).left() - dot - PADDING);
    let is_row = lefts[0] < lefts[1];
    let right = |index: usize| if is_row && index < 2 { lefts[index + 1] } else { end };
    [0, 1, 2].map(|index| Rangef::new(lefts[index], right(index)))
}

/// What is wrong with the strip, in words.
fn faults(program: &Program) -> Vec<String> {
    let mut found = Vec::new();
    for (title, bounds) in TITLES.into_iter().zip(cells(program)) {
        let cell = program.harness.get_by_role_and_label(Role::Region, title);
        let parts = parts(&cell);
        assert!(parts.len() > 2, "{title}: {parts:?}");
        for (index, (text, rect)) in parts.iter().enumerate() {
            if rect.left() < bounds.min || rect.right() > bounds.max {
                found.push(format!("{title}: {text:?} at {rect} leaves {} to {}", bounds.min, bounds.max));
            }
            let others = parts.iter().skip(index + 1);
            let over = others.filter(|(_, other)| {
                let shared = rect.intersect(*other);
                shared.width() > 0.5 && shared.height() > 0.25 * rect.height().min(other.height())
            });
            found.extend(over.map(|(other, _)| format!("{title}: {text:?} lies over {other:?}")));
        }
    }
    found
}

#[test]
fn no_text_of_the_answer_leaves_its_cell_or_lies_over_another() {
    let mut found = Vec::new();
    for width in WIDTHS {
        let mut program = Program::on(Machine::default(), vec2(width, 900.0));
        for numbers in LONG {
            for (field, [value, sigma]) in [FX, B, D, W_IMG, W_REAL].into_iter().zip(numbers) {
                program.type_into(field, value);
                program.type_into(&format!("Uncertainty of {field}"), sigma);
            }
            found.extend(
                faults(&program)
                    .into_iter()
                    .map(|fault| format!("at {width}, {numbers:?}: {fault}")),
            );
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found.join("\n"));
}

#[test]
fn the_answer_is_as_high_whatever_is_known() {
    for width in WIDTHS {
        // As high as all of it, so that nothing scrolls.
        let mut program = Program::on(Machine::default(), vec2(width, 4000.0));
        // The places of the titles, and that of the card below.
        let places = |program: &Program, below: &str| {
            let card = program.harness.get_by_role_and_label(Role::Heading, below).rect();
            (TITLES.map(|title| heading(program, title).left_top()), card.left_top())
        };
        let before = places(&program, "What the letters mean");
        program.two_distances();
        let after = |program: &Program| places(program, "Stereo against monocular");
        assert_eq!(after(&program), before, "two distances at {width}");
        program.type_into(W_REAL, "3.1");
        assert_eq!(after(&program), before, "disagreeing at {width}");
        program.type_into(D, "-12");
        assert_eq!(after(&program), before, "an error at {width}");
        type_sigma(&mut program, FX, "many");
        assert_eq!(after(&program), before, "two errors at {width}");
    }
}
