//! Pieces of sentences.

use crate::field::Key;
use crate::fields;
use depth_core::setup::{Object, Pair};

/// `text` with a capital first letter.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| {
        std::iter::once(first.to_ascii_uppercase()).chain(chars).collect()
    })
}

/// `text` as it stands in the middle of a line: with a small first letter, where that begins a word of several.
pub fn lower(text: &str) -> String {
    let mut chars = text.chars();
    match (chars.next(), chars.next()) {
        (Some(first), Some(second)) if second.is_lowercase() => {
            std::iter::once(first.to_ascii_lowercase()).chain(text.chars().skip(1)).collect()
        }
        _ => text.to_owned(),
    }
}

/// What is still needed: "needs b and d"; empty where nothing is.
pub fn needs(missing: &[Key]) -> String {
    let symbols: Vec<&str> = missing.iter().map(|key| key.symbol).collect();
    match symbols.as_slice() {
        [] => String::new(),
        [one] => format!("needs {one}"),
        [first @ .., last] => format!("needs {} and {last}", first.join(", ")),
    }
}

/// How many σ: what is left of a difference by rounding is none, and beyond 10 it only matters that it is beyond (computed from the
/// logarithms, it is not what a reader computes from the two numbers).
pub fn sigmas(z: f64) -> String {
    match z {
        ..0.05 => "0".to_owned(),
        ..9.95 => format!("{z:.1}"),
        _ => "over 10".to_owned(),
    }
}

/// `text` between quotation marks, cut where it is too long to quote. Text that runs from right to left is isolated (UAX 9): it would
/// turn the sentence that begins with it around.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 24;
    let is_right_to_left = |c: char| matches!(c, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{feff}');
    let is_isolated = text.trim().chars().take(LONGEST).any(is_right_to_left);
    let mut quoted = String::from("“");
    quoted.extend(is_isolated.then_some('\u{2068}'));
    for (count, c) in text.trim().chars().enumerate() {
        if count == LONGEST {
            quoted.push('…');
            break;
        }
        // Nor does what is quoted turn anything around.
        let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        quoted.push(if c.is_control() || turns { ' ' } else { c });
    }
    quoted.extend(is_isolated.then_some('\u{2069}'));
    quoted.push('”');
    quoted
}

/// What of the object is measured, in the image and in the world, in the middle of a sentence: "the width in the image", "the real
/// width".
pub fn sizes(object: Object) -> [&'static str; 2] {
    [fields::IMAGE_WIDTH, fields::REAL_WIDTH].map(|key| key.worded(object, Pair::default()).noun)
}

/// A field in the middle of a sentence about causes: "disparity".
pub fn short_name(key: Key) -> &'static str {
    key.noun.trim_start_matches("the ")
}

/// A share of a whole, "75 %"; "< 1 %" where there is something that rounds to nothing. Several that belong together are
/// [`shares`].
pub fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent > 0.0 && percent < 0.5 {
        BELOW_ONE.to_owned()
    } else {
        format!("{percent:.0} %")
    }
}

const BELOW_ONE: &str = "< 1 %";

/// Shares of one whole, in percent of it and in their order: what is written adds up to what they add up to, 100 % where they are all
/// (largest remainders). What is above 0 and has none of it is "< 1 %". What is no share, such as NaN, counts as 0.
pub fn shares(shares: &[f64]) -> Vec<String> {
    let exact: Vec<f64> = shares
        .iter()
        .map(|share| (share * 100.0).clamp(0.0, 100.0))
        .map(|p| if p.is_nan() { 0.0 } else { p })
        .collect();
    // What is below a half is never rounded up.
    let whole = |percent: f64| if percent < 0.5 { 0.0 } else { percent.floor() };
    let mut written: Vec<f64> = exact.iter().copied().map(whole).collect();
    let total = exact.iter().sum::<f64>().round();
    let mut by_remainder: Vec<usize> = (0..exact.len()).collect();
    let remainder = |at: &usize| {
        exact
            .get(*at)
            .map_or(0.0, |percent| if *percent < 0.5 { 0.0 } else { percent.fract() })
    };
    by_remainder.sort_by(|a, b| remainder(b).total_cmp(&remainder(a)));
    let mut left = total - written.iter().sum::<f64>();
    for at in by_remainder {
        if left < 0.5 {
            break;
        }
        if let Some(percent) = written.get_mut(at).filter(|_| remainder(&at) > 0.0) {
            *percent += 1.0;
            left -= 1.0;
        }
    }
    // What many small ones have together goes to the largest.
    if left > 0.5
        && let Some(largest) = written.iter_mut().max_by(|a, b| a.total_cmp(b)).filter(|largest| **largest > 0.0)
    {
        *largest += left;
    }
    let text = |(percent, exact): (f64, f64)| {
        if percent == 0.0 && exact > 0.0 {
            BELOW_ONE.to_owned()
        } else {
            format!("{percent:.0} %")
        }
    };
    written.into_iter().zip(exact).map(text).collect()
}

#[cfg(test)]
mod tests {
    use super::{quoted, shares};

    #[test]
    fn shares_add_up_to_a_hundred_percent() {
        for (parts, expected) in [
            (&[0.752, 0.188, 0.060][..], &["75 %", "19 %", "6 %"][..]),
            (&[1.0 / 3.0; 3], &["34 %", "33 %", "33 %"]),
            (&[0.146, 0.146, 0.708], &["15 %", "14 %", "71 %"]),
            (&[0.858, 0.138, 0.004], &["86 %", "14 %", "< 1 %"]),
            (&[0.996, 0.004], &["100 %", "< 1 %"]),
            (&[0.984, 0.004, 0.004, 0.004, 0.004], &["100 %", "< 1 %", "< 1 %", "< 1 %", "< 1 %"]),
            (&[1.0, 0.0], &["100 %", "0 %"]),
            (&[0.745, 0.245, f64::NAN], &["75 %", "24 %", "0 %"]),
            (&[], &[]),
        ] {
            assert_eq!(shares(parts), expected, "{parts:?}");
        }
    }

    #[test]
    fn only_text_that_runs_from_right_to_left_is_isolated() {
        assert_eq!(quoted(" far "), "“far”");
        assert_eq!(quoted("متر ٥"), "“\u{2068}متر ٥\u{2069}”");
        assert_eq!(quoted("מטר"), "“\u{2068}מטר\u{2069}”");
        assert_eq!(quoted("a".repeat(30).as_str()), format!("“{}…”", "a".repeat(24)));
    }
}
