//! Links that fill in the form: `#fx=700&sfx=2&b=100mm&sb=0.5mm&d=50`.
//!
//! A link sets only what it names, and what it sets is text, checked like typing. The σ of a field has its key with an s in front, what is
//! solved for is `solve=stereo.d`, and the unit of the results is `unit=ft`.

use crate::entry::Entry;
use crate::field::Key;
use crate::fields;
use crate::form::Inputs;
use crate::number;
use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};

/// The longest text a link may put into a field; longer ones are cut. Nobody types more.
const LONGEST: usize = 64;

/// What is solved for, the unit of the results.
const SOLVE: &str = "solve";
const UNIT: &str = "unit";

/// The unit of the results of those who chose none, which a link does not name.
const USUAL_UNIT: LengthUnit = LengthUnit::Meter;

/// The fields that a link may name.
fn keys() -> impl Iterator<Item = Key> {
    Key::form().chain([fields::DISTANCE])
}

/// Fills `inputs` with what the part of a link behind its `#` names. Returns whether it named anything.
///
/// A value is taken as it would be typed: `100mm` sets the unit as well, a bare number has the field's default unit. A bare σ has the unit
/// of its value. Unknown names are passed over; the unit of the results is left to [`result_unit`].
pub fn apply(fragment: &str, inputs: &mut Inputs) -> bool {
    let (mut any, mut names_fx, mut names_lens) = (result_unit(fragment).is_some(), false, false);
    for (name, value) in pairs(fragment) {
        any |= choose(name, value, inputs);
        let text = || {
            percent_decoded(value)
                .chars()
                .filter(|c| !c.is_control())
                .take(LONGEST)
                .collect::<String>()
        };
        if let Some(key) = keys().find(|key| key.as_str() == name) {
            // In whichever order a link has them, a lens that it names belongs to its fx.
            names_lens |= key == fields::FX_LENS;
            names_fx |= key == fields::FOCAL_LENGTH;
            inputs.entries.fill(key, Entry::new(text(), key.kind.length_unit()));
            any = true;
        } else if let Some(key) = keys().find(|key| key.has_sigma && name.strip_prefix('s') == Some(key.as_str())) {
            inputs.set_sigma(key, text());
            any = true;
        }
    }
    for (name, _) in pairs(fragment) {
        if let Some(key) = keys().find(|key| [Some(name), name.strip_prefix('s')].contains(&Some(key.as_str()))) {
            inputs.tidy(key);
        }
    }
    if names_fx && !names_lens {
        inputs.edited(fields::FOCAL_LENGTH);
    }
    any
}

/// The unit of the results that the part of a link behind its `#` names.
pub fn result_unit(fragment: &str) -> Option<LengthUnit> {
    let (_, value) = pairs(fragment).find(|(name, _)| *name == UNIT)?;
    let symbol = percent_decoded(value);
    LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == symbol)
}

fn pairs(fragment: &str) -> impl Iterator<Item = (&str, &str)> {
    fragment.trim_start_matches('#').split('&').filter_map(|pair| pair.split_once('='))
}

/// Takes a choice of a link: what of the object is measured, how the cameras stand, what is solved for.
fn choose(name: &str, value: &str, inputs: &mut Inputs) -> bool {
    let object = Object::ALL.into_iter().find(|object| (name, value) == ("object", object.key()));
    let pair = Pair::ALL.into_iter().find(|pair| (name, value) == ("pair", pair.key()));
    inputs.object = object.unwrap_or(inputs.object);
    inputs.pair = pair.unwrap_or(inputs.pair);
    let unknown = unknowns().find(|&unknown| name == SOLVE && value == unknown_name(unknown));
    inputs.unknown = unknown.or(inputs.unknown);
    let is_distance = name == SOLVE && value == fields::DISTANCE.as_str();
    if is_distance {
        inputs.unknown = None;
    }
    object.is_some() || pair.is_some() || unknown.is_some() || is_distance
}

fn unknowns() -> impl Iterator<Item = (Method, Field)> {
    Method::ALL
        .into_iter()
        .flat_map(|method| method.unknowns().map(move |field| (method, field)))
}

/// "stereo.d"
fn unknown_name((method, field): (Method, Field)) -> String {
    let method = match method {
        Method::Stereo => "stereo",
        Method::Monocular => "monocular",
    };
    format!("{method}.{}", Key::from(field).as_str())
}

