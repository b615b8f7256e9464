//! A Q matrix as people paste it: printed by numpy or MATLAB, written in a program, cut from OpenCV's YAML, XML or JSON, or
//! sixteen numbers. One scanner takes the numbers behind the name Q; it is no parser of any of these formats.

use crate::assess::Assessment;
use crate::fields::{CX, CY};
use crate::note::Issue;
use crate::number::plain;
use depth_core::q_matrix::{self, StereoGeometry};
use depth_core::quantity::Pixels;

/// Reads the Q matrix in `text`. In a whole calibration file it is the entry named Q.
///
/// # Errors
/// What is wrong with the text, or which entry of the matrix cannot be one of a Q.
pub fn read(text: &str) -> Result<StereoGeometry, Issue> {
    let Scanned { numbers, factor } = numbers(entries(text)?)?;
    let mut matrix = [[0.0; 4]; 4];
    for (slot, number) in matrix.iter_mut().flatten().zip(&numbers) {
        *slot = number * factor.unwrap_or(1.0);
    }
    if numbers.len() != 16 {
        return Err(Issue::QMatrixCount { found: numbers.len() });
    }
    let is_rounded = factor.is_some() && matrix[3][2] == 0.0;
    q_matrix::read(&matrix).map_err(|wrong| {
        if is_rounded && (wrong.row, wrong.column) == (3, 2) {
            return Issue::QMatrixRounded;
        }
        Issue::QMatrixEntry {
            row: wrong.row + 1,
            column: wrong.column + 1,
            expected: wrong.expected,
            found: wrong.found,
        }
    })
}

/// A part of the text that means something here.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Token<'a> {
    /// A name, with what stands between it and the next sign but quotes and spaces: `:` and `=` make it the name of a value, as
    /// does a `<` before it.
    Name { name: &'a str, is_of_value: bool, rest: &'a str },
    /// A number, which may be a fraction such as `-1/0.2`.
    Number(f64),
    /// What looks like a number or part of a calculation, and is none.
    Unreadable(&'a str),
    /// The factor in front of a matrix that MATLAB prints.
    Times,
    /// The end of an element of XML.
    Closing,
}

/// What is part of the values of a matrix, and not the name of another one.
const OWN_NAMES: [&str; 14] = [
    "data", "rows", "cols", "dt", "d", "type_id", "dtype", "opencv", "matrix", "array", "np", "numpy", "order", "xml",
];

/// The part of `text` that holds the sixteen entries: what follows the name Q, and there the name "data".
fn entries(text: &str) -> Result<&str, Issue> {
    let mut others = false;
    let mut scanner = Scanner { rest: text, before: ' ' };
    while let Some(token) = scanner.next() {
        match token {
            Token::Name { name: "Q", rest, .. } => return Ok(behind_data(rest)),
            Token::Name {
                name, is_of_value: true, ..
            } if !OWN_NAMES.contains(&name) => others = true,
            _ => {}
        }
    }
    if others { Err(Issue::NoQMatrix) } else { Ok(behind_data(text)) }
}

