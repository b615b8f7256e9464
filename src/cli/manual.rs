//! The manual page: one for the whole program, because whoever types `man depth-calculator` wants to know its options.

use super::{COMPLETIONS_HELP, Cli, NAME, options};
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, italic, roman};

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
    let top = Man::new(root.clone().override_usage(synopsis(&root))).manual("User Commands");
    top.render_title(&mut page)?;
    top.render_name_section(&mut page)?;
    top.render_synopsis_section(&mut page)?;
    top.render_description_section(&mut page)?;
    commands(&root).to_writer(&mut page)?;
    if let Some(calculate) = root.find_subcommand("calculate") {
        Man::new(calculate.clone()).render_options_section(&mut page)?;
    }
    sections(options::MORE_HELP).to_writer(&mut page)?;
    sections(&COMPLETIONS_HELP.replace("Examples:", "Completions:")).to_writer(&mut page)?;
    top.render_version_section(&mut page)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
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
        .map(|value| format!(" <{}>", value.get_id().as_str().to_uppercase()))
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
        roff.control(if title.is_some() { "SH" } else { "PP" }, title.map(str::to_uppercase).as_deref());
        let lines = block.lines().skip(usize::from(title.is_some()));
        roff.control("nf", []);
        for line in lines {
            roff.text([roman(line.strip_prefix("  ").unwrap_or(line))]);
        }
        roff.control("fi", []);
    }
    roff
}
