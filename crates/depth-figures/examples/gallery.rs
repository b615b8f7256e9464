//! Writes a page with every picture in many cases and widths: `cargo run -p depth-figures --example gallery -- page.html`.

use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solution};
use depth_core::quantity::LengthUnit;
use depth_figures::axis::Quantity;
use depth_figures::bars::Bars;
use depth_figures::budget::Budget;
use depth_figures::curve::{CurveModel, Shown};
use depth_figures::sources::{Solved, Source};
use depth_figures::{Figure, Ink, InterWidths, Words, svg};
use depth_text::form::Example;
use depth_text::unit::Unit;
use std::fmt::Write as _;

const WIDTHS: [f32; 2] = [300.0, 368.0];

/// fx, b, d, w_img, w_real with their σ; NaN is not known.
type Inputs = [(f64, f64); 5];
const MUG: Inputs = [(700.0, 2.0), (0.1, 0.0005), (50.0, 0.5), (150.0, 2.0), (0.3, 0.01)];

fn solved(inputs: Inputs) -> Solution {
    let fields = [
        Field::FocalLength,
        Field::Baseline,
        Field::Disparity,
        Field::ImageWidth,
        Field::RealWidth,
    ];
    let mut problem = Problem::default();
    for (field, (value, sigma)) in fields.into_iter().zip(inputs) {
        problem.set(field, (!value.is_nan()).then_some(value));
        problem.set_sigma(field, sigma);
    }
    problem.solve()
}

fn cases() -> Vec<(&'static str, Inputs)> {
    let [f, b, d, w, l] = MUG;
    let none = (f64::NAN, 0.0);
    vec![
        ("mug", MUG),
        ("10 times as far", [f, b, d, w, (3.0, 0.1)]),
        ("21 % farther", [f, b, d, (150.0, 0.1), (0.363, 0.001)]),
        ("no sigma", MUG.map(|(value, _)| (value, 0.0))),
        ("d 50 ± 20", [f, b, (50.0, 20.0), w, l]),
        ("d 50 ± 60", [f, b, (50.0, 60.0), w, l]),
        ("d −12, last the mug", [f, b, (-12.0, 0.5), w, l]),
        ("stereo only", [f, b, d, none, none]),
        ("1e7 m", [f, (1e6, 5e3), d, w, (2.9e6, 1e5)]),
        ("1e-6 m", [f, (1e-7, 1e-9), d, w, (3e-7, 1e-8)]),
        ("sigma 1e-6", MUG.map(|(value, _)| (value, value * 1e-6))),
        ("nearer", [f, b, d, w, (0.05, 0.001)]),
    ]
}

fn card(page: &mut String, title: &str, caption: &str, figure: &Figure) {
    let _ = write!(
        page,
        r#"<div class="card"><p><b>{}</b><span>{}</span></p>{}</div>"#,
        svg::escape(title),
        svg::escape(caption),
        svg::of(figure, title, "")
    );
}

/// What a page begins with.
fn head(fonts: &std::path::Path) -> String {
    let fonts = fonts.display();
    format!(
        "<meta charset=utf-8><style>@font-face{{font-family:Inter;src:url(file://{fonts}/Inter-Regular.ttf)}}\
         @font-face{{font-family:Inter;font-weight:600;src:url(file://{fonts}/Inter-SemiBold.ttf)}}\
         body{{margin:8px;background:#f4f6f8;font-family:Inter}}svg{{display:block;overflow:visible}}\
         .card{{display:inline-block;vertical-align:top;background:#fff;border:1px solid #dce1e7;border-radius:8px;\
         padding:8px 16px 16px;margin:4px}}\
         p{{margin:8px 0 12px;display:flex;justify-content:space-between;font-size:14px}}\
         b{{font-weight:600}}span{{font-size:12px;color:#535e6c}}</style>"
    )
}

/// Both pictures of a case, in every width.
fn case(page: &mut String, name: &str, inputs: Inputs) {
    let last = solved(MUG);
    let last = Some(&last).filter(|_| name.contains("last"));
    let solution = solved(inputs);
    page.push_str("<div>");
    for width in WIDTHS {
        let rows = Bars::new(&solution, last, LengthUnit::Meter).layout(width, 220.0, &InterWidths);
        card(page, name, &rows.caption, &rows.figure);
    }
    for width in WIDTHS {
        let Some(model) = CurveModel::new(&solution, last, LengthUnit::Meter) else {
            continue;
        };
        let tip = model.point.as_ref().map(|point| point.x).filter(|_| width > 300.0);
        let curve = model.layout(width, 224.0, &Shown { axes: None, tip }, &InterWidths);
        card(page, name, &curve.caption, &curve.figure);
    }
    page.push_str("</div>");
}

/// What is shown where the disparity is solved for.
fn solved_for(page: &mut String) {
    let source = |name, share| Source {
        symbol: Words::symbol(name, Ink::Text),
        name: Words::symbol(name, Ink::Text),
        share,
    };
    let disparity = Solved {
        name: "Disparity".to_owned(),
        quantity: Quantity::disparity(false),
        unit: Unit::Pixel,
        value: 50.0,
        sigma: 0.4588,
        method: Some(Method::Stereo),
        sources: vec![source("D", 0.606), source("b", 0.297), source("fx", 0.097)],
    };
    page.push_str("<div>");
    for width in WIDTHS {
        let rows = Bars::gains(&disparity).layout(width, 220.0, &InterWidths);
        card(page, "If one input were exact", &rows.caption, &rows.figure);
        let distance = Measured::from_base(1.4, 0.01);
        let Some(model) = CurveModel::inverse(&solved(MUG).problem, distance, LengthUnit::Meter) else {
            continue;
        };
        let shown = Shown {
            axes: None,
            tip: Some(1.4),
        };
        let curve = model.layout(width, 224.0, &shown, &InterWidths);
        card(page, "Disparity against distance", &curve.caption, &curve.figure);
    }
    page.push_str("</div>");
}

/// The budget of the mug, with a legend and with a table; and as it was.
fn budgets(page: &mut String) {
    let mut inputs = Example::CoffeeMug.inputs();
    for (field, text, sigma) in [
        (Field::FocalLength, "700", "2"),
        (Field::Baseline, "100 mm", "0.5 mm"),
        (Field::Disparity, "50", "0.5"),
        (Field::ImageWidth, "150", "2"),
        (Field::RealWidth, "0.30", "0.01"),
    ] {
        let entry = inputs.entry_mut(field);
        entry.text = text.into();
        entry.sigma = sigma.into();
    }
    let mug = inputs.assess();
    inputs.entry_mut(Field::Disparity).text = "-12".into();
    let now = Budget::new(&mug, None, LengthUnit::Meter);
    let was = Budget::new(&inputs.assess(), Some(&mug), LengthUnit::Meter);
    for (budget, is_detailed) in [(&now, false), (&was, false), (&now, true)] {
        let figure = budget.layout(368.0, is_detailed, &InterWidths);
        card(page, "Where the uncertainty comes from", "", &figure);
    }
}

fn main() -> std::io::Result<()> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "gallery.html".to_owned());
    let mut page = head(&std::env::current_dir()?.join("assets/fonts"));
    budgets(&mut page);
    solved_for(&mut page);
    for (name, inputs) in cases() {
        case(&mut page, name, inputs);
    }
    std::fs::write(path, page)
}
