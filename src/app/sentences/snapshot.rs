//! Shows every sentence of an enum in a snapshot.

use std::fmt::{Debug, Display};

/// Examples of the variants of an enum, each behind the pattern of its variant. Does not compile where a variant has no example.
macro_rules! every {
    ($sentence:ty; $($variant:pat => $example:expr),* $(,)?) => {{
        let name = |sentence: &$sentence| match sentence {
            $($variant => stringify!($variant)),*
        };
        let examples: Vec<(&str, $sentence)> = vec![$((stringify!($variant), $example)),*];
        for (variant, example) in &examples {
            assert_eq!(*variant, name(example), "an example of another variant");
        }
        examples.into_iter().map(|(_, example)| example).collect::<Vec<$sentence>>()
    }};
}
pub(crate) use every;

/// Compares the sentences and their facts with the snapshot `name`.
pub(crate) fn assert_shown(name: &str, sentences: &[impl Debug + Display]) {
    assert_lines(name, sentences.iter().map(|sentence| format!("{sentence:?}\n    {sentence}")));
}

/// Compares the sentences with the snapshot `name`, without their facts, where these are long.
pub(crate) fn assert_said(name: &str, sentences: &[impl Display]) {
    assert_lines(name, sentences.iter().map(ToString::to_string));
}

fn assert_lines(name: &str, lines: impl Iterator<Item = String>) {
    let lines: Vec<String> = lines.collect();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/sentences/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, lines.join("\n")));
}
