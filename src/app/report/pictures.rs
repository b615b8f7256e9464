//! The pictures of the report: those of the screen, laid out for its columns. What the uncertainty comes from is a table there.

use crate::app::calculator::Card;
use crate::app::sentences::Description;
use crate::core::quantity::{LengthUnit, Pixels};
use depth_figures::bars::Bars;
use depth_figures::curve::{CurveModel, Shown};
use depth_figures::ground::{self, Above, ImageView, SideView};
use depth_figures::sources::Solved;
use depth_figures::top_view::{Model, Options, Source, TopView};
use depth_figures::{InterWidths, svg};
use depth_text::assess::Assessment;
use depth_text::report;
use depth_text::report::strip::Mode;
use depth_text::sentences::capital;

use crate::app::theme::paper::{COLUMN, GROUND_HEIGHT, ROWS_HEIGHT, VIEW_HEIGHT};

/// A picture of the report.
pub struct Picture {
    /// Its heading.
    pub title: &'static str,
    /// An `svg` element.
    pub svg: String,
    /// What is to be said below it; may be empty.
    pub note: String,
}

impl Picture {
    fn new(card: Card, figure: &depth_figures::Figure, description: &str, note: String) -> Self {
        Self {
            title: card.title(),
            svg: svg::of(figure, card.title(), description),
            note: sentences(&note),
        }
    }
}

/// `note` as whole sentences: what stands at a title on the screen, stands below a picture here.
fn sentences(note: &str) -> String {
    let note = capital(note);
    if note.is_empty() || note.ends_with('.') { note } else { note + "." }
}

/// What `mode` has pictures of, in reading order.
pub fn of(mode: Mode, assessment: &Assessment, unit: LengthUnit) -> Vec<Picture> {
    let found = match mode {
        Mode::Distance => [bars(assessment, unit), curve(assessment, unit), top_view(assessment, unit)],
        Mode::Quantity => [gains(assessment, unit), inverse_curve(assessment, unit), top_view(assessment, unit)],
        Mode::Ground => {
            let model = ground::Model::new(assessment, unit);
            [
                model.as_ref().map(side_view),
                model.as_ref().map(floor),
                model.as_ref().and_then(image),
            ]
        }
        Mode::TwoShots | Mode::TwoPoints => [None, None, None],
    };
    found.into_iter().flatten().collect()
}

/// Both distances on one axis, as soon as there is one.
fn bars(assessment: &Assessment, unit: LengthUnit) -> Option<Picture> {
    let solution = &assessment.solution;
    let bars = Bars::new(solution, None, unit);
    (!bars.is_empty()).then(|| {
        let drawn = bars.layout(COLUMN, ROWS_HEIGHT, &InterWidths);
        let description = Description::Bars { solution, unit };
        Picture::new(Card::Bars, &drawn.figure, &description.to_string(), drawn.caption)
    })
}

/// What an answer gains when one input is known exactly.
fn gains(assessment: &Assessment, unit: LengthUnit) -> Option<Picture> {
    let bars = Bars::gains(&Solved::unknown(assessment, unit)?);
    let drawn = bars.layout(COLUMN, ROWS_HEIGHT, &InterWidths);
    let rows = bars.in_words();
    let description = Description::Gains { rows: &rows };
    Some(Picture::new(Card::Gains, &drawn.figure, &description.to_string(), drawn.caption))
}

fn curve(assessment: &Assessment, unit: LengthUnit) -> Option<Picture> {
    let solution = &assessment.solution;
    let model = CurveModel::new(solution, None, unit)?;
    let typed = solution
        .problem
        .disparity
        .and_then(|disparity| Some(Pixels::new(disparity.px()?.value.px())));
    let description = Description::Curve {
        point: typed.zip(solution.stereo.distance()),
        unit,
    };
    let mut picture = picture_of_curve(Card::Curve, &model, &description);
    if let Some(range) = report::one_pixel_range(solution, unit) {
        let one_pixel = sentences(&format!("{}: {range}", report::ONE_PIXEL));
        picture.note = format!("{} {one_pixel}", picture.note).trim_start().to_owned();
    }
    Some(picture)
}

fn inverse_curve(assessment: &Assessment, unit: LengthUnit) -> Option<Picture> {
    let model = CurveModel::inverse_of(assessment, unit)?;
    Some(picture_of_curve(
        Card::InverseCurve,
        &model,
        &Description::InverseCurve { point: None },
    ))
}

fn picture_of_curve(card: Card, model: &CurveModel, description: &Description<'_>) -> Picture {
    let drawn = model.layout(COLUMN, VIEW_HEIGHT, &Shown::default(), &InterWidths);
    Picture::new(card, &drawn.figure, &description.to_string(), drawn.caption)
}

fn top_view(assessment: &Assessment, unit: LengthUnit) -> Option<Picture> {
    let model = Model::new(Source {
        now: assessment,
        before: None,
        unit,
        angle: None,
    })?;
    let drawn = TopView::new(&model, [COLUMN, VIEW_HEIGHT], Options::default(), &InterWidths);
    let note = format!("{}. {}", drawn.caption, drawn.note);
    Some(Picture::new(Card::TopView, &drawn.figure, &note, note.clone()))
}

fn side_view(model: &ground::Model) -> Picture {
    let drawn = SideView::new(model, [COLUMN, GROUND_HEIGHT], &InterWidths);
    Picture::new(Card::SideView, &drawn.figure, &drawn.caption, drawn.caption.clone())
}

fn floor(model: &ground::Model) -> Picture {
    let drawn = Above::new(model, [COLUMN, GROUND_HEIGHT], &InterWidths);
    let note = format!("{}. {}", drawn.caption, drawn.note);
    Picture::new(Card::Floor, &drawn.figure, &note, note.clone())
}

/// The point in the image, no higher than the pictures beside it.
fn image(model: &ground::Model) -> Option<Picture> {
    let of_width = |width| ImageView::new(model, width, &InterWidths);
    let full = of_width(COLUMN)?;
    let smaller = (GROUND_HEIGHT / full.figure.height).min(1.0);
    let ImageView {
        mut figure, caption, note, ..
    } = of_width(COLUMN * smaller)?;
    // Pictures are drawn as wide as the column: letters would become larger.
    figure.width = COLUMN;
    let note = format!("{caption} px. {note}");
    Some(Picture::new(Card::Image, &figure, &Description::InImage.to_string(), note))
}
