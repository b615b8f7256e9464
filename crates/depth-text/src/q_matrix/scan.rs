//! One scanner takes the numbers behind the name Q out of whatever is around them; it is no parser of YAML, XML or JSON.

use crate::note::Issue;

/// A part of the text that means something here.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Token<'a> {
    /// A name. Before `:` and `=`, and as an element of XML, it is the name of a value.
    Name { name: &'a str, is_of_value: bool, rest: &'a str },
    /// A number, which may be a fraction such as `-1/0.2`, and the unit of its last digit.
    Number(f64, f64),
    /// What looks like a number or part of a calculation, and is none.
    Unreadable(&'a str),
    /// The factor in front of a matrix that MATLAB prints.
    Times,
    /// The end of an element of XML.
    Closing,
}

/// What is part of the values of a matrix, and not the name of another one.
const OWN_NAMES: [&str; 19] = [
    "data", "rows", "cols", "dt", "d", "type_id", "dtype", "opencv", "matrix", "array", "np", "numpy", "order", "xml", "version", "tensor",
    "device", "cuda", "cpu",
];

/// Whether `name` is that of a Q matrix.
fn is_q(name: &str) -> bool {
    ["q", "q_matrix", "qmatrix", "q_mat"].iter().any(|q| name.eq_ignore_ascii_case(q))
}

/// The part of `text` that holds the sixteen entries: what follows the name Q, and there the name "data".
pub(super) fn entries(text: &str) -> Result<&str, Issue> {
    let (mut named, mut mentioned, mut others) = (None, None, false);
    for token in Scanner::of(text) {
        match token {
            Token::Name { name, is_of_value, rest } if is_q(name) => {
                let place = if is_of_value { &mut named } else { &mut mentioned };
                place.get_or_insert(rest);
            }
            Token::Name {
                name, is_of_value: true, ..
            } if !OWN_NAMES.contains(&name) => others = true,
            _ => {}
        }
    }
    match named.or(mentioned) {
        Some(rest) => Ok(behind_data(behind_declaration(rest))),
        None if others => Err(Issue::NoQMatrix),
        None => Ok(behind_data(text)),
    }
}

/// `text` behind what declares a variable or opens an element: `[4][4] =`, `= cv::Mat_<double>(4, 4) <<`, ` rows="4">`.
fn behind_declaration(text: &str) -> &str {
    if let Some((_, rest)) = text.split_once("<<") {
        return rest;
    }
    let line = text.lines().next().unwrap_or_default();
    let brackets = line.trim_start().starts_with('[').then(|| text.split_once('=')).flatten();
    let element = line.split_once('>').filter(|(attributes, _)| attributes.contains("=\""));
    match (brackets, element) {
        (Some((before, rest)), _) if !before.contains([',', '\n']) => rest,
        (_, Some((attributes, _))) => text.get(attributes.len() + 1..).unwrap_or(text),
        _ => text,
    }
}

/// `text` behind the name "data", if the next numbers are its own: rows and columns are numbers too.
fn behind_data(text: &str) -> &str {
    for token in Scanner::of(text) {
        match token {
            Token::Name { name: "data", rest, .. } => return rest,
            Token::Name {
                name, is_of_value: true, ..
            } if !OWN_NAMES.contains(&name) => return text,
            _ => {}
        }
    }
    text
}

/// `text` without comments, whose numbers are no entries: of YAML and Python, C, and MATLAB.
pub(super) fn without_comments(text: &str) -> String {
    let mut rest = text;
    let mut without = String::with_capacity(text.len());
    while let Some((before, (_, behind))) = rest
        .split_once("/*")
        .and_then(|(before, behind)| Some((before, behind.split_once("*/")?)))
    {
        without.push_str(before);
        rest = behind;
    }
    without.push_str(rest);
    let code = |line: &str| {
        let end = ["#", "%", "//"].into_iter().filter_map(|start| line.find(start)).min();
        line.get(..end.unwrap_or(line.len())).unwrap_or(line).to_owned()
    };
    without.lines().map(code).collect::<Vec<_>>().join("\n")
}

