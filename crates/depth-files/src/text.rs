//! Files of lines.

use crate::format::Format;
use crate::number::first_numbers;
use crate::place::Place;
use crate::refusal::Refusal;

/// A line, counted from 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'a> {
    pub(crate) place: Place,
    pub(crate) text: &'a str,
}

/// The lines of `text` that hold something, without blanks around them.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> + Clone {
    let all = text.lines().enumerate().map(|(index, text)| Line {
        // Formats of lines have both cameras in one file.
        place: Place { file: 0, line: index + 1 },
        text: text.trim(),
    });
    all.filter(|line| !line.text.is_empty())
}

impl Line<'_> {
    /// As many numbers as are expected, and nothing else.
    pub(crate) fn array<const N: usize>(self, text: &str, format: Format, name: &str, expected: &'static str) -> Result<[f64; N], Refusal> {
        let not_a_number = |text: &str| Refusal::NotANumber {
            format,
            name: name.to_owned(),
            place: self.place,
            text: text.trim().chars().take(40).collect(),
        };
        let (count, all) = first_numbers::<N>(text).ok_or_else(|| not_a_number(text))?;
        if count != N {
            return Err(Refusal::Count {
                format,
                name: name.to_owned(),
                place: self.place,
                count,
                expected: expected.to_owned(),
            });
        }
        match all.iter().find(|number| !number.is_finite()) {
            Some(number) => Err(not_a_number(&number.to_string())),
            None => Ok(all),
        }
    }
}
