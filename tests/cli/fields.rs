//! Every field of the table, through everything that is made from the table: a field added there needs no other edit, and
//! none of these can forget it.

use super::{run, run_words};
use depth_calculator::core::angle::AngleUnit;
use depth_calculator::core::problem::Field;
use depth_calculator::core::quantity::LengthUnit;
use depth_text::entry::{Entries, Entry};
use depth_text::export::{Exporter as _, Provenance, Results, Text};
use depth_text::field::{Key, Kind, Section};
use depth_text::fields::{CAMERA_PITCH, DISTANCE, FLOOR_ANGLE, FLOOR_ROW, FOCAL_LENGTH, TABLE, TAPED_RANGE, TARGET_HEIGHT, ZERO};
use depth_text::form::Inputs;
use depth_text::link;
use depth_text::note::Issue;
use depth_text::reading::{read, read_with_sigma};
use depth_text::unit::Unit;

/// Every unit, with the words for it.
const UNITS: [(Unit, &[&str]); 18] = [
    (Unit::Pixel, &["px", "pixels"]),
    (Unit::Length(LengthUnit::Millimeter), &["mm", "millimeters"]),
    (Unit::Length(LengthUnit::Centimeter), &["cm", "centimeter"]),
    (Unit::Length(LengthUnit::Meter), &["m", "meters"]),
    (Unit::Length(LengthUnit::Kilometer), &["km", "kilometers"]),
    (Unit::Length(LengthUnit::Inch), &["in", "inch"]),
    (Unit::Length(LengthUnit::Foot), &["ft", "feet"]),
    (Unit::Length(LengthUnit::Yard), &["yd", "yards"]),
    (Unit::Length(LengthUnit::Mile), &["mi", "miles"]),
    (Unit::Length(LengthUnit::Micrometer), &["µm", "μm", "um", "microns"]),
    (Unit::Length(LengthUnit::Nanometer), &["nm", "nanometers"]),
    (Unit::Angle(AngleUnit::Degree), &["°", "deg", "degrees"]),
    (Unit::Angle(AngleUnit::Arcminute), &["arcmin", "arcminutes"]),
    (Unit::Angle(AngleUnit::Arcsecond), &["arcsec", "arcseconds"]),
    (Unit::Angle(AngleUnit::Radian), &["rad", "radians"]),
    (Unit::Angle(AngleUnit::Milliradian), &["mrad", "milliradians"]),
    (Unit::Angle(AngleUnit::MinuteOfAngle), &["MOA", "moa"]),
    (Unit::Angle(AngleUnit::NatoMil), &["mil", "mils", "NATO mil"]),
];

/// The fields with a number in them.
fn numbers() -> impl Iterator<Item = Key> {
    TABLE.iter().copied().filter(|key| key.kind != Kind::Text)
}

/// Something that differs from field to field.
fn some_number(key: Key) -> String {
    // Below the camera, so that a ray that goes down meets it; nearer than the object.
    if key == TARGET_HEIGHT || key == ZERO {
        return "1".to_owned();
    }
    let position = TABLE.iter().position(|&other| other == key).unwrap();
    format!("{}", 20 + position)
}

/// What is typed into the field: a number, the unit chosen beside it, a σ.
fn filled(key: Key) -> Entry {
    Entry {
        text: some_number(key),
        unit: key.is_length().then_some(LengthUnit::Inch),
        sigma: if key.has_sigma { "1 %".into() } else { String::new() },
        ..Entry::default()
    }
}

#[test]
fn every_field_is_stored_under_its_key() {
    let mut entries = Entries::default();
    for &key in TABLE {
        *entries.entry_mut(key) = filled(key);
    }
    let stored = serde_json::to_value(&entries).unwrap();
    for &key in TABLE {
        assert_eq!(stored[key.as_str()]["text"], some_number(key), "{key:?}");
    }
    assert_eq!(serde_json::from_value::<Entries>(stored.clone()).unwrap(), entries);
    // One that is not known any more is left out, and takes nothing with it.
    let mut later = stored;
    later["no-such-field"] = serde_json::json!({ "text": "1" });
    assert_eq!(serde_json::from_value::<Entries>(later).unwrap(), entries);
}

/// The form with every field filled in, but for the one of two that takes the place of the other.
fn form(left_out: Key) -> Inputs {
    let mut inputs = Inputs::default();
    for key in Key::form().filter(|&key| key != left_out) {
        *inputs.entry_mut(key) = filled(key);
    }
    inputs
}

