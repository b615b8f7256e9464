//! Text as HTML: escaped, with symbols that have true subscripts.

use crate::report::{Line, Part, Tone};

/// The symbols that have a subscript, and where that begins.
const SUBSCRIPTS: [(&str, &str); 16] = [
    ("fx", "x"),
    ("fy", "y"),
    ("cx", "x"),
    ("cy", "y"),
    ("w_img", "img"),
    ("w_real", "real"),
    ("f_lens", "lens"),
    ("w_1", "1"),
    ("w_2", "2"),
    ("u_1", "1"),
    ("u_2", "2"),
    ("v_1", "1"),
    ("v_2", "2"),
    ("d_1", "1"),
    ("d_2", "2"),
    ("h_target", "target"),
];

/// `text` with the signs escaped that mean something in HTML, in an attribute too.
pub(super) fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\'' => html.push_str("&#39;"),
            c => html.push(c),
        }
    }
    html
}

/// `text` escaped, its symbols with their subscripts: "f<sub>x</sub> · b / d".
pub(super) fn with_symbols(text: &str) -> String {
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut html = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_word = is_of_word(first);
        let end = rest.find(|c| is_of_word(c) != is_word).unwrap_or(rest.len());
        let (word, after) = rest.split_at_checked(end).unwrap_or((rest, ""));
        match SUBSCRIPTS.iter().find(|(symbol, _)| *symbol == word) {
            Some((symbol, below)) => {
                let base = symbol.trim_end_matches(below).trim_end_matches('_');
                html.push_str(&format!("{base}<sub>{below}</sub>"));
            }
            None => html.push_str(&together(&escaped(word), &html, after)),
        }
        rest = after;
    }
    html
}

/// `between` with a space that does not break where it stands between a number and its unit.
fn together(between: &str, before: &str, after: &str) -> String {
    let is_behind_number = |text: &str| text.ends_with(|c: char| c.is_ascii_digit() || c == ')');
    let is_unit = after.starts_with(char::is_alphabetic);
    match between {
        " " if is_behind_number(before) && is_unit => "\u{a0}".to_owned(),
        ") " if is_unit => ")\u{a0}".to_owned(),
        _ => between.replace(" %", "\u{a0}%").replace("± ", "±\u{a0}"),
    }
}

/// The class that colors what has this tone.
pub(super) const fn class(tone: Tone) -> &'static str {
    match tone {
        Tone::Stereo => "stereo",
        Tone::Monocular => "monocular",
        Tone::Combined => "combined",
        Tone::Neutral => "neutral",
    }
}

/// `text` in the color of `tone`.
pub(super) fn in_color(tone: Tone, text: &str) -> String {
    format!("<span class=\"{}\">{}</span>", class(tone), with_symbols(text))
}

/// A line of the strip, what belongs to a field in its color.
pub(super) fn line(line: &Line) -> String {
    let part = |part: &Part| match part {
        Part::Text(text) => with_symbols(text),
        Part::Field(key, text) => in_color(Tone::of(*key), text),
    };
    let html = line.parts.iter().map(part).collect::<String>();
    let class = if line.is_refusal { "refusal" } else { "small" };
    format!("<p class=\"{class}\">{html}</p>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_is_typed_is_markup() {
        assert_eq!(escaped("<b a=\"'&\">"), "&lt;b a=&quot;&#39;&amp;&quot;&gt;");
        assert_eq!(
            with_symbols("w_real · fx / w_img <script>"),
            "w<sub>real</sub> · f<sub>x</sub> / w<sub>img</sub> &lt;script&gt;"
        );
        assert_eq!(with_symbols("(1.4 ± 0.1) m, 91 %"), "(1.4 ±\u{a0}0.1)\u{a0}m, 91\u{a0}%");
        assert_eq!(with_symbols("Focal length (fx), fxy"), "Focal length (f<sub>x</sub>), fxy");
    }
}
