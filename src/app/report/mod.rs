//! The report of the session: what goes on paper, and into a file that a browser shows and prints.

#[cfg(not(target_arch = "wasm32"))]
mod fonts;
mod pictures;

use super::App;
use depth_text::export::{Figure, Html, Provenance, Results};
use depth_text::link;

/// The name of its file.
#[cfg(not(target_arch = "wasm32"))]
pub const FILE_NAME: &str = "depth-calculator-report.html";

impl App {
    /// The report as a page of its own, with its fonts.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn report_page(&self) -> String {
        self.with_report(|report, results| report.page(results, &fonts::rules()))
    }

    /// The report as a part of a page that has its styles. Where something is missing or cannot be read, it is the form, and says so.
    pub fn report_body(&self) -> String {
        self.with_report(|report, results| report.body(results))
    }

    /// Calls `write` with the report of the session.
    fn with_report(&self, write: impl FnOnce(&Html<'_>, &Results<'_>) -> String) -> String {
        let (mode, unit) = (self.settings.mode(&self.session.inputs), self.settings.result_unit);
        let pictures = pictures::of(mode, self.session.assessment(), unit);
        let figures = pictures.iter().map(|picture| Figure {
            title: picture.title,
            svg: &picture.svg,
            caption: &picture.note,
        });
        let figures: Vec<Figure<'_>> = figures.collect();
        let report = Html { mode, figures: &figures };
        self.with_results(|results| write(&report, results))
    }

    /// Calls `write` with the results of the session, and where they come from: version, date, and a link that opens them again.
    pub(super) fn with_results(&self, write: impl FnOnce(&Results<'_>) -> String) -> String {
        let (inputs, unit) = (&self.session.inputs, self.settings.result_unit);
        let mut link = self.platform.address();
        let fragment = link::fragment(inputs, unit);
        if !fragment.is_empty() {
            link = format!("{link}#{fragment}");
        }
        write(&Results {
            inputs,
            assessment: self.session.assessment(),
            unit,
            provenance: Provenance {
                version: env!("CARGO_PKG_VERSION"),
                date: &self.platform.today(),
                link: &link,
            },
        })
    }
}
