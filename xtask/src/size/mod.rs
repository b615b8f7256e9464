//! `cargo xtask size`: what a first visit downloads before the calculator can be used, what that consists of, and whether it is too
//! much.

mod bill;
mod first_visit;
mod module;
mod owner;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::compress;
use crate::files::collect_files;
use crate::second_module;
use first_visit::is_program;

/// With brotli. At 10 Mbit/s that is 0.7 s.
const BUDGET: u64 = 900_000;
/// With brotli, of the second module, which is loaded when there is the first work for it.
const SECOND_BUDGET: u64 = 600_000;
/// Lines of the bill that are printed.
const LINES: usize = 40;

/// Prints the size of every file of the first visit to the page in `dist`, and what the program consists of.
/// Err: a sentence, where the files are larger than the budget.
pub(crate) fn check(dist: &Path) -> Result<(), String> {
    let first = check_first(dist);
    let second = check_second(dist);
    first.and(second)
}

/// Prints the size of the second module. Err: a sentence, where it is larger than its budget.
fn check_second(dist: &Path) -> Result<(), String> {
    let mut paths = Vec::new();
    collect_files(dist, &mut paths).map_err(|error| format!("dist/ cannot be read: {error}."))?;
    paths.retain(|path| second_module::is_of_it(path));
    paths.sort();
    let sizes = compress::sizes(&paths)?;
    println!(
        "\n{:>12} {:>12} {:>12}  file of the second module",
        "bytes", "with gzip", "with brotli"
    );
    let mut sum = 0;
    for ([raw, gzip, brotli], path) in sizes.iter().zip(&paths) {
        let name = path.file_name().unwrap_or_default().display();
        println!("{raw:>12} {gzip:>12} {brotli:>12}  {name}");
        sum += brotli;
    }
    println!("{:>12} {:>12} {sum:>12}  together; at most {SECOND_BUDGET} with brotli", "", "");
    if paths.len() != 3 {
        return Err(format!("The second module should be three files; it is {}.", paths.len()));
    }
    if sum > SECOND_BUDGET {
        return Err(format!(
            "The second module has {sum} bytes with brotli, {} more than its budget of {SECOND_BUDGET}.",
            sum - SECOND_BUDGET
        ));
    }
    Ok(())
}

fn check_first(dist: &Path) -> Result<(), String> {
    let files = first_visit::files(dist)?;
    let paths: Vec<_> = files.iter().map(|file| dist.join(file)).collect();
    let sizes = compress::sizes(&paths)?;

    println!(
        "\n{:>12} {:>12} {:>12}  file of the first visit",
        "bytes", "with gzip", "with brotli"
    );
    for ([raw, gzip, brotli], file) in sizes.iter().zip(&files) {
        println!("{raw:>12} {gzip:>12} {brotli:>12}  {file}");
    }
    let [raw, gzip, brotli] = sizes.iter().fold([0; 3], |[raw, gzip, brotli], file| {
        [raw + file[0], gzip + file[1], brotli + file[2]]
    });
    println!("{raw:>12} {gzip:>12} {brotli:>12}  together; at most {BUDGET} with brotli");

    for (file, [_, _, brotli]) in files.iter().zip(&sizes).filter(|(file, _)| is_program(file)) {
        let program = fs::read(dist.join(file)).map_err(|error| format!("dist/{file} cannot be read: {error}."))?;
        print_sections(file, &program)?;
        print_bill(file, &program, *brotli)?;
    }
    if brotli > BUDGET {
        return Err(format!(
            "The first visit downloads {brotli} bytes with brotli, {} more than the budget of {BUDGET}.",
            brotli - BUDGET
        ));
    }
    Ok(())
}

fn print_sections(file: &str, program: &[u8]) -> Result<(), String> {
    let sections = module::sections(program).ok_or_else(|| format!("dist/{file} is no WebAssembly file."))?;
    let mut bytes: BTreeMap<&str, usize> = BTreeMap::new();
    for (id, content) in sections {
        *bytes.entry(module::section_name(id)).or_default() += content.len();
    }
    let mut parts: Vec<_> = bytes.into_iter().collect();
    parts.sort_by_key(|&(_, size)| std::cmp::Reverse(size));
    println!("\n{:>12}  part of {file}", "bytes");
    for (name, bytes) in parts {
        println!("{bytes:>12}  {name}");
    }
    Ok(())
}

fn print_bill(file: &str, program: &[u8], brotli: u64) -> Result<(), String> {
    let Some(names) = bill::names_of(program) else {
        println!("\nThere is no bill: {file} is not of the last build on this computer, which leaves the names of its functions.");
        return Ok(());
    };
    let names: Vec<&str> = names.split('\n').collect();
    let lines = bill::bill(program, brotli, &names)?;
    println!("\n{:>12} {:>12}  whose, in {file} (estimated)", "bytes", "with brotli");
    let (shown, rest) = lines.split_at(LINES.min(lines.len()));
    for line in shown {
        println!("{:>12} {:>12}  {}", line.raw, line.brotli, line.what);
    }
    let raw: u64 = rest.iter().map(|line| line.raw).sum();
    let shown: u64 = shown.iter().map(|line| line.brotli).sum();
    println!("{raw:>12} {:>12}  the rest, {} of them", brotli.saturating_sub(shown), rest.len());
    println!("{:>12} {brotli:>12}  together", "");
    Ok(())
}
