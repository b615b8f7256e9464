//! The answer strip says what the page shows.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::{Example, Inputs};
use depth_text::report::{Cell, Mode, Part, Quality, Shown, Strip, Value};

/// What is typed: a value with its σ a field, as `700 ± 2`.
fn form(fields: &[(&str, &str)]) -> Inputs {
    let mut inputs = Inputs::default();
    for (name, text) in fields {
        let key = Key::named(name).unwrap();
        inputs.entry_mut(key).text = (*text).to_owned();
        inputs.tidy(key);
    }
    inputs
}

const MUG: [(&str, &str); 5] = [
    ("fx", "700 ± 2"),
    ("b", "100 ± 0.5"),
    ("d", "50 ± 0.5"),
    ("wimg", "150 ± 2"),
    ("wreal", "0.30 ± 0.01"),
];

fn strip(mode: Mode, inputs: &Inputs, was: Option<&Assessment>) -> [Cell; 3] {
    let assessment = inputs.assess();
    let shown = Shown {
        inputs,
        assessment: &assessment,
        unit: LengthUnit::Meter,
        was,
    };
    Strip::new(mode, &shown).cells
}

/// "Stereo | fx · b / d | (1.400 ± 0.016) m | 1.384…1.416 m · 75 % from d | 700 px · 0.1 m / 50 px"
fn texts(cells: &[Cell; 3]) -> [String; 3] {
    cells.clone().map(|cell| {
        let badge = cell.badge.map_or_else(String::new, |badge| format!(" ({})", badge.text));
        let [first, second] = cell.lines.clone().map(|line| line.text());
        format!(
            "{}{badge} | {} | {} | {first} | {second}",
            cell.title,
            cell.formula,
            cell.value.text()
        )
    })
}

#[test]
fn why_the_combined_sigma_is_wider_than_both_is_said() {
    // 1.400 m and 1.493 m, 1.8 σ apart: 1.8 times what both together would have.
    let mut apart = MUG;
    apart[4] = ("wreal", "0.32 ± 0.01");
    let [_, _, combined] = texts(&strip(Mode::Distance, &form(&apart), None));
    assert!(
        combined.ends_with("1.8 σ apart, so ± is 1.8 times as wide | The shared fx is counted once"),
        "{combined}"
    );
}

#[test]
fn a_refused_focal_length_is_named_where_the_rest_is_still_missing() {
    let [stereo, ..] = texts(&strip(Mode::Distance, &form(&[("fx", "-7")]), None));
    assert_eq!(
        stereo,
        "Stereo | fx · b / d | needs b and d | No distance: fx must be above 0 px. | The focal length cannot be negative."
    );
}

#[test]
fn equal_distances_are_called_equal() {
    let exact = [("fx", "700"), ("b", "100"), ("d", "50"), ("wimg", "150"), ("wreal", "0.30")];
    let [_, _, combined] = texts(&strip(Mode::Distance, &form(&exact), None));
    assert_eq!(
        combined,
        "Combined |  | needs ± in both | Both distances are equal | Add ± to both to see if they agree"
    );
}

#[test]
fn a_distance_has_its_interval_its_cause_and_its_numbers() {
    let cells = strip(Mode::Distance, &form(&MUG), None);
    assert_eq!(
        texts(&cells),
        [
            "Stereo | fx · b / d | (1.400 ± 0.016) m | 1.384…1.416 m · 75 % from d | 700 px · 0.1 m / 50 px",
            "Monocular | w_real · fx / w_img | (1.400 ± 0.050) m | 1.350…1.451 m · 86 % from w_real | 0.30 m · 700 px / 150 px",
            "Combined (Agree) |  | (1.400 ± 0.015) m | 0 σ apart; stereo weighs 91 % | The shared fx is counted once",
        ]
    );
    let [stereo, _, combined] = &cells;
    assert_eq!(
        stereo.lines[1].parts,
        [
            Part::Field(fields::FOCAL_LENGTH, "700 px".into()),
            Part::Text(" · ".into()),
            Part::Field(fields::BASELINE, "0.1 m".into()),
            Part::Text(" / ".into()),
            Part::Field(fields::DISPARITY, "50 px".into()),
        ]
    );
    assert_eq!(stereo.lines[0].parts.last(), Some(&Part::Field(fields::DISPARITY, "d".into())));
    assert_eq!(combined.badge.unwrap().quality, Quality::Good);
}

#[test]
fn an_empty_form_shows_the_computed_example() {
    let cells = strip(Mode::Distance, &Inputs::default(), None);
    assert_eq!(
        texts(&cells),
        [
            "Stereo | fx · b / d | needs fx, b and d | Example: 700 px · 0.1 m / 50 px | = (1.400 ± 0.016) m",
            "Monocular | w_real · fx / w_img | needs fx, w_img and w_real | Example: 0.30 m · 700 px / 150 px | = (1.400 ± 0.050) m",
            "Combined |  | needs both distances | Example: (1.400 ± 0.015) m | One number, and whether the two agree",
        ]
    );
    assert_eq!(
        cells[0].value,
        Value::Needs(vec![fields::FOCAL_LENGTH, fields::BASELINE, fields::DISPARITY])
    );
}

