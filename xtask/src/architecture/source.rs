//! Rust as a tree of tokens, without its tests: enough to see which paths and literals a file has.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use std::fs;
use std::path::Path;
use std::str::FromStr as _;

/// The tokens of a file, without items that only tests have.
pub(super) fn read(file: &Path) -> Result<Vec<TokenTree>, String> {
    let text = fs::read_to_string(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))?;
    parse(&text).map_err(|reason| format!("{} cannot be parsed: {reason}.", file.display()))
}

/// The tokens of `text`, without items that only tests have.
pub(super) fn parse(text: &str) -> Result<Vec<TokenTree>, String> {
    // A byte order mark is no token.
    let stream = TokenStream::from_str(text.trim_start_matches('\u{feff}')).map_err(|error| error.to_string())?;
    Ok(without_tests(stream))
}

fn without_tests(stream: TokenStream) -> Vec<TokenTree> {
    let mut kept = Vec::new();
    let mut tokens = stream.into_iter().peekable();
    while let Some(token) = tokens.next() {
        let attribute = is_punct(&token, '#').then(|| tokens.peek().cloned()).flatten();
        if attribute.as_ref().is_some_and(is_test_attribute) {
            // Further attributes are a mark and a group in brackets, so they are skipped with the item.
            for skipped in tokens.by_ref() {
                if is_punct(&skipped, ';') || group(&skipped, Delimiter::Brace).is_some() {
                    break;
                }
            }
            continue;
        }
        kept.push(match token {
            TokenTree::Group(group) => {
                let inside = without_tests(group.stream()).into_iter().collect();
                let mut copy = Group::new(group.delimiter(), inside);
                copy.set_span(group.span());
                TokenTree::Group(copy)
            }
            other => other,
        });
    }
    kept
}

/// `[test]`, `[cfg(test)]` or `[cfg(all(test, …))]`, behind its mark.
fn is_test_attribute(token: &TokenTree) -> bool {
    let text = group(token, Delimiter::Bracket).map(|group| group.stream().to_string().replace(' ', ""));
    text.is_some_and(|text| text == "test" || text == "cfg(test)" || text.starts_with("cfg(all(test,"))
}

/// The tokens inside `token`, if it is a group with these brackets.
pub(super) fn group(token: &TokenTree, delimiter: Delimiter) -> Option<&Group> {
    match token {
        TokenTree::Group(group) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

pub(super) fn ident(token: Option<&TokenTree>) -> Option<&Ident> {
    match token {
        Some(TokenTree::Ident(ident)) => Some(ident),
        _ => None,
    }
}

pub(super) fn is_ident(token: Option<&TokenTree>, name: &str) -> bool {
    ident(token).is_some_and(|ident| ident == name)
}

pub(super) fn is_punct(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// Whether `::` stands at `at`.
pub(super) fn is_path_separator(tokens: &[TokenTree], at: usize) -> bool {
    let is_colon = |at: usize| tokens.get(at).is_some_and(|token| is_punct(token, ':'));
    is_colon(at) && is_colon(at + 1)
}

#[cfg(test)]
mod tests {
    use super::parse;

    fn text(source: &str) -> Option<String> {
        let tokens = parse(source).ok()?;
        Some(tokens.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn what_only_tests_have_is_left_out() {
        let source = "use a::b; #[cfg(test)] #[allow(x)] mod tests { use c::d; } #[cfg(test)] mod more; #[test] fn t() {} fn f() {}";
        assert_eq!(text(source).as_deref(), Some("use a : : b ; fn f () { }"));
        assert_eq!(
            text("#[cfg(not(test))] fn f() {}").as_deref(),
            Some("# [cfg (not (test))] fn f () { }")
        );
        assert_eq!(text("mod m { #[cfg(test)] use a; }").as_deref(), Some("mod m { }"));
    }

    #[test]
    fn what_is_no_rust_is_refused() {
        assert!(parse("fn f( {").is_err());
    }
}
