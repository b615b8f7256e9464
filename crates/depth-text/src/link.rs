//! Links that fill in the form: `#fx=700&b=100mm&d=50`.
//!
//! A link sets only what it names, and what it sets is text, checked like typing.

use crate::assess::Assessment;
use crate::entry::Entry;
use crate::field::Key;
use crate::fields;
use crate::form::Inputs;
use crate::unit::Unit;
use depth_core::setup::{Object, Pair};

/// The longest text a link may put into a field; longer ones are cut. Nobody types more.
const LONGEST: usize = 64;

/// Fills `inputs` with what the part of a link behind its `#` names. Returns whether it named anything.
///
/// A value is taken as it would be typed: `100mm` sets the unit as well, a bare number has the field's default unit.
/// Unknown names are passed over.
pub fn apply(fragment: &str, inputs: &mut Inputs) -> bool {
    let (mut any, mut names_fx, mut names_lens) = (false, false, false);
    for pair in fragment.trim_start_matches('#').split('&') {
        let Some((name, value)) = pair.split_once('=') else { continue };
        any |= choose(name, value, inputs);
        let Some(key) = Key::form().find(|key| key.as_str() == name) else {
            continue;
        };
        let text: String = percent_decoded(value).chars().filter(|c| !c.is_control()).take(LONGEST).collect();
        // In whichever order a link has them, a lens that it names belongs to its fx.
        names_lens |= key == fields::FX_LENS;
        names_fx |= key == fields::FOCAL_LENGTH;
        inputs.entries.fill(key, Entry::new(text, key.kind.length_unit()));
        inputs.tidy(key);
        any = true;
    }
    if names_fx && !names_lens {
        inputs.edited(fields::FOCAL_LENGTH);
    }
    any
}

/// Takes a choice of a link: what of the object is measured, how the cameras stand.
fn choose(name: &str, value: &str, inputs: &mut Inputs) -> bool {
    let object = Object::ALL.into_iter().find(|object| (name, value) == ("object", object.key()));
    let pair = Pair::ALL.into_iter().find(|pair| (name, value) == ("pair", pair.key()));
    inputs.object = object.unwrap_or(inputs.object);
    inputs.pair = pair.unwrap_or(inputs.pair);
    object.is_some() || pair.is_some()
}

/// The part of a link behind the `#` that fills in `inputs` again: `fx=700&b=100mm&d=50`. Empty fields are left out.
///
/// A text that cannot be read stands there as it was typed.
pub fn fragment(inputs: &Inputs, assessment: &Assessment) -> String {
    let mut pairs = Vec::new();
    for key in Key::form() {
        let entry = inputs.entry(key);
        if entry.is_blank() {
            continue;
        }
        let (text, unit) = match assessment.reading(key) {
            // With every digit that follows from what was typed.
            Some(reading) if reading.is_computed => (entry.text.trim(), entry.unit.map(Unit::Length)),
            Some(reading) => (reading.number_text.as_str(), reading.unit.filter(|&unit| unit != Unit::Pixel)),
            // The unit chosen beside it belongs to what may yet become a number.
            None if key.is_length() && entry.text.trim_end().ends_with(|c: char| c.is_ascii_digit()) => {
                (entry.text.trim(), entry.chosen_unit(key))
            }
            None => (entry.text.trim(), None),
        };
        pairs.push(format!(
            "{}={}{}",
            key.as_str(),
            percent_encoded(text),
            percent_encoded(&unit.map_or_else(String::new, |unit| unit.to_string()))
        ));
    }
    if inputs.object != Object::default() {
        pairs.push(format!("object={}", inputs.object.key()));
    }
    if inputs.pair != Pair::default() {
        pairs.push(format!("pair={}", inputs.pair.key()));
    }
    pairs.join("&")
}

fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, tail)) = rest.split_first() {
        rest = tail;
        let escaped = match (first, tail) {
            (b'%', [high, low, after @ ..]) => hex(*high).zip(hex(*low)).map(|(high, low)| (high * 16 + low, after)),
            _ => None,
        };
        match escaped {
            Some((byte, after)) => {
                bytes.push(byte);
                rest = after;
            }
            None if first == b'+' => bytes.push(b' '),
            None => bytes.push(first),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn percent_encoded(text: &str) -> String {
    text.bytes()
        .map(|byte| match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'.' | b'-' | b',' | b'_' => char::from(byte).to_string(),
            _ => format!("%{byte:02X}"),
        })
        .collect()
}

fn hex(digit: u8) -> Option<u8> {
    char::from(digit).to_digit(16).and_then(|value| u8::try_from(value).ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form::Example;
    use depth_core::problem::{Field, Outcome};
    use depth_core::quantity::{Length, LengthUnit};

    #[test]
    fn the_links_of_the_examples_fill_them_in() {
        for (link, meters) in [("#fx=700&b=100mm&d=50", 1.4), ("#fx=950&wimg=200&wreal=0.9m", 4.275)] {
            let mut inputs = Inputs::default();
            assert!(apply(link, &mut inputs));
            let solution = inputs.assess().solution;
            let distance = solution.stereo.distance().or(solution.monocular.distance());
            assert_eq!(distance, Some(Length::from_m(meters)), "{link}");
        }
    }

    #[test]
    fn a_lens_belongs_to_the_fx_of_its_link_in_either_order() {
        for (link, lens) in [("fx-lens=15mm&fx=937.5", "15"), ("fx=937.5&fx-lens=15mm", "15"), ("fx=937.5", "")] {
            let mut inputs = Inputs::default();
            inputs.entry_mut(fields::FX_LENS).text = "4".into();
            assert!(apply(link, &mut inputs));
            assert_eq!(inputs.entry(fields::FX_LENS).text, lens, "{link}");
        }
    }

    #[test]
    fn a_link_sets_only_what_it_names() {
        let mut inputs = Example::CoffeeMug.inputs();
        assert!(apply("d=25&x=1&nonsense", &mut inputs));
        assert_eq!(inputs.assess().solution.stereo, Outcome::Distance(Length::from_m(2.8)));
        assert!(!apply("#", &mut inputs));
    }

    #[test]
    fn a_bare_number_has_the_default_unit_whatever_was_chosen_before() {
        let mut inputs = Inputs::default();
        inputs.choose_unit(Field::Baseline, LengthUnit::Foot);
        assert!(apply("b=100", &mut inputs));
        assert_eq!(inputs.entry(Field::Baseline), &Entry::new("100", Some(LengthUnit::Millimeter)));
    }

    #[test]
    fn what_is_written_reads_back_even_when_it_is_not_a_number() {
        for text in ["700", "a&b=c%", "−3", "1,000", "mug ☕", "4mm", "4 kg", "1/3"] {
            let mut inputs = Example::CoffeeMug.inputs();
            inputs.entry_mut(Field::Disparity).text = text.into();
            let mut back = Inputs::default();
            assert!(apply(&fragment(&inputs, &inputs.assess()), &mut back));
            assert_eq!(back, inputs, "{text:?}");
        }
    }

    #[test]
    fn hostile_links_do_no_harm() {
        for link in [
            "#d=%",
            "#d=%zz",
            "#d=%ff%fe",
            "#=&=&",
            "#d=\u{0}1",
            &format!("#d={}", "9".repeat(100_000)),
        ] {
            let mut inputs = Inputs::default();
            apply(link, &mut inputs);
            assert!(inputs.entry(Field::Disparity).text.chars().count() <= LONGEST);
            let _ = inputs.assess();
        }
    }
}
