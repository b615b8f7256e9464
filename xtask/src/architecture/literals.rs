//! Colors and sizes are named in the theme, and used by their names everywhere else.
//!
//! What is looked for outside `src/app/theme`:
//! - a color that is not a field of a palette: `Color32::from_…` (also of `Rgba` and `Hsva`) with a literal inside, a constant such as
//!   `Color32::RED` (`TRANSPARENT` and `PLACEHOLDER` are none), and `hex_color!`;
//! - a number in points in a call that takes a size: of a font (`FontId::new`, `strong`, `.size`), the width of a line (`Stroke::new`), a
//!   radius (`.corner_radius`, `.circle_filled`), a space or a margin (`.add_space`, `Margin::symmetric`, `Margin { left: 14, … }`), a width,
//!   a height or both (`vec2`, `.set_width`, `.expand`, `max_width: 640.0`), or a limit of one (`.min`, `.max`);
//! - a number in points that is assigned to a spacing (`ui.spacing_mut().item_spacing.x = 6.0`) or to a constant (`const GAP: f32 = 6.0`);
//! - a number in points that is added to something or subtracted from it (`rect.right() - 8.0`).
//!
//! Zero is no size. A factor (`2.0 * STEP`, `rect.width() * 0.36`) is a ratio, as is whatever is less than 1 where a width, a position or
//! a vector is expected, and a limit up to 2. The window on the desktop is no part of what is drawn in it.

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
/// The size of the window.
const WINDOW: &str = "src/platform/desktop/placement.rs";

/// Functions with a size in points among their arguments: the type or module that they are often called by, and the name.
const FUNCTIONS: &[(&str, Sizes)] = &[
    ("FontId::new", Sizes::at(0)),
    ("FontId::proportional", Sizes::at(0)),
    ("FontId::monospace", Sizes::at(0)),
    ("Stroke::new", Sizes::at(0)),
    ("CornerRadius::same", Sizes::at(0)),
    ("strong", Sizes::at(0)),
    ("regular", Sizes::at(0)),
    ("Margin::same", Sizes::at(0)),
    ("Margin::symmetric", Sizes::anywhere()),
    ("Shape::dashed_line", Sizes::anywhere()),
    ("vec2", Sizes::anywhere().from(1.0)),
    ("Vec2::new", Sizes::anywhere().from(1.0)),
    ("Vec2::splat", Sizes::at(0).from(1.0)),
];
/// Methods with a size in points among their arguments.
const METHODS: &[(&str, Sizes)] = &[
    ("size", Sizes::at(0)),
    ("corner_radius", Sizes::at(0)),
    ("rect_filled", Sizes::at(1)),
    ("circle", Sizes::at(1)),
    ("circle_filled", Sizes::at(1)),
    ("append", Sizes::at(1)),
    ("add_space", Sizes::at(0)),
    ("margin", Sizes::at(0)),
    ("inner_margin", Sizes::at(0)),
    ("outer_margin", Sizes::at(0)),
    ("expand", Sizes::at(0)),
    ("shrink", Sizes::at(0)),
    ("set_width", Sizes::at(0)),
    ("set_height", Sizes::at(0)),
    ("set_min_width", Sizes::at(0)),
    ("set_max_width", Sizes::at(0)),
    ("set_min_height", Sizes::at(0)),
    ("set_max_height", Sizes::at(0)),
    ("desired_width", Sizes::at(0)),
    ("min_width", Sizes::at(0)),
    ("max_width", Sizes::at(0)),
    ("min_height", Sizes::at(0)),
    ("max_height", Sizes::at(0)),
    ("width", Sizes::at(0).from(1.0)),
    ("height", Sizes::at(0).from(1.0)),
    ("min", Sizes::at(0).from(2.5)),
    ("max", Sizes::at(0).from(2.5)),
];
/// Types of constants that can be a size in points.
const SIZE_TYPES: &[&str] = &["f32", "i8"];

