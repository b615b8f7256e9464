//! What the top view shows, in meters, and what is written into it.

use depth_core::measured::Measured;
use depth_core::problem::{Method, Solution};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::setup::Object;
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::style::Style;
use depth_text::{fields, report};

/// The scene in meters: X to the right, Z away from the cameras, the middle of the cameras at the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The stereo distance.
    pub stereo: Option<Sight>,
    /// The monocular distance.
    pub monocular: Option<Sight>,
    /// How far the cameras of the stereo distance are apart, and how that is written.
    pub baseline: Option<(f64, String)>,
    /// How wide the object is as it shows to the cameras, where that is known, and how that is written.
    pub width: Option<(f64, String)>,
    /// Whether the object is turned, so that only w_real · cos φ of its width shows.
    pub is_turned: bool,
    /// Whether the object is known to stand beside the optical axis, on which it is drawn.
    pub is_aside: bool,
    /// Where distances are counted from, m in front of the lens.
    pub zero_m: f64,
    /// Whether it is seen from the side, as the cameras stand one above the other, or a height is measured.
    pub is_from_side: bool,
    /// The unit of the axes.
    pub unit: LengthUnit,
    /// The angle between both lines of sight as it is written, where that is to be shown: "(4.091 ± 0.036)°".
    pub angle: Option<String>,
}

/// A distance in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    /// From the lens, m.
    pub depth_m: f64,
    /// σ along Z, m; 0 where it is not known.
    pub sigma_m: f64,
    /// σ across, m; 0 where it is not known.
    pub across_m: f64,
    /// The distance as it is written.
    pub text: String,
    /// Whether it was given, and something else solved for.
    pub is_given: bool,
    /// Whether it holds no longer, as an input of it cannot be read.
    pub is_stale: bool,
}

/// What the scene is made from.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// What was typed.
    pub now: &'a Assessment,
    /// What was last valid: a distance that is refused now is taken from there, in gray.
    pub before: Option<&'a Assessment>,
    /// The unit of the results.
    pub unit: LengthUnit,
    /// The angle between the rays as it is written, where it is to be shown.
    pub angle: Option<&'a str>,
}

impl Model {
    /// The scene; `None` while there is no distance, or none that can be drawn.
    pub fn new(source: Source<'_>) -> Option<Self> {
        let of = |method: Method| {
            let sight = |assessment, is_stale| Sight::new(assessment, method, source.unit, is_stale).map(|sight| (assessment, sight));
            let was_refused = source.now.refusal(method).is_some();
            let before = source.before.filter(|_| was_refused);
            sight(source.now, false).or_else(|| sight(before?, true))
        };
        let (stereo, monocular) = (of(Method::Stereo), of(Method::Monocular));
        let (main, main_method) = match (&stereo, &monocular) {
            (Some((assessment, _)), _) => (*assessment, Method::Stereo),
            (None, Some((assessment, _))) => (*assessment, Method::Monocular),
            (None, None) => return None,
        };
        let problem = &main.solution.problem;
        let is_from_side = problem.needs_fy(main_method);
        let of_object = monocular.as_ref().map_or(main, |(assessment, _)| assessment);
        let baseline = stereo.as_ref().and_then(|(assessment, _)| {
            let meters = assessment.solution.problem.baseline?.value.m();
            Some((meters, written(assessment, fields::BASELINE, meters, source.unit)))
        });
        let shown = shown_width(&of_object.solution, is_from_side);
        let is_turned = shown.is_some_and(|(shown, real)| shown.value.m() < real.m() * (1.0 - 1e-6));
        let width = shown.map(|(shown, real)| {
            let text = if is_turned {
                Style::WINDOW.length_like(shown.value, shown, source.unit)
            } else {
                written(of_object, fields::REAL_WIDTH, real.m(), source.unit)
            };
            (shown.value.m(), text)
        });
        let [stereo, monocular] = [stereo, monocular].map(|found| found.map(|(_, sight)| sight));
        let deepest = [&stereo, &monocular]
            .into_iter()
            .flatten()
            .map(|sight| sight.depth_m)
            .fold(0.0, f64::max);
        let model = Self {
            zero_m: problem.zero.map_or(0.0, Length::m),
            unit: Style::WINDOW.unit_of(Length::from_m(deepest), source.unit),
            angle: source.angle.map(str::to_owned),
            stereo,
            monocular,
            baseline,
            width,
            is_turned,
            is_aside: source.now.geometry.point.is_some(),
            is_from_side,
        };
        model.is_drawable().then_some(model)
    }

    /// The larger of both distances from the lens, m.
    pub(super) fn deepest(&self) -> f64 {
        self.sights().map(|sight| sight.depth_m).fold(0.0, f64::max)
    }

    /// Both distances, where they are there.
    pub(super) fn sights(&self) -> impl Iterator<Item = &Sight> {
        [&self.stereo, &self.monocular].into_iter().flatten()
    }

    /// Pictures are of single precision, so lengths beyond its range are not drawn.
    fn is_drawable(&self) -> bool {
        let lengths = [&self.baseline, &self.width].into_iter().flatten().map(|(meters, _)| *meters);
        let depths = self.sights().map(|sight| sight.depth_m);
        lengths.chain(depths).all(|length| (1e-12..1e12).contains(&length))
    }
}

impl Sight {
    fn new(assessment: &Assessment, method: Method, unit: LengthUnit, is_stale: bool) -> Option<Self> {
        let solution = &assessment.solution;
        let distance = solution.outcome(method).distance()?;
        let zero_m = solution.problem.zero.map_or(0.0, Length::m);
        let given = assessment.unknown.as_ref().filter(|unknown| unknown.method == method);
        let given = given.and_then(|unknown| unknown.distance);
        let known = solution.uncertainty(method);
        let sigma_m = given.map_or_else(|| known.map_or(0.0, |known| known.sigma.m()), |given| given.sigma.m());
        let baseline = solution.problem.baseline.filter(|_| method == Method::Stereo);
        // The middle of both columns is known twice as well as their difference, d, and seen under the same scale: b/2 · σ_d/d.
        let across_m = known.zip(baseline).map_or(0.0, |(known, baseline)| {
            baseline.value.m() / 2.0 * known.model.relative_divisor_sigma()
        });
        let typed = assessment.reading(fields::DISTANCE).filter(|_| given.is_some());
        Some(Self {
            depth_m: distance.m() + zero_m,
            sigma_m,
            across_m,
            text: typed.map_or_else(
                || Style::WINDOW.length_like(distance, Measured::new(distance, Length::from_m(sigma_m)), unit),
                |reading| Style::WINDOW.typed(reading),
            ),
            is_given: given.is_some(),
            is_stale,
        })
    }
}

/// How wide the object shows itself to be and how wide it is, where that lies in the plane of the picture.
fn shown_width(solution: &Solution, is_from_side: bool) -> Option<(Measured<Length>, Length)> {
    let problem = &solution.problem;
    let is_in_plane = problem.object == Object::Ball || (problem.object == Object::Height) == is_from_side;
    let shown = problem.foreshortened_width().filter(|_| is_in_plane)?;
    Some((shown, problem.real_width?.value))
}

/// What was typed as it was typed, and what was computed in the unit of the results.
fn written(assessment: &Assessment, key: Key, meters: f64, unit: LengthUnit) -> String {
    let reading = assessment.reading(key).filter(|_| !assessment.is_solved_for(key));
    reading.map_or_else(
        || report::length(Some(Length::from_m(meters)), unit),
        |reading| Style::WINDOW.typed(reading),
    )
}