/// The numbers in `entries`; where they are not sixteen, those behind its brackets (a date may stand before them), or with commas
/// for decimal points, if that makes them sixteen.
pub(super) fn sixteen(entries: &str) -> Result<Scanned, Issue> {
    let first = numbers(entries);
    let is_complete = |scanned: &Scanned| scanned.numbers.len() == 16;
    if first.as_ref().is_ok_and(is_complete) {
        return first;
    }
    let in_brackets = entries.find("[[").and_then(|at| numbers(entries.get(at..)?).ok());
    let with_points = || numbers(&with_decimal_points(entries)).ok();
    let in_brackets = in_brackets.filter(is_complete).or_else(|| with_points().filter(is_complete));
    in_brackets.map_or_else(|| first.map(behind_date), Ok)
}

/// Without what stands before the sixteen numbers of a matrix, which begins with 1, 0, 0.
fn behind_date(mut scanned: Scanned) -> Scanned {
    let before = scanned.numbers.len().saturating_sub(16);
    let first: Vec<f64> = scanned.numbers.iter().skip(before).take(3).map(|(number, _)| *number).collect();
    if before > 0 && first == [1.0, 0.0, 0.0] {
        scanned.numbers.drain(..before);
    }
    scanned
}

/// `text` with a point for each comma between two digits.
fn with_decimal_points(text: &str) -> String {
    let mut before = ' ';
    let mut rest = text.chars().peekable();
    let mut written = String::with_capacity(text.len());
    while let Some(c) = rest.next() {
        let is_decimal = c == ',' && before.is_ascii_digit() && rest.peek().is_some_and(char::is_ascii_digit);
        written.push(if is_decimal { '.' } else { c });
        before = c;
    }
    written
}

/// The rows of a matrix that MATLAB or Octave printed in parts because it was too wide, each in one piece again; `None` where it
/// is in one piece. A part is headed "Columns 1 through 3" or "Column 4".
pub(super) fn side_by_side(text: &str) -> Option<String> {
    let is_header = |line: &str| {
        let words = line.trim().trim_end_matches(':');
        let range = words.strip_prefix("Columns ").or_else(|| words.strip_prefix("Column "));
        range.is_some_and(|range| {
            let mut words = range.split_whitespace();
            words.all(|word| word.parse::<usize>().is_ok() || matches!(word, "through" | "to" | "and"))
        })
    };
    let first = text.lines().position(is_header)?;
    let mut joined = text.lines().take(first).collect::<Vec<_>>().join("\n");
    // What follows the numbers is another matrix.
    let is_part = |line: &&str| is_header(line) || starts_number(line.trim_start());
    let lines = text.lines().skip(first).filter(|line| !line.trim().is_empty());
    let lines: Vec<&str> = lines.take_while(is_part).collect();
    let parts = lines.split(|line| is_header(line)).filter(|part| !part.is_empty());
    let parts: Vec<&[&str]> = parts.collect();
    for row in 0..4 {
        joined.push('\n');
        for part in &parts {
            joined.push(' ');
            joined.push_str(part.get(row).copied().unwrap_or_default());
        }
    }
    Some(joined)
}

/// The numbers of a matrix, each with the unit of its last digit, and what all of them are to be multiplied by.
pub(super) struct Scanned {
    pub(super) numbers: Vec<(f64, f64)>,
    pub(super) factor: Option<f64>,
}

/// The numbers at the beginning of `text`, up to the next name, or behind the sixteenth to whatever is no number.
fn numbers(text: &str) -> Result<Scanned, Issue> {
    let mut numbers: Vec<(f64, f64)> = Vec::new();
    let (mut factor, mut is_product) = (None, false);
    for token in Scanner::of(text) {
        match token {
            Token::Number(number, _) if is_product => {
                is_product = false;
                if let Some(last) = numbers.last_mut() {
                    *last = (last.0 * number, 0.0);
                }
            }
            Token::Number(number, unit) => numbers.push((number, unit)),
            _ if numbers.len() == 16 => break,
            Token::Unreadable(word) => {
                return Err(Issue::QMatrixNumber { text: word.to_owned() });
            }
            Token::Times if factor.is_none() && numbers.len() == 1 => factor = numbers.pop().map(|(factor, _)| factor),
            Token::Times if !numbers.is_empty() && !is_product => is_product = true,
            Token::Times if is_product => {
                return Err(Issue::QMatrixNumber { text: "*".to_owned() });
            }
            Token::Name { .. } | Token::Closing if is_product => return Err(Issue::QMatrixNumber { text: "*".to_owned() }),
            Token::Name { .. } | Token::Closing if !numbers.is_empty() => break,
            Token::Name { .. } | Token::Closing | Token::Times => {}
        }
    }
    Ok(Scanned { numbers, factor })
}