#[test]
fn while_an_input_is_refused_the_last_value_stands() {
    let was = form(&MUG).assess();
    let mut inputs = form(&MUG);
    inputs.entry_mut(Field::Disparity).text = "−12".into();
    let cells = strip(Mode::Distance, &inputs, Some(&was));
    assert_eq!(
        texts(&cells),
        [
            "Stereo | fx · b / d | was 1.400 m | No distance: d must be above 0 px. | −12 px would lie behind the cameras.",
            "Monocular | w_real · fx / w_img | (1.400 ± 0.050) m | 1.350…1.451 m · 86 % from w_real | 0.30 m · 700 px / 150 px",
            "Combined |  | was 1.400 m | Needs both distances; stereo is missing. | Until then monocular stands alone.",
        ]
    );
    assert!(cells[0].lines[0].is_refusal && cells[0].remarks[0].contains("swapped"));
    assert_eq!(cells[0].lines[0].parts[1], Part::Field(fields::DISPARITY, "d".into()));
    inputs.entry_mut(Field::Disparity).text = "5o".into();
    let cells = strip(Mode::Distance, &inputs, None);
    assert_eq!(
        texts(&cells)[0],
        "Stereo | fx · b / d |  | No distance: d cannot be read. | “o” is not a unit known here."
    );
}

#[test]
fn a_disagreement_names_the_two_likeliest_causes() {
    let mut inputs = form(&MUG);
    inputs.entry_mut(Field::RealWidth).text = "300 cm".into();
    inputs.set_sigma(Field::RealWidth, "10");
    inputs.tidy(Field::RealWidth);
    let cells = strip(Mode::Distance, &inputs, None);
    assert_eq!(
        texts(&cells)[1..],
        [
            "Monocular | w_real · fx / w_img | (14.00 ± 0.50) m | 13.50…14.51 m · 86 % from w_real | 3 m · 700 px / 150 px",
            "Combined (Disagree) |  | Monocular is 10 times as far | Is w_real really in cm? In mm they would agree. | Is b really in mm? In cm they would agree.",
        ]
    );
    assert_eq!(cells[2].badge.unwrap().quality, Quality::Bad);
}

#[test]
fn without_sigma_a_pixel_says_how_sure_it_is() {
    let cells = strip(Mode::Distance, &Example::CoffeeMug.inputs(), None);
    assert_eq!(
        texts(&cells)[0],
        "Stereo | fx · b / d | 1.400 m | 1.373…1.429 m with d ± 1 px | 700 px · 0.1 m / 50 px"
    );
    let mut both = Example::CoffeeMug.inputs();
    both.entry_mut(Field::ImageWidth).text = "150".into();
    both.entry_mut(Field::RealWidth).text = "0.31".into();
    assert_eq!(
        texts(&strip(Mode::Distance, &both, None))[2],
        "Combined |  | needs ± in both | Monocular is 1.03 times as far | Add ± to both to see if they agree"
    );
}

#[test]
fn what_was_remarked_before_still_is() {
    let mut tilted = Example::Doorway.inputs();
    tilted.entry_mut(Field::Tilt).text = "60".into();
    let remarks = |inputs: &Inputs, cell: usize| strip(Mode::Distance, inputs, None)[cell].remarks.join(" ");
    assert!(
        remarks(&tilted, 1).contains("Monocular without the tilt: 4.275 m."),
        "{}",
        remarks(&tilted, 1)
    );
    let poor = form(&[("fx", "700"), ("b", "100"), ("d", "50 ± 20")]);
    assert!(remarks(&poor, 0).contains("± σ describes this poorly"), "{}", remarks(&poor, 0));
    let lens = form(&[("fx", "4000"), ("fx-lens", "16"), ("b", "20"), ("d", "400")]);
    assert!(remarks(&lens, 0).contains("16.00 mm of the lens"), "{}", remarks(&lens, 0));
    let mil = form(&[("wimg", "0.75 mil"), ("wreal", "10 in")]);
    assert!(remarks(&mil, 1).contains("NATO"), "{}", remarks(&mil, 1));
    let only_b = form(&[("fx", "700"), ("b", "100 ± 0.5"), ("d", "50")]);
    assert!(remarks(&only_b, 0).contains("one pixel of disparity"), "{}", remarks(&only_b, 0));
}

