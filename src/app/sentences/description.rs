//! What a picture shows, in words, for whoever does not see it.

use super::hint::{Hint, grouped};
use crate::core::monte_carlo::Histogram;
use crate::core::problem::{Method, Origin, Solution};
use crate::core::quantity::{Length, LengthUnit, Pixels};
use depth_text::names::Named as _;
use depth_text::sentences::percent;
use depth_text::style::Style;
use depth_text::{number, report};
use std::fmt::{self, Display, Formatter};

/// The description of a picture, with the numbers in it.
#[derive(Clone, Copy, Debug)]
pub enum Description<'a> {
    /// What the letters mean.
    Letters,
    /// What an answer gains when one input is known exactly: a name and what is left of σ each.
    Gains { rows: &'a [(String, String)] },
    /// The curve of the disparity against the distance.
    InverseCurve { point: Option<(&'a str, &'a str)> },
    /// The camera and the ray from the side: how far ahead, how far to the right, and along the floor.
    SideView { ahead: &'a str, along: &'a str },
    /// The point in the image, below the horizon.
    InImage,
    /// The floor from above.
    Floor { ahead: &'a str, right: &'a str },
    /// The bars of both distances.
    Bars { solution: &'a Solution, unit: LengthUnit },
    /// The curve of distance against disparity, with the current point where there is one.
    Curve { point: Option<(Pixels, Length)>, unit: LengthUnit },
    /// The scene from above.
    TopView(TopView<'a>),
    /// The bar of the shares of the variance.
    Budget { shares: &'a str },
    /// The histogram of so many simulated distances.
    Histogram {
        histogram: &'a Histogram,
        draws: u32,
        unit: LengthUnit,
    },
}

/// What the top view shows. `baseline` is absent for one camera, `width` where that of the object is not known, and the far end of
/// `interval` where it is infinitely far away.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
pub struct TopView<'a> {
    pub baseline: Option<&'a str>,
    pub distance: &'a str,
    /// Which of two distances that is.
    pub origin: Option<Origin>,
    pub interval: Option<(Length, Option<Length>)>,
    pub width: Option<&'a str>,
    pub unit: LengthUnit,
    /// Whether it is seen from the side.
    pub is_from_side: bool,
}

impl Display for Description<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let length = |length, unit| report::length(Some(length), unit);
        match *self {
            Self::Letters => f.write_str(
                "Two cameras a baseline b apart look at a box that is w_real wide, at the distance D. In their images, which lie the focal \
                 length f_x from the lens, the box is w_img wide, and shifted by the disparity d. Stereo: D = fx · b / d. Monocular: \
                 D = w_real · fx / w_img.",
            ),
            Self::Gains { rows } => {
                f.write_str("What is left of the uncertainty")?;
                for (name, left) in rows {
                    write!(f, "; {name}: {left}")?;
                }
                f.write_str(".")
            }
            Self::InverseCurve { point } => {
                f.write_str("Curve of disparity against distance, falling as one over the distance.")?;
                match point {
                    Some((distance, disparity)) => write!(f, " At {distance} the disparity is {disparity}."),
                    None => Ok(()),
                }
            }
            Self::SideView { ahead, along } => write!(
                f,
                "The camera from the side: its ray meets the floor {ahead} straight ahead, {along} away along the floor."
            ),
            Self::InImage => f.write_str("The image, with the horizon, the principal point and the point that is measured."),
            Self::Floor { ahead, right } => write!(f, "The floor from above: the point is {ahead} ahead and {right} to the right."),
            Self::Bars { solution, unit } => {
                let bars: Vec<String> = Method::ALL.iter().filter_map(|&method| bar(solution, method, unit)).collect();
                write!(f, "Bar chart. {}.", bars.join(", "))
            }
            Self::Curve { point, unit } => {
                f.write_str("Curve of distance against disparity, falling as one over the disparity.")?;
                match point {
                    Some((disparity, distance)) => write!(
                        f,
                        " At {} px the distance is {}.",
                        number::plain(disparity.px()),
                        length(distance, unit)
                    ),
                    None => f.write_str(" Enter a disparity to see its point."),
                }
            }
            Self::TopView(view) => view.fmt(f),
            Self::Budget { shares } => write!(f, "Shares of the variance: {shares}."),
            Self::Histogram { histogram, draws, unit } => write!(
                f,
                "Histogram of {} simulated distances from {} to {}, {} of the draws beyond.",
                grouped(draws),
                length(histogram.low, unit),
                length(histogram.high, unit),
                percent(f64::from(histogram.beyond) / f64::from(draws.max(1)))
            ),
        }
    }
}

