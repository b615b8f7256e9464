//! Another mode of the sensor of a rig: its image resized or binned, then cropped.

use super::rig::{Rig, number};
use crate::core::camera::Intrinsics;
use crate::core::quantity::Pixels;
use depth_text::entry::{Entries, Entry};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::note::{Issue, Note};
use depth_text::reading::{self, Reading};

/// What is asked for.
pub const KEYS: [Key; 5] = [
    fields::MODE_WIDTH,
    fields::CROP_WIDTH,
    fields::CROP_HEIGHT,
    fields::CROP_LEFT,
    fields::CROP_TOP,
];

/// What became of a rig.
#[derive(Debug)]
pub struct OtherMode {
    /// What could be read of the fields.
    pub readings: Vec<Reading>,
    /// What is wrong with a field.
    pub notes: Vec<Note>,
    /// The rig in that mode, or why there is none.
    pub rig: Result<Rig, ModeProblem>,
}

/// Why there is no rig in another mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeProblem {
    /// The rig lacks the size of its image, or fx.
    NoCamera,
    /// A field of the rig cannot be read.
    Unreadable,
    /// Something is wrong with a field.
    SeeNotes,
    /// Nothing was asked for.
    Nothing,
    /// The part that is kept is not inside the image.
    Outside,
}

impl ModeProblem {
    /// What to do about it.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::NoCamera => "Fill in the width and the height of the image and fx of the rig first.",
            Self::Unreadable => "A number of the rig cannot be read: correct it there first.",
            Self::SeeNotes => "",
            Self::Nothing => "Type the width after resizing, or the size of the part that is kept, or both.",
            Self::Outside => {
                "The part that is kept reaches out of the resized image. Make it smaller, or begin farther to the left and at the top. If the mode comes from more rows than this image has, put the size of the whole sensor into the rig first."
            }
        }
    }
}

/// `rig` in the mode that `entries` ask for: first resized to the width, then cropped, in the middle where no corner is given.
pub fn other_mode(rig: &Rig, entries: &Entries) -> OtherMode {
    let (mut readings, mut notes) = (Vec::<Reading>::new(), Vec::new());
    for key in KEYS {
        let may_be_zero = [fields::CROP_LEFT, fields::CROP_TOP].contains(&key);
        match reading::read_positive(key, entries.entry(key)) {
            Err(note) if may_be_zero && note.issue == (Issue::Zero { key }) => {
                readings.extend(reading::read(key, entries.entry(key)).ok().flatten());
            }
            Ok(reading) => readings.extend(reading),
            Err(note) => notes.push(note),
        }
    }
    let value = |key: Key| readings.iter().find(|reading| reading.key == key).map(|reading| reading.value);
    let asked = KEYS.map(|key| value(key).map(Pixels::new));
    let rig = match intrinsics(rig) {
        _ if !notes.is_empty() => Err(ModeProblem::SeeNotes),
        _ if Rig::KEYS
            .into_iter()
            .any(|key| reading::read_with_sigma(key, rig.inputs.entry(key)).is_err()) =>
        {
            Err(ModeProblem::Unreadable)
        }
        None => Err(ModeProblem::NoCamera),
        Some(_) if asked.iter().all(Option::is_none) => Err(ModeProblem::Nothing),
        Some(before) => changed(before, asked)
            .map(|after| of_other_mode(rig, before, after))
            .ok_or(ModeProblem::Outside),
    };
    OtherMode { readings, notes, rig }
}

/// The camera of a rig; its principal point is in the middle where it is not known.
fn intrinsics(rig: &Rig) -> Option<Intrinsics> {
    let read = |key: Key| Some(reading::read(key, rig.inputs.entry(key)).ok()??.value).filter(|value| value.is_finite());
    let positive = |key: Key| read(key).filter(|value| *value > 0.0).map(Pixels::new);
    let (width, height) = (positive(fields::FRAME_WIDTH)?, positive(fields::FRAME_HEIGHT)?);
    let fx = positive(fields::FOCAL_LENGTH)?;
    let middle = |side: Pixels| (side.px() - 1.0) / 2.0;
    Some(Intrinsics {
        fx,
        fy: positive(fields::FY).unwrap_or(fx),
        cx: Pixels::new(read(fields::CX).unwrap_or_else(|| middle(width))),
        cy: Pixels::new(read(fields::CY).unwrap_or_else(|| middle(height))),
        width,
        height,
    })
}