/// The part of a link behind the `#` that fills in `inputs` again, with results in `unit`: `fx=700&sfx=2&b=100mm&d=50`. Empty fields and
/// what is chosen as usual are left out.
///
/// A text that cannot be read stands there as it was typed.
pub fn fragment(inputs: &Inputs, unit: LengthUnit) -> String {
    let mut pairs: Vec<String> = keys().flat_map(|key| of_field(inputs, key)).collect();
    if inputs.object != Object::default() {
        pairs.push(format!("object={}", inputs.object.key()));
    }
    if inputs.pair != Pair::default() {
        pairs.push(format!("pair={}", inputs.pair.key()));
    }
    if let Some(unknown) = inputs.unknown {
        pairs.push(format!("{SOLVE}={}", unknown_name(unknown)));
    }
    if unit != USUAL_UNIT {
        pairs.push(format!("{UNIT}={}", percent_encoded(unit.symbol())));
    }
    pairs.join("&")
}

/// Value and σ of a field, each where there is one.
fn of_field(inputs: &Inputs, key: Key) -> impl Iterator<Item = String> {
    let mut entry = inputs.entry(key).clone();
    entry.tidy(key);
    let primes = key.kind.primes();
    // The unit chosen beside it belongs to a bare number, and to what may yet become one.
    let is_bare = |text: &str| match number::read(text, primes) {
        Ok(typed) => typed.unit.is_none(),
        Err(_) => text.ends_with(|c: char| c.is_ascii_digit()),
    };
    let chosen = entry.chosen_unit(key).filter(|_| key.is_length()).map_or("", |unit| unit.symbol());
    let is_of_value = entry.is_blank() || is_bare(entry.text.trim());
    let with_unit = move |text: &str, counts: bool| {
        let unit = if counts && is_bare(text) { chosen } else { "" };
        format!("{}{}", percent_encoded(text), percent_encoded(unit))
    };
    let text = entry.text.trim();
    let value = (!text.is_empty()).then(|| format!("{}={}", key.as_str(), with_unit(text, true)));
    let sigma = entry.sigma.trim();
    let has_sigma = key.has_sigma && !sigma.is_empty();
    let sigma = has_sigma.then(|| format!("s{}={}", key.as_str(), with_unit(sigma, is_of_value)));
    value.into_iter().chain(sigma)
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
            assert!(apply(&fragment(&inputs, LengthUnit::Meter), &mut back));
            assert_eq!(back, inputs, "{text:?}");
        }
    }

    #[test]
    fn a_link_has_the_sigmas_and_all_that_was_chosen() {
        let mut inputs = Example::CoffeeMug.inputs();
        for (key, sigma) in [
            (fields::FOCAL_LENGTH, "2"),
            (fields::BASELINE, "0.5 mm"),
            (fields::DISPARITY, "1 %"),
        ] {
            inputs.set_sigma(key, sigma);
        }
        inputs.entry_mut(fields::DISTANCE).text = "1.4".into();
        inputs.set_sigma(fields::DISTANCE, "0.01");
        inputs.unknown = Some((Method::Stereo, Field::Disparity));
        inputs.object = Object::Height;
        let written = fragment(&inputs, LengthUnit::Foot);
        assert_eq!(
            written,
            "fx=700&sfx=2&b=10cm&sb=0.5%20mm&d=50&sd=1%20%25&distance=1.4m&sdistance=0.01m&object=height&solve=stereo.d&unit=ft"
        );
        let mut back = Inputs::default();
        assert!(apply(&written, &mut back));
        assert_eq!((back, result_unit(&written)), (inputs, Some(LengthUnit::Foot)));
    }

    #[test]
    fn a_sigma_in_the_unit_of_its_value_is_a_bare_number() {
        let mut inputs = Inputs::default();
        assert!(apply("sb=0.5mm&b=100mm&sd=0.5px&swreal=1cm", &mut inputs));
        let sigmas = [fields::BASELINE, fields::DISPARITY, fields::REAL_WIDTH].map(|key| inputs.sigma(key).to_owned());
        assert_eq!(sigmas, ["0.5", "0.5", "1cm"]);
    }

    #[test]
    fn the_name_of_a_sigma_is_no_field() {
        for key in keys() {
            assert!(keys().all(|other| other.as_str() != format!("s{}", key.as_str())), "{key:?}");
            assert!(![SOLVE, UNIT, "object", "pair"].contains(&key.as_str()), "{key:?}");
            assert!(![SOLVE, UNIT].contains(&format!("s{}", key.as_str()).as_str()), "{key:?}");
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