/// `text` behind the name "data", if the next numbers are its own: rows and columns are numbers too.
fn behind_data(text: &str) -> &str {
    let mut scanner = Scanner { rest: text, before: ' ' };
    while let Some(token) = scanner.next() {
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

/// The numbers of a matrix and what all of them are to be multiplied by.
struct Scanned {
    numbers: Vec<f64>,
    factor: Option<f64>,
}

/// The numbers at the beginning of `text`, up to the next name.
fn numbers(text: &str) -> Result<Scanned, Issue> {
    let mut numbers = Vec::new();
    let mut factor = None;
    let mut scanner = Scanner { rest: text, before: ' ' };
    while let Some(token) = scanner.next() {
        match token {
            Token::Number(number) => numbers.push(number),
            Token::Unreadable(word) => {
                return Err(Issue::QMatrixNumber { text: word.to_owned() });
            }
            Token::Times if factor.is_none() && numbers.len() == 1 => factor = numbers.pop(),
            Token::Times => {
                return Err(Issue::QMatrixNumber { text: "*".to_owned() });
            }
            Token::Name { .. } | Token::Closing if !numbers.is_empty() => break,
            Token::Name { .. } | Token::Closing => {}
        }
    }
    Ok(Scanned { numbers, factor })
}

/// Cuts a text into tokens.
struct Scanner<'a> {
    rest: &'a str,
    /// The last sign that is no space or quote.
    before: char,
}

impl<'a> Iterator for Scanner<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        loop {
            let text = self.rest;
            let first = text.chars().next()?;
            if first.is_ascii_digit() || (matches!(first, '.' | '-' | '−' | '+') && starts_number(text)) {
                return Some(self.number(text));
            }
            if first.is_alphabetic() || first == '_' {
                return Some(self.name(text));
            }
            self.rest = text.get(first.len_utf8()..).unwrap_or_default();
            if first == '<' && self.rest.starts_with('/') {
                return Some(Token::Closing);
            }
            if first == '*' {
                return Some(Token::Times);
            }
            if !first.is_whitespace() && !matches!(first, '"' | '\'') {
                self.before = first;
            }
        }
    }
}

impl<'a> Scanner<'a> {
    fn name(&mut self, text: &'a str) -> Token<'a> {
        let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
        let (name, rest) = text.split_at_checked(end).unwrap_or((text, ""));
        self.rest = rest;
        let is_tag = self.before == '<';
        let is_minus = matches!(self.before, '-' | '−');
        self.before = ' ';
        let lower = name.to_ascii_lowercase();
        if is_minus || lower.starts_with("nan") || lower.starts_with("inf") {
            return Token::Unreadable(name);
        }
        let next = rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '"' | '\''));
        // The declaration of XML has names of its own.
        let is_of_value = is_tag || (next.starts_with([':', '=']) && !next.starts_with("=="));
        Token::Name { name, is_of_value, rest }
    }

    fn number(&mut self, text: &'a str) -> Token<'a> {
        self.before = '0';
        let Some((number, rest)) = leading_number(text) else {
            let end = text.find(is_gap).unwrap_or(text.len());
            let (word, rest) = text.split_at_checked(end).unwrap_or((text, ""));
            self.rest = rest;
            return Token::Unreadable(word);
        };
        self.rest = rest;
        match rest
            .trim_start_matches(' ')
            .strip_prefix('/')
            .and_then(|divisor| leading_number(divisor.trim_start_matches(' ')))
        {
            Some((divisor, rest)) => {
                self.rest = rest;
                let fraction = number / divisor;
                if fraction.is_finite() {
                    Token::Number(fraction)
                } else {
                    Token::Unreadable(text.get(..text.len() - rest.len()).unwrap_or(text))
                }
            }
            None => Token::Number(number),
        }
    }
}

/// Whether the sign or point that `text` starts with belongs to a number.
fn starts_number(text: &str) -> bool {
    let unsigned = text.trim_start_matches(['-', '−', '+']);
    unsigned.trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit())
}

/// The number that `text` starts with, and what follows it. `None` where it goes on with something else.
fn leading_number(text: &str) -> Option<(f64, &str)> {
    let mut in_exponent = false;
    let mut previous = ' ';
    let end = text
        .find(|c: char| {
            let belongs = match c {
                '0'..='9' | '.' => true,
                '+' | '-' | '−' => previous == ' ' || matches!(previous, 'e' | 'E'),
                'e' | 'E' => !std::mem::replace(&mut in_exponent, true),
                _ => false,
            };
            previous = c;
            !belongs
        })
        .unwrap_or(text.len());
    let (number, rest) = text.split_at_checked(end)?;
    if rest.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        return None;
    }
    let number: f64 = number.replace('−', "-").parse().ok()?;
    number.is_finite().then_some((number, rest))
}

fn is_gap(c: char) -> bool {
    c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '(' | ')' | '{' | '}' | '<')
}

