//! Writes numbers as people read them.

/// What stands where there is no number.
pub const NO_NUMBER: &str = "–.–";

/// Magnitudes that are written out; others are in scientific notation.
const READABLE: std::ops::RangeInclusive<f64> = 0.001..=99_999.0;

/// `value` with `digits` significant digits, in scientific notation outside 0.001 to 99 999.
///
/// `significant(1.4, 4)` is "1.400", `significant(123456.0, 4)` is "1.235e5". Not finite: [`NO_NUMBER`].
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (Ok(rounded), Some(exponent)) = (scientific.parse::<f64>(), exponent_of(&scientific)) else {
        return scientific;
    };
    if !READABLE.contains(&value.abs()) {
        return scientific;
    }
    let decimals = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
    format!("{rounded:.*}", usize::try_from(decimals).unwrap_or(0))
}

/// `value` as someone would write it: up to 12 significant digits and no trailing zeros.
pub fn plain(value: f64) -> String {
    let text = significant(value, 12);
    let (mantissa, exponent) = text.find('e').and_then(|at| text.split_at_checked(at)).unwrap_or((&text, ""));
    if !mantissa.contains('.') {
        return text;
    }
    format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// `value` with every digit it has: the shortest text that reads back as the same number.
pub fn exact(value: f64) -> String {
    if READABLE.contains(&value.abs()) || value == 0.0 {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// `value` to `decimals` places; negative ones round to tens, hundreds and so on. In scientific notation, to the same place,
/// outside 0.001 to 99 999. Not finite: [`NO_NUMBER`].
pub fn to_decimals(value: f64, decimals: i32) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    let places = usize::try_from(decimals + magnitude(value)).unwrap_or(0).min(17);
    if value != 0.0 && !READABLE.contains(&value.abs()) {
        return format!("{value:.places$e}");
    }
    if decimals < 0 {
        return significant(value, places + 1);
    }
    format!("{value:.*}", usize::try_from(decimals).unwrap_or(0).min(17))
}

/// The multiple of `resolution` that is nearest to `value`, with at most the 12 significant digits that [`plain`] writes: the product
/// of two floating-point numbers can have a remainder behind them, as in 333 · 0.1 = 33.300000000000004.
///
/// `rounded_to(33.333, 0.1)` is 33.3, `rounded_to(1666.0, 100.0)` is 1700.0. Not finite: unchanged.
pub fn rounded_to(value: f64, resolution: f64) -> f64 {
    if !value.is_finite() {
        return value;
    }
    let multiple = (value / resolution).round() * resolution;
    format!("{multiple:.11e}").parse().unwrap_or(multiple)
}

/// The power of ten of the first digit that `value` has with two significant digits: 0.0158 has −2, 0.0999 has −1.
pub fn magnitude(value: f64) -> i32 {
    exponent_of(&format!("{value:.1e}")).unwrap_or(0)
}

fn exponent_of(scientific: &str) -> Option<i32> {
    scientific.split_once('e')?.1.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_significant_digits_and_scientific_outside_the_readable_range() {
        for (value, expected) in [
            (1.4, "1.400"),
            (4.275, "4.275"),
            (0.001, "0.001000"),
            (0.0009999, "9.999e-4"),
            (0.000_999_99, "1.000e-3"),
            (12_345.6, "12350"),
            (99_990.0, "99990"),
            (99_999.0, "100000"),
            (99_999.1, "1.000e5"),
            (123_456.0, "1.235e5"),
            (-1.23456, "-1.235"),
            (0.0, "0"),
            (f64::NAN, NO_NUMBER),
            (f64::INFINITY, NO_NUMBER),
        ] {
            assert_eq!(significant(value, 4), expected, "{value}");
        }
    }

    #[test]
    fn a_rounded_number_has_no_remainder_behind_its_last_digit() {
        for (value, resolution, expected) in [
            (33.333, 0.1, 33.3),
            (0.1 + 0.2, 0.1, 0.3),
            (1666.0, 100.0, 1700.0),
            (0.04, 0.1, 0.0),
            (-2.66, 0.1, -2.7),
            (7.3, 2.5, 7.5),
            (1.234e-9, 1e-11, 1.23e-9),
            (6.02e23, 1e21, 6.02e23),
            (f64::INFINITY, 1.0, f64::INFINITY),
        ] {
            assert_eq!(rounded_to(value, resolution), expected, "{value} to {resolution}");
        }
    }

    #[test]
    fn plain_and_exact_keep_what_was_entered() {
        assert_eq!(plain(0.1), "0.1");
        assert_eq!(plain(700.0), "700");
        assert_eq!(plain(3.3 * 0.3048), "1.00584");
        assert_eq!(plain(1e-300), "1e-300");
        assert_eq!(exact(1.372_549_019_607_843_2), "1.3725490196078431");
        assert_eq!(exact(1e200), "1e200");
    }
}
