//! The report: one page that stands by itself.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use depth_core::problem::Field;
use depth_core::quantity::LengthUnit;
use depth_text::export::{Exporter as _, Figure, Html, Provenance, Results};
use depth_text::field::Key;
use depth_text::form::Inputs;
use depth_text::report::Mode;

const FIGURE: Figure<'_> = Figure {
    title: "Top view",
    svg: "<svg viewBox=\"0 0 1 1\"></svg>",
    caption: "To scale.",
};

fn mug() -> Inputs {
    let mut inputs = Inputs::default();
    for (name, text) in [
        ("fx", "700 ± 2"),
        ("b", "100 ± 0.5"),
        ("d", "50 ± 0.5"),
        ("wimg", "150 ± 2"),
        ("wreal", "0.30 ± 0.01"),
    ] {
        let key = Key::named(name).unwrap();
        inputs.entry_mut(key).text = text.to_owned();
        inputs.tidy(key);
    }
    inputs
}

fn page(mode: Mode, inputs: &Inputs) -> String {
    let assessment = inputs.assess();
    let html = Html { mode, figures: &[FIGURE] };
    let Ok(page) = html.export(&Results {
        inputs,
        assessment: &assessment,
        unit: LengthUnit::Meter,
        provenance: Provenance {
            version: "0.1.0",
            date: "November 25, 2026",
            link: "https://example.org/#fx=700&b=100mm",
        },
    });
    page
}

fn assert_has(page: &str, pieces: &[&str]) {
    for piece in pieces {
        assert!(page.contains(piece), "{piece} is not in\n{page}");
    }
}

#[test]
fn the_report_has_title_answers_table_figures_budget_and_link() {
    let page = page(Mode::Distance, &mug());
    assert_has(
        &page,
        &[
            "<!DOCTYPE html>",
            "<title>Distance of an object</title>",
            "Depth Calculator 0.1.0 · November 25, 2026",
            "<b>1.400</b><span class=\"quiet\"> ± 0.016)</span>&nbsp;<b>m</b>",
            "D = w<sub>real</sub> · f<sub>x</sub> / w<sub>img</sub>",
            "Intermediate values",
            "± 0.0140 m",
            "<b>75 %</b>",
            "<svg viewBox=\"0 0 1 1\"></svg>",
            "<figcaption>To scale.</figcaption>",
            "<a href=\"https://example.org/#fx=700&amp;b=100mm\">",
            "@page",
            "the combined distance counts it once.",
        ],
    );
    for outside in ["<script", "http-equiv", "<link", "src=", "url(", "@import"] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn with_nothing_typed_it_prints_the_form_and_says_what_is_missing() {
    let page = page(Mode::Distance, &Inputs::default());
    assert_has(
        &page,
        &[
            "Start with the focal length in pixels",
            "What was entered",
            "Calibration: K[0][0], P[0] or Q[2][3]",
        ],
    );
    assert!(!page.contains("<figure>"), "{page}");
}

#[test]
fn what_cannot_be_read_is_printed_as_it_was_typed_and_is_no_markup() {
    let mut inputs = mug();
    inputs.entry_mut(Field::Disparity).text = "<b>&\"5o".into();
    let page = page(Mode::Distance, &inputs);
    assert_has(&page, &["&lt;b&gt;&amp;&quot;5o", "d</span> cannot be read.", "1.400"]);
    assert!(!page.contains("<b>&\"") && !page.contains("<figure>"), "{page}");
}

#[test]
fn every_mode_has_a_page() {
    for mode in Mode::ALL {
        for inputs in [mug(), Inputs::default()] {
            let page = page(mode, &inputs);
            for tag in [
                "table", "tr", "td", "th", "p", "div", "section", "span", "b", "sub", "figure", "svg", "ul", "li",
            ] {
                let opened = page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
                assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{tag} in {mode:?}\n{page}");
            }
        }
    }
}
