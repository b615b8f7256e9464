//! `cargo xtask test`: every test, from the formulas to real browsers, or only some of them.

mod choice;
mod list;
mod part;

use clap::Args;
use std::path::{Path, PathBuf};

use crate::browsers::{self, Engine, Places, Programs};
use crate::plan::Plan;
use crate::prerequisites::{self, Needs};
use crate::step::{cargo, root, run, step};
use crate::table::{Outcome, Table};
use crate::{desktop, dist, images, size};
use choice::{Available, Choice, choose};
use part::Part;

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
    #[arg(long, value_name = "NUMBER", default_value_t = 6)]
    batches: u32,
    #[command(flatten)]
    places: Places,
}

/// Runs the chosen tests; the browsers get the page exactly as `cargo xtask dist` leaves it. Err: a sentence.
pub(crate) fn run_chosen(options: &Options) -> Result<(), String> {
    let wants_names = options.words.iter().any(|word| Part::named(word).is_none());
    let tests = if options.list || wants_names {
        list::browser_tests()?
    } else {
        Vec::new()
    };
    if options.list {
        list::print(&tests);
        return Ok(());
    }
    let available = Available {
        tests: &tests,
        targets: &list::rust_targets(),
        files: &browsers::test_files()?,
    };
    let choice = choose(&options.words, &available)?;
    prerequisites::check(Needs {
        node: choice.parts.iter().any(|part| part.needs_page()),
        build_bytes: if choice.parts == [Part::Desktop] { 0 } else { BUILD_BYTES },
    })?;
    println!("Parts");
    for part in &choice.parts {
        println!("  {:<9} {}", part.name(), plan(*part, options));
    }

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
    if choice.parts.iter().any(|part| part.needs_page()) {
        test_page(&choice, options, &mut table);
    }
    table.finish(options.complete)
}

/// What will become of a part on this computer.
fn plan(part: Part, options: &Options) -> Plan {
    match part {
        Part::Rust | Part::Size => Plan::Run(String::new()),
        Part::Desktop => desktop::plan(options.complete),
        Part::Browser(engine) => browsers::plan(engine, &options.places, options.complete),
    }
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
