//! The focal lengths in pixels that facts of a camera state, and all the others from these.

use super::facts::{CameraAnswer, CameraFacts, CameraProblem, CameraRemark, Cause, Fact};
use super::film::{FilmExtent, focal_length_under_water, focused_image_distance, focused_lens};
use super::focal_length::{diagonal, focal_length_from_multiple, focal_length_from_pixel_pitch};
use super::projection::Projection;
use super::sensor::{Side, TOLERANCE};
use crate::angle::Angle;
use crate::judge;
use crate::quantity::{Length, Pixels};

/// What explains a contradiction fits better than by chance.
const FITS: f64 = 0.005;
/// So far from square may pixels be: anamorphic images are farther.
const SQUARE: f64 = 0.1;
/// In degrees. Wider lenses distort on purpose.
const MOST_OF_A_PINHOLE: f64 = 100.0;

/// A fact as a focal length.
#[derive(Clone, Copy)]
struct Said {
    at: usize,
    fact: Fact,
    focal_length: Pixels,
}

impl Fact {
    /// The view, and the part of the image that it is over; `None` of what is no view.
    fn view(self, [width, height]: [Pixels; 2]) -> Option<(Angle, Pixels)> {
        match self {
            Self::HorizontalView(view) => Some((view, width)),
            Self::VerticalView(view) => Some((view, height)),
            Self::DiagonalView(view) => Some((view, diagonal(width, height))),
            _ => None,
        }
    }

    const fn is_lens(self) -> bool {
        matches!(self, Self::Lens(_))
    }

    /// Whether it says fy and nothing else.
    const fn is_of_fy(self) -> bool {
        matches!(self, Self::Fy(_) | Self::P11(_))
    }

    /// Whether it says a focal length in pixels without a detour.
    const fn is_direct(self) -> bool {
        matches!(self, Self::Fx(_) | Self::Fy(_) | Self::P00(_) | Self::P11(_))
    }
}

impl CameraFacts {
    /// All that follows from what is stated.
    ///
    /// Where facts exclude one another, the first is followed, with a [`CameraRemark::Contradiction`]; of facts that agree the one that says
    /// it most directly is. fy is fx unless something says it.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    /// use depth_core::camera::{CameraFacts, Fact, Projection, Sensor};
    /// use depth_core::quantity::Pixels;
    ///
    /// // A webcam with a diagonal view of 78°.
    /// let webcam = CameraFacts {
    ///     size: [Pixels::new(1920.0), Pixels::new(1080.0)],
    ///     facts: vec![Fact::DiagonalView(Angle::from_degrees(78.0))],
    ///     sensor: Sensor::default(),
    ///     focused_at: None,
    ///     projection: Projection::Pinhole,
    ///     is_under_water: false,
    /// };
    /// assert!((webcam.solve().unwrap().fx.px() - 1360.2).abs() < 0.05);
    /// ```
    ///
    /// # Errors
    /// A [`CameraProblem`].
    pub fn solve(&self) -> Result<CameraAnswer, CameraProblem> {
        let (pitch, of_sensor) = self.sensor.pitch(self.size).map_err(|_| CameraProblem::ShortDiagonal)?;
        let mut remarks: Vec<CameraRemark> = of_sensor.into_iter().map(CameraRemark::Sensor).collect();
        // Where something else says the focal length, a lens without the size of a pixel says that size.
        let says_pitch = |fact: Fact| pitch.is_none() && matches!(fact, Fact::Lens(_)) && self.facts.iter().any(|other| !other.is_lens());
        let said = (0..)
            .zip(&self.facts)
            .filter(|(_, fact)| !says_pitch(**fact))
            .map(|(at, &fact)| {
                let focal_length = self.focal_length((at, fact), pitch)?;
                Ok(Said { at, fact, focal_length })
            })
            .collect::<Result<Vec<Said>, CameraProblem>>()?;
        let [fx, fy] = followed(&said, &mut remarks).ok_or(CameraProblem::NothingStated)?;
        for remark in &mut remarks {
            if let CameraRemark::Contradiction { facts, cause, .. } = remark {
                *cause = self.cause(facts, pitch);
            }
        }
        remarks.extend(self.whole(&said));
        let pitch = match self.facts.iter().copied().find(|fact| says_pitch(*fact)) {
            Some(Fact::Lens(lens)) => Some(Length::from_m(self.image_distance(lens)?.m() / fx.px())),
            _ => pitch,
        };
        remarks.extend(self.wide());
        let lens = pitch.map(|pitch| Length::from_m(fx.px() * pitch.m()));
        let lens = lens.and_then(|image| self.focused_at.map_or(Some(image), |distance| focused_lens(image, distance)));
        let [width, height] = self.size;
        let is_pinhole = self.projection == Projection::Pinhole;
        // Of the lens, not of where its image is sharp.
        let far = lens
            .zip(pitch)
            .filter(|_| self.focused_at.is_some())
            .map_or(fx, |(lens, pitch)| Pixels::new(lens.m() / pitch.m()));
        let film = [FilmExtent::Diagonal, FilmExtent::Width].map(|extent| extent.equivalent(far, self.size).filter(|_| is_pinhole));
        let [fx, fy] = if self.is_under_water {
            remarks.push(CameraRemark::UnderWater);
            [fx, fy].map(|f| focal_length_under_water(f).unwrap_or(f))
        } else {
            [fx, fy]
        };
        let views = self.views([fx, fy]);
        if let Some(view) = views.last().copied().flatten().filter(|view| is_pinhole && !is_of_camera(*view)) {
            remarks.push(CameraRemark::View(view));
        }
        Ok(CameraAnswer {
            fx,
            fy,
            pitch,
            lens: lens.filter(|lens| judge::positive(lens.m()).is_ok()),
            views,
            film,
            sensor: [width, height, diagonal(width, height)].map(|side| Some(Length::from_m(pitch?.m() * side.px()))),
            multiples: [2.0 * fx.px() / width.px(), 2.0 * fy.px() / height.px()],
            remarks,
        })
    }

