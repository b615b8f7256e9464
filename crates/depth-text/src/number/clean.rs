//! What people's keyboards and logs put around a number, taken away before it is parsed.

use super::typed::LONGEST;
use std::borrow::Cow;

/// `text` with digits of other scripts, fractions in one sign and narrow spaces between groups of digits as ASCII has them.
pub fn normalized(text: &str) -> Cow<'_, str> {
    // Nobody types a number so long.
    if text.is_ascii() || text.len() > LONGEST {
        return Cow::Borrowed(text);
    }
    let mut ascii = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            // Arabic-Indic, Persian, full-width.
            '٠'..='٩' => ascii.push(digit(c, '٠')),
            '۰'..='۹' => ascii.push(digit(c, '۰')),
            '０'..='９' => ascii.push(digit(c, '０')),
            '٫' => ascii.push('.'),
            '٬' => ascii.push('\u{2009}'),
            '٪' => ascii.push('%'),
            '⁄' | '÷' => ascii.push('/'),
            // Pages that are read from right to left put them around numbers. What turns digits around is none of them.
            '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202c}' | '\u{2066}'..='\u{2069}' | '\u{feff}' => {}
            _ => match FRACTIONS.iter().find(|(sign, _)| *sign == c) {
                Some((_, fraction)) => ascii.extend([" ", *fraction]),
                None => ascii.push(c),
            },
        }
    }
    Cow::Owned(without_narrow_spaces(&ascii))
}

const FRACTIONS: [(char, &str); 10] = [
    ('½', "1/2"),
    ('⅓', "1/3"),
    ('⅔', "2/3"),
    ('¼', "1/4"),
    ('¾', "3/4"),
    ('⅛', "1/8"),
    ('⅜', "3/8"),
    ('⅝', "5/8"),
    ('⅞', "7/8"),
    ('⅙', "1/6"),
];

fn digit(c: char, zero: char) -> char {
    let value = u32::from(c) - u32::from(zero);
    char::from_digit(value, 10).unwrap_or(c)
}

/// A narrow space is no decimal mark anywhere, so that one between a digit and three others groups them; behind a decimal mark also
/// fewer, as the last group may be shorter: 0.012 30.
fn without_narrow_spaces(text: &str) -> String {
    let mut joined = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        let rest = text.get(at + c.len_utf8()..).unwrap_or_default();
        let digits = rest.chars().take_while(char::is_ascii_digit).count();
        let is_narrow = matches!(c, '\u{2009}' | '\u{202f}') && joined.ends_with(|c: char| c.is_ascii_digit());
        if !is_narrow || !(digits == 3 || (digits < 3 && digits > 0 && ends_in_whole_decimals(&joined))) {
            joined.push(c);
        }
    }
    joined
}

/// Whether `text` ends with decimals in whole groups of three.
fn ends_in_whole_decimals(text: &str) -> bool {
    let before = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let decimals = text.len() - before.len();
    before.ends_with(['.', ',']) && decimals > 0 && decimals.is_multiple_of(3)
}

/// What stands behind a name: "718.856 px" of "fx = 718.856 px" and of "\"fx\": 718.856,".
pub fn without_name(text: &str) -> &str {
    let is_name = |name: &str| {
        let name = name.trim();
        name.starts_with(|c: char| c.is_alphabetic() || matches!(c, '"' | '\'' | '_')) && name.len() <= LONGEST_NAME
    };
    let behind = |sign| text.split_once(sign).filter(|(name, _)| is_name(name));
    match behind('=').or_else(|| behind(':')) {
        Some((_, value)) if !value.trim().is_empty() => without_brackets(value.trim().trim_end_matches([',', ';']).trim_end()),
        _ => without_brackets(text),
    }
}

/// The name in front of a value: "fx" of "fx = 718.856 px".
pub fn name(text: &str) -> Option<&str> {
    if text.len() > LONGEST {
        return None;
    }
    let value = without_name(text);
    let name = text.trim().strip_suffix(value)?.trim_end();
    let name = name.strip_suffix(['=', ':'])?.trim();
    Some(name.trim_matches(['"', '\'']))
}

const LONGEST_NAME: usize = 40;

/// A unit without the brackets that logs and tables put around it: `px` of `[px]`.
pub fn without_brackets(unit: &str) -> &str {
    let inside = |open, close| unit.strip_prefix(open).and_then(|rest: &str| rest.strip_suffix(close));
    inside('[', ']').or_else(|| inside('(', ')')).map_or(unit, str::trim)
}
