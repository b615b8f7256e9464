//! The table of all fields: a field added here is read, stored, linked, reported and, where it has an option, known to the
//! command line without another edit. Longer than a file should be, as a table is read from top to bottom.

use crate::field::{CommandOption, FieldSpec, Key, Kind, Section};
use depth_core::problem::Field;
use depth_core::quantity::LengthUnit;

/// Makes a [`Key`] of each row, and of all of them the [`TABLE`].
macro_rules! table {
    ($($(#[$doc:meta])* $name:ident = $spec:expr;)*) => {
        $($(#[$doc])* pub const $name: Key = Key::of(&$spec);)*

        /// Every field, those of the form first and in reading order.
        pub static TABLE: &[Key] = &[$($name),*];
    };
}

const BLANK: FieldSpec = FieldSpec::BLANK;

const INPUT: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    has_sigma: true,
    ..BLANK
};

const PIXELS: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    ..BLANK
};

const METERS: FieldSpec = FieldSpec {
    kind: Kind::Length(LengthUnit::Meter),
    ..BLANK
};

const POINT: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    section: Some(Section::Point),
    is_optional: true,
    ..BLANK
};

const GROUND: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    section: Some(Section::Ground),
    is_optional: true,
    ..BLANK
};

const SHOT: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    section: Some(Section::TwoShots),
    is_optional: true,
    has_sigma: true,
    ..BLANK
};

const OF_TWO: FieldSpec = FieldSpec {
    kind: Kind::Pixels,
    section: Some(Section::TwoPoints),
    is_optional: true,
    ..BLANK
};

const MILLIMETERS: FieldSpec = FieldSpec {
    kind: Kind::Length(LengthUnit::Millimeter),
    ..BLANK
};

const VIEW: FieldSpec = FieldSpec {
    kind: Kind::Angle,
    ..BLANK
};

/// An option of the command line: its name, and the help of it and of its σ. A page has no command line, and need not download
/// them.
const fn option(name: &'static str, help: &'static str, sigma_help: &'static str) -> Option<CommandOption> {
    if cfg!(target_arch = "wasm32") {
        return None;
    }
    Some(CommandOption { name, help, sigma_help })
}