    /// How far behind the lens the image is sharp.
    fn image_distance(&self, lens: Length) -> Result<Length, CameraProblem> {
        match self.focused_at {
            None => Ok(lens),
            Some(distance) => focused_image_distance(lens, distance).ok_or(CameraProblem::FocusTooNear),
        }
    }

    /// What the fact at a place says.
    fn focal_length(&self, (at, fact): (usize, Fact), pitch: Option<Length>) -> Result<Pixels, CameraProblem> {
        let [width, height] = self.size;
        if let Some((view, extent)) = fact.view(self.size) {
            return self.projection.focal_length(view, extent).ok_or(CameraProblem::NoSuchView(at));
        }
        let focal_length = match fact {
            Fact::Fx(f) | Fact::Fy(f) => judge::positive(f.px()).ok().map(Pixels::new),
            Fact::P00(p00) => focal_length_from_multiple(p00 / 2.0, width),
            Fact::P11(p11) => focal_length_from_multiple(p11 / 2.0, height),
            Fact::Film(extent, equivalent) => extent.focal_length(equivalent, self.size),
            Fact::Lens(lens) => {
                let pitch = pitch.ok_or(CameraProblem::NoPitch(at))?;
                focal_length_from_pixel_pitch(self.image_distance(lens)?, pitch)
            }
            Fact::HorizontalView(_) | Fact::VerticalView(_) | Fact::DiagonalView(_) => None,
        };
        focal_length.ok_or(CameraProblem::NoFocalLength(at))
    }

    /// What would make the facts at these places agree.
    fn cause(&self, said: &[(usize, Pixels)], pitch: Option<Length>) -> Option<Cause> {
        let facts: Vec<(usize, Fact)> = said.iter().filter_map(|(at, _)| Some((*at, *self.facts.get(*at)?))).collect();
        if facts.iter().all(|(_, fact)| matches!(fact, Fact::Film(..))) {
            return Some(Cause::Film);
        }
        let agrees = |projection: Projection| {
            let other = Self {
                projection,
                ..self.clone()
            };
            let all: Option<Vec<Pixels>> = facts.iter().map(|fact| other.focal_length(*fact, pitch).ok()).collect();
            all.is_some_and(|all| all.iter().all(|one| all.first().is_some_and(|first| is_within(*one, *first, FITS))))
        };
        let is_wide = |(_, fact): &(usize, Fact)| fact.view(self.size).is_some_and(|(view, _)| view.degrees() > MOST_OF_A_PINHOLE);
        let may_be_fisheye = self.projection == Projection::Pinhole && facts.iter().any(is_wide);
        let mut fisheyes = Projection::ALL.into_iter().filter(|one| *one != Projection::Pinhole);
        if let Some(projection) = fisheyes.find(|one| may_be_fisheye && agrees(*one)) {
            return Some(Cause::Fisheye(projection));
        }
        let (_, first) = said.first()?;
        let [width, height] = self.size;
        facts.iter().find_map(|(at, fact)| {
            let (view, side, now) = match fact {
                Fact::HorizontalView(view) => (view, Side::Width, width),
                Fact::VerticalView(view) => (view, Side::Height, height),
                _ => return None,
            };
            let before = Pixels::new(2.0 * first.px() * (view.radians() / 2.0).tan());
            let is_cut =
                self.projection == Projection::Pinhole && before.px() > now.px() * (1.0 + TOLERANCE) && before.px() < now.px() * 4.0;
            is_cut.then_some(Cause::Cut {
                at: *at,
                side,
                before,
                now,
            })
        })
    }

