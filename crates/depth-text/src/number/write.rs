//! Writes numbers as people read them.

/// What stands where there is no number.
pub const NO_NUMBER: &str = "–.–";

/// Which numbers are written out; others have a power of ten behind them.
#[derive(Clone, Copy, Debug)]
pub struct Notation {
    smallest: f64,
    largest: f64,
    /// Whether digits of long numbers stand in groups.
    groups: bool,
}

/// An `f64` has no more digits than this many behind the first.
const MOST_PLACES: i32 = 17;

/// Between groups of digits.
const GROUP: char = '\u{2009}';

impl Notation {
    /// Short enough for a card.
    pub const SHORT: Self = Self {
        smallest: 0.001,
        largest: 999_999.0,
        groups: true,
    };

    /// For programs as much as for people: written out until nobody would count the zeros.
    pub const LONG: Self = Self {
        smallest: 1e-6,
        largest: 1e15,
        groups: false,
    };

    /// In a terminal, where no unit was asked for.
    pub const TERMINAL: Self = Self {
        smallest: 1e-4,
        largest: Self::SHORT.largest,
        ..Self::LONG
    };

    /// The smallest number that is written out.
    pub(crate) const fn smallest(self) -> f64 {
        self.smallest
    }

    pub(crate) fn writes_out(self, value: f64) -> bool {
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
            return with_power(&scientific);
        }
        // Rounding may have added a digit in front: 9.9996 is 10.00.
        let decimals = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
        self.grouped(match usize::try_from(decimals) {
            Ok(decimals) => format!("{rounded:.decimals$}"),
            Err(_) => format!("{rounded:.0}"),
        })
    }

    /// `value` as someone would type it: up to `digits` significant digits and no trailing zeros.
    pub fn plain(self, value: f64, digits: usize) -> String {
        let text = Self { groups: false, ..self }.significant(value, digits);
        let (mantissa, power) = text.find(TIMES).and_then(|at| text.split_at_checked(at)).unwrap_or((&text, ""));
        if !mantissa.contains('.') {
            return text;
        }
        format!("{}{power}", mantissa.trim_end_matches('0').trim_end_matches('.'))
    }

    /// A σ with two digits beside a value with `decimals`: written out with as many where it alone would have a power of ten.
    pub(crate) fn beside(self, sigma: f64, decimals: i32) -> String {
        let is_small = !self.writes_out(sigma) && sigma.abs() < 1.0 && decimals >= 1 - magnitude(sigma);
        match usize::try_from(decimals) {
            Ok(decimals) if is_small => self.grouped(format!("{sigma:.decimals$}")),
            _ => self.significant(sigma, 2),
        }
    }

    /// [`plain`](Self::plain) as people read it: long numbers in groups, with the minus of print.
    pub fn readable(self, value: f64, digits: usize) -> String {
        let plain = self.plain(value, digits);
        with_minus(&if plain.contains(TIMES) { plain } else { self.grouped(plain) })
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
            return with_power(&scientific);
        }
        self.grouped(match usize::try_from(decimals.min(MOST_PLACES - magnitude)) {
            Ok(decimals) => format!("{value:.decimals$}"),
            // Rounded to tens or more: written as a whole number.
            Err(_) => scientific.parse::<f64>().map_or(scientific, |whole| format!("{whole:.0}")),
        })
    }

    /// A written-out number in groups of three digits on both sides of the point, where there are more than four on that side.
    fn grouped(self, number: String) -> String {
        if !self.groups {
            return number;
        }
        let (sign, digits) = number.strip_prefix('-').map_or(("", number.as_str()), |digits| ("-", digits));
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
        let mut grouped = sign.to_owned();
        push_groups(&mut grouped, whole, whole.len() % 3);
        if !decimals.is_empty() {
            grouped.push('.');
            push_groups(&mut grouped, decimals, 0);
        }
        grouped
    }
}

/// Adds `digits` to `text`, with a space before every third one, counted from the place `first`; four digits are no group and a rest.
fn push_groups(text: &mut String, digits: &str, first: usize) {
    for (at, c) in digits.chars().enumerate() {
        if digits.len() > 4 && at > 0 && at % 3 == first {
            text.push(GROUP);
        }
        text.push(c);
    }
}

/// Between a number and its power of ten.
const TIMES: &str = " × 10";

/// "1.400e-11" as people write it, 1.400 × 10⁻¹¹.
fn with_power(scientific: &str) -> String {
    match scientific.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa}{TIMES}{}", raised(exponent)),
        None => scientific.to_owned(),
    }
}

/// The power of ten to put behind a number, " × 10⁻¹¹".
pub(crate) fn power(exponent: i32) -> String {
    format!("{TIMES}{}", raised(&exponent.to_string()))
}

fn raised(exponent: &str) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        c => c
            .to_digit(10)
            .and_then(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(usize::try_from(digit).ok()?))
            .unwrap_or(c),
    };
    exponent.chars().map(raised).collect()
}

/// Significant digits of a number that stands as it was typed, at most.
pub const TYPED_DIGITS: usize = 12;

/// [`Notation::significant`] in short notation: `significant(1.4, 4)` is "1.400", `significant(1.4e-11, 4)` is
/// "1.400 × 10⁻¹¹".
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
    fn four_significant_digits_and_a_power_of_ten_outside_the_readable_range() {
        for (value, expected) in [
            (1.4, "1.400"),
            (4.275, "4.275"),
            (0.001, "0.001\u{2009}000"),
            (0.0123, "0.012\u{2009}30"),
            (0.001_234, "0.001\u{2009}234"),
            (0.0009999, "9.999 × 10⁻⁴"),
            (0.000_999_99, "1.000 × 10⁻³"),
            (1234.5, "1234"),
            (12_345.6, "12\u{2009}350"),
            (-12_345.6, "-12\u{2009}350"),
            (384_400.0, "384\u{2009}400"),
            (999_999.1, "1.000 × 10⁶"),
            (2e8, "2.000 × 10⁸"),
            (1.4e-11, "1.400 × 10⁻¹¹"),
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
            (1.5e20, 4, "1.500 × 10²⁰"),
            (1.5e-20, 4, "1.500 × 10⁻²⁰"),
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
            (2e20, -18, "2.00 × 10²⁰"),
        ] {
            assert_eq!(Notation::LONG.to_decimals(value, decimals), expected, "{value} to {decimals}");
        }
        for (value, expected) in [(0.1 * 1000.0, "100"), (1_234_567.5, "1234567.5"), (1e-300, "1 × 10⁻³⁰⁰")] {
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
        assert_eq!(plain(1e-300), "1 × 10⁻³⁰⁰");
        assert_eq!(plain(123_456.5), "123456.5");
        assert_eq!(exact(1.372_549_019_607_843_2), "1.3725490196078431");
        assert_eq!(exact(1e200), "1e200");
    }
}
