//! The report: one page of HTML that stands by itself, for paper and for a file.

mod markup;

use super::exporter::{Exporter, Results};
use crate::field::Key;
use crate::note::Severity;
use crate::report::{self, Budget, Cell, Mode, NONE, Row, Shown, Strip, Tone, Value};
use crate::sentences::Page;
use depth_core::problem::Method;
use markup::{class, escaped, in_color, line, with_symbols};
use std::convert::Infallible;

/// All of its style: without gray grounds, and without a size of the page, so that A4 and Letter both fit.
const CSS: &str = include_str!("style.css");

/// The report on what `mode` asks for.
#[derive(Clone, Copy, Debug)]
pub struct Html<'a> {
    /// What is asked for.
    pub mode: Mode,
    /// The pictures, two in a line.
    pub figures: &'a [Figure<'a>],
}

/// A picture of the report, drawn by the caller.
#[derive(Clone, Copy, Debug)]
pub struct Figure<'a> {
    /// Its heading.
    pub title: &'a str,
    /// The picture: one `<svg>` element, taken as it is.
    pub svg: &'a str,
    /// A line below it; may be empty.
    pub caption: &'a str,
}

impl Exporter for Html<'_> {
    type Error = Infallible;

    fn export(&self, results: &Results<'_>) -> Result<String, Infallible> {
        Ok(self.page(results, ""))
    }
}

impl Html<'_> {
    /// The whole page, with rules of CSS in front of its own, such as `@font-face`.
    pub fn page(&self, results: &Results<'_>, rules: &str) -> String {
        let (title, body) = (escaped(&Page::Title(self.mode).to_string()), self.body(results));
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n<style>\n{rules}{CSS}</style>\n</head>\n<body>\n{body}</body>\n</html>\n"
        )
    }

    /// What stands inside the page, for a page that links its style (`style.css`) by itself.
    pub fn body(&self, results: &Results<'_>) -> String {
        let shown = Shown {
            inputs: results.inputs,
            assessment: results.assessment,
            unit: results.unit,
            was: None,
        };
        let cells = Strip::new(self.mode, &shown).cells;
        let has_answer = cells.iter().any(|cell| matches!(cell.value, Value::Number { .. }));
        let is_readable = !results.assessment.notes.iter().any(|note| note.severity == Severity::Error);
        let mut body = header(&Page::Title(self.mode).to_string(), results);
        if has_answer {
            body.push_str(&answer(&cells));
        }
        if has_answer && is_readable {
            body.push_str(&table(&report::mode_rows(self.mode, &shown)));
            body.push_str(&self.figures(&report::budgets(self.mode, &shown)));
        } else {
            body.push_str(&what_is_missing(&shown));
            body.push_str(&form(self.mode, &shown));
        }
        body.push_str(&footer(results, has_answer));
        body
    }

    /// The pictures in two columns, the budget second.
    fn figures(&self, budgets: &[Budget]) -> String {
        let pictures = self.figures.iter().map(|figure| {
            let caption = if figure.caption.is_empty() {
                String::new()
            } else {
                format!("<figcaption>{}</figcaption>", with_symbols(figure.caption))
            };
            format!(
                "<figure>\n<h2>{}</h2>\n{}\n{caption}</figure>\n",
                with_symbols(figure.title),
                figure.svg
            )
        });
        let mut blocks: Vec<String> = pictures.collect();
        if !budgets.is_empty() {
            let budgets = budgets.iter().map(budget).collect::<String>();
            let heading = Page::WhereUncertaintyComesFrom;
            blocks.insert(blocks.len().min(1), format!("<figure>\n<h2>{heading}</h2>\n{budgets}</figure>\n"));
        }
        format!("<div class=\"figures\">\n{}</div>\n", blocks.concat())
    }
}

fn header(title: &str, results: &Results<'_>) -> String {
    let provenance = escaped(&results.provenance.line(" · "));
    format!("<header><h1>{}</h1><p>{provenance}</p></header>\n", escaped(title))
}

