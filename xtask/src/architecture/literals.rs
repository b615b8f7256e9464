//! Colors and sizes are named in the theme, and used by their names everywhere else.
//!
//! What is looked for outside `src/app/theme`:
//! - a color that is not a field of a palette: `Color32::from_…` (also of `Rgba` and `Hsva`) with a literal inside, a constant such as
//!   `Color32::RED` (`TRANSPARENT` and `PLACEHOLDER` are none), and `hex_color!`;
//! - a number in points as the size of a font (`FontId::new`, `proportional`, `monospace`, `strong`, `regular`, `.size`), the width of
//!   a line (`Stroke::new`), or a radius (`CornerRadius::same`, `.corner_radius`, and the second argument of `.rect_filled`).
//!
//! Zero is no size. Products of a name (`2.0 * STEP`), and the lengths within one picture, are not looked for.

use proc_macro2::{Delimiter, TokenTree};
use std::fmt;
use std::path::Path;

use super::source::{self, group, ident, is_path_separator, is_punct};
use crate::files::collect_files;

/// What draws or may come to draw.
const FOLDERS: &[&str] = &["src", "crates/egui-mirror/src"];
/// Where colors and sizes stand.
const THEME: &[&str] = &["src/app/theme/palette.rs", "src/app/theme/"];

const COLORS: &[&str] = &["Color32", "Rgba", "Hsva", "HsvaGamma"];
/// Constants of `Color32` that are no colors.
const NO_COLORS: &[&str] = &["TRANSPARENT", "PLACEHOLDER"];
/// Functions whose first argument is a size in points: the type or module that they are often called by, and the name.
const SIZED: &[&str] = &[
    "FontId::new",
    "FontId::proportional",
    "FontId::monospace",
    "Stroke::new",
    "CornerRadius::same",
    "strong",
    "regular",
];
/// Methods whose first argument is a size in points.
const SIZED_METHODS: &[&str] = &["size", "corner_radius"];
/// The method whose second argument is a radius.
const FILLED: &str = "rect_filled";

/// How many sizes still stand outside the theme. This number only ever goes down.
const SIZES_LEFT: usize = 0;

/// A color or a size that has no name.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Literal {
    Color(String),
    /// In the call of what, and the number.
    Size(String, String),
}

impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Color(color) => write!(f, "has the color {color}: give it a name in the theme."),
            Self::Size(call, number) => write!(f, "has the size {number} in {call}: give it a name in the theme."),
        }
    }
}

/// Where a literal stands.
type Found = (String, usize, Literal);

/// What breaks the rule in the workspace at `root`, a line each.
pub(super) fn broken(root: &Path) -> Result<Vec<String>, String> {
    let mut files = Vec::new();
    for folder in FOLDERS {
        // A crate that is not there draws nothing.
        collect_files(&root.join(folder), &mut files).ok();
    }
    files.sort();
    let mut found: Vec<Found> = Vec::new();
    for file in files
        .iter()
        .filter(|file| file.extension().is_some_and(|extension| extension == "rs"))
    {
        let name = file.strip_prefix(root).unwrap_or(file).display().to_string().replace('\\', "/");
        if !THEME.iter().any(|theme| name.starts_with(theme)) {
            let literals = in_tokens(&source::read(file)?);
            found.extend(literals.into_iter().map(|(line, literal)| (name.clone(), line, literal)));
        }
    }
    Ok(sentences(&found, SIZES_LEFT))
}

/// Every color, and the sizes where they are more than are left.
fn sentences(found: &[Found], sizes_left: usize) -> Vec<String> {
    let is_color = |literal: &Literal| matches!(literal, Literal::Color(_));
    let sizes = found.iter().filter(|(_, _, literal)| !is_color(literal)).count();
    if sizes < sizes_left {
        println!("Only {sizes} sizes are left outside the theme: let SIZES_LEFT in xtask/src/architecture/literals.rs say so.");
    }
    let shown = found.iter().filter(|(_, _, literal)| is_color(literal) || sizes > sizes_left);
    shown.map(|(file, line, literal)| format!("{file}:{line} {literal}")).collect()
}

/// The literals with their lines.
fn in_tokens(tokens: &[TokenTree]) -> Vec<(usize, Literal)> {
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => found.extend(in_tokens(&group.stream().into_iter().collect::<Vec<_>>())),
            TokenTree::Ident(word) => {
                let literal = color(tokens, at).or_else(|| size(tokens, at));
                found.extend(literal.map(|literal| (word.span().start().line, literal)));
            }
            _ => {}
        }
    }
    found
}

/// The color that begins at `at`.
fn color(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    let word = ident(tokens.get(at))?.to_string();
    if word == "hex_color" && tokens.get(at + 1).is_some_and(|token| is_punct(token, '!')) {
        return Some(Literal::Color("hex_color!".to_owned()));
    }
    if !COLORS.contains(&word.as_str()) || !is_path_separator(tokens, at + 1) {
        return None;
    }
    let name = ident(tokens.get(at + 3))?.to_string();
    let is_constant = name.chars().all(|c| c.is_ascii_uppercase() || c == '_') && !NO_COLORS.contains(&name.as_str());
    let is_literal = name.starts_with("from_") && arguments(tokens, at + 4).iter().flatten().any(|token| literal(token).is_some());
    (is_constant || is_literal).then(|| Literal::Color(format!("{word}::{name}")))
}