/// Cuts a text into tokens.
struct Scanner<'a> {
    rest: &'a str,
    /// The sign before `rest`.
    before: char,
}

impl<'a> Iterator for Scanner<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        loop {
            let text = self.rest;
            let first = text.chars().next()?;
            if starts_number(text) {
                return Some(self.number(text));
            }
            if first.is_alphabetic() || first == '_' {
                return Some(self.name(text));
            }
            self.rest = text.get(first.len_utf8()..).unwrap_or_default();
            self.before = first;
            if first == '<' && self.rest.starts_with('/') {
                return Some(Token::Closing);
            }
            if first == '*' {
                return Some(Token::Times);
            }
        }
    }
}

impl<'a> Scanner<'a> {
    const fn of(text: &'a str) -> Self {
        Self { rest: text, before: ' ' }
    }

    fn name(&mut self, text: &'a str) -> Token<'a> {
        let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
        let (name, rest) = text.split_at_checked(end).unwrap_or((text, ""));
        self.rest = rest;
        let (is_tag, is_minus) = (self.before == '<', self.before == '-');
        self.before = 'a';
        let lower = name.to_ascii_lowercase();
        if is_minus || matches!(lower.as_str(), "nan" | "inf" | "infinity") {
            return Token::Unreadable(name);
        }
        let next = rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '"' | '\'' | '*'));
        let is_of_value = is_tag || (next.starts_with([':', '=']) && !next.starts_with("==") && !next.starts_with("::"));
        Token::Name { name, is_of_value, rest }
    }

    fn number(&mut self, text: &'a str) -> Token<'a> {
        self.before = '0';
        let Some((number, unit, rest)) = leading_number(text) else {
            let end = text.find(is_gap).unwrap_or(text.len());
            let (word, rest) = text.split_at_checked(end).unwrap_or((text, ""));
            self.rest = rest;
            return Token::Unreadable(word);
        };
        self.rest = rest;
        let Some((divisor, rest)) = rest.trim_start_matches(' ').strip_prefix('/').and_then(divisor) else {
            return Token::Number(number, unit);
        };
        self.rest = rest;
        let fraction = number / divisor;
        if fraction.is_finite() {
            Token::Number(fraction, 0.0)
        } else {
            Token::Unreadable(text.get(..text.len() - rest.len()).unwrap_or(text))
        }
    }
}

/// Whether a number, with its sign, is what `text` starts with.
fn starts_number(text: &str) -> bool {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    unsigned
        .strip_prefix('.')
        .unwrap_or(unsigned)
        .starts_with(|c: char| c.is_ascii_digit())
}

/// The number behind a slash, which may be in parentheses, and what follows it.
fn divisor(text: &str) -> Option<(f64, &str)> {
    let text = text.trim_start_matches(' ');
    match text.strip_prefix('(') {
        Some(inside) => {
            let (number, _, rest) = leading_number(inside.trim_start_matches(' '))?;
            Some((number, rest.trim_start_matches(' ').strip_prefix(')')?))
        }
        None => leading_number(text).map(|(number, _, rest)| (number, rest)),
    }
}

/// The number that `text` starts with, the unit of its last digit, and what follows it. `None` where it goes on with something else.
fn leading_number(text: &str) -> Option<(f64, f64, &str)> {
    let mut in_exponent = false;
    let mut previous = ' ';
    let end = text
        .find(|c: char| {
            let belongs = match c {
                '0'..='9' | '.' => true,
                '+' | '-' => previous == ' ' || matches!(previous, 'e' | 'E'),
                'e' | 'E' => !std::mem::replace(&mut in_exponent, true),
                _ => false,
            };
            previous = c;
            !belongs
        })
        .unwrap_or(text.len());
    let (number, rest) = text.split_at_checked(end)?;
    // The suffix of a float in C.
    let rest = rest
        .strip_prefix(['f', 'F'])
        .filter(|rest| !rest.starts_with(is_of_word))
        .unwrap_or(rest);
    if rest.starts_with(is_of_word) {
        return None;
    }
    let value: f64 = number.parse().ok()?;
    let mantissa = number.split(['e', 'E']).next().unwrap_or(number);
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let unit = if decimals == 0 || in_exponent {
        0.0
    } else {
        0.1_f64.powi(i32::try_from(decimals).unwrap_or(i32::MAX))
    };
    value.is_finite().then_some((value, unit, rest))
}

fn is_of_word(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn is_gap(c: char) -> bool {
    c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '(' | ')' | '{' | '}' | '<')
}
