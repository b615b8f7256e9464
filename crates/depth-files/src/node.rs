//! What a structured file holds, whatever it is written in: texts, lists and maps, each with its line.

use crate::format::Format;
use crate::number::number;
use crate::place::Place;
use crate::refusal::Refusal;

/// A part of a file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) place: Place,
    pub(crate) value: Value,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Text(String),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
}

impl Node {
    /// The part with this key, in whatever case.
    pub(crate) fn get(&self, key: &str) -> Option<&Self> {
        self.entries()
            .find(|(name, _)| name.eq_ignore_ascii_case(key))
            .map(|(_, node)| node)
    }

    /// What a map holds, in the order of the file; nothing for anything else.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (&str, &Self)> {
        let entries: &[(String, Self)] = match &self.value {
            Value::Map(entries) => entries,
            _ => &[],
        };
        entries.iter().map(|(key, node)| (key.as_str(), node))
    }

    /// What a list holds; nothing for anything else.
    pub(crate) fn items(&self) -> &[Self] {
        match &self.value {
            Value::List(items) => items,
            _ => &[],
        }
    }

    pub(crate) fn text(&self) -> Option<&str> {
        match &self.value {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// All numbers in it, row after row: of a list of lists, of a text with blanks between them, or of a matrix as OpenCV and ROS write it,
    /// with `rows`, `cols` and `data`. `name`: what to call it where something in it is no number.
    pub(crate) fn numbers(&self, format: Format, name: &str) -> Result<Vec<f64>, Refusal> {
        match &self.value {
            Value::Map(_) => match self.get("data") {
                Some(data) => data.numbers(format, name),
                None => Err(self.is_no_number(format, name, "a map")),
            },
            Value::List(items) => {
                let all = items.iter().map(|item| item.numbers(format, name)).collect::<Result<Vec<_>, _>>()?;
                Ok(all.concat())
            }
            Value::Text(text) => {
                let parts = text.split_whitespace();
                parts
                    .map(|part| number(part).ok_or_else(|| self.is_no_number(format, name, part)))
                    .collect()
            }
        }
    }

    /// The coefficients of a distortion, or none where they cannot be read.
    pub(crate) fn coefficients(node: Option<&Self>, format: Format) -> Vec<f64> {
        crate::checks::coefficients(node.and_then(|node| node.numbers(format, "the distortion").ok()))
    }

    /// As many numbers as are expected. `rows` says how many in words.
    pub(crate) fn array<const N: usize>(&self, format: Format, name: &str, expected: &'static str) -> Result<[f64; N], Refusal> {
        let numbers = self.numbers(format, name)?;
        let count = numbers.len();
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(self.is_no_number(format, name, &number.to_string()));
        }
        <[f64; N]>::try_from(numbers).map_err(|_| Refusal::Count {
            format,
            name: name.to_owned(),
            place: self.place,
            count,
            expected: expected.to_owned(),
        })
    }

    /// One number.
    pub(crate) fn number(&self, format: Format, name: &str) -> Result<f64, Refusal> {
        let [number] = self.array(format, name, "1")?;
        Ok(number)
    }

    fn is_no_number(&self, format: Format, name: &str, text: &str) -> Refusal {
        Refusal::NotANumber {
            format,
            name: name.to_owned(),
            place: self.place,
            text: text.chars().take(40).collect(),
        }
    }
}