/// The size in the call that begins at `at`.
fn size(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    let word = ident(tokens.get(at))?.to_string();
    let before = |distance: usize| at.checked_sub(distance).and_then(|at| tokens.get(at));
    let is_method = before(1).is_some_and(|token| is_punct(token, '.'));
    let of = (at >= 3 && is_path_separator(tokens, at - 2)).then(|| ident(before(3))).flatten();
    let called = of.map(|of| format!("{of}::{word}"));
    let is_function = |name: &&str| !is_method && (*name == word || called.as_deref() == Some(*name));
    let argument = if is_method && word == FILLED {
        1
    } else if is_method && SIZED_METHODS.contains(&word.as_str()) || SIZED.iter().any(is_function) {
        0
    } else {
        return None;
    };
    let arguments = arguments(tokens, at + 1);
    let [token] = arguments.get(argument)?.as_slice() else {
        return None;
    };
    let number = literal(token).filter(|number| number.parse() != Ok(0.0))?;
    Some(Literal::Size(called.unwrap_or(word), number))
}

/// What stands between the commas of the call whose brackets stand at `at`.
fn arguments(tokens: &[TokenTree], at: usize) -> Vec<Vec<TokenTree>> {
    let group = tokens.get(at).and_then(|token| group(token, Delimiter::Parenthesis));
    let inside: Vec<TokenTree> = group.into_iter().flat_map(|group| group.stream()).collect();
    inside.split(|token| is_punct(token, ',')).map(<[TokenTree]>::to_vec).collect()
}

fn literal(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Literal(literal) => Some(literal.to_string()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Literal, in_tokens, sentences, source};

    fn found(text: &str) -> Vec<(usize, Literal)> {
        source::parse(text).map(|tokens| in_tokens(&tokens)).unwrap_or_default()
    }

    #[test]
    fn colors_are_found_with_their_lines() {
        for color in [
            "egui::Color32::from_rgb(1, 2, 3)",
            "Color32::from_gray(9)",
            "Color32::RED",
            "Color32::from_hex(\"#123456\")",
            "Rgba::from_rgb(0.1, red, 0.3)",
            "egui::hex_color!(\"#123456\")",
        ] {
            let lines: Vec<usize> = found(&format!("fn f() {{\n    paint({color});\n}}"))
                .into_iter()
                .map(|(line, _)| line)
                .collect();
            assert_eq!(lines, [2], "{color}");
        }
        for none in [
            "Color32::TRANSPARENT",
            "Color32::from_rgb(r, g, b)",
            "palette.blue",
            "\"Color32::RED\"",
        ] {
            assert_eq!(found(&format!("fn f() {{ paint({none}); }}")), [], "{none}");
        }
    }

    #[test]
    fn sizes_in_points_are_found() {
        for size in [
            "FontId::proportional(17.0)",
            "egui::FontId::new(17.0, family)",
            "RichText::new(text).size(17.0)",
            "theme::strong(17.0)",
            "regular(13)",
            "egui::Stroke::new(1.5, palette.line)",
            "frame.corner_radius(6)",
            "painter.rect_filled(rect.expand(2.0), 3.0, palette.surface)",
        ] {
            assert_eq!(found(&format!("fn f() {{ draw({size}); }}")).len(), 1, "{size}");
        }
        for none in [
            "theme::strong(theme::BODY_SIZE)",
            "theme::strong(if big { 2.0 } else { 1.0 })",
            "galley.size()",
            "ui.add_space(2.0 * theme::STEP)",
            "painter.rect_filled(rect, 0.0, color)",
            "Stroke::new(width, color)",
            "tree.strong(17.0)",
        ] {
            assert_eq!(found(&format!("fn f() {{ draw({none}); }}")), [], "{none}");
        }
    }

    #[test]
    fn one_color_or_one_size_more_than_are_left_is_named_with_its_line() {
        let color = ("a.rs".to_owned(), 3, Literal::Color("Color32::RED".to_owned()));
        let size = ("b.rs".to_owned(), 4, Literal::Size("Stroke::new".to_owned(), "1.5".to_owned()));
        let found = [color, size];
        assert_eq!(
            sentences(&found, 1),
            ["a.rs:3 has the color Color32::RED: give it a name in the theme."]
        );
        assert_eq!(
            sentences(&found, 0).get(1).map(String::as_str),
            Some("b.rs:4 has the size 1.5 in Stroke::new: give it a name in the theme.")
        );
    }

    #[test]
    fn tests_may_have_literals() {
        assert_eq!(found("#[cfg(test)] mod tests { fn f() { Color32::RED; } }"), []);
    }
}