table! {
    /// fx, px, or a length where d or w_img is one
    FOCAL_LENGTH = FieldSpec {
        key: "fx", kind: Kind::FocalLength, name: "Focal length (fx)", symbol: "fx", noun: "the focal length", examples: &["700"],
        hint: "Focal length of the camera in pixels.",
        description: "Camera’s focal length",
        input: Some(Field::FocalLength), section: Some(Section::Camera),
        option: option(
            "fx",
            "Focal length in pixels of the image that the other pixels are counted in",
            "1 σ of the focal length, such as 2 or 0.3%",
        ),
        ..INPUT
    };
    /// The lens that fx was computed from.
    FX_LENS = FieldSpec {
        key: "fx-lens", name: "Lens that fx came from", symbol: "f_lens", noun: "the lens", examples: &["15"],
        kind: Kind::Length(LengthUnit::Millimeter),
        hint: "Added to the distance. Empty where fx was calibrated.",
        input: Some(Field::Lens), section: Some(Section::Camera), is_optional: true,
        option: option(
            "lens",
            "Focal length of the lens that fx was computed from: it is added to the distance; bare: in mm. Not for a calibrated fx",
            "",
        ),
        ..BLANK
    };
    /// fy, px: fx where it is left out.
    FY = FieldSpec {
        key: "fy", kind: Kind::FocalLength, name: "Focal length along the columns (fy)", symbol: "fy", noun: "fy", examples: &["700"],
        hint: "Only if it differs from fx.",
        input: Some(Field::Fy), section: Some(Section::Camera), is_optional: true,
        option: option(
            "fy",
            "Focal length along the columns, for heights, vertical pairs and points; without it, fx",
            "1 σ of fy; without it, that of fx in proportion",
        ),
        has_sigma: true,
        ..BLANK
    };
    /// b, a length
    BASELINE = FieldSpec {
        key: "b", name: "Camera baseline (b)", symbol: "b", noun: "the baseline", examples: &["100"],
        kind: Kind::Length(LengthUnit::Millimeter),
        hint: "Distance between the two cameras.",
        description: "Distance between the two cameras",
        input: Some(Field::Baseline), section: Some(Section::Stereo),
        option: option("baseline", "Distance between the two cameras; bare: in mm", "1 σ of the baseline, such as 0.5mm or 0.5%"),
        ..INPUT
    };
    /// d, px, an angle or a length on the sensor
    DISPARITY = FieldSpec {
        key: "d", kind: Kind::Extent, name: "Disparity (d)", symbol: "d", noun: "the disparity", examples: &["50"],
        hint: "Horizontal shift between the two images.",
        description: "Horizontal pixel difference",
        input: Some(Field::Disparity), section: Some(Section::Stereo),
        option: option(
            "disparity",
            "Shift of the object between the rectified images, left x minus right x, in pixels; or as an angle, or a length on the sensor",
            "1 σ of the disparity, such as 0.25",
        ),
        ..INPUT
    };
    /// δ = cx_right − cx_left, px
    DOFFS = FieldSpec {
        key: "doffs", name: "Principal point offset (doffs)", symbol: "doffs", noun: "doffs", examples: &["0", "131.1"],
        hint: "cx right minus cx left; added to the disparity.",
        signed: true, is_optional: true,
        input: Some(Field::Doffs), section: Some(Section::Stereo),
        option: option("doffs", "cx of the right camera minus cx of the left one, added to the disparity; with --pair vertical, cy of the lower camera minus cy of the upper one", "1 σ of doffs"),
        ..INPUT
    };
    /// w_img, px, an angle or a length on the sensor
    IMAGE_WIDTH = FieldSpec {
        key: "wimg", kind: Kind::Extent, name: "Object width in image (w_img)", symbol: "w_img", noun: "the width in the image", examples: &["150"],
        hint: "Width of the object in the image.",
        description: "Object’s width in the image",
        input: Some(Field::ImageWidth), section: Some(Section::Monocular),
        option: option("w-img", "Width of the object in the image in pixels; or as an angle, or a length on the sensor", "1 σ of the width in the image"),
        ..INPUT
    };
    /// w_real, a length
    REAL_WIDTH = FieldSpec {
        key: "wreal", name: "Object real width (w_real)", symbol: "w_real", noun: "the real width", examples: &["0.30"],
        kind: Kind::Length(LengthUnit::Meter),
        hint: "Actual physical width of the object.",
        description: "Object’s actual physical width",
        input: Some(Field::RealWidth), section: Some(Section::Monocular),
        option: option("w-real", "Width of the object itself; bare: in m", "1 σ of the real width, such as 1cm or 3%"),
        ..INPUT
    };
    /// Column of the principal point.
    CX = FieldSpec {
        key: "cx", name: "Principal point cx", symbol: "cx", noun: "cx", examples: &["640"],
        option: option(
            "cx",
            "Column of the principal point, about half the width of the image",
            "",
        ),
        hint: "Not calibrated: about half of the width.",
        ..POINT
    };
    /// Row of the principal point.
    CY = FieldSpec {
        key: "cy", name: "Principal point cy", symbol: "cy", noun: "cy", examples: &["360"],
        option: option(
            "cy",
            "Row of the principal point, about half the height of the image",
            "",
        ),
        hint: "Not calibrated: about half of the height.",
        ..POINT
    };
    /// Column of the pixel whose range is wanted.
    PIXEL_COLUMN = FieldSpec {
        key: "u", name: "Column of the pixel (u)", symbol: "u", noun: "the column of the pixel", examples: &["900"],
        option: option(
            "u",
            "Column of the pixel, counted from the left",
            "",
        ),
        hint: "Counted from the left edge of the image.",
        ..POINT
    };
    /// Row of the pixel whose range is wanted.
    PIXEL_ROW = FieldSpec {
        key: "v", name: "Row of the pixel (v)", symbol: "v", noun: "the row of the pixel", examples: &["500"],
        option: option(
            "v",
            "Row of the pixel, counted from the top",
            "",
        ),
        hint: "Counted from the top edge of the image.",
        ..POINT
    };
    /// The range that a tape measures, where the depth is wanted.
    TAPED_RANGE = FieldSpec {
        key: "range", name: "Range by tape (R)", symbol: "R", noun: "the range", examples: &["1.62"],
        kind: Kind::Length(LengthUnit::Meter), has_sigma: true,
        hint: "Only to get the depth from it.",
        option: option(
            "range",
            "Range from the lens to what the pixel shows, by tape or laser, to get its depth; bare: in m",
            "1 σ of the range, such as 5mm or 1%",
        ),
        ..POINT
    };
    /// How far in front of the lens distances are counted from.
    ZERO = FieldSpec {
        key: "zero", name: "The tape starts in front of the lens", symbol: "zero", noun: "the zero point", examples: &["4.2"],
        kind: Kind::Length(LengthUnit::Millimeter), signed: true,
        hint: "From the entrance pupil to the front glass, say.",
        input: Some(Field::Zero), section: Some(Section::Point), is_optional: true,
        option: option(
            "zero",
            "How far in front of the lens distances are counted from, such as its front glass; bare: in mm",
            "",
        ),
        ..BLANK
    };
    /// How far the target is turned away.
    TILT = FieldSpec {
        key: "tilt", name: "Tilt of the target", symbol: "φ", noun: "the tilt", kind: Kind::Angle, examples: &["20"], signed: true,
        hint: "0° is facing the camera.",
        input: Some(Field::Tilt), section: Some(Section::Target), is_optional: true,
        option: option(
            "tilt",
            "Angle by which the object is turned away from facing the camera; bare: in degrees",
            "",
        ),
        ..BLANK
    };
    /// Height of the camera above the floor.
    CAMERA_HEIGHT = FieldSpec {
        key: "camera-height", name: "Height of the camera", symbol: "h", noun: "the height of the camera", examples: &["1.2"],
        kind: Kind::Length(LengthUnit::Meter), has_sigma: true,
        hint: "From the floor to the lens.",
        option: option(
            "height",
            "Height of the lens above the floor; bare: in m",
            "1 σ of the height, such as 5cm or 2%",
        ),
        ..GROUND
    };
    /// How far the optical axis points down.
    CAMERA_PITCH = FieldSpec {
        key: "camera-pitch", name: "Pitch of the camera, downwards", symbol: "θ", noun: "the pitch of the camera",
        kind: Kind::Angle, examples: &["10"], signed: true, has_sigma: true,
        hint: "0° is level, 90° straight down.",
        option: option(
            "pitch",
            "How far the camera looks down: 0 is level, 90 straight down; bare: in degrees",
            "1 σ of the pitch, such as 0.5",
        ),
        ..GROUND
    };
    /// Row at which the point on the floor is seen.
    FLOOR_ROW = FieldSpec {
        key: "floor-row", name: "Row of the point on the floor", symbol: "v", noun: "the row of the point", examples: &["500"],
        has_sigma: true,
        option: option(
            "row",
            "Row at which the point is seen",
            "1 σ of the row, such as 1",
        ),
        hint: "Where the point touches the floor, from the top edge.",
        ..GROUND
    };
    /// Column at which the point on the floor is seen.
    FLOOR_COLUMN = FieldSpec {
        key: "floor-column", name: "Column of the point on the floor", symbol: "u", noun: "the column of the point",
        examples: &["1100"],
        hint: "Only to get how far it is to the right; needs cx.",
        option: option(
            "u",
            "Column at which the point is seen, to get how far it is to the right",
            "",
        ),
        ..GROUND
    };
    /// Height of the target above the floor.
    TARGET_HEIGHT = FieldSpec {
        key: "target-height", name: "Height of the target", symbol: "h_target", noun: "the height of the target", examples: &["0"],
        kind: Kind::Length(LengthUnit::Meter), signed: true,
        hint: "0 is a point on the floor.",
        option: option(
            "target-height",
            "Height of the point above the floor, if it does not lie on it; bare: in m",
            "",
        ),
        ..GROUND
    };
    /// How far below the optical axis the point is seen, instead of its row.
    FLOOR_ANGLE = FieldSpec {
        key: "floor-angle", name: "Angle below the optical axis", symbol: "α", noun: "the angle below the axis",
        kind: Kind::Angle, examples: &["11.3"], signed: true,
        hint: "Instead of the row; needs no focal length.",
        option: option(
            "angle",
            "Angle of the point below the optical axis, instead of its row; bare: in degrees",
            "",
        ),
        ..GROUND
    };

    /// How wide the object is in the photograph from farther away.
    FAR_WIDTH = FieldSpec {
        key: "far-px", name: "Width in the first photograph", symbol: "w_1", noun: "the width in the first photograph",
        examples: &["1162"], hint: "From the first place, which is farther away.",
        option: option("far-px", "Width of the object in the photograph from farther away", "1 σ of that width, such as 1"),
        ..SHOT
    };
    /// How wide it is in the one from nearer.
    NEAR_WIDTH = FieldSpec {
        key: "near-px", name: "Width in the second photograph", symbol: "w_2", noun: "the width in the second photograph",
        examples: &["1429"], hint: "From the second place, a step nearer.",
        option: option("near-px", "Width of the object in the photograph from nearer", "1 σ of that width, such as 1"),
        ..SHOT
    };
    /// How far the camera was moved between both.
    STEP = FieldSpec {
        key: "step", name: "Step between them", symbol: "s", noun: "the step", examples: &["0.5"],
        kind: Kind::Length(LengthUnit::Meter), hint: "Straight towards the object.",
        option: option("step", "How far the camera was moved between them, towards the object; bare: in m", "1 σ of the step, such as 1mm"),
        ..SHOT
    };
    /// Column of the first of two points.
    FROM_COLUMN = FieldSpec {
        key: "from-u", name: "Column of the first point", symbol: "u_1", noun: "the column of the first point", examples: &["138"],
        ..OF_TWO
    };
    /// Row of the first of two points.
    FROM_ROW = FieldSpec {
        key: "from-v", name: "Row of the first point", symbol: "v_1", noun: "the row of the first point", examples: &["219"], ..OF_TWO
    };
    /// Disparity of the first of two points.
    FROM_DISPARITY = FieldSpec {
        key: "from-d", name: "Disparity of the first point", symbol: "d_1", noun: "the disparity of the first point", examples: &["36"],
        has_sigma: true, ..OF_TWO
    };
    /// Column of the second of two points.
    TO_COLUMN = FieldSpec {
        key: "to-u", name: "Column of the second point", symbol: "u_2", noun: "the column of the second point", examples: &["264"],
        ..OF_TWO
    };
    /// Row of the second of two points.
    TO_ROW = FieldSpec {
        key: "to-v", name: "Row of the second point", symbol: "v_2", noun: "the row of the second point", examples: &["216"], ..OF_TWO
    };
    /// Disparity of the second of two points.
    TO_DISPARITY = FieldSpec {
        key: "to-d", name: "Disparity of the second point", symbol: "d_2", noun: "the disparity of the second point", examples: &["30"],
        has_sigma: true, ..OF_TWO
    };

    /// D, where something else is solved for.
    DISTANCE = FieldSpec {
        key: "distance", name: "Distance (D)", symbol: "D", noun: "the distance", examples: &["1.4"], has_sigma: true,
        hint: "The distance along the optical axis, now an input.",
        option: option(
            "distance",
            "With --solve-for: the distance along the optical axis; bare: in m",
            "1 σ of the distance, such as 1cm or 1%",
        ),
        ..METERS
    };

    /// Focal length of a lens.
    LENS = FieldSpec {
        key: "lens", name: "Focal length of the lens", noun: "the focal length of the lens", examples: &["4"], ..MILLIMETERS
    };
    /// Size of one pixel of a sensor.
    PIXEL_PITCH = FieldSpec {
        key: "pixel-pitch", name: "Pixel pitch", noun: "the pixel pitch", kind: Kind::Pitch, examples: &["3"], ..BLANK
    };
    /// Width of a sensor.
    SENSOR_WIDTH = FieldSpec {
        key: "sensor-width", name: "Width of the sensor", noun: "the width of the sensor", examples: &["4.8"], ..MILLIMETERS
    };
    /// Width of a whole image.
    FRAME_WIDTH = FieldSpec {
        key: "frame-width", name: "Width of the image", noun: "the width of the image", examples: &["1280"], ..PIXELS
    };
    /// Height of a whole image.
    FRAME_HEIGHT = FieldSpec {
        key: "frame-height", name: "Height of the image", noun: "the height of the image", examples: &["720"], ..PIXELS
    };
    /// Field of view along the rows.
    HORIZONTAL_VIEW = FieldSpec {
        key: "horizontal-view", name: "Horizontal field of view", noun: "the field of view", examples: &["69"], ..VIEW
    };
    /// Field of view along the columns.
    VERTICAL_VIEW = FieldSpec {
        key: "vertical-view", name: "Vertical field of view", noun: "the field of view", examples: &["42"], ..VIEW
    };
    /// Field of view from corner to corner.
    DIAGONAL_VIEW = FieldSpec {
        key: "diagonal-view", name: "Diagonal field of view", noun: "the field of view", examples: &["78"], ..VIEW
    };
    /// A focal length as a multiple of the image's width, or of half of it.
    MULTIPLE = FieldSpec {
        key: "multiple", name: "Multiple", noun: "the multiple", examples: &["0.97428"], ..BLANK
    };
    /// Width in a reference photograph.
    REFERENCE_IMAGE_WIDTH = FieldSpec {
        key: "reference-wimg", name: "Its width in the image", noun: "the width in the image", examples: &["150"], ..PIXELS
    };
    /// Distance of what a reference photograph shows.
    REFERENCE_DISTANCE = FieldSpec {
        key: "reference-distance", name: "Its distance", noun: "the distance", examples: &["1.4"], ..METERS
    };
    /// Width of what a reference photograph shows.
    REFERENCE_REAL_WIDTH = FieldSpec {
        key: "reference-wreal", name: "Its real width", noun: "the real width", examples: &["0.3"], ..METERS
    };
    /// A focal length at another resolution.
    KNOWN_FOCAL_LENGTH = FieldSpec {
        key: "known-fx", name: "Known focal length", noun: "the known focal length", examples: &["631.3"], ..PIXELS
    };
    /// Width of the image before it was resized.
    WIDTH_BEFORE = FieldSpec {
        key: "width-before", name: "Width of the image it belongs to", noun: "the width of the image", examples: &["1280"], ..PIXELS
    };
    /// Width of the image after it was resized.
    WIDTH_AFTER = FieldSpec {
        key: "width-after", name: "Width after resizing, before any crop", noun: "the width after resizing", examples: &["768"],
        ..PIXELS
    };

    /// Column of a point in the left image.
    LEFT_COLUMN = FieldSpec {
        key: "left-x", name: "x in the left image", noun: "x in the left image", examples: &["660"], signed: true, ..PIXELS
    };
    /// Column of the point in the right image.
    RIGHT_COLUMN = FieldSpec {
        key: "right-x", name: "x in the right image", noun: "x in the right image", examples: &["610"], signed: true, ..PIXELS
    };
    /// The whole distance between two stations.
    STATIONS = FieldSpec {
        key: "stations", name: "Distance between the cameras", noun: "the distance between the cameras", examples: &["100"], ..METERS
    };
    /// The angle between the line from one station to the other and the line of sight.
    BASELINE_ANGLE = FieldSpec {
        key: "baseline-angle", name: "Angle to the line of sight", noun: "the angle", kind: Kind::Angle, examples: &["60"], ..BLANK
    };

    /// What a program stored for a disparity.
    STORED_VALUE = FieldSpec { key: "stored", name: "Stored value", noun: "the stored value", examples: &["800"], signed: true, ..BLANK };
    /// The matcher's minDisparity.
    MIN_DISPARITY = FieldSpec {
        key: "min-disparity", name: "minDisparity", noun: "minDisparity", kind: Kind::Count, examples: &["0"], signed: true, ..BLANK
    };
    /// Sub-pixel bits of DepthAI.
    SUBPIXEL_BITS = FieldSpec {
        key: "subpixel-bits", name: "Sub-pixel bits", noun: "the number of sub-pixel bits", kind: Kind::Count, examples: &["3"],
        signed: true,
        ..BLANK
    };
    /// A disparity as a part of the width of the image.
    FRACTION = FieldSpec { key: "fraction", name: "Fraction", noun: "the fraction", examples: &["0.039"], signed: true, ..BLANK };
    /// A disparity with the opposite sign.
    ZED_DISPARITY = FieldSpec {
        key: "zed-disparity", name: "Disparity of the ZED", noun: "the disparity of the ZED", examples: &["−50"], signed: true,
        ..PIXELS
    };
    /// Column of the left principal point.
    LEFT_CX = FieldSpec {
        key: "left-cx", name: "cx of the left camera", noun: "cx of the left camera", examples: &["610"], ..PIXELS
    };
    /// Column of the right principal point.
    RIGHT_CX = FieldSpec {
        key: "right-cx", name: "cx of the right camera", noun: "cx of the right camera", examples: &["650"], ..PIXELS
    };
    /// doffs from a calibration file.
    FILE_DOFFS = FieldSpec { key: "file-doffs", name: "doffs", noun: "doffs", examples: &["131.1"], signed: true, ..PIXELS };

    /// Side of a square of a calibration board.
    SQUARE_SIZE = FieldSpec {
        key: "square-size", name: "Size of a square of the board", noun: "the size of a square", examples: &["25"], ..MILLIMETERS
    };
    /// A Q matrix as pasted.
    Q_MATRIX = FieldSpec {
        key: "q-matrix", name: "Q matrix", noun: "the Q matrix", kind: Kind::Text,
        examples: &["[[1. 0. 0. −610.] [0. 1. 0. −350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]"], ..BLANK
    };
}