/// Which arguments of a call are sizes in points.
#[derive(Clone, Copy)]
struct Sizes {
    /// The number of the argument; each of them where there is none.
    argument: Option<usize>,
    /// The smallest number that is no ratio.
    least: f64,
}

impl Sizes {
    const fn at(argument: usize) -> Self {
        Self {
            argument: Some(argument),
            least: f64::MIN_POSITIVE,
        }
    }

    const fn anywhere() -> Self {
        Self {
            argument: None,
            least: f64::MIN_POSITIVE,
        }
    }

    const fn from(self, least: f64) -> Self {
        Self { least, ..self }
    }
}

/// How many sizes still stand outside the theme. This number only ever goes down.
const SIZES_LEFT: usize = 0;

/// A color or a size that has no name.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Literal {
    Color(String),
    /// In what, and the number.
    Size(String, String),
}

impl Literal {
    const fn is_color(&self) -> bool {
        matches!(self, Self::Color(_))
    }
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
        // A module of tests that is a folder has its attribute in another file.
        if !THEME.iter().any(|theme| name.starts_with(theme)) && !name.contains("/tests/") {
            let literals = in_tokens(&source::read(file)?);
            let literals = literals.into_iter().filter(|(_, literal)| name != WINDOW || literal.is_color());
            found.extend(literals.map(|(line, literal)| (name.clone(), line, literal)));
        }
    }
    Ok(sentences(&found, SIZES_LEFT))
}

/// Every color, and the sizes where they are more than are left.
fn sentences(found: &[Found], sizes_left: usize) -> Vec<String> {
    let sizes = found.iter().filter(|(_, _, literal)| !literal.is_color()).count();
    if sizes < sizes_left {
        println!("Only {sizes} sizes are left outside the theme: let SIZES_LEFT in xtask/src/architecture/literals.rs say so.");
    }
    let shown = found.iter().filter(|(_, _, literal)| literal.is_color() || sizes > sizes_left);
    shown.map(|(file, line, literal)| format!("{file}:{line} {literal}")).collect()
}