/// The three cells side by side.
fn answer(cells: &[Cell; 3]) -> String {
    let cells = cells.iter().map(|cell| {
        let [first_line, second] = &cell.lines;
        let badge = cell.badge.map_or_else(String::new, |badge| format!("{}, ", badge.text));
        let first = line(&report::Line {
            parts: std::iter::once(report::Part::Text(badge))
                .filter(|badge| !badge.text().is_empty())
                .chain(first_line.parts.iter().cloned())
                .collect(),
            ..*first_line
        });
        // The numbers of a formula stand in the table.
        let second = match cell.tone {
            Tone::Stereo | Tone::Monocular if !(cell.formula.is_empty() || first_line.is_refusal) => {
                format!("<p class=\"small\">{}</p>", formula(cell))
            }
            _ => line(second),
        };
        let tone = class(cell.tone);
        format!(
            "<div><h2 class=\"{tone}\">{}</h2><p class=\"value\">{}</p>{first}{second}</div>\n",
            escaped(&cell.title),
            value(&cell.value)
        )
    });
    format!("<section class=\"answer\">\n{}</section>\n", cells.collect::<String>())
}

/// "D = fx · b / d" of a distance, else the formula alone.
fn formula(cell: &Cell) -> String {
    let is_distance = Method::ALL
        .into_iter()
        .any(|method| crate::names::Named::name(method) == cell.title);
    let front = if is_distance { "D = " } else { "" };
    with_symbols(&format!("{front}{}", cell.formula.trim_start_matches("D = ")))
}

/// "(<b>1.400</b> ± 0.016) <b>m</b>"
fn value(value: &Value) -> String {
    let Value::Number {
        number,
        sigma,
        power,
        unit,
    } = value
    else {
        return format!("<span class=\"quiet words\">{}</span>", with_symbols(&value.text()));
    };
    let (number, power) = (escaped(number), escaped(power));
    let number = match sigma {
        Some(sigma) => format!(
            "<span class=\"quiet\">(</span><b>{number}</b><span class=\"quiet\"> ± {})</span>{power}",
            escaped(sigma)
        ),
        None => format!("<b>{number}</b>{power}"),
    };
    let Some(unit) = unit else { return number };
    // Behind a number that is "(…)" as behind any other.
    let behind = unit.behind("");
    let space = if behind.starts_with(' ') { "&nbsp;" } else { "" };
    format!("{number}{space}<b>{}</b>", escaped(behind.trim_start()))
}

/// The table of inputs and outputs.
fn table(rows: &[Row]) -> String {
    let heading = Page::Table;
    let columns = ["Parameter", "Value", "± 1 σ", "Unit", "Description"].map(|name| format!("<th scope=\"col\">{name}</th>"));
    let rows = rows.iter().map(|row| {
        let group = row.heading.map_or_else(String::new, |heading| format!("<tr><th scope=\"colgroup\" colspan=\"5\">{heading}</th></tr>\n"));
        let symbol = if row.key.is_some() && !row.parameter_symbol.is_empty() {
            format!(" {}", in_color(row.tone, row.parameter_symbol))
        } else {
            String::new()
        };
        format!(
            "{group}<tr><th scope=\"row\">{}{symbol}</th><td class=\"value\">{}</td><td class=\"sigma\">{}</td><td>{}</td><td class=\"description\">{}</td></tr>\n",
            with_symbols(&row.label),
            aligned(&row.value),
            row.sigma.as_deref().map_or_else(String::new, aligned),
            escaped(&row.symbol),
            with_symbols(&row.description)
        )
    });
    format!(
        "<section>\n<h2>{heading}</h2>\n<table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table>\n</section>\n",
        columns.concat(),
        rows.collect::<String>()
    )
}

/// A number in two parts that meet at its point, so that those of a column stand below each other.
fn aligned(number: &str) -> String {
    let at = number.find('.').unwrap_or(number.len());
    let (whole, decimals) = number.split_at_checked(at).unwrap_or((number, ""));
    format!(
        "<span class=\"i\">{}</span><span class=\"f\">{}</span>",
        escaped(whole),
        escaped(decimals)
    )
}

/// The grays of a budget, the largest share first.
const GRAYS: [&str; 4] = ["#414a57", "#8a94a3", "#c9cfd8", "#e3e7ec"];