/// The camera after that; `None` where the part that is kept is not inside the image.
fn changed(before: Intrinsics, [after, width, height, left, top]: [Option<Pixels>; 5]) -> Option<Intrinsics> {
    let resized = match after {
        None => before,
        Some(after) => {
            let scale = after.px() / before.width.px();
            before.resized(after, Pixels::new((before.height.px() * scale).round()))?
        }
    };
    // In whole pixels, as every program crops.
    let begin =
        |given: Option<Pixels>, kept: Pixels, whole: Pixels| given.map_or_else(|| ((whole.px() - kept.px()) / 2.0).floor(), Pixels::px);
    let (width, height) = (width.unwrap_or(resized.width), height.unwrap_or(resized.height));
    let (left, top) = (begin(left, width, resized.width), begin(top, height, resized.height));
    let is_inside = left >= 0.0 && top >= 0.0 && left + width.px() <= resized.width.px() && top + height.px() <= resized.height.px();
    is_inside
        .then(|| resized.cropped(Pixels::new(left), Pixels::new(top), width, height))
        .flatten()
}

/// `rig` with `after` in place of `before`. doffs scales with the image; the baseline does not.
fn of_other_mode(rig: &Rig, before: Intrinsics, after: Intrinsics) -> Rig {
    let mut other = rig.clone();
    let scale = after.fx.px() / before.fx.px();
    let is_known = |key: Key| !rig.inputs.entry(key).is_blank();
    let mut fill = |key: Key, value: f64| {
        let sigma = reading::read_with_sigma(key, rig.inputs.entry(key)).ok().flatten();
        let sigma = sigma.and_then(|reading| reading.sigma).filter(|sigma| *sigma > 0.0);
        *other.inputs.entry_mut(key) = Entry {
            sigma: sigma.map(|sigma| number(sigma * scale)).unwrap_or_default(),
            ..Entry::new(number(value), None)
        };
    };
    fill(fields::FRAME_WIDTH, after.width.px());
    fill(fields::FRAME_HEIGHT, after.height.px());
    fill(fields::FOCAL_LENGTH, after.fx.px());
    for (key, value) in [(fields::FY, after.fy), (fields::CX, after.cx), (fields::CY, after.cy)] {
        if is_known(key) {
            fill(key, value.px());
        }
    }
    if let Ok(Some(doffs)) = reading::read(fields::DOFFS, rig.inputs.entry(fields::DOFFS)) {
        fill(fields::DOFFS, doffs.value * scale);
    }
    let size = format!("{} × {}", number(after.width.px()), number(after.height.px()));
    other.name = format!("{}, {size}", rig.shown_name());
    other
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{ModeProblem, Rig, other_mode};
    use depth_text::entry::{Entries, Entry};
    use depth_text::field::Key;
    use depth_text::fields;

    fn rig(numbers: &[(Key, &str)]) -> Rig {
        let mut rig = Rig {
            name: "Robot".to_owned(),
            ..Rig::default()
        };
        for (key, text) in numbers {
            *rig.inputs.entry_mut(*key) = Entry::new(*text, None);
        }
        rig
    }

    fn asked(numbers: &[(Key, &str)]) -> Entries {
        let mut entries = Entries::default();
        for (key, text) in numbers {
            *entries.entry_mut(*key) = Entry::new(*text, None);
        }
        entries
    }

    fn numbers<const N: usize>(rig: &Rig, keys: [Key; N]) -> [f64; N] {
        keys.map(|key| rig.inputs.entry(key).text.parse().unwrap())
    }

    /// The RealSense D435i at 640 × 480 is its whole sensor, 1280 × 800, scaled by 0.6 and cropped: 378.806 px, not half of 631.343
    /// (librealsense, unit tests).
    #[test]
    fn a_mode_that_is_scaled_and_cropped_is_not_half_of_the_other() {
        let full = rig(&[
            (fields::FRAME_WIDTH, "1280"),
            (fields::FRAME_HEIGHT, "800"),
            (fields::FOCAL_LENGTH, "631.343"),
            (fields::CX, "637.1"),
            (fields::CY, "399.5"),
            (fields::DOFFS, "10"),
            (fields::BASELINE, "49.864"),
        ]);
        let mode = asked(&[(fields::MODE_WIDTH, "768"), (fields::CROP_WIDTH, "640")]);
        let other = other_mode(&full, &mode).rig.unwrap();
        let [width, height, fx, cx, cy, doffs, baseline] = numbers(
            &other,
            [
                fields::FRAME_WIDTH,
                fields::FRAME_HEIGHT,
                fields::FOCAL_LENGTH,
                fields::CX,
                fields::CY,
                fields::DOFFS,
                fields::BASELINE,
            ],
        );
        assert_eq!([width, height, doffs, baseline], [640.0, 480.0, 6.0, 49.864]);
        assert!((fx - 378.806).abs() < 5e-4, "{fx}");
        // (637.1 + ½)·0.6 − ½ − 64 and (399.5 + ½)·0.6 − ½.
        assert!((cx - 318.06).abs() < 1e-9 && (cy - 239.5).abs() < 1e-9, "{cx} {cy}");
        assert_eq!(other.name, "Robot, 640 × 480");
    }

    #[test]
    fn cropping_changes_no_focal_length_and_sigma_is_scaled_with_its_value() {
        let mut full = rig(&[
            (fields::FRAME_WIDTH, "1280"),
            (fields::FRAME_HEIGHT, "720"),
            (fields::FOCAL_LENGTH, "700"),
        ]);
        full.inputs.entry_mut(fields::FOCAL_LENGTH).sigma = "2".to_owned();
        let cropped = other_mode(&full, &asked(&[(fields::CROP_WIDTH, "640"), (fields::CROP_LEFT, "0")]))
            .rig
            .unwrap();
        assert_eq!(numbers(&cropped, [fields::FOCAL_LENGTH]), [700.0]);
        let binned = other_mode(&full, &asked(&[(fields::MODE_WIDTH, "640")])).rig.unwrap();
        assert_eq!(numbers(&binned, [fields::FOCAL_LENGTH, fields::FRAME_HEIGHT]), [350.0, 360.0]);
        assert_eq!(binned.inputs.entry(fields::FOCAL_LENGTH).sigma, "1");
        assert!(binned.inputs.entry(fields::CX).is_blank(), "what was not known is not made up");
    }

    #[test]
    fn what_cannot_be_is_said() {
        let full = rig(&[
            (fields::FRAME_WIDTH, "1280"),
            (fields::FRAME_HEIGHT, "720"),
            (fields::FOCAL_LENGTH, "700"),
        ]);
        let problem = |rig: &Rig, numbers: &[(Key, &str)]| other_mode(rig, &asked(numbers)).rig.unwrap_err();
        assert_eq!(problem(&full, &[]), ModeProblem::Nothing);
        assert_eq!(problem(&full, &[(fields::CROP_WIDTH, "1281")]), ModeProblem::Outside);
        assert_eq!(
            problem(&full, &[(fields::CROP_WIDTH, "640"), (fields::CROP_LEFT, "641")]),
            ModeProblem::Outside
        );
        assert_eq!(problem(&full, &[(fields::MODE_WIDTH, "0")]), ModeProblem::SeeNotes);
        assert_eq!(problem(&full, &[(fields::CROP_TOP, "-1")]), ModeProblem::SeeNotes);
        assert_eq!(problem(&rig(&[(fields::FOCAL_LENGTH, "700")]), &[]), ModeProblem::NoCamera);
    }
}
