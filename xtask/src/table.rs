//! What a command did, part by part, as a table at its end: no failure hides another part, and what was left out is said.

use crate::step;
use std::time::Instant;

/// How a part ended.
pub(crate) enum Outcome {
    /// Everything was right; the words, if any, say what was counted.
    Passed(String),
    /// A sentence saying what was wrong.
    Failed(String),
    /// A sentence saying why it was not tried.
    LeftOut(String),
}

impl Outcome {
    /// Why it did not pass, or what was counted.
    pub(crate) fn reason(self) -> String {
        match self {
            Self::Passed(reason) | Self::Failed(reason) | Self::LeftOut(reason) => reason,
        }
    }
}

impl From<Result<(), String>> for Outcome {
    fn from(result: Result<(), String>) -> Self {
        result.map_or_else(Self::Failed, |()| Self::Passed(String::new()))
    }
}

struct Row {
    part: String,
    outcome: Outcome,
    seconds: f64,
}

/// The parts so far.
#[derive(Default)]
pub(crate) struct Table {
    rows: Vec<Row>,
}

impl Table {
    /// Does `work` and notes how it ended. Returns whether it passed.
    pub(crate) fn run<T: Into<Outcome>>(&mut self, part: &str, work: impl FnOnce() -> T) -> bool {
        let start = Instant::now();
        let outcome = work().into();
        let passed = matches!(outcome, Outcome::Passed(_));
        if let Outcome::Failed(reason) = &outcome {
            eprintln!("\n{reason}");
        }
        self.rows.push(Row {
            part: part.to_owned(),
            outcome,
            seconds: start.elapsed().as_secs_f64(),
        });
        passed
    }

    /// Notes a part that was not tried.
    pub(crate) fn leave_out(&mut self, part: &str, reason: impl Into<String>) {
        let reason = reason.into();
        self.run(part, || Outcome::LeftOut(reason));
    }

    /// Prints the table and where the time went. Err: a sentence, where a part failed, or was left out although nothing may be
    /// (`complete`).
    pub(crate) fn finish(self, complete: bool) -> Result<(), String> {
        println!("\n{}", self.text());
        step::print_times();
        let count = |wanted: fn(&Outcome) -> bool| self.rows.iter().filter(|row| wanted(&row.outcome)).count();
        let failed = count(|outcome| matches!(outcome, Outcome::Failed(_)));
        let left_out = count(|outcome| matches!(outcome, Outcome::LeftOut(_)));
        let passed = self.rows.len() - failed - left_out;
        println!("\nParts: {passed} passed, {failed} failed, {left_out} left out");
        if failed > 0 {
            Err(format!("{failed} of {} parts failed; the table above says why.", self.rows.len()))
        } else if complete && left_out > 0 {
            Err(format!(
                "{left_out} parts were left out, and with --complete none may be; the table above says why."
            ))
        } else {
            Ok(())
        }
    }

    fn text(&self) -> String {
        let width = self.rows.iter().map(|row| row.part.chars().count()).max().unwrap_or(0);
        let lines = self.rows.iter().map(|Row { part, outcome, seconds }| {
            let (word, why) = match outcome {
                Outcome::Passed(counted) => ("passed", counted),
                Outcome::Failed(reason) => ("FAILED", reason),
                Outcome::LeftOut(reason) => ("left out", reason),
            };
            // A reason of several lines stays in its column.
            let why = why.replace('\n', &format!("\n{:indent$}", "", indent = width + 24));
            format!("  {part:<width$}  {word:<8}  {seconds:>7.1} s  {why}")
                .trim_end()
                .to_owned()
        });
        let head = format!("  {:<width$}  {:<8}  {:>9}", "part", "result", "time");
        std::iter::once(head).chain(lines).collect::<Vec<_>>().join("\n")
    }
}

#[cfg(test)]
mod tests {
    use super::{Outcome, Table};

    fn table() -> Table {
        let mut table = Table::default();
        table.run("rust", || Ok(()));
        table.run("firefox", || Outcome::Passed("9 passed".into()));
        table
    }

    #[test]
    fn a_part_that_fails_is_named_with_its_reason_and_the_next_one_still_runs() {
        let mut table = table();
        assert!(!table.run("webkit", || Err::<(), _>("It hangs.\nTwice.".to_owned())));
        assert!(table.run("size", || Ok(())));
        let text = table.text();
        assert!(text.contains("webkit   FAILED"), "{text}");
        assert!(text.contains("It hangs.\n                               Twice."), "{text}");
        assert!(table.finish(false).is_err_and(|reason| reason.contains("1 of 4")));
    }

    #[test]
    fn what_is_left_out_fails_only_where_everything_must_run() {
        let mut left_out = table();
        left_out.leave_out("webkit", "It is not here.");
        assert!(left_out.text().contains("webkit   left out"), "{}", left_out.text());
        assert!(left_out.finish(false).is_ok());
        let mut left_out = table();
        left_out.leave_out("webkit", "It is not here.");
        assert!(left_out.finish(true).is_err());
        assert!(table().finish(true).is_ok());
    }
}
