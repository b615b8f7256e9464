//! "Where the uncertainty comes from": a bar for each method, cut into the shares of its inputs.

use crate::numbers::{self, to_f32};
use crate::sources::{Solved, Source};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};
use depth_core::problem::Method;
use depth_core::quantity::LengthUnit;
use depth_text::assess::Assessment;
use depth_text::names::Named as _;
use depth_text::number::Notation;
use depth_text::sentences::shares;
use depth_text::style::Style;
use depth_text::unit::Unit;

/// The size of headings and of the table, points.
const SIZE: f32 = 12.5;
/// The size of the legend, points.
const LEGEND_SIZE: f32 = 12.0;
/// The height of a heading, its bar below it not counted, points.
const HEADING: f32 = 22.0;
/// The height of a bar, points.
const BAR: f32 = 16.0;
/// Between two shares of a bar, points.
const GAP: f32 = 2.0;
/// The height of a line of the legend, points.
const LEGEND: f32 = 28.0;
/// Between a bar and the table below it, points.
const ABOVE_TABLE: f32 = 6.0;
/// The height of a row of the table, points.
const TABLE_ROW: f32 = 24.0;
/// Between a table and the next heading, points.
const BELOW_TABLE: f32 = 22.0;
/// The marks of the legend, points.
const MARK: f32 = 10.0;
/// The column of shares, points.
const SHARES: f32 = 52.0;

/// A source as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its mark.
    pub ink: Ink,
    /// Its symbol.
    pub symbol: Words,
    /// Its name with the symbol.
    pub name: Words,
    /// The σ that it alone would give: "± 0.0140 m".
    pub contribution: String,
    /// Its part of the variance, 0 to 1.
    pub share: f64,
    /// The same as text: "75 %", "< 1 %".
    pub share_text: String,
}

/// What the uncertainty of one value comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The value: "Stereo", "Disparity".
    pub name: String,
    /// Its σ: "± 0.016 m", "was ± 0.016 m".
    pub sigma: String,
    /// Whether it is what was.
    pub is_stale: bool,
    /// The sources, the largest first.
    pub entries: Vec<Entry>,
}

/// Every value that has a σ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Budget {
    /// From the top.
    pub blocks: Vec<Block>,
}

impl Block {
    /// "Stereo, ± 0.016 m: Disparity d 75 %, Camera baseline b 19 %".
    pub fn in_words(&self) -> String {
        let entries = self
            .entries
            .iter()
            .map(|entry| format!("{} {}", entry.name.text(), entry.share_text));
        format!("{}, {}: {}", self.name, self.sigma, entries.collect::<Vec<_>>().join(", "))
    }
}

impl Budget {
    /// Both methods, as far as they have a σ. Where there is no distance, it is that of `last`, the last inputs that gave one, in gray.
    pub fn new(assessment: &Assessment, last: Option<&Assessment>, unit: LengthUnit) -> Self {
        let blocks = Method::ALL.into_iter().filter_map(|method| {
            if assessment.solution.outcome(method).distance().is_some() {
                return of_method(assessment, method, unit);
            }
            let was = of_method(last?, method, unit)?;
            Some(Block {
                sigma: format!("was {}", was.sigma),
                is_stale: true,
                ..was
            })
        });
        Self { blocks: blocks.collect() }
    }

    /// What was solved for.
    pub fn solved(solved: &Solved) -> Self {
        Self {
            blocks: vec![Block::new(solved)],
        }
    }

    /// The picture in `width` points; as high as it needs. `is_detailed` has a table with a row for each source instead of a legend.
    pub fn layout(&self, width: f32, is_detailed: bool, measure: &dyn Measure) -> Figure {
        let mut figure = Figure::new(width, 0.0);
        let mut top = 0.0;
        for (index, block) in self.blocks.iter().enumerate() {
            if index > 0 {
                top += if is_detailed { BELOW_TABLE } else { 3.0 };
            }
            heading(&mut figure, top, block, measure);
            top += HEADING;
            bar(&mut figure, top, block);
            top += BAR;
            top = if is_detailed {
                table(&mut figure, top + ABOVE_TABLE, block, measure)
            } else {
                legend(&mut figure, top, block, measure)
            };
        }
        figure.height = top;
        figure
    }
}

impl Block {
    fn new(solved: &Solved) -> Self {
        const INKS: [Ink; 3] = [Ink::ShareFirst, Ink::ShareSecond, Ink::ShareThird];
        let Solved { value, sigma, unit, .. } = solved;
        let mut sources: Vec<&Source> = solved.sources.iter().filter(|source| source.share > 0.0).collect();
        sources.sort_by(|a, b| b.share.total_cmp(&a.share));
        let texts = shares(&sources.iter().map(|source| source.share).collect::<Vec<_>>());
        let inks = INKS.into_iter().chain(std::iter::repeat(Ink::ShareRest));
        let entries = sources.into_iter().zip(texts).zip(inks).map(|((source, share_text), ink)| Entry {
            ink,
            symbol: source.symbol.clone(),
            name: source.name.clone(),
            contribution: contribution(*value, *sigma, source.share, *unit),
            share: source.share,
            share_text,
        });
        Self {
            name: solved.name.clone(),
            sigma: numbers::sigma(*value, *sigma, *unit),
            is_stale: false,
            entries: entries.collect(),
        }
    }

