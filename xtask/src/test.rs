//! `cargo xtask test`: every test, from the formulas to real browsers, or only some of them.

use clap::Args;
use std::path::{Path, PathBuf};

use crate::browsers::{self, Engine, Places, Programs};
use crate::prerequisites::{self, Needs};
use crate::step::{cargo, command, output, root, run, step};
use crate::table::{Outcome, Table};
use crate::{desktop, dist, images, size};

/// What a build of everything takes, as measured with `du` after `cargo xtask check` and `cargo xtask test`.
const BUILD_BYTES: u64 = 6_000_000_000;

#[derive(Args, Clone, Debug)]
pub(crate) struct Options {
    /// Parts (rust, desktop, size, chromium, firefox, webkit), and files of tests or parts of their names; all if there are none
    #[arg(value_name = "PART|FILE|NAME")]
    words: Vec<String>,
    /// List the parts and the tests, and run none
    #[arg(long)]
    list: bool,
    /// Install what is missing with apt-get (with sudo, unless this is root); what is still left out is a failure
    #[arg(long)]
    complete: bool,
    /// Test the page in this folder instead of building it
    #[arg(long, value_name = "FOLDER")]
    dist: Option<PathBuf>,
    /// Where the random walk through the page starts
    #[arg(long, value_name = "NUMBER", default_value_t = 20_261_122)]
    seed: u64,
    /// How many times eight steps the random walk takes
    #[arg(long, value_name = "NUMBER", default_value_t = 25)]
    batches: u32,
    #[command(flatten)]
    places: Places,
}

/// What can be tested by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Rust,
    Desktop,
    Size,
    Browser(Engine),
}

impl Part {
    const ALL: [Self; 6] = [
        Self::Rust,
        Self::Desktop,
        Self::Size,
        Self::Browser(Engine::Chromium),
        Self::Browser(Engine::Firefox),
        Self::Browser(Engine::WebKit),
    ];

    const fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::Desktop => "desktop",
            Self::Size => "size",
            Self::Browser(engine) => engine.name(),
        }
    }

    const fn description(self) -> &'static str {
        match self {
            Self::Rust => "tests and examples in Rust: the mathematics, the texts, the screens, the command line, these commands",
            Self::Desktop => "the desktop program as assistive technology meets it (Linux)",
            Self::Size => "what a first visit to the page downloads",
            Self::Browser(Engine::Chromium) => "the page in Chromium or Google Chrome",
            Self::Browser(Engine::Firefox) => "the page in Firefox",
            Self::Browser(Engine::WebKit) => "the page in WebKit (Linux)",
        }
    }
}

/// A test of the page: the file it is in, and its name.
type BrowserTest = (String, String);

/// What to run: the parts, and of their tests only those that are named, if any are.
#[derive(Debug, PartialEq)]
struct Choice {
    parts: Vec<Part>,
    /// For cargo.
    rust: Vec<String>,
    /// Files in tests/browser.
    files: Vec<String>,
    /// Names of tests in them; none for all.
    names: Vec<String>,
}

/// Runs the chosen tests; the browsers get the page exactly as `cargo xtask dist` leaves it. Err: a sentence.
pub(crate) fn run_chosen(options: &Options) -> Result<(), String> {
    let wants_names = options.words.iter().any(|word| part(word).is_none());
    let tests = if options.list || wants_names { list()? } else { Vec::new() };
    if options.list {
        print_list(&tests);
        return Ok(());
    }
    let choice = choose(&options.words, &tests, &rust_targets(), &browsers::test_files()?)?;
    let of_page = |part: &Part| matches!(part, Part::Size | Part::Browser(_));
    prerequisites::check(Needs {
        node: choice.parts.iter().any(of_page),
        build_bytes: if choice.parts == [Part::Desktop] { 0 } else { BUILD_BYTES },
    })?;
    print_browsers(&choice.parts, options);

    let mut table = Table::default();
    if choice.parts.contains(&Part::Rust) {
        images::prepare(options.complete);
        table.run("rust", || rust(&choice.rust));
        if let Some(reason) = images::left_out() {
            table.leave_out("images", reason);
        }
    }
    if choice.parts.contains(&Part::Desktop) {
        table.run("desktop", || desktop::test(options.complete));
    }
    if choice.parts.iter().any(of_page) {
        test_page(&choice, options, &mut table);
    }
    table.finish(options.complete)
}

