//! A Q matrix as people paste it: printed by numpy, cut from OpenCV's YAML or XML, or sixteen numbers.

use depth_core::q_matrix::{self, Expected, StereoGeometry};

/// Reads the Q matrix in `text`. In a whole calibration file it is the entry named Q.
///
/// # Errors
/// A sentence that says what is wrong with the text, or which entry of the matrix cannot be one of a Q.
pub fn read(text: &str) -> Result<StereoGeometry, String> {
    let numbers = numbers(entries(text))?;
    let mut matrix = [[0.0; 4]; 4];
    for (slot, number) in matrix.iter_mut().flatten().zip(&numbers) {
        *slot = *number;
    }
    if numbers.len() != 16 {
        return Err(format!("A Q matrix has 16 numbers; this text has {}.", numbers.len()));
    }
    q_matrix::read(&matrix).map_err(|wrong| {
        let expected = match wrong.expected {
            Expected::Exactly(number) => format!("is {number} in a Q matrix"),
            Expected::Positive => "is the focal length and must be above zero".to_owned(),
            Expected::NotZero => "is one over the baseline and cannot be zero".to_owned(),
            Expected::Finite => "must be a finite number".to_owned(),
        };
        format!(
            "This is not a Q matrix of stereoRectify: row {}, column {} {expected}, here it is {}.",
            wrong.row + 1,
            wrong.column + 1,
            super::number::plain(wrong.found)
        )
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

fn numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(|c: char| c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '(' | ')' | '{' | '}' | '='))
        .map(|word| word.replace('−', "-"))
        .filter(|word| {
            word.chars().any(|c| c.is_ascii_digit()) || word.to_lowercase().contains("nan") || word.to_lowercase().contains("inf")
        })
        .map(|word| match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(format!(
                "{} is not a number that can stand in a Q matrix.",
                super::number::quoted(&word)
            )),
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
        assert!(read("1 2 3").unwrap_err().contains("16 numbers; this text has 3"));
        assert!(read("").unwrap_err().contains("has 0"));
        assert!(read(&"1 ".repeat(16)).unwrap_err().contains("row 1, column 2"));
        assert!(read("1 0 0 -610 0 1 0 -350 0 0 0 nan 0 0 0.01 0.4").unwrap_err().contains("nan"));
    }
}