#[test]
fn a_solved_disparity_has_its_meaning_and_the_form_of_opencv() {
    let mut inputs = form(&[("fx", "700 ± 2"), ("b", "100 ± 0.5"), ("distance", "1.40 ± 0.01")]);
    inputs.unknown = Some((Method::Stereo, Field::Disparity));
    assert_eq!(
        texts(&strip(Mode::Quantity, &inputs, None)),
        [
            "Disparity | fx · b / D | (50.00 ± 0.46) px | 49.54…50.46 px · 60 % from D | 700 px · 0.1 m / 1.40 m",
            "One pixel at this distance | D / d | 28 mm | One less, 49 px: 1.429 m | One more, 51 px: 1.373 m",
            "For OpenCV | d × 16 | (800.0 ± 7.3) | As StereoBM returns it | numDisparities: 64 or more",
        ]
    );
    inputs.entry_mut(fields::DISTANCE).text.clear();
    assert_eq!(strip(Mode::Quantity, &inputs, None)[0].value, Value::Needs(vec![fields::DISTANCE]));
}

#[test]
fn every_solvable_quantity_has_three_cells() {
    for method in Method::ALL {
        for field in method.unknowns() {
            let mut inputs = form(&MUG);
            inputs.entry_mut(fields::DISTANCE).text = "1.4 ± 0.01".into();
            inputs.tidy(fields::DISTANCE);
            inputs.unknown = Some((method, field));
            let cells = strip(Mode::Quantity, &inputs, None);
            for cell in &cells {
                assert!(matches!(cell.value, Value::Number { .. }), "{field:?}: {cell:?}");
                assert!(
                    !cell.title.is_empty() && !cell.formula.is_empty() && cell.lines[0].text() != "",
                    "{field:?}: {cell:?}"
                );
            }
            assert_eq!(cells[0].title, Key::from(field).label);
            assert!(!cells[0].lines[1].text().is_empty(), "{field:?}");
        }
    }
}

#[test]
fn the_ground_plane_is_ahead_to_the_right_and_along() {
    let inputs = form(&[
        ("fx", "700"),
        ("fy", "700"),
        ("cx", "640"),
        ("cy", "360"),
        ("camera-height", "1.20 ± 0.05"),
        ("camera-pitch", "10 ± 0.5"),
        ("floor-column", "1100"),
        ("floor-row", "500"),
    ]);
    assert_eq!(
        texts(&strip(Mode::Ground, &inputs, None)),
        [
            "Straight ahead | H / tan(θ + α) | (3.08 ± 0.15) m | 72 % from H, 28 % from θ | 1.20 m / tan(10° + 11.31°)",
            "To the right | depth · (u − cx) / fx | (2.13 ± 0.10) m | 78 % from H, 22 % from θ | 3.238 m · 460 px / 700 px",
            "Along the floor | √(ahead² + right²) | (3.74 ± 0.18) m | √(3.076² + 2.128²) m | Slant, from the lens: (3.93 ± 0.19) m",
        ]
    );
    let missing = strip(Mode::Ground, &Inputs::default(), None);
    let needs = vec![
        fields::FOCAL_LENGTH,
        fields::CY,
        fields::CAMERA_HEIGHT,
        fields::CAMERA_PITCH,
        fields::FLOOR_ROW,
    ];
    assert_eq!(missing[0].value, Value::Needs(needs));
    let mut up = inputs.clone();
    up.entry_mut(fields::CAMERA_PITCH).text = "-30".into();
    let cells = strip(Mode::Ground, &up, Some(&inputs.assess()));
    assert_eq!(cells[0].value, Value::Was("3.08 m".into()));
    assert!(cells[0].lines[0].is_refusal);
}

#[test]
fn the_further_ways_have_their_cells() {
    let shots = form(&[("far-px", "1162"), ("near-px", "1429"), ("step", "0.4191"), ("fx", "4000")]);
    let cells = texts(&strip(Mode::TwoShots, &shots, None));
    assert!(cells[0].starts_with("From the first place | s · w_2 / (w_2 − w_1) | (2.243 ± 0.011) m | 0.4191 m · 1429 / (1429 − 1162) | ± is for 1 px in each width"), "{cells:?}");
    let points = form(&[
        ("fx", "452.9"),
        ("b", "75"),
        ("cx", "298.85"),
        ("cy", "245.52"),
        ("from-u", "138"),
        ("from-v", "219"),
        ("from-d", "36 ± 0.5"),
        ("to-u", "264"),
        ("to-v", "216"),
        ("to-d", "30 ± 0.5"),
    ]);
    let cells = texts(&strip(Mode::TwoPoints, &points, None));
    assert!(cells[0].contains("(0.312 ± 0.011) m"), "{cells:?}");
    for mode in [Mode::TwoShots, Mode::TwoPoints] {
        for cell in strip(mode, &Inputs::default(), None) {
            assert!(matches!(cell.value, Value::Needs(_)), "{cell:?}");
        }
    }
}