fn rust(names: &[String]) -> Result<(), String> {
    step("Tests and examples in Rust", || {
        let mut test = cargo(&["test", "--locked", "--workspace", "--no-fail-fast"]);
        run(test.args(names))
    })
}

/// Builds the page, and tests it in every chosen way that is possible here.
fn test_page(choice: &Choice, options: &Options, table: &mut Table) {
    let mut dist = Err("The page was not built.".to_owned());
    match &options.dist {
        Some(folder) => dist = existing(folder),
        None => {
            table.run("build the page", || {
                dist = dist::build();
                dist.clone().map(drop)
            });
        }
    }
    for part in &choice.parts {
        match (part, &dist) {
            (Part::Rust | Part::Desktop, _) => {}
            (part, Err(reason)) => table.leave_out(part.name(), reason),
            (Part::Size, Ok(dist)) => {
                table.run(part.name(), || step("Size of the first visit", || size::check(dist)));
            }
            (Part::Browser(engine), Ok(dist)) => {
                table.run(part.name(), || in_browser(*engine, dist, choice, options));
            }
        }
    }
}

fn existing(folder: &Path) -> Result<PathBuf, String> {
    let folder = std::path::absolute(folder).map_err(|error| format!("{} is no folder: {error}.", folder.display()))?;
    if folder.join("index.html").is_file() {
        Ok(folder)
    } else {
        Err(format!("There is no page in {}: it has no index.html.", folder.display()))
    }
}

fn in_browser(engine: Engine, dist: &Path, choice: &Choice, options: &Options) -> Outcome {
    if let Err(reason) = browsers::install_packages("Install the packages of the browser tests", &root().join("tests/browser")) {
        return Outcome::Failed(reason);
    }
    let programs: Programs = match browsers::find_or_install(engine, &options.places, options.complete) {
        Ok(programs) => programs,
        Err(missing) => return missing,
    };
    let tests = browsers::Tests {
        dist,
        files: &choice.files,
        names: &choice.names,
        seed: options.seed,
        batches: options.batches,
    };
    let mut outcome = Outcome::LeftOut("It was not run.".to_owned());
    let what = format!("Tests in a real browser: {}", programs.version);
    // The step says how long it took; how it ended is the table's.
    let _ = step(&what, || {
        outcome = tests.run(engine, &programs);
        if matches!(outcome, Outcome::Failed(_)) {
            Err(String::new())
        } else {
            Ok(())
        }
    });
    outcome
}

/// Says which browsers will be used, before anything is built.
fn print_browsers(parts: &[Part], options: &Options) {
    for part in parts {
        let Part::Browser(engine) = part else { continue };
        match browsers::find(*engine, &options.places) {
            Ok(programs) => println!("  ok       {}", programs.version),
            Err(missing) if missing.needs_geckodriver => println!("  later    {}; it will be built", missing.why),
            Err(missing) if browsers::can_install(*engine, options.complete) => {
                println!("  later    {}; it will be installed", missing.why)
            }
            Err(missing) => println!("  without  {}; {} will be left out", missing.why, engine.name()),
        }
    }
}

fn part(word: &str) -> Option<Part> {
    Part::ALL.into_iter().find(|part| part.name() == word)
}

/// The names of the files of Rust tests, which cargo calls targets.
fn rust_targets() -> Vec<String> {
    let entries = std::fs::read_dir(root().join("tests")).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let is_folder = entry.path().join("main.rs").is_file();
            if is_folder {
                Some(name)
            } else {
                name.strip_suffix(".rs").map(str::to_owned)
            }
        })
        .collect();
    names.sort();
    names
}

fn list() -> Result<Vec<BrowserTest>, String> {
    prerequisites::node()?;
    browsers::install_packages("Install the packages of the browser tests", &root().join("tests/browser"))?;
    let printed = output(command("node", &["tests/browser/list.mjs"]).args(browsers::test_files()?))
        .ok_or("The browser tests could not be listed: `node tests/browser/list.mjs` failed.")?;
    let tests = printed.lines().filter_map(|line| line.split_once('\t'));
    Ok(tests.map(|(file, name)| (file.to_owned(), name.to_owned())).collect())
}

