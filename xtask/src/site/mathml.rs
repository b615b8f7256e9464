//! The formulas of the Learn text in MathML, which browsers draw and screen readers read.
//!
//! A formula is one line: `D = fx · b / d`. A `/` divides everything before it in its product by the one factor after it;
//! `_` starts a subscript; `√` stands before its factor; brackets around a whole numerator, denominator or radicand are
//! not drawn, because the bar already says what they say.

use std::fmt::Write as _;
use std::iter::Peekable;
use std::str::Chars;

use super::html::escaped;

/// One formula as a `<math>` element of its own line. Err: a sentence that names the formula and what was not understood.
pub(super) fn block(formula: &str) -> Result<String, String> {
    let mut parser = Parser {
        rest: formula.chars().peekable(),
    };
    let row = parser
        .relation()
        .and_then(|row| match parser.next() {
            None => Ok(row),
            Some(mark) => Err(format!("\"{mark}\" is out of place")),
        })
        .map_err(|reason| format!("The formula \"{formula}\" cannot be shown: {reason}."))?;
    Ok(format!(
        "<math display=\"block\" alttext=\"{}\">{row}</math>\n",
        escaped(formula.trim())
    ))
}

/// A part of a formula: elements in a row.
struct Part {
    mathml: String,
    /// The row without its brackets, if all of it stands in brackets.
    unbracketed: Option<String>,
}

impl Part {
    fn new(mathml: String) -> Self {
        Self { mathml, unbracketed: None }
    }

    /// As one element, without brackets around the whole.
    fn alone(self) -> String {
        format!("<mrow>{}</mrow>", self.unbracketed.unwrap_or(self.mathml))
    }
}

struct Parser<'a> {
    rest: Peekable<Chars<'a>>,
}

