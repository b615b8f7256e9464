//! The manual page: one for the whole program, because whoever types `man depth-calculator` wants to know its options.

use super::arguments::{COMPLETIONS_HELP, Cli, NAME};
use super::help;
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, italic, roman};

/// When the program was made, in seconds since 1970: whoever builds a package says so, as the commit or the package has it, so that
/// the same sources always make the same page. Without it the page has no date.
///
/// Source: Reproducible Builds, "`SOURCE_DATE_EPOCH`" specification 1.1.
const SOURCE_DATE_EPOCH: Option<&str> = option_env!("SOURCE_DATE_EPOCH");

/// The page in the format of man.
///
/// `Man::render` makes a page for each command instead, and lets the examples flow into one paragraph.
///
/// # Errors
/// None in practice: it is written into memory.
pub(super) fn page() -> std::io::Result<String> {
    let mut root = Cli::command().disable_help_subcommand(true);
    root.build();
    let mut page = Vec::new();
    let top = Man::new(root.clone().override_usage(synopsis(&root)))
        .manual("User Commands")
        .date(SOURCE_DATE_EPOCH.and_then(date).unwrap_or_default());
    top.render_title(&mut page)?;
    top.render_name_section(&mut page)?;
    top.render_synopsis_section(&mut page)?;
    top.render_description_section(&mut page)?;
    commands(&root).to_writer(&mut page)?;
    page.append(&mut of_command(&root, "calculate", help::CALCULATE)?);
    // What belongs to one of the other commands stands in a section of that command.
    for (name, more) in [
        ("ground", help::GROUND),
        ("step", help::STEP),
        ("between", help::BETWEEN),
        ("q", help::Q),
    ] {
        let sections = of_command(&root, name, more)?;
        let sections = String::from_utf8_lossy(&sections).replace(".SH ", ".SS ");
        page.extend_from_slice(format!(".SH {}\n{sections}", name.to_ascii_uppercase()).as_bytes());
    }
    sections(&COMPLETIONS_HELP.replace("Examples:", "Completions:")).to_writer(&mut page)?;
    top.render_version_section(&mut page)?;
    let page = String::from_utf8_lossy(&page);
    // Without its quotes the next argument would be taken for an empty date.
    Ok(page.replacen(&format!(".TH {NAME} 1  "), &format!(".TH {NAME} 1 \"\" "), 1))
}

/// The options of a command, and what its help says below them.
fn of_command(root: &Command, name: &str, more: &str) -> std::io::Result<Vec<u8>> {
    let mut page = Vec::new();
    if let Some(command) = root.find_subcommand(name) {
        Man::new(command.clone()).render_options_section(&mut page)?;
    }
    sections(more).to_writer(&mut page)?;
    Ok(page)
}

/// A line for each way to call the program.
fn synopsis(root: &Command) -> String {
    let alone = cfg!(feature = "app").then(|| NAME.to_owned());
    let commands = root.get_subcommands().map(|command| format!("{NAME} {}", call(command)));
    alone.into_iter().chain(commands).collect::<Vec<_>>().join("\n")
}

/// `command` with its arguments: `completions <SHELL>`.
fn call(command: &Command) -> String {
    let values: String = command
        .get_positionals()
        .map(|value| format!(" <{}>", value.get_id().as_str().to_ascii_uppercase()))
        .collect();
    let has_options = command.get_opts().next().is_some();
    format!("{}{}{values}", command.get_name(), if has_options { " [OPTIONS]" } else { "" })
}

fn commands(root: &Command) -> Roff {
    let mut roff = Roff::new();
    roff.control("SH", ["COMMANDS"]);
    for command in root.get_subcommands() {
        roff.control("TP", []);
        roff.text([bold(call(command))]);
        roff.text([roman(command.get_about().map(ToString::to_string).unwrap_or_default())]);
        for value in command.get_positionals() {
            let names: Vec<_> = value.get_possible_values().iter().map(|one| one.get_name().to_owned()).collect();
            if names.is_empty() {
                continue;
            }
            roff.control("br", []);
            roff.text([roman("One of: "), italic(names.join(", "))]);
        }
    }
    roff
}

/// The blocks of `help`, each a title with a colon and indented lines, as sections with their line ends.
fn sections(help: &str) -> Roff {
    let mut roff = Roff::new();
    for block in help.split("\n\n") {
        let title = block.lines().next().and_then(|line| line.strip_suffix(':'));
        roff.control(
            if title.is_some() { "SH" } else { "PP" },
            title.map(str::to_ascii_uppercase).as_deref(),
        );
        let lines = block.lines().skip(usize::from(title.is_some()));
        roff.control("nf", []);
        for line in lines {
            roff.text([roman(line.strip_prefix("  ").unwrap_or(line))]);
        }
        roff.control("fi", []);
    }
    roff
}

/// The day of a time in seconds since 1970, as `2026-11-26`. `None` for what is no such time.
///
/// Source: Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms", `civil_from_days`, for days after 1970.
fn date(seconds: &str) -> Option<String> {
    let days = seconds.trim().parse::<u32>().ok()? / 86_400;
    // Counted from the first of March of the year 0, so that a leap day is the last of its year.
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let (month, next_year) = if month_from_march < 10 {
        (month_from_march + 3, 0)
    } else {
        (month_from_march - 9, 1)
    };
    let year = era * 400 + year_of_era + next_year;
    Some(format!("{year:04}-{month:02}-{day:02}"))
}

#[cfg(test)]
mod tests {
    use super::date;

    /// Against `date --utc --date=@SECONDS +%F` of GNU coreutils 9.1.
    #[test]
    fn a_time_in_seconds_is_a_day() {
        for (seconds, day) in [
            ("0", "1970-01-01"),
            ("86399", "1970-01-01"),
            ("951782400", "2000-02-29"),
            ("951868800", "2000-03-01"),
            ("1767225599", "2025-12-31"),
            ("1767225600", "2026-01-01"),
            ("4107542400", "2100-03-01"),
        ] {
            assert_eq!(date(seconds).as_deref(), Some(day), "{seconds}");
        }
        assert_eq!(date("yesterday"), None);
        assert_eq!(date("-1"), None);
    }
}