fn print_list(tests: &[BrowserTest]) {
    println!("\nParts");
    for part in Part::ALL {
        println!("  {:<9} {}", part.name(), part.description());
    }
    println!("\nFiles of Rust tests (all tests in them: cargo test -- --list)");
    println!("  {}", rust_targets().join(", "));
    println!("\nTests in browsers");
    let mut last = "";
    for (file, name) in tests {
        if file != last {
            println!("  {file}");
            last = file;
        }
        println!("    {name}");
    }
}

/// What the words of the command line ask for. Err: a sentence, where a word is neither a part nor in any name.
fn choose(words: &[String], tests: &[BrowserTest], targets: &[String], files: &[String]) -> Result<Choice, String> {
    let (parts, words): (Vec<_>, Vec<_>) = words.iter().map(|word| part(word).ok_or(word)).partition(Result::is_ok);
    let mut parts: Vec<Part> = parts.into_iter().flatten().collect();
    let words: Vec<&String> = words.into_iter().filter_map(Result::err).collect();
    let all = |parts: &[Part]| parts.is_empty();
    let browser = all(&parts) || parts.iter().any(|part| matches!(part, Part::Browser(_)));
    let rust = all(&parts) || parts.contains(&Part::Rust);

    let mut choice = Choice {
        parts: Vec::new(),
        rust: Vec::new(),
        files: Vec::new(),
        names: Vec::new(),
    };
    if words.is_empty() {
        choice.files = files.to_vec();
    }
    let mut names_of_rust_tests = Vec::new();
    for word in words {
        let lower = word.to_lowercase();
        let in_file = |file: &&String| browser && file.rsplit('/').next().is_some_and(|name| name.contains(&lower));
        let whole: Vec<&String> = files.iter().filter(in_file).collect();
        let all_of_them = |(file, _): &&BrowserTest| whole.contains(&file);
        let named: Vec<&BrowserTest> = tests
            .iter()
            .filter(|(_, name)| browser && name.to_lowercase().contains(&lower))
            .collect();
        let target = targets.iter().find(|target| rust && **target == lower);
        if let Some(target) = target {
            choice.rust.extend(["--test".to_owned(), target.clone()]);
        } else if !whole.is_empty() || !named.is_empty() {
            let chosen = tests.iter().filter(all_of_them).chain(named);
            for (file, name) in chosen {
                choice.files.push(file.clone());
                choice.names.push(name.clone());
            }
        } else if parts.contains(&Part::Rust) {
            names_of_rust_tests.push(word.clone());
        } else {
            return Err(format!(
                "No part, file or test is called \"{word}\": `cargo xtask test --list` shows what there is. \
                 For a test in Rust: `cargo xtask test rust {word}`."
            ));
        }
    }
    choice.files.sort();
    choice.files.dedup();
    if !names_of_rust_tests.is_empty() {
        // Cargo itself takes one name, the tests behind the dashes take several.
        choice.rust.push("--".to_owned());
        choice.rust.append(&mut names_of_rust_tests);
    }
    let is_named = !choice.rust.is_empty() || !choice.names.is_empty();
    if parts.is_empty() {
        parts = Part::ALL.to_vec();
        parts.retain(|part| !is_named || !matches!(part, Part::Desktop | Part::Size));
    }
    // Of what names stand for, only the parts that have it.
    parts.retain(|part| match part {
        Part::Rust => !is_named || !choice.rust.is_empty(),
        Part::Browser(_) => !is_named || !choice.names.is_empty(),
        Part::Desktop | Part::Size => true,
    });
    choice.parts = Part::ALL.into_iter().filter(|part| parts.contains(part)).collect();
    Ok(choice)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Choice, Engine, Part, choose};

    fn chosen(words: &str) -> Result<Choice, String> {
        let text = |words: &[&str]| words.iter().map(ToString::to_string).collect::<Vec<_>>();
        let tests = [
            ("t/a.test.mjs", "The mug"),
            ("t/a.test.mjs", "a door"),
            ("t/b.test.mjs", "golden mug"),
        ];
        let tests = tests.map(|(file, name)| (file.to_owned(), name.to_owned()));
        let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        choose(&words, &tests, &text(&["cli", "golden"]), &text(&["t/a.test.mjs", "t/b.test.mjs"]))
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
            assert!(super::rust_targets().iter().any(|known| known == target), "{target}");
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