impl Parser<'_> {
    /// `relation := sum { ("=" | "≈") sum }`
    fn relation(&mut self) -> Result<String, String> {
        self.row(&['=', '≈'], Self::sum)
    }

    /// `sum := ["−"] product { ("+" | "−" | "±") product }`
    fn sum(&mut self) -> Result<String, String> {
        let sign = if self.accept('−') { "<mo>−</mo>" } else { "" };
        Ok(sign.to_owned() + &self.row(&['+', '−', '±'], |parser| Ok(parser.product()?.mathml))?)
    }

    fn row(&mut self, marks: &[char], part: impl Fn(&mut Self) -> Result<String, String>) -> Result<String, String> {
        let mut row = part(self)?;
        while let Some(mark) = self.peek().filter(|mark| marks.contains(mark)) {
            self.next();
            // Writing into a text cannot fail.
            write!(row, "<mo>{mark}</mo>{}", part(self)?).ok();
        }
        Ok(row)
    }

    /// `product := power { ("·" | "/") power }`
    fn product(&mut self) -> Result<Part, String> {
        let mut product = self.power()?;
        loop {
            product = if self.accept('·') {
                Part::new(product.mathml + "<mo>·</mo>" + &self.power()?.mathml)
            } else if self.accept('/') {
                Part::new(format!("<mfrac>{}{}</mfrac>", product.alone(), self.power()?.alone()))
            } else {
                return Ok(product);
            };
        }
    }

    /// `power := factor ["²" | "³"]`
    fn power(&mut self) -> Result<Part, String> {
        let factor = self.factor()?;
        let exponent = match self.peek() {
            Some('²') => 2,
            Some('³') => 3,
            _ => return Ok(factor),
        };
        self.next();
        Ok(Part::new(format!("<msup><mrow>{}</mrow><mn>{exponent}</mn></msup>", factor.mathml)))
    }

    /// `factor := "(" sum ")" | "√" factor | number | name`
    fn factor(&mut self) -> Result<Part, String> {
        match self.peek() {
            Some('(') => {
                self.next();
                let sum = self.sum()?;
                if !self.accept(')') {
                    return Err("a bracket is not closed".to_owned());
                }
                Ok(Part {
                    mathml: format!("<mo>(</mo>{sum}<mo>)</mo>"),
                    unbracketed: Some(sum),
                })
            }
            Some('√') => {
                self.next();
                Ok(Part::new(format!("<msqrt>{}</msqrt>", self.factor()?.alone())))
            }
            Some(digit) if digit.is_ascii_digit() => {
                let number = self.take_while(|c| c.is_ascii_digit() || c == '.');
                Ok(Part::new(format!("<mn>{number}</mn>")))
            }
            Some(letter) if letter.is_alphabetic() => Ok(Part::new(self.name())),
            Some(mark) => Err(format!("\"{mark}\" is out of place")),
            None => Err("it ends too early".to_owned()),
        }
    }

    /// A variable, whose name is letters and perhaps a subscript; a Δ in front of it is a sign of its own.
    fn name(&mut self) -> String {
        let letters = self.take_while(char::is_alphabetic);
        let name = match letters.strip_prefix('Δ') {
            Some(changing) if !changing.is_empty() => format!("<mrow><mi mathvariant=\"normal\">Δ</mi><mi>{changing}</mi></mrow>"),
            _ => format!("<mi>{letters}</mi>"),
        };
        // Without white space: a subscript touches its letter.
        if self.rest.peek() != Some(&'_') {
            return name;
        }
        self.rest.next();
        let subscript = self.take_while(char::is_alphanumeric);
        let kind = if subscript.chars().all(|c| c.is_ascii_digit()) {
            "mn"
        } else {
            "mi"
        };
        format!("<msub>{name}<{kind}>{subscript}</{kind}></msub>")
    }

    fn take_while(&mut self, belongs: impl Fn(char) -> bool) -> String {
        let mut text = String::new();
        while let Some(character) = self.rest.next_if(|character| belongs(*character)) {
            text.push(character);
        }
        text
    }

    fn accept(&mut self, mark: char) -> bool {
        let there = self.peek() == Some(mark);
        if there {
            self.next();
        }
        there
    }

    /// The next character that is not white space.
    fn peek(&mut self) -> Option<char> {
        while self.rest.next_if(|character| character.is_whitespace()).is_some() {}
        self.rest.peek().copied()
    }

    fn next(&mut self) -> Option<char> {
        self.peek();
        self.rest.next()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::block;

    /// What stands inside the `<math>` element.
    fn inside(formula: &str) -> String {
        let block = block(formula).unwrap();
        let (start, row) = block.split_once('>').unwrap();
        assert_eq!(start, format!("<math display=\"block\" alttext=\"{formula}\""));
        row.strip_suffix("</math>\n").unwrap().to_owned()
    }

    #[test]
    fn a_fraction_takes_the_whole_product_before_it() {
        assert_eq!(
            inside("D = fx · b / d"),
            "<mi>D</mi><mo>=</mo><mfrac><mrow><mi>fx</mi><mo>·</mo><mi>b</mi></mrow><mrow><mi>d</mi></mrow></mfrac>"
        );
    }

    #[test]
    fn what_follows_a_fraction_multiplies_it() {
        assert_eq!(
            inside("a / b · c"),
            "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac><mo>·</mo><mi>c</mi>"
        );
    }

    #[test]
    fn brackets_go_where_a_bar_says_the_same_and_stay_elsewhere() {
        assert_eq!(
            inside("(a + b) / (c · d)"),
            "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mi>c</mi><mo>·</mo><mi>d</mi></mrow></mfrac>"
        );
        assert_eq!(
            inside("f · (X − b) / Z"),
            "<mfrac><mrow><mi>f</mi><mo>·</mo><mo>(</mo><mi>X</mi><mo>−</mo><mi>b</mi><mo>)</mo></mrow><mrow><mi>Z</mi></mrow></mfrac>"
        );
    }

    #[test]
    fn subscripts_powers_roots_and_changes_have_their_elements() {
        assert_eq!(inside("w_real"), "<msub><mi>w</mi><mi>real</mi></msub>");
        assert_eq!(inside("X_1"), "<msub><mi>X</mi><mn>1</mn></msub>");
        assert_eq!(inside("Z²"), "<msup><mrow><mi>Z</mi></mrow><mn>2</mn></msup>");
        assert_eq!(inside("√(2.5 ± σ)"), "<msqrt><mrow><mn>2.5</mn><mo>±</mo><mi>σ</mi></mrow></msqrt>");
        assert_eq!(inside("−Δd"), "<mo>−</mo><mrow><mi mathvariant=\"normal\">Δ</mi><mi>d</mi></mrow>");
    }

    #[test]
    fn what_is_no_formula_is_refused_by_name() {
        for (formula, reason) in [
            ("D = fx ·", "it ends too early"),
            ("D = (fx", "a bracket is not closed"),
            ("D = fx)", "\")\" is out of place"),
            ("D = fx b", "\"b\" is out of place"),
            ("D = <b>", "\"<\" is out of place"),
            ("", "it ends too early"),
        ] {
            let error = block(formula).unwrap_err();
            assert_eq!(error, format!("The formula \"{formula}\" cannot be shown: {reason}."));
        }
    }
}