#[test]
fn every_field_of_the_form_is_in_its_assessment_its_link_and_its_report() {
    for (left_out, other) in [(FLOOR_ANGLE, FLOOR_ROW), (FLOOR_ROW, FLOOR_ANGLE)] {
        let inputs = form(left_out);
        assert!(!inputs.entry(other).is_blank());
        every_field_is_everywhere(&inputs, left_out);
    }
}

fn every_field_is_everywhere(inputs: &Inputs, left_out: Key) {
    let assessment = inputs.assess();
    let fragment = link::fragment(inputs, LengthUnit::Meter);
    let Ok(report) = Text.export(&Results {
        inputs,
        assessment: &assessment,
        unit: LengthUnit::Meter,
        provenance: Provenance::default(),
    });
    let mut back = Inputs::default();
    assert!(link::apply(&fragment, &mut back));
    for key in Key::form().filter(|&key| key != left_out) {
        let reading = assessment.reading(key).unwrap();
        assert_eq!(reading.number_text, some_number(key), "{key:?}");
        assert_eq!(back.entry(key).text, some_number(key), "{key:?} in {fragment}");
        assert_eq!(back.entry(key).unit, inputs.entry(key).unit, "{key:?} in {fragment}");
        let sigma = reading.sigma_text().unwrap_or_default();
        assert_eq!(sigma.is_empty(), !key.has_sigma, "{key:?}");
        let line = format!("{}\t{}\t{sigma}\t", key.name, reading.number_text);
        assert!(
            report.lines().any(|candidate| candidate.starts_with(&line)),
            "{line:?} is not in\n{report}"
        );
        if let Some(field) = key.input {
            assert_eq!(assessment.solution.problem.get(field), Some(reading.value), "{key:?}");
        }
    }
}