/// A bar and a row for each input.
fn budget(budget: &Budget) -> String {
    let gray = |place: usize| GRAYS.get(place).or(GRAYS.last()).copied().unwrap_or_default();
    let mut from = 0.0;
    let mut bar = String::new();
    let mut rows = String::new();
    for (place, row) in budget.rows.iter().enumerate() {
        let width = row.share * 100.0;
        bar.push_str(&format!(
            "<rect x=\"{from:.2}\" width=\"{width:.2}\" height=\"4\" fill=\"{}\"/>",
            gray(place)
        ));
        from += width;
        let swatch = format!(
            "<svg class=\"swatch\" viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" fill=\"{}\"/></svg>",
            gray(place)
        );
        rows.push_str(&format!(
            "<tr><td>{swatch}{} {}</td><td class=\"number\">{}</td><td class=\"number\"><b>{}</b></td></tr>\n",
            with_symbols(row.key.label),
            in_color(Tone::of(row.key), row.key.symbol),
            escaped(&row.contribution),
            escaped(&row.percent)
        ));
    }
    format!(
        "<div class=\"budget\"><p><span>{}</span><span>{}</span></p>\n<svg viewBox=\"0 0 100 4\" preserveAspectRatio=\"none\" aria-hidden=\"true\">{bar}</svg>\n<table>\n{rows}</table></div>\n",
        escaped(&budget.title),
        escaped(&budget.sigma)
    )
}

/// What is wrong with what was typed, and what is missing.
fn what_is_missing(shown: &Shown<'_>) -> String {
    let assessment = shown.assessment;
    let wrong = assessment.notes.iter().filter(|note| note.severity == Severity::Error);
    let notes = wrong
        .chain(&assessment.missing)
        .map(|note| format!("<li>{}</li>\n", with_symbols(&note.message())));
    let notes = notes.collect::<String>();
    if notes.is_empty() {
        return String::new();
    }
    format!("<section>\n<h2>{}</h2>\n<ul>\n{notes}</ul>\n</section>\n", Page::WhatIsMissing)
}

/// The fields with what was typed into them, to be filled in by hand.
fn form(mode: Mode, shown: &Shown<'_>) -> String {
    let inputs = shown.inputs;
    let mut keys: Vec<Key> = report::mode_rows(mode, shown).into_iter().filter_map(|row| row.key).collect();
    if mode == Mode::Distance {
        keys.extend(
            Key::form()
                .filter(|key| inputs.shows(*key) && !keys.contains(key))
                .collect::<Vec<_>>(),
        );
    }
    let rows = keys.into_iter().map(|key| {
        let entry = inputs.entry(key);
        let text = if entry.is_blank() { NONE } else { entry.text.trim() };
        let unit = entry.chosen_unit(key).map_or("", |unit| unit.symbol());
        let sigma = entry.sigma_text();
        let sigma = if key.has_sigma && !sigma.is_empty() { format!("± {sigma}") } else { String::new() };
        format!(
            "<tr><th scope=\"row\">{} {}</th><td class=\"value\">{}</td><td class=\"sigma\">{}</td><td>{unit}</td><td class=\"description\">{}</td></tr>\n",
            with_symbols(key.label),
            in_color(Tone::of(key), key.symbol),
            escaped(text),
            escaped(&sigma),
            with_symbols(key.hint)
        )
    });
    format!(
        "<section>\n<h2>{}</h2>\n<table>\n<tbody>\n{}</tbody>\n</table>\n</section>\n",
        Page::Form,
        rows.collect::<String>()
    )
}

fn footer(results: &Results<'_>, has_answer: bool) -> String {
    let assessment = results.assessment;
    let has_sigma = Method::ALL
        .into_iter()
        .any(|method| assessment.solution.uncertainty(method).is_some());
    let mut text = String::new();
    if has_answer {
        text.push_str(
            &Page::EveryValue {
                has_sigma,
                is_combined: assessment.solution.combined.is_some(),
            }
            .to_string(),
        );
    }
    let link = results.provenance.link;
    // Nothing but an address is a link.
    let is_address = ["https://", "http://", "file://"].iter().any(|scheme| link.starts_with(scheme));
    let open = match (link.is_empty(), is_address) {
        (true, _) => String::new(),
        (false, true) => format!("<p>{} <a href=\"{1}\">{1}</a></p>", Page::OpenAgain, escaped(link)),
        (false, false) => format!("<p>{} {}</p>", Page::OpenAgain, escaped(link)),
    };
    format!("<footer><p>{}</p>{open}</footer>\n", with_symbols(&text))
}
