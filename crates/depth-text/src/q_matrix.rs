//! A Q matrix as people paste it: printed by numpy, cut from OpenCV's YAML or XML, or sixteen numbers.

use crate::note::Issue;
use depth_core::q_matrix::{self, StereoGeometry};

/// Reads the Q matrix in `text`. In a whole calibration file it is the entry named Q.
///
/// # Errors
/// What is wrong with the text, or which entry of the matrix cannot be one of a Q.
pub fn read(text: &str) -> Result<StereoGeometry, Issue> {
    let numbers = numbers(entries(text))?;
    let mut matrix = [[0.0; 4]; 4];
    for (slot, number) in matrix.iter_mut().flatten().zip(&numbers) {
        *slot = *number;
    }
    if numbers.len() != 16 {
        return Err(Issue::QMatrixCount { found: numbers.len() });
    }
    q_matrix::read(&matrix).map_err(|wrong| Issue::QMatrixEntry {
        row: wrong.row + 1,
        column: wrong.column + 1,
        expected: wrong.expected,
        found: wrong.found,
    })
}

/// The part of `text` that holds the sixteen entries.
fn entries(text: &str) -> &str {
    // In a file with several matrices: from the one named Q on.
    let named = ["\nQ:", "\nQ :", "<Q "]
        .iter()
        .find_map(|name| Some(text.split_once(name)?.1))
        .unwrap_or(text);
    let named = named.trim_start().strip_prefix("Q:").unwrap_or(named);
    // Behind the type and the dimensions, which are numbers too.
    if let Some((_, data)) = named.split_once("<data>") {
        return data.split("</data>").next().unwrap_or(data);
    }
    if let Some((_, data)) = named.split_once("data:") {
        return data.split(']').next().unwrap_or(data);
    }
    named.split("dtype").next().unwrap_or(named)
}

fn numbers(text: &str) -> Result<Vec<f64>, Issue> {
    text.split(|c: char| c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '(' | ')' | '{' | '}' | '='))
        .map(|word| word.replace('−', "-"))
        .filter(|word| {
            word.chars().any(|c| c.is_ascii_digit()) || word.to_lowercase().contains("nan") || word.to_lowercase().contains("inf")
        })
        .map(|word| match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(Issue::QMatrixNumber { text: word }),
        })
        .collect()
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
