//! What the answer of the current mode is made of, for its pictures.

use crate::app::context::AppContext;
use crate::core::judge::Term;
use crate::core::measured::Measured;
use depth_figures::axis::Quantity;
use depth_figures::sources::{Solved, Source};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::report::strip::{Cell, Shown, Strip};
use depth_text::report::{self, Row};
use depth_text::style::Style;
use depth_text::unit::Unit;

impl AppContext<'_> {
    /// The answer as it is written.
    pub fn strip(&self) -> Strip {
        Strip::new(self.mode(), &self.shown())
    }

    fn shown(&self) -> Shown<'_> {
        Shown {
            inputs: &self.session.inputs,
            assessment: self.session.assessment(),
            unit: self.unit(),
            was: Some(self.session.last()),
        }
    }

    /// The cell of the answer.
    pub fn answer(&self) -> Cell {
        let mode = self.mode();
        self.strip().cells.into_iter().nth(mode.headline()).unwrap_or_default()
    }

    /// The rows of the table.
    pub fn table(&self) -> Vec<Row> {
        report::mode_rows(self.mode(), &self.shown())
    }

    /// What was solved for, with what its σ comes from; as it was, while an input cannot be used.
    pub fn solved_with_sources(&self) -> Option<Solved> {
        let unit = self.unit();
        Solved::unknown(self.session.assessment(), unit).or_else(|| Solved::unknown(self.session.last(), unit))
    }

    /// The distance along the floor, with what its σ comes from.
    pub fn ground_with_sources(&self) -> Option<Solved> {
        let ground = self.session.answered().geometry.ground.as_ref()?;
        let Measured { value, sigma } = ground.distance;
        let unit = Style::WINDOW.unit_of(value, self.unit());
        let mut sources: Vec<Source> = ground
            .distance_shares
            .iter()
            .filter(|(_, share)| *share > 0.0)
            .map(|&(term, share)| Source::new(key_of(term), share))
            .collect();
        sources.sort_by(|a, b| b.share.total_cmp(&a.share));
        (sigma.m() > 0.0).then(|| Solved {
            name: "Distance along the floor".to_owned(),
            quantity: Quantity::distance(unit.symbol()),
            unit: Unit::Length(unit),
            value: value.in_unit(unit),
            sigma: sigma.in_unit(unit),
            method: None,
            sources,
        })
    }

    /// The angle between both lines of sight as it is written, where the disparity is solved for.
    pub fn angle_between_rays(&self) -> Option<String> {
        report::angle_between_rays(self.session.answered())
    }
}

/// The field of a term of the ground plane.
const fn key_of(term: Term) -> Key {
    match term {
        Term::CameraHeight => fields::CAMERA_HEIGHT,
        Term::Pitch => fields::CAMERA_PITCH,
        Term::BelowAxis => fields::FLOOR_ANGLE,
        Term::Input(_) => fields::FOCAL_LENGTH,
        _ => fields::FLOOR_ROW,
    }
}