    /// How strong its colors are.
    const fn opacity(&self) -> f32 {
        if self.is_stale { 0.55 } else { 1.0 }
    }
}

fn of_method(assessment: &Assessment, method: Method, unit: LengthUnit) -> Option<Block> {
    let known = assessment.solution.uncertainty(method)?;
    let distance = assessment.solution.outcome(method).distance()?;
    let unit = Style::WINDOW.unit_of(distance, unit);
    Some(Block::new(&Solved {
        name: method.name().to_owned(),
        quantity: crate::axis::Quantity::distance(unit.symbol()),
        unit: Unit::Length(unit),
        value: distance.in_unit(unit),
        sigma: known.sigma.in_unit(unit),
        method: Some(method),
        sources: Source::all(assessment, known),
    }))
}

/// The σ that one source alone would give, with one more decimal than that of all: the largest is not much smaller.
fn contribution(value: f64, sigma: f64, share: f64, unit: Unit) -> String {
    let one = sigma * share.sqrt();
    let decimals = numbers::decimals_beside(value, sigma).saturating_add(1);
    format!("± {} {}", Notation::SHORT.to_decimals(one, decimals), unit.symbol())
}

fn heading(figure: &mut Figure, top: f32, block: &Block, measure: &dyn Measure) {
    let y = top + 9.0;
    let name = Words::strong(block.name.as_str(), Ink::Text);
    let sigma = if block.is_stale {
        Words::new(block.sigma.as_str(), Ink::Muted)
    } else {
        Words::strong(block.sigma.as_str(), Ink::Text)
    };
    let taken = measure.width(&name, SIZE) + measure.width(&sigma, SIZE) + 10.0;
    let size = SIZE * (figure.width / taken).min(1.0);
    figure.text(Point::new(0.0, y), Align::Left, name, size);
    figure.text(Point::new(figure.width, y), Align::Right, sigma, size);
}

/// The bar; no share is so small that nothing of it is seen.
fn bar(figure: &mut Figure, top: f32, block: &Block) {
    const LEAST: f32 = 2.0;
    let count = f32::from(u8::try_from(block.entries.len()).unwrap_or(u8::MAX));
    let room = figure.width - GAP * (count - 1.0).max(0.0) - LEAST * count;
    let mut left = 0.0;
    for entry in &block.entries {
        let right = left + LEAST + room * to_f32(entry.share);
        let rect = Rect::new(left, top, right.min(figure.width), top + BAR);
        figure.rect(rect, 0.0, Fill::sheer(entry.ink, block.opacity()));
        left = right + GAP;
    }
}

/// "■ d 75 %  ■ b 19 %", on as many lines as it needs; the lower end is returned.
fn legend(figure: &mut Figure, top: f32, block: &Block, measure: &dyn Measure) -> f32 {
    const TEXT_AT: f32 = 16.0;
    const BETWEEN: f32 = 20.0;
    let (mut left, mut y) = (0.0, top + LEGEND / 2.0);
    for entry in &block.entries {
        let words = entry.symbol.clone().then(format!(" {}", entry.share_text), Ink::Text);
        let width = TEXT_AT + measure.width(&words, LEGEND_SIZE);
        if left > 0.0 && left + width > figure.width {
            left = 0.0;
            y += 20.0;
        }
        mark(figure, Point::new(left, y), entry.ink, block.opacity());
        figure.text(Point::new(left + TEXT_AT, y), Align::Left, words, LEGEND_SIZE);
        left += width + BETWEEN;
    }
    y + LEGEND / 2.0
}

fn mark(figure: &mut Figure, left: Point, ink: Ink, opacity: f32) {
    let rect = Rect::new(left.x, left.y - MARK / 2.0, left.x + MARK, left.y + MARK / 2.0);
    figure.rect(rect, 2.0, Fill::sheer(ink, opacity));
}