/// The literals with their lines.
fn in_tokens(tokens: &[TokenTree]) -> Vec<(usize, Literal)> {
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => found.extend(in_tokens(&group.stream().into_iter().collect::<Vec<_>>())),
            TokenTree::Ident(word) => {
                let sized = size_in_call(tokens, at)
                    .or_else(|| size_in_margin(tokens, at))
                    .or_else(|| size_in_field(tokens, at))
                    .or_else(|| size_in_spacing(tokens, at))
                    .or_else(|| size_in_constant(tokens, at));
                let literal = color(tokens, at).or(sized);
                found.extend(literal.map(|literal| (word.span().start().line, literal)));
            }
            TokenTree::Literal(number) => {
                let literal = size_in_sum(tokens, at);
                found.extend(literal.map(|literal| (number.span().start().line, literal)));
            }
            TokenTree::Punct(_) => {}
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
fn size_in_call(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    let word = ident(tokens.get(at))?.to_string();
    let before = |distance: usize| at.checked_sub(distance).and_then(|at| tokens.get(at));
    let is_method = before(1).is_some_and(|token| is_punct(token, '.'));
    let of = (at >= 3 && is_path_separator(tokens, at - 2)).then(|| ident(before(3))).flatten();
    let called = of.map(|of| format!("{of}::{word}"));
    let is_called = |name: &str| name == word || (!is_method && called.as_deref() == Some(name));
    let calls = if is_method { METHODS } else { FUNCTIONS };
    let (_, sized) = calls.iter().find(|(name, _)| is_called(name))?;
    let arguments = arguments(tokens, at + 1);
    let number = match sized.argument {
        Some(argument) => number(arguments.get(argument)?, sized.least),
        None => arguments.iter().find_map(|argument| number(argument, sized.least)),
    };
    Some(Literal::Size(called.unwrap_or(word), number?))
}

/// The size in the `Margin { … }` that begins at `at`.
fn size_in_margin(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    ident(tokens.get(at)).filter(|word| *word == "Margin")?;
    let fields = group(tokens.get(at + 1)?, Delimiter::Brace)?
        .stream()
        .into_iter()
        .collect::<Vec<_>>();
    let number = fields
        .split(|token| is_punct(token, ','))
        .find_map(|field| number(field.get(2..)?, f64::MIN_POSITIVE))?;
    Some(Literal::Size("Margin".to_owned(), number))
}

/// The size in the field of a struct, named for a width or a height, that begins at `at`.
fn size_in_field(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    let name = ident(tokens.get(at))?.to_string();
    let is_field = tokens.get(at + 1).is_some_and(|token| is_punct(token, ':')) && !is_path_separator(tokens, at + 1);
    let is_size = name.ends_with("width") || name.ends_with("height");
    let value = tokens.get(at + 2..)?.split(|token| is_punct(token, ',')).next()?;
    let number = number(value, f64::MIN_POSITIVE).filter(|_| is_field && is_size)?;
    Some(Literal::Size(name, number))
}

/// The size that is assigned in the statement `….spacing_mut().… = …` whose `spacing_mut` stands at `at`.
fn size_in_spacing(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    ident(tokens.get(at)).filter(|word| *word == "spacing_mut")?;
    let statement = tokens.get(at..)?.split(|token| is_punct(token, ';')).next()?;
    let equals = statement.iter().position(|token| is_punct(token, '='))?;
    let number = number(statement.get(equals + 1..)?, f64::MIN_POSITIVE)?;
    Some(Literal::Size("spacing_mut".to_owned(), number))
}

/// The size that is the value of the constant whose `const` stands at `at`.
fn size_in_constant(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    ident(tokens.get(at)).filter(|word| *word == "const")?;
    let name = ident(tokens.get(at + 1))?.to_string();
    ident(tokens.get(at + 3)).filter(|word| SIZE_TYPES.iter().any(|size| *word == size))?;
    tokens.get(at + 4).filter(|token| is_punct(token, '='))?;
    let value = tokens.get(at + 5..)?.split(|token| is_punct(token, ';')).next()?;
    Some(Literal::Size(name, number(value, f64::MIN_POSITIVE)?))
}

/// The size at `at`, if it is a term of a sum or a difference: a number with a decimal point, greater than 1.
fn size_in_sum(tokens: &[TokenTree], at: usize) -> Option<Literal> {
    let is_any = |at: usize, marks: &[char]| tokens.get(at).is_some_and(|token| marks.iter().any(|mark| is_punct(token, *mark)));
    let text = literal(tokens.get(at)?).filter(|text| text.contains('.') && value(text).is_some_and(|value| value > 1.0))?;
    let before = at.checked_sub(1);
    // A sign behind nothing, or behind another sign, is that of the number.
    let is_operand = |at: usize| tokens.get(at).is_some_and(|token| !matches!(token, TokenTree::Punct(_)));
    let is_second = before.is_some_and(|sign| is_any(sign, &['+', '-']) && sign.checked_sub(1).is_some_and(is_operand));
    let is_factor = before.is_some_and(|sign| is_any(sign, &['*', '/'])) || is_any(at + 1, &['*', '/']);
    let is_term = (is_second || is_any(at + 1, &['+', '-'])) && !is_factor;
    is_term.then(|| Literal::Size("a sum".to_owned(), text))
}

/// The number that `tokens` are, with or without a sign, if it is at least `least` from zero.
fn number(tokens: &[TokenTree], least: f64) -> Option<String> {
    let token = match tokens {
        [token] => token,
        [sign, token] if is_punct(sign, '-') => token,
        _ => return None,
    };
    literal(token).filter(|text| value(text).is_some_and(|value| value >= least))
}

/// The value of a number as Rust writes it.
fn value(text: &str) -> Option<f64> {
    let digits = SIZE_TYPES.iter().find_map(|size| text.strip_suffix(size)).unwrap_or(text);
    digits.replace('_', "").parse().ok()
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
mod tests;
