//! The line under a field: what was read, where another unit helps, else the hint.

use crate::field::Key;
use crate::number::Notation;
use crate::reading::Reading;
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::quantity::LengthUnit;

/// Digits with which a value is read back in another unit.
const DIGITS: usize = 5;
/// Digits with which the result is read back of what was worked out.
const COMPUTED_DIGITS: usize = 6;

/// The line under the field `key`: its value in another unit where that helps to see a slip ("= 0.1 m, from lens center to lens center",
/// "= 300 mm; seen face on", "= 1.125 in"), else its hint. `key` is in the [words](Key::worded) of what is measured.
pub fn field_line(key: Key, reading: Option<&Reading>) -> String {
    line(key, reading, false)
}

/// So many characters fit where two fields share the width.
const LONGEST_IN_PAIR: usize = 26;

/// [`field_line`] where two fields share the width.
pub fn field_line_in_pair(key: Key, reading: Option<&Reading>) -> String {
    line(key, reading, true)
}

fn line(key: Key, reading: Option<&Reading>, in_pair: bool) -> String {
    let hint = || key.hint_for(in_pair).to_owned();
    let Some(reading) = reading else { return hint() };
    if reading.is_computed {
        let unit = reading.unit;
        return format!("= {}", with_unit(reading.number, unit, COMPUTED_DIGITS));
    }
    if reading.unit == Some(Unit::Angle(AngleUnit::NatoMil)) {
        let mrad = Unit::Angle(AngleUnit::Milliradian);
        return format!(
            "= {}; a mil is 1/6400 here (NATO)",
            with_unit(mrad.from_base(reading.value), Some(mrad), DIGITS)
        );
    }
    match other_unit(key, reading) {
        Some(unit) => {
            let value = format!("= {}", with_unit(unit.from_base(reading.value), Some(unit), DIGITS));
            let whole = format!("{value}{}", key.behind_reading);
            if in_pair && whole.chars().count() > LONGEST_IN_PAIR {
                value
            } else {
                whole
            }
        }
        None => hint(),
    }
}

fn with_unit(number: f64, unit: Option<Unit>, digits: usize) -> String {
    let number = Notation::SHORT.readable(number, digits);
    unit.map_or_else(|| number.clone(), |unit| unit.behind(&number))
}

/// The unit in which the value of `reading` is worth reading back; `None` where the hint says more.
fn other_unit(key: Key, reading: &Reading) -> Option<Unit> {
    let (unit, of_field) = (reading.unit?, key.kind.default_unit()?);
    if reading.value == 0.0 {
        return None;
    }
    match unit {
        Unit::Angle(AngleUnit::Degree) | Unit::Pixel => None,
        Unit::Angle(_) => Some(Unit::DEGREE),
        // One on the sensor has no other unit.
        Unit::Length(_) | Unit::Square(_) if !of_field.is_length() => None,
        _ if unit != of_field => Some(of_field),
        _ if key.behind_reading.is_empty() => None,
        Unit::Length(unit) => next_to(unit, reading.value).map(Unit::Length),
        Unit::Square(_) => Some(Unit::Length(LengthUnit::Millimeter)),
    }
}

/// The unit in which people check a length that they have in `unit`.
fn next_to(unit: LengthUnit, meters: f64) -> Option<LengthUnit> {
    match unit {
        LengthUnit::Millimeter => Some(LengthUnit::Meter),
        LengthUnit::Meter if meters.abs() < 1.0 => Some(LengthUnit::Millimeter),
        LengthUnit::Meter if meters.abs() < 10.0 => Some(LengthUnit::Centimeter),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entry::Entry;
    use crate::fields;
    use crate::reading::read;

    #[test]
    fn a_value_is_read_back_where_another_unit_helps() {
        for (key, text, expected) in [
            (fields::BASELINE, "100", "= 0.1 m, from lens center to lens center"),
            (fields::BASELINE, "10 cm", "= 100 mm, from lens center to lens center"),
            (fields::BASELINE, "100 m", "= 100\u{2009}000 mm, from lens center to lens center"),
            (fields::BASELINE, "1 1/8 in", "= 1.125 in"),
            (fields::BASELINE, "", "From lens center to lens center"),
            (fields::REAL_WIDTH, "0.30", "= 300 mm; seen face on"),
            (fields::REAL_WIDTH, "300 cm", "= 3 m; seen face on"),
            (fields::CAMERA_HEIGHT, "1.20", "= 120 cm, lens to floor"),
            (fields::CAMERA_PITCH, "0.1 rad", "= 5.7296°"),
            (fields::CAMERA_PITCH, "10", "0° level, + is downwards"),
            (fields::DISTANCE, "1.4", "Along the axis, from the lens"),
            (fields::DISTANCE, "4 ft", "= 1.2192 m"),
            (
                fields::IMAGE_WIDTH,
                "0.75 mil",
                "= 0.736\u{2009}31 mrad; a mil is 1/6400 here (NATO)",
            ),
            (fields::IMAGE_WIDTH, "3 mm", "From edge to edge, in the undistorted image"),
            (fields::FOCAL_LENGTH, "1400/2", "= 700 px"),
            (fields::TARGET_HEIGHT, "0", "0 is a point on the floor"),
        ] {
            let reading = read(key, &Entry::new(text, None)).unwrap_or_default();
            assert_eq!(field_line(key, reading.as_ref()), expected, "{text}");
        }
        assert_eq!(field_line_in_pair(fields::FOCAL_LENGTH, None), "K[0][0]");
        assert_eq!(field_line_in_pair(fields::CX, None), "K[0][2]; half of the width");
    }
}