/// What a Q matrix would hold of the form: its baseline in meters. `None` while focal length, baseline or principal point is
/// missing.
pub fn of_form(assessment: &Assessment) -> Option<StereoGeometry> {
    let problem = &assessment.solution.problem;
    let pixels = |key| assessment.reading(key).map(|reading| Pixels::new(reading.value));
    Some(StereoGeometry {
        focal_length: problem.focal_length?.value,
        baseline: problem.baseline?.value.m(),
        doffs: problem.offset().value,
        cx: pixels(CX)?,
        cy: pixels(CY)?,
        swapped: false,
    })
}

/// The Q matrix of `geometry` as `stereoRectify` makes it, in the notation of numpy, which every reader of Q here takes too.
pub fn written(geometry: &StereoGeometry) -> Option<String> {
    let matrix = q_matrix::of(geometry)?;
    let rows = matrix.map(|row| format!("[{}]", row.map(plain).join(", ")));
    Some(format!("[{}]", rows.join(",\n ")))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    /// OpenCV 4.14, stereoRectify with T = (−100, 0, 0), cx 610 and 650: Q[2][3] = 700, Q[3][2] = 0.01, Q[3][3] = 0.4.
    fn is_the_reference(text: &str) {
        let q = read(text).unwrap();
        assert_eq!(
            (q.focal_length.px(), q.baseline, q.doffs.px(), q.swapped),
            (700.0, 100.0, 40.0, false),
            "{text}"
        );
        assert_eq!((q.cx.px(), q.cy.px()), (610.0, 350.0));
    }

    #[test]
    fn numpy_yaml_xml_and_plain_numbers_are_read() {
        is_the_reference(
            "array([[ 1.00e+00,  0.,  0., -6.10e+02],\n [0., 1., 0., -350.],\n [0., 0., 0., 700.],\n [0., 0., 0.01, 0.4]], dtype=float64)",
        );
        is_the_reference(
            "[[   1.    0.    0. -610.  ]\n [   0.    1.    0. -350.  ]\n [   0.    0.    0.  700.  ]\n [   0.    0.    0.01    0.4 ]]",
        );
        is_the_reference(
            "%YAML:1.0\n---\nP2: !!opencv-matrix\n   rows: 3\n   cols: 4\n   data: [ 1., 2., 3. ]\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ 1., 0., 0., -610., 0., 1., 0., -350., 0., 0.,\n       0., 700., 0., 0., 0.01, 0.4 ]\n",
        );
        is_the_reference(
            "<Q type_id=\"opencv-matrix\"><rows>4</rows><cols>4</cols><dt>d</dt><data>\n1. 0. 0. -610. 0. 1. 0. -350. 0. 0. 0. 700. 0. 0. 0.01 0.4</data></Q>",
        );
        is_the_reference("Q = 1 0 0 −610; 0 1 0 −350; 0 0 0 700; 0 0 0.01 0.4");
    }

    /// OpenCV's own formats, and what programs print and people write.
    #[test]
    fn every_way_to_write_it_is_read() {
        is_the_reference("np.float32([[1,0,0,-610],[0,1,0,-350],[0,0,0,700],[0,0,0.01,0.4]])");
        is_the_reference("Q = np.array([[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, -1/-100, 0.4]], dtype=np.float32)");
        is_the_reference("numpy.array([[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, 1 / 100, 0.4]])");
        is_the_reference(
            "stereo:\n   K1: !!opencv-matrix\n      rows: 3\n      cols: 3\n      dt: d\n      data: [ 700., 0., 610., 0., 700., 350., 0., 0., 1. ]\n   Q: !!opencv-matrix\n      rows: 4\n      cols: 4\n      dt: d\n      data: [ 1., 0., 0., -610., 0., 1., 0., -350., 0., 0.,\n          0., 700., 0., 0., 0.01, 0.4 ]\n   R1: !!opencv-matrix\n      rows: 3\n      cols: 3\n      data: [ 1., 2., 3. ]\n",
        );
        is_the_reference(
            r#"{ "K1": { "type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d", "data": [ 7.0, 0.0, 6.1 ] },
                 "Q": { "type_id": "opencv-matrix", "rows": 4, "cols": 4, "dt": "d",
                   "data": [ 1.0, 0.0, 0.0, -610.0, 0.0, 1.0, 0.0, -350.0, 0.0, 0.0, 0.0, 700.0, 0.0, 0.0, 0.01, 0.4 ] },
                 "rms": 0.2 }"#,
        );
        is_the_reference(r#"{"Q": [[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, 0.01, 0.4]], "image_width": 1280}"#);
        is_the_reference(
            "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K1 type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>7 0 6</data></K1>\n<Q type_id=\"opencv-matrix\">\n  <rows>4</rows>\n  <cols>4</cols>\n  <dt>d</dt>\n  <data>\n    1. 0. 0. -610. 0. 1. 0. -350. 0. 0. 0. 700. 0. 0. 1.0e-02 0.4</data></Q>\n<rms>0.2</rms>\n</opencv_storage>",
        );
        is_the_reference("Q:\n- [1, 0, 0, -610]\n- [0, 1, 0, -350]\n- [0, 0, 0, 700]\n- [0, 0, 0.01, 0.4]\n");
        // MATLAB, format short: a factor in front of all.
        is_the_reference(
            "Q =\n\n   1.0e+03 *\n\n    0.0010         0         0   -0.6100\n         0    0.0010         0   -0.3500\n         0         0         0    0.7000\n         0         0    0.00001    0.0004\n",
        );
    }

    #[test]
    fn it_is_refused_for_the_true_reason() {
        let said = |text: &str| read(text).unwrap_err().to_string();
        for without in [
            "%YAML:1.0\nK1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   data: [ 1., 2., 3. ]\n",
            "<opencv_storage><M1><data>1 2 3</data></M1></opencv_storage>",
            "{\"M1\": [[1, 2], [3, 4]]}",
        ] {
            assert!(said(without).contains("There is no Q in it"), "{without}: {}", said(without));
        }
        let rounded = "Q =\n  1.0e+03 *\n 0.0010 0 0 -0.6100\n 0 0.0010 0 -0.3500\n 0 0 0 0.7000\n 0 0 0.0000 0.0004";
        assert!(said(rounded).contains("format long g"), "{}", said(rounded));
        let sample = "Q = np.float32([[1, 0, 0, -0.5*w], [0,-1, 0,  0.5*h], [0, 0, 0, -f], [0, 0, 1, 0]])";
        assert!(said(sample).contains("“*”") || said(sample).contains('w'), "{}", said(sample));
        assert!(said("np.float32([[1,0,0,-320],[0,1,0,-240],[0,0,0,500]])").contains("has 12"));
        assert!(said("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 1/0 0.4").contains("1/0"));
    }

    #[test]
    fn what_is_written_is_read() {
        let q = read("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 0.01 0.4").unwrap();
        let text = written(&q).unwrap();
        assert_eq!(text, "[[1, 0, 0, -610],\n [0, 1, 0, -350],\n [0, 0, 0, 700],\n [0, 0, 0.01, 0.4]]");
        assert_eq!(read(&text), Ok(q));
    }

    #[test]
    fn a_negative_sign_means_swapped() {
        assert!(read("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 -0.01 -0.4").unwrap().swapped);
    }

    #[test]
    fn what_is_no_q_matrix_is_refused_in_words() {
        assert!(read("1 2 3").unwrap_err().to_string().contains("16 numbers; this text has 3"));
        assert!(read("").unwrap_err().to_string().contains("has 0"));
        assert!(read(&"1 ".repeat(16)).unwrap_err().to_string().contains("row 1, column 2"));
        assert!(
            read("1 0 0 -610 0 1 0 -350 0 0 0 nan 0 0 0.01 0.4")
                .unwrap_err()
                .to_string()
                .contains("nan")
        );
    }
}
