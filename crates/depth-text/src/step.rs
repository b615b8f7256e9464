//! Counting a number up and down with the arrow keys.

use crate::entry::Entry;
use crate::field::Key;
use crate::number::{self, plain};

impl Entry {
    /// Counts the last typed digit up or down by `steps`: 700 goes to 701, 0.30 to 0.31. An empty field starts at its
    /// example. Stays above zero by going on in smaller digits (1 down to 0.9). A text that is not a positive number is
    /// left as it is.
    pub fn step(&mut self, key: Key, steps: i32) {
        if self.is_blank() {
            key.example().clone_into(&mut self.text);
            return;
        }
        self.tidy(key);
        let Ok(typed) = number::read(&self.text, key.kind.primes()) else {
            return;
        };
        // The last digit of a fraction is no digit of the number.
        if typed.is_computed {
            return;
        }
        let unit = match typed.unit {
            None => None,
            // An angle in radians keeps its unit; a unit that the field does not have is not counted away.
            Some(unit) if key.kind.reads(unit) => Some(unit),
            Some(_) => return,
        };
        if let Some(number) = stepped(&typed, steps) {
            self.text = unit.map_or_else(|| number.clone(), |unit| unit.behind(&number));
        }
    }
}

fn stepped(typed: &number::Typed, steps: i32) -> Option<String> {
    const MOST_DECIMALS: usize = 12;
    if typed.number <= 0.0 {
        return None;
    }
    if typed.number_text.contains(['e', 'E', '×', '*']) {
        // The last digit of 1e3 is a thousand: too coarse a step, so count hundredths of the number.
        let value = typed.number * (1.0 + f64::from(steps) * 0.01);
        return (value.is_normal() && value > 0.0).then(|| plain(value));
    }
    let typed_decimals = typed.number_text.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    (typed_decimals..=MOST_DECIMALS).find_map(|decimals| {
        let last_digit = format!("1e-{decimals}").parse::<f64>().ok()?;
        let value = typed.number + f64::from(steps) * last_digit;
        // Half a digit above zero would print as zero.
        (value > last_digit / 2.0).then(|| format!("{value:.decimals$}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields;

    #[test]
    fn stepping_counts_the_last_typed_digit_and_never_reaches_zero() {
        let stepped = |text: &str, steps: i32| {
            let mut entry = Entry::new(text, None);
            entry.step(fields::DISPARITY, steps);
            entry.text
        };
        for (text, steps, expected) in [
            ("50", 1, "51"),
            ("50", -1, "49"),
            ("50", 10, "60"),
            ("50.3", 1, "50.4"),
            ("0,30", 1, "0.31"),
            ("5", -10, "4.0"),
            ("1", -1, "0.9"),
            ("1e3", 1, "1010"),
            ("3 px", 1, "4"),
            ("", 1, "50"),
            ("abc", 1, "abc"),
            ("-3", 1, "-3"),
            ("4 kg", 1, "4 kg"),
            ("4 mrad", 1, "5 mrad"),
            ("20°", 1, "21°"),
            ("1/3", 1, "1/3"),
        ] {
            assert_eq!(stepped(text, steps), expected, "{text:?} by {steps}");
        }
        let mut angle = Entry::new("0.35 rad", None);
        angle.step(fields::TILT, 1);
        assert_eq!(angle.text, "0.36 rad");
    }
}