/// A row for each source, its name at the left, its σ and its share at the right; the lower end is returned.
fn table(figure: &mut Figure, top: f32, block: &Block, measure: &dyn Measure) -> f32 {
    const TEXT_AT: f32 = 18.0;
    let width = figure.width;
    let mut top = top;
    for entry in &block.entries {
        let y = top + TABLE_ROW / 2.0;
        figure.line(Point::new(0.0, top), Point::new(width, top), Stroke::new(Ink::Line, 1.0));
        mark(figure, Point::new(0.0, y), entry.ink, block.opacity());
        let contribution = Words::new(entry.contribution.as_str(), Ink::Text);
        // Where the name has no room, its symbol has.
        let room = width - SHARES - measure.width(&contribution, SIZE) - 10.0 - TEXT_AT;
        let fits = measure.width(&entry.name, SIZE) <= room;
        let name = if fits { entry.name.clone() } else { entry.symbol.clone() };
        figure.text(Point::new(TEXT_AT, y), Align::Left, name, SIZE);
        figure.text(Point::new(width - SHARES, y), Align::Right, contribution, SIZE);
        let share = Words::strong(entry.share_text.as_str(), Ink::Text);
        figure.text(Point::new(width, y), Align::Right, share, SIZE);
        top += TABLE_ROW;
    }
    top
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]
mod tests {
    use super::*;
    use crate::InterWidths;
    use crate::checks::assert_tidy;
    use depth_core::problem::Field;
    use depth_text::form::{Example, Inputs};

    /// The mug with the σ of its card.
    fn mug() -> Inputs {
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
        inputs
    }

    #[test]
    fn the_mug_has_the_shares_of_its_card() {
        let budget = Budget::new(&mug().assess(), None, LengthUnit::Meter);
        let said: Vec<Vec<String>> = budget
            .blocks
            .iter()
            .map(|block| {
                let entries = block
                    .entries
                    .iter()
                    .map(|entry| format!("{} {} {}", entry.name.text(), entry.contribution, entry.share_text));
                std::iter::once(format!("{} {}", block.name, block.sigma)).chain(entries).collect()
            })
            .collect();
        let stereo = [
            "Stereo ± 0.016 m",
            "Disparity d ± 0.0140 m 75 %",
            "Camera baseline b ± 0.0070 m 19 %",
            "Focal length fx ± 0.0040 m 6 %",
        ];
        assert_eq!(said[0], stereo);
        assert_eq!(said[1][1], "Object real width wreal ± 0.0467 m 86 %");
        assert_eq!(said[1][3], "Focal length fx ± 0.0040 m < 1 %");
    }

    #[test]
    fn nothing_leaves_the_picture_and_no_text_is_over_another() {
        let mut inputs = mug();
        inputs.entry_mut(Field::Doffs).text = "0".into();
        inputs.entry_mut(Field::Doffs).sigma = "0.2".into();
        let budget = Budget::new(&inputs.assess(), None, LengthUnit::Meter);
        assert_eq!(budget.blocks[0].entries.len(), 4);
        for width in [200.0, 300.0, 326.0, 368.0, 560.0] {
            for is_detailed in [false, true] {
                let figure = budget.layout(width, is_detailed, &InterWidths);
                assert!(figure.height > 100.0);
                assert_tidy(&figure, &format!("{width}, {is_detailed}"));
            }
        }
    }

    #[test]
    fn what_holds_no_longer_is_said_to_be_what_was() {
        let mut inputs = mug();
        inputs.entry_mut(Field::Disparity).text = "-12".into();
        let budget = Budget::new(&inputs.assess(), Some(&mug().assess()), LengthUnit::Meter);
        let said: Vec<_> = budget.blocks.iter().map(|block| (block.is_stale, block.sigma.as_str())).collect();
        assert_eq!(said, [(true, "was ± 0.016 m"), (false, "± 0.050 m")]);
        assert_eq!(Budget::new(&inputs.assess(), None, LengthUnit::Meter).blocks.len(), 1);
    }

    /// D 1.40 ± 0.01 m: (0.714 %)² of (0.918 %)² from the distance, (0.5 %)² from the baseline.
    #[test]
    fn what_was_solved_for_has_the_shares_of_its_inputs() {
        let mut inputs = mug();
        inputs.unknown = Some((Method::Stereo, Field::Disparity));
        inputs.entry_mut(depth_text::fields::DISTANCE).text = "1.40".into();
        inputs.entry_mut(depth_text::fields::DISTANCE).sigma = "0.01".into();
        let solved = Solved::unknown(&inputs.assess(), LengthUnit::Meter).unwrap();
        let block = Block::new(&solved);
        let said: Vec<_> = block
            .entries
            .iter()
            .map(|entry| format!("{} {} {}", entry.name.text(), entry.contribution, entry.share_text))
            .collect();
        assert_eq!(
            said,
            [
                "Object distance D ± 0.357 px 60 %",
                "Camera baseline b ± 0.250 px 30 %",
                "Focal length fx ± 0.143 px 10 %"
            ]
        );
        assert_eq!((block.name.as_str(), block.sigma.as_str()), ("Disparity", "± 0.46 px"));
        let model = crate::curve::CurveModel::inverse_of(&inputs.assess(), LengthUnit::Meter).unwrap();
        let said: Vec<_> = model.tip_at(1.4).iter().map(Words::text).collect();
        assert_eq!(said.get(..2).unwrap(), ["D = (1.40 ± 0.01) m", "d = (50.00 ± 0.46) px"]);
    }
}