/// Makes a [`Key`] of the field `$of` in other words.
macro_rules! in_other_words {
    ($($name:ident = $of:ident { $($words:tt)* })*) => {
        $(pub(crate) const $name: Key = {
            const SPEC: FieldSpec = FieldSpec { $($words)*, ..*$of.spec() };
            Key::of(&SPEC)
        };)*
    };
}

in_other_words! {
    IMAGE_HEIGHT = IMAGE_WIDTH {
        name: "Object height in image (w_img)", noun: "the height in the image",
        hint: "Height of the object in the image, in rows.",
        description: "Object’s height in the image"
    }
    REAL_HEIGHT = REAL_WIDTH {
        name: "Object real height (w_real)", noun: "the real height",
        hint: "Actual physical height of the object.",
        description: "Object’s actual physical height"
    }
    BALL_IN_IMAGE = IMAGE_WIDTH {
        name: "Ball width in image (w_img)",
        hint: "Width of the ball, with it in the middle of the image.",
        description: "Ball’s width in the middle of the image"
    }
    BALL_DIAMETER = REAL_WIDTH {
        name: "Ball real diameter (w_real)", noun: "the diameter",
        hint: "Actual diameter of the ball.",
        description: "Ball’s actual diameter"
    }
    VERTICAL_BASELINE = BASELINE {
        hint: "From the upper camera to the lower one."
    }
    VERTICAL_DOFFS = DOFFS {
        hint: "cy of the lower camera minus that of the upper one; added to the disparity."
    }
    VERTICAL_DISPARITY = DISPARITY {
        hint: "Vertical shift between the two images, in rows.",
        description: "Vertical pixel difference"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_leads_back_to_its_field_and_no_two_fields_share_one() {
        for (position, &key) in TABLE.iter().enumerate() {
            assert_eq!(Key::named(key.key), Some(key));
            assert_eq!(TABLE.iter().filter(|other| **other == key).count(), 1, "{key:?}");
            assert!(
                !key.name.is_empty() && !key.noun.is_empty() && !key.key.is_empty(),
                "number {position}"
            );
            assert!(key.kind == Kind::Text || !key.examples.is_empty(), "{key:?}");
        }
        for field in Field::ALL {
            assert_eq!(Key::from(field).input, Some(field));
        }
    }

    #[test]
    fn the_fields_of_the_form_are_in_reading_order() {
        let in_sections: Vec<_> = Section::ALL.into_iter().flat_map(Section::keys).collect();
        assert_eq!(in_sections, Key::form().collect::<Vec<_>>());
        assert!(TABLE.is_sorted());
    }
}