/// What a program reads has every field that was given, by the name of its option and in its base unit.
#[test]
fn every_field_of_calculate_is_in_its_json() {
    let keys = || Key::form().filter(|key| !key.section.is_some_and(Section::is_way_of_its_own));
    let mut arguments = vec!["calculate".to_owned(), "--json".to_owned()];
    for key in keys() {
        let option = key.option.unwrap().name;
        arguments.push(format!("--{option}={}", some_number(key)));
        arguments.extend(key.has_sigma.then(|| format!("--sigma-{option}=1 %")));
    }
    let output = run_words(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for key in keys() {
        let input = &answer["inputs"][key.option.unwrap().name];
        let number: f64 = some_number(key).parse().unwrap();
        let value = key.kind.default_unit().map_or(number, |unit| unit.to_base(number));
        assert!(close(input["value"].as_f64().unwrap(), value), "{key:?}: {input}");
        let base = key.kind.default_unit().map(Unit::base);
        assert_eq!(input["unit"].as_str(), base.map(Unit::symbol), "{key:?}");
        assert_eq!(input["sigma"].is_number(), key.has_sigma, "{key:?}: {input}");
    }
}

#[test]
fn every_field_of_the_form_has_its_options_with_their_help_completion_and_manual() {
    let text = |arguments: &str| String::from_utf8(run(arguments).stdout).unwrap();
    let (completions, manual) = (text("completions bash"), text("man"));
    // Three fields of a point have one option.
    for key in Key::form().filter(|key| key.section != Some(Section::TwoPoints)) {
        let command = match key.section {
            Some(Section::Ground) => "ground",
            Some(Section::TwoShots) => "step",
            _ => "calculate",
        };
        let help = text(&format!("{command} --help"));
        let option = key.option.unwrap();
        let placeholder = key.kind.placeholder();
        for (name, placeholder, line) in [
            (option.name.to_owned(), placeholder.to_owned(), option.help),
            (format!("sigma-{}", option.name), format!("{placeholder}|%"), option.sigma_help),
        ]
        .into_iter()
        .take(1 + usize::from(key.has_sigma))
        {
            let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(words(&help).contains(&format!("--{name} <{placeholder}> {line}")), "{name}");
            assert!(completions.contains(&format!("--{name}")), "{name}");
            assert!(manual.contains(&format!("\\-\\-{}", name.replace('-', "\\-"))), "{name}");
        }
        let refused = run_words(&[command, &format!("--{}=1 furlong", option.name)]);
        let reason = String::from_utf8(refused.stderr).unwrap();
        let start = format!("depth-calculator: --{}: “furlong” is not a unit known here.", option.name);
        assert!(reason.starts_with(&start), "{reason}");
    }
}

#[test]
fn every_field_reads_its_units_and_refuses_all_others() {
    for key in numbers() {
        for (unit, words) in UNITS {
            for word in words {
                let entry = Entry::new(format!("3 {word}"), None);
                let read = read(key, &entry);
                let is_type_of_sensor = key.key.starts_with("sensor-") && unit == Unit::Length(LengthUnit::Inch);
                if is_type_of_sensor {
                    let note = read.unwrap_err();
                    assert!(matches!(note.issue, Issue::SensorType { .. }), "{key:?} {word}");
                } else if key.kind.reads(unit) {
                    let reading = read.unwrap().unwrap();
                    assert_eq!((reading.unit, reading.number), (Some(unit), 3.0), "{key:?} {word}");
                    assert!(close(reading.value, unit.to_base(3.0)), "{key:?} {word}");
                } else {
                    let note = read.unwrap_err();
                    assert!(note.key == key && !note.message().is_empty(), "{key:?} {word}");
                }
            }
        }
        let bare = read(key, &Entry::new("3", None)).unwrap().unwrap();
        assert_eq!(bare.unit, key.kind.default_unit(), "{key:?}");
    }
}

/// Whatever the field: what is no unit is refused, in the value and in σ, and never taken for the unit of the field.
#[test]
fn an_unknown_unit_is_refused_everywhere() {
    for key in numbers() {
        for unit in ["C", "K", "kmh", "pxl", "furlongs", "%", "kg", "mp", "µ", "x"] {
            let wrong = Entry::new(format!("700 {unit}"), None);
            assert!(read(key, &wrong).is_err(), "{key:?} takes {unit}");
            if key.has_sigma && unit != "%" {
                let wrong = Entry {
                    sigma: format!("2 {unit}"),
                    ..Entry::new("3", None)
                };
                assert!(read_with_sigma(key, &wrong).is_err(), "σ of {key:?} takes {unit}");
            }
        }
    }
}

#[test]
fn a_sigma_is_read_in_every_unit_of_its_field_and_in_percent_of_the_value() {
    for key in numbers().filter(|key| key.has_sigma) {
        let sigma = |text: &str| {
            let entry = Entry {
                sigma: text.into(),
                ..Entry::new("3", None)
            };
            read_with_sigma(key, &entry).unwrap().unwrap().sigma
        };
        let bare = |number: f64| key.kind.default_unit().map_or(number, |unit| unit.to_base(number));
        assert_eq!(sigma(""), None);
        for same in ["0.03", "± 0.03", "1 %", "±1%"] {
            assert!(close(sigma(same).unwrap(), bare(0.03)), "{key:?} {same}");
        }
        // Those of the kind of the value.
        let base = key.kind.default_unit().map(Unit::base);
        for (unit, words) in UNITS.iter().filter(|(unit, _)| Some(unit.base()) == base) {
            assert!(close(sigma(&format!("2 {}", words[0])).unwrap(), unit.to_base(2.0)), "{key:?}");
        }
    }
}

fn close(got: f64, expected: f64) -> bool {
    (got / expected - 1.0).abs() < 1e-12
}

/// Programs in which σ could be switched off wrote so; what did not count then must not count now.
#[test]
fn a_sigma_that_was_switched_off_is_not_read_back() {
    let stored = |with_uncertainty: &str| {
        let text = format!(
            r#"{{"entries":{{"fx":{{"text":"700","sigma":"2"}},"d":{{"text":"50 ± 0.5"}},"distance":{{"text":"1","sigma":"1 %"}},
            "range":{{"text":"1.5","sigma":"1 %"}},"camera-pitch":{{"text":"10","sigma":"0.5"}}}}{with_uncertainty}}}"#
        );
        serde_json::from_str::<Inputs>(&text).unwrap()
    };
    let (on, off, now) = (
        stored(r#","with_uncertainty":true"#),
        stored(r#","with_uncertainty":false"#),
        stored(""),
    );
    assert_eq!(on, now);
    for (key, kept) in [(FOCAL_LENGTH, false), (DISTANCE, false), (TAPED_RANGE, true), (CAMERA_PITCH, true)] {
        assert!(!now.sigma(key).is_empty(), "{key:?}");
        assert_eq!(!off.sigma(key).is_empty(), kept, "{key:?}");
    }
    assert_eq!(off.assess().solution.problem.sigma(Field::Disparity), 0.5, "typed behind its value");
    let again = serde_json::to_string(&now).unwrap();
    assert_eq!(serde_json::from_str::<Inputs>(&again).unwrap(), now);
    assert!(!again.contains("with_uncertainty"), "{again}");
}