impl Display for TopView<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self {
            baseline,
            distance,
            origin,
            interval,
            width,
            unit,
            is_from_side,
        } = *self;
        let length = |length, unit| report::length(Some(length), unit);
        match baseline {
            Some(baseline) => write!(f, "Two cameras {baseline} apart")?,
            None => f.write_str("One camera")?,
        }
        write!(f, "; the object {distance} away")?;
        match origin {
            Some(Origin::Combined) => f.write_str(" by both methods combined")?,
            Some(Origin::Method(method)) => write!(f, " by {}", method.name().to_ascii_lowercase())?,
            None => {}
        }
        match interval {
            Some((near, Some(far))) => write!(f, ", between {} and {}", length(near, unit), length(far, unit))?,
            Some((near, None)) => write!(f, ", {} or more", length(near, unit))?,
            None => {}
        }
        if let Some(width) = width {
            write!(f, ", {width} wide")?;
        }
        let place = match baseline {
            _ if is_from_side => Hint::FromTheSide,
            Some(_) => Hint::ObjectMidway,
            None => Hint::ObjectAhead,
        };
        write!(f, ". {place}")
    }
}

/// "Stereo distance 1.400 ± 0.031 m, from 1.369 … 1.432 m"
fn bar(solution: &Solution, method: Method, unit: LengthUnit) -> Option<String> {
    let distance = solution.outcome(method).distance()?;
    let words = match solution.uncertainty(method) {
        Some(uncertainty) => format!(
            "{}, from {}",
            Style::WINDOW.distance(solution, method, unit),
            report::interval(uncertainty, unit)
        ),
        None => report::length(Some(distance), unit),
    };
    Some(format!("{} distance {words}", method.name()))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{Description, TopView};
    use crate::app::sentences::snapshot::{assert_said, every};
    use crate::core::monte_carlo::Histogram;
    use crate::core::problem::{Field, Origin, Problem};
    use crate::core::quantity::{Length, LengthUnit, Pixels};

    #[test]
    fn every_picture_is_described_as_it_was_written() {
        let mut mug = Problem::default();
        mug.set(Field::FocalLength, Some(700.0));
        mug.set(Field::Baseline, Some(0.1));
        mug.set(Field::Disparity, Some(50.0));
        mug.set_sigma(Field::Disparity, 1.0);
        mug.set_sigma(Field::FocalLength, 7.0);
        let solution = mug.solve();
        let unit = LengthUnit::Meter;
        let meters = Length::from_m;
        let histogram = Histogram {
            low: meters(1.3),
            high: meters(1.5),
            counts: vec![40, 55],
            below: 2,
            beyond: 3,
        };
        let gains = [("All as typed".to_owned(), "± 0.46 px".to_owned())];
        let mut descriptions = every![Description<'_>;
            Description::Letters => Description::Letters,
            Description::Gains { .. } => Description::Gains { rows: &gains },
            Description::InverseCurve { .. } => Description::InverseCurve { point: Some(("1.40 m", "50.00 px")) },
            Description::SideView { .. } => Description::SideView { ahead: "3.08 m", along: "3.74 m" },
            Description::InImage => Description::InImage,
            Description::Floor { .. } => Description::Floor { ahead: "3.08 m", right: "2.13 m" },
            Description::Bars { .. } => Description::Bars { solution: &solution, unit },
            Description::Curve { .. } => Description::Curve { point: Some((Pixels::new(50.0), meters(1.4))), unit },
            Description::TopView(_) => Description::TopView(TopView {
                baseline: Some("10 cm"),
                distance: "1.400 m",
                origin: Some(Origin::Combined),
                interval: Some((meters(1.373), Some(meters(1.429)))),
                width: None,
                unit,
                is_from_side: false,
            }),
            Description::Budget { .. } => Description::Budget { shares: "disparity 75 %, baseline 25 %" },
            Description::Histogram { .. } => Description::Histogram { histogram: &histogram, draws: 100, unit },
        ];
        descriptions.extend([
            Description::Curve { point: None, unit },
            Description::TopView(TopView {
                baseline: None,
                distance: "4.275 m",
                origin: None,
                interval: Some((meters(4.1), None)),
                width: Some("0.9 m"),
                unit,
                is_from_side: true,
            }),
        ]);
        assert_said("descriptions", &descriptions);
    }
}
