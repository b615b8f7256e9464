//! Writes numbers as people read them.

/// What stands where there is no number.
pub const NO_NUMBER: &str = "–.–";

/// Which numbers are written out; others are in scientific notation.
#[derive(Clone, Copy, Debug)]
pub struct Notation {
    smallest: f64,
    largest: f64,
}

/// An `f64` has no more digits than this many behind the first.
const MOST_PLACES: i32 = 17;

impl Notation {
    /// Short enough for a card.
    pub const SHORT: Self = Self {
        smallest: 0.001,
        largest: 99_999.0,
    };

    /// For programs as much as for people: written out until nobody would count the zeros.
    pub const LONG: Self = Self {
        smallest: 1e-6,
        largest: 1e15,
    };

    fn writes_out(self, value: f64) -> bool {
        value == 0.0 || (self.smallest..=self.largest).contains(&value.abs())
    }

    /// `value` with `digits` significant digits. Not finite: [`NO_NUMBER`].
    pub fn significant(self, value: f64, digits: usize) -> String {
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
        if !self.writes_out(value) {
            return scientific;
        }
        // Rounding may have added a digit in front: 9.9996 is 10.00.
        let decimals = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
        match usize::try_from(decimals) {
            Ok(decimals) => format!("{rounded:.decimals$}"),
            Err(_) => format!("{rounded:.0}"),
        }
    }

    /// `value` as someone would type it: up to `digits` significant digits and no trailing zeros.
    pub fn plain(self, value: f64, digits: usize) -> String {
        let text = self.significant(value, digits);
        let (mantissa, exponent) = text.find('e').and_then(|at| text.split_at_checked(at)).unwrap_or((&text, ""));
        if !mantissa.contains('.') {
            return text;
        }
        format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
    }

    /// `value` to `decimals` places; negative ones round to tens, hundreds and so on. Not finite: [`NO_NUMBER`].
    pub fn to_decimals(self, value: f64, decimals: i32) -> String {
        if !value.is_finite() {
            return NO_NUMBER.to_owned();
        }
        let magnitude = magnitude(value);
        let places = usize::try_from(decimals.saturating_add(magnitude).min(MOST_PLACES)).unwrap_or(0);
        let scientific = format!("{value:.places$e}");
        if !self.writes_out(value) {
            return scientific;
        }
        match usize::try_from(decimals.min(MOST_PLACES - magnitude)) {
            Ok(decimals) => format!("{value:.decimals$}"),
            // Rounded to tens or more: written as a whole number.
            Err(_) => scientific.parse::<f64>().map_or(scientific, |whole| format!("{whole:.0}")),
        }
    }
}

/// Significant digits of a number that stands as it was typed, at most.
pub const TYPED_DIGITS: usize = 12;

/// [`Notation::significant`] in short notation: `significant(1.4, 4)` is "1.400", `significant(123456.0, 4)` is "1.235e5".
pub fn significant(value: f64, digits: usize) -> String {
    Notation::SHORT.significant(value, digits)
}

/// `value` as someone would write it, in short notation: up to 12 significant digits and no trailing zeros.
pub fn plain(value: f64) -> String {
    Notation::SHORT.plain(value, TYPED_DIGITS)
}

/// `value` with every digit it has: the shortest text that reads back as the same number.
pub fn exact(value: f64) -> String {
    if Notation::SHORT.writes_out(value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
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

/// A number as people type it with the minus of print.
pub fn with_minus(number: &str) -> String {
    number.replace('-', "−")
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
    fn long_notation_writes_out_what_short_notation_does_not() {
        for (value, digits, expected) in [
            (9.9996, 4, "10.00"),
            (99_999.9, 4, "100000"),
            (99_902.4, 4, "99900"),
            (123_456.0, 4, "123500"),
            (0.000_123_456, 4, "0.0001235"),
            (-1234.56, 2, "-1200"),
            (1.5e20, 4, "1.500e20"),
            (1.5e-20, 4, "1.500e-20"),
        ] {
            assert_eq!(Notation::LONG.significant(value, digits), expected, "{value} with {digits}");
        }
        for (value, decimals, expected) in [
            (1.4, 3, "1.400"),
            (12_345.0, -1, "12340"),
            (12_355.0, -2, "12400"),
            (4.0, -3, "4"),
            (0.0, 3, "0.000"),
            (1.4, 40, "1.39999999999999991"),
            (2e20, -18, "2.00e20"),
        ] {
            assert_eq!(Notation::LONG.to_decimals(value, decimals), expected, "{value} to {decimals}");
        }
        for (value, expected) in [(0.1 * 1000.0, "100"), (1_234_567.5, "1234567.5"), (1e-300, "1e-300")] {
            assert_eq!(Notation::LONG.plain(value, 12), expected);
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