    /// That a diagonal is that of the whole picture, where this image has a shape that is often cut: an equivalent for 35 mm film is of the
    /// 4:3 of phones, a webcam's diagonal view of its 16:9.
    fn whole(&self, said: &[Said]) -> Option<CameraRemark> {
        let [long, short] = {
            let [width, height] = self.size.map(Pixels::px);
            [width.max(height), width.min(height)]
        };
        let (only, others) = said.split_first()?;
        let (shape, whole) = match only.fact {
            Fact::Film(FilmExtent::Diagonal, _) if long / short > 1.6 => ([4, 3], [long, long * 0.75]),
            Fact::DiagonalView(_) if long / short < 1.4 => ([16, 9], [short * 16.0 / 9.0, short]),
            _ => return None,
        };
        let other = Self {
            size: whole.map(Pixels::new),
            ..self.clone()
        };
        let focal_length = other.focal_length((only.at, only.fact), None).ok()?;
        others.is_empty().then_some(CameraRemark::Whole {
            at: only.at,
            shape,
            focal_length,
        })
    }

    /// What is seen across the image, down, and from corner to corner.
    fn views(&self, [fx, fy]: [Pixels; 2]) -> [Option<Angle>; 3] {
        let [width, height] = self.size;
        let [across, down] = [width.px() / fx.px(), height.px() / fy.px()];
        // In focal lengths.
        [across, down, across.hypot(down)].map(|extent| self.projection.view(Pixels::new(1.0), Pixels::new(extent)))
    }

    /// That the widest view is hardly a pinhole's.
    fn wide(&self) -> Option<CameraRemark> {
        let views = self.facts.iter().filter_map(|fact| fact.view(self.size));
        let (view, extent) = views.max_by(|(one, _), (other, _)| one.radians().total_cmp(&other.radians()))?;
        if self.projection != Projection::Pinhole || view.degrees() <= MOST_OF_A_PINHOLE {
            return None;
        }
        let fisheyes = Projection::ALL.into_iter().filter(|projection| *projection != Projection::Pinhole);
        let as_fisheye = fisheyes
            .filter_map(|projection| Some((projection, projection.focal_length(view, extent)?)))
            .collect();
        Some(CameraRemark::Wide { view, as_fisheye })
    }
}

/// fx and fy of what was said, and where it excludes itself.
fn followed(said: &[Said], remarks: &mut Vec<CameraRemark>) -> Option<[Pixels; 2]> {
    let is_vertical = |one: &&Said| matches!(one.fact, Fact::VerticalView(_));
    let has_own = said.iter().any(|one| one.fact.is_of_fy());
    let has_others = said.iter().any(|one| !one.fact.is_of_fy() && !is_vertical(&one));
    // With square pixels a vertical view says fx too.
    let is_of_fy = |one: &Said| one.fact.is_of_fy() || has_own && is_vertical(&one);
    let (of_fy, of_fx): (Vec<Said>, Vec<Said>) = said.iter().copied().partition(is_of_fy);
    let fy = first(&of_fy, true, remarks);
    let fx = first(&of_fx, false, remarks).or(fy)?;
    // A vertical view beside other facts that it agrees with is fy.
    let view = said.iter().find(is_vertical).map(|one| one.focal_length);
    let view = view.filter(|view| has_others && is_within(*view, fx, TOLERANCE));
    let fy = fy.or(view).unwrap_or(fx);
    if !is_within(fy, fx, SQUARE) {
        remarks.push(CameraRemark::NotSquare { fx, fy });
    }
    Some([fx, fy])
}

/// The first of several that exclude one another, else the one that says it most directly.
fn first(said: &[Said], is_of_fy: bool, remarks: &mut Vec<CameraRemark>) -> Option<Pixels> {
    let first = said.first()?;
    if said.iter().any(|one| !is_within(one.focal_length, first.focal_length, TOLERANCE)) {
        remarks.push(CameraRemark::Contradiction {
            is_of_fy,
            facts: said.iter().map(|one| (one.at, one.focal_length)).collect(),
            cause: None,
        });
        return Some(first.focal_length);
    }
    let direct = said.iter().find(|one| one.fact.is_direct());
    Some(direct.unwrap_or(first).focal_length)
}

/// Whether a camera may have such a diagonal view: of telescopes those of a degree, of lenses without distortion those of 150°.
fn is_of_camera(view: Angle) -> bool {
    (0.2..=160.0).contains(&view.degrees())
}

fn is_within(one: Pixels, other: Pixels, tolerance: f64) -> bool {
    (one.px() / other.px() - 1.0).abs() <= tolerance
}
