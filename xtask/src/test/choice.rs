//! Which tests the words of the command line choose.

use super::list::BrowserTest;
use super::part::Part;

/// What the words can name besides parts.
pub(super) struct Available<'a> {
    /// Tests of the page.
    pub(super) tests: &'a [BrowserTest],
    /// Files of Rust tests.
    pub(super) targets: &'a [String],
    /// Files of tests of the page.
    pub(super) files: &'a [String],
}

/// What to run: the parts, and of their tests only those that are named, if any are.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Choice {
    pub(super) parts: Vec<Part>,
    /// For cargo.
    pub(super) rust: Vec<String>,
    /// Files in tests/browser.
    pub(super) files: Vec<String>,
    /// Names of tests in them; none for all.
    pub(super) names: Vec<String>,
}

/// What one word of the command line that is no part stands for.
enum Meaning<'a> {
    RustFile(&'a str),
    BrowserTests(Vec<&'a BrowserTest>),
    /// The name of a test in Rust, or a part of one: only cargo knows them all.
    RustTest,
}

/// What the words of the command line ask for. Err: a sentence, where a word is neither a part nor in any name.
pub(super) fn choose(words: &[String], available: &Available<'_>) -> Result<Choice, String> {
    let parts: Vec<Part> = words.iter().filter_map(|word| Part::named(word)).collect();
    let mut choice = Choice::default();
    let mut rust_tests = Vec::new();
    for word in words.iter().filter(|word| Part::named(word).is_none()) {
        match meaning(word, &parts, available)? {
            Meaning::RustFile(target) => choice.rust.extend(["--test".to_owned(), target.to_owned()]),
            Meaning::BrowserTests(tests) => {
                for (file, name) in tests {
                    choice.files.push(file.clone());
                    choice.names.push(name.clone());
                }
            }
            Meaning::RustTest => rust_tests.push(word.clone()),
        }
    }
    if parts.len() == words.len() {
        choice.files = available.files.to_vec();
    }
    choice.files.sort();
    choice.files.dedup();
    if !rust_tests.is_empty() {
        // Cargo itself takes one name, the tests behind the dashes take several.
        choice.rust.push("--".to_owned());
        choice.rust.append(&mut rust_tests);
    }
    choice.parts = parts_to_run(&parts, &choice);
    Ok(choice)
}

fn meaning<'a>(word: &str, parts: &[Part], available: &Available<'a>) -> Result<Meaning<'a>, String> {
    let rust = parts.is_empty() || parts.contains(&Part::Rust);
    let browser = parts.is_empty() || parts.iter().any(|part| matches!(part, Part::Browser(_)));
    let lower = word.to_ascii_lowercase();
    if let Some(target) = available.targets.iter().find(|target| rust && **target == lower) {
        return Ok(Meaning::RustFile(target));
    }
    let file_holds = |file: &str| file.rsplit('/').next().is_some_and(|name| name.contains(&lower));
    let in_file = available.tests.iter().filter(|(file, _)| browser && file_holds(file));
    let named = available
        .tests
        .iter()
        .filter(|(_, name)| browser && name.to_ascii_lowercase().contains(&lower));
    let tests: Vec<&BrowserTest> = in_file.chain(named).collect();
    if !tests.is_empty() {
        Ok(Meaning::BrowserTests(tests))
    } else if parts.contains(&Part::Rust) {
        Ok(Meaning::RustTest)
    } else {
        Err(format!(
            "No part, file or test is called \"{word}\": `cargo xtask test --list` shows what there is. \
             For a test in Rust: `cargo xtask test rust {word}`."
        ))
    }
}

/// Of the parts that were named, or of all, those that have one of the tests that were named, if any were.
fn parts_to_run(named: &[Part], choice: &Choice) -> Vec<Part> {
    let only_some_tests = !choice.rust.is_empty() || !choice.names.is_empty();
    let runs = |part: &Part| match part {
        Part::Rust => !only_some_tests || !choice.rust.is_empty(),
        Part::Browser(_) => !only_some_tests || !choice.names.is_empty(),
        Part::Desktop | Part::Size => !only_some_tests || !named.is_empty(),
    };
    let is_named = |part: &Part| named.is_empty() || named.contains(part);
    Part::ALL.into_iter().filter(|part| is_named(part) && runs(part)).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Available, Choice, Part, choose};
    use crate::browsers::Engine;
    use crate::test::list::rust_targets;

    fn chosen(words: &str) -> Result<Choice, String> {
        let text = |words: &[&str]| words.iter().map(ToString::to_string).collect::<Vec<_>>();
        let tests = [
            ("t/a.test.mjs", "The mug"),
            ("t/a.test.mjs", "a door"),
            ("t/b.test.mjs", "golden mug"),
        ];
        let tests = tests.map(|(file, name)| (file.to_owned(), name.to_owned()));
        let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        let available = Available {
            tests: &tests,
            targets: &text(&["cli", "golden"]),
            files: &text(&["t/a.test.mjs", "t/b.test.mjs"]),
        };
        choose(&words, &available)
    }

    #[test]
    fn no_words_are_everything_and_a_part_is_that_part() {
        let all = chosen("").unwrap();
        assert_eq!(all.parts, Part::ALL);
        assert_eq!((all.files.len(), all.names.len(), all.rust.len()), (2, 0, 0));
        let two = chosen("firefox size").unwrap();
        assert_eq!(two.parts, [Part::Size, Part::Browser(Engine::Firefox)]);
        assert!(two.names.is_empty());
    }

    #[test]
    fn a_word_chooses_a_file_or_the_tests_whose_names_hold_it() {
        let file = chosen("chromium a.test").unwrap();
        assert_eq!(
            (file.files.as_slice(), file.names.as_slice()),
            (
                ["t/a.test.mjs".to_owned()].as_slice(),
                ["The mug".to_owned(), "a door".to_owned()].as_slice()
            )
        );
        // A word that is in a file's name and in tests of another file.
        assert_eq!(chosen("chromium b").unwrap().names.len(), 1);
        let tests = chosen("chromium MUG").unwrap();
        assert_eq!(tests.names, ["The mug", "golden mug"]);
        assert_eq!(tests.files.len(), 2);
        // Without a part: in every engine.
        assert_eq!(chosen("door").unwrap().parts.len(), 3);
    }

    #[test]
    fn rust_tests_are_chosen_by_file_or_by_name() {
        let file = chosen("golden").unwrap();
        assert_eq!(
            (file.parts.as_slice(), file.rust.join(" ")),
            ([Part::Rust].as_slice(), "--test golden".to_owned())
        );
        assert_eq!(chosen("rust fieller budget").unwrap().rust, ["--", "fieller", "budget"]);
        for target in ["cli", "golden", "screens"] {
            assert!(rust_targets().iter().any(|known| known == target), "{target}");
        }
    }

    #[test]
    fn a_part_runs_only_if_the_names_beside_it_are_of_its_tests() {
        assert_eq!(chosen("rust chromium mug").unwrap().parts, [Part::Browser(Engine::Chromium)]);
        assert_eq!(chosen("rust chromium golden").unwrap().parts, [Part::Rust]);
        assert_eq!(chosen("rust chromium golden mug").unwrap().parts.len(), 2);
        assert_eq!(
            chosen("size mug chromium").unwrap().parts,
            [Part::Size, Part::Browser(Engine::Chromium)]
        );
    }

    #[test]
    fn a_word_that_means_nothing_is_refused_with_a_way_on() {
        let refusal = chosen("chromium zebra").unwrap_err();
        assert!(refusal.contains("zebra") && refusal.contains("--list"), "{refusal}");
    }
}
