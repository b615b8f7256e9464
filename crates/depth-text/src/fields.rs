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

const CHANNEL: FieldSpec = FieldSpec {
    kind: Kind::Count,
    hint: "0 to 255",
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
        hint: "Calibration: K[0][0], P[0] or Q[2][3]",
        description: "camera, K[0][0]",
        input: Some(Field::FocalLength), section: Some(Section::Camera),
        option: option(
            "fx",
            "Focal length in pixels of the image that the other pixels are counted in",
            "1 σ of the focal length, such as 2 or 0.3%",
        ),
        label: "Focal length", hint_in_pair: "K[0][0]", sigma_example: "2",
        ..INPUT
    };
    /// The lens that fx was computed from.
    FX_LENS = FieldSpec {
        key: "fx-lens", name: "Lens that fx came from", symbol: "f_lens", noun: "the lens", examples: &["15"],
        kind: Kind::Length(LengthUnit::Millimeter),
        hint: "Added to the distance; empty where fx was calibrated",
        input: Some(Field::Lens), section: Some(Section::Camera), is_optional: true,
        option: option(
            "lens",
            "Focal length of the lens that fx was computed from: it is added to the distance; bare: in mm. Not for a calibrated fx",
            "",
        ),
        label: "Lens that fx came from",
        ..BLANK
    };
    /// fy, px: fx where it is left out.
    FY = FieldSpec {
        key: "fy", kind: Kind::FocalLength, name: "Focal length along the columns (fy)", symbol: "fy", noun: "fy", examples: &["700"],
        hint: "K[1][1]; only if it differs from fx",
        input: Some(Field::Fy), section: Some(Section::Camera), is_optional: true,
        option: option(
            "fy",
            "Focal length along the columns, for heights, vertical pairs and points; without it, fx",
            "1 σ of fy; without it, that of fx in proportion",
        ),
        has_sigma: true,
        label: "Focal length", hint_in_pair: "K[1][1]", sigma_example: "2",
        ..BLANK
    };
    /// b, a length
    BASELINE = FieldSpec {
        key: "b", name: "Camera baseline (b)", symbol: "b", noun: "the baseline", examples: &["100"],
        kind: Kind::Length(LengthUnit::Millimeter),
        hint: "From lens center to lens center",
        description: "between the two lens centers",
        input: Some(Field::Baseline), section: Some(Section::Stereo),
        option: option("baseline", "Distance between the two cameras; bare: in mm", "1 σ of the baseline, such as 0.5mm or 0.5%"),
        label: "Camera baseline", behind_reading: ", from lens center to lens center", sigma_example: "0.5",
        ..INPUT
    };
    /// d, px, an angle or a length on the sensor
    DISPARITY = FieldSpec {
        key: "d", kind: Kind::Extent, name: "Disparity (d)", symbol: "d", noun: "the disparity", examples: &["50"],
        hint: "x left − x right; good matching: ± 0.1 to 0.5 px",
        description: "shift between the two images",
        input: Some(Field::Disparity), section: Some(Section::Stereo),
        option: option(
            "disparity",
            "Shift of the object between the rectified images, left x minus right x, in pixels; or as an angle, or a length on the sensor",
            "1 σ of the disparity, such as 0.25",
        ),
        label: "Disparity", hint_in_pair: "x left − x right", sigma_example: "0.5",
        ..INPUT
    };
    /// δ = cx_right − cx_left, px
    DOFFS = FieldSpec {
        key: "doffs", name: "Principal point offset (doffs)", symbol: "doffs", noun: "doffs", examples: &["0", "131.1"],
        hint: "cx right − cx left; added to the disparity",
        signed: true, is_optional: true,
        input: Some(Field::Doffs), section: Some(Section::Stereo),
        option: option("doffs", "cx of the right camera minus cx of the left one, added to the disparity; with --pair vertical, cy of the lower camera minus cy of the upper one", "1 σ of doffs"),
        label: "Principal point offset", hint_in_pair: "cx right − cx left", sigma_example: "0.5",
        ..INPUT
    };
    /// w_img, px, an angle or a length on the sensor
    IMAGE_WIDTH = FieldSpec {
        key: "wimg", kind: Kind::Extent, name: "Object width in image (w_img)", symbol: "w_img", noun: "the width in the image", examples: &["150"],
        hint: "From edge to edge, in the undistorted image",
        description: "edge to edge, in the image",
        input: Some(Field::ImageWidth), section: Some(Section::Monocular),
        option: option("w-img", "Width of the object in the image in pixels; or as an angle, or a length on the sensor", "1 σ of the width in the image"),
        label: "Object width in image", sigma_example: "2",
        ..INPUT
    };
    /// w_real, a length
    REAL_WIDTH = FieldSpec {
        key: "wreal", name: "Object real width (w_real)", symbol: "w_real", noun: "the real width", examples: &["0.30"],
        kind: Kind::Length(LengthUnit::Meter),
        hint: "From edge to edge, seen face on",
        description: "edge to edge, seen face on",
        input: Some(Field::RealWidth), section: Some(Section::Monocular),
        option: option("w-real", "Width of the object itself; bare: in m", "1 σ of the real width, such as 1cm or 3%"),
        label: "Object real width", behind_reading: "; seen face on", sigma_example: "0.01",
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
        hint: "K[0][2]; half of the width",
        label: "Center",
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
        hint: "K[1][2]; half of the height",
        label: "Center",
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
        hint: "From the left edge",
        label: "Column",
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
        hint: "From the top edge",
        label: "Row",
        ..POINT
    };
    /// The range that a tape measures, where the depth is wanted.
    TAPED_RANGE = FieldSpec {
        key: "range", name: "Range by tape (R)", symbol: "R", noun: "the range", examples: &["1.62"],
        kind: Kind::Length(LengthUnit::Meter), has_sigma: true,
        hint: "Lens to object along the line of sight; gives the depth",
        option: option(
            "range",
            "Range from the lens to what the pixel shows, by tape or laser, to get its depth; bare: in m",
            "1 σ of the range, such as 5mm or 1%",
        ),
        label: "Range by tape", behind_reading: ", along the line of sight", hint_in_pair: "Only to get the depth", sigma_example: "0.005",
        ..POINT
    };
    /// How far in front of the lens distances are counted from.
    ZERO = FieldSpec {
        key: "zero", name: "The tape starts in front of the lens", symbol: "zero", noun: "the zero point", examples: &["4.2"],
        kind: Kind::Length(LengthUnit::Millimeter), signed: true,
        hint: "How far in front of the lens the tape starts",
        input: Some(Field::Zero), section: Some(Section::Point), is_optional: true,
        option: option(
            "zero",
            "How far in front of the lens distances are counted from, such as its front glass; bare: in mm",
            "",
        ),
        label: "Zero point", hint_in_pair: "In front of the lens",
        ..BLANK
    };
    /// How far the target is turned away.
    TILT = FieldSpec {
        key: "tilt", name: "Tilt of the target", symbol: "φ", noun: "the tilt", kind: Kind::Angle, examples: &["20"], signed: true,
        hint: "0° is facing the camera",
        input: Some(Field::Tilt), section: Some(Section::Target), is_optional: true,
        option: option(
            "tilt",
            "Angle by which the object is turned away from facing the camera; bare: in degrees",
            "",
        ),
        label: "Tilt of the target",
        ..BLANK
    };
    /// Height of the camera above the floor.
    CAMERA_HEIGHT = FieldSpec {
        key: "camera-height", name: "Height of the camera", symbol: "H", noun: "the height of the camera", examples: &["1.2"],
        kind: Kind::Length(LengthUnit::Meter), has_sigma: true,
        hint: "From the lens to the floor",
        option: option(
            "height",
            "Height of the lens above the floor; bare: in m",
            "1 σ of the height, such as 5cm or 2%",
        ),
        label: "Camera height", behind_reading: ", lens to floor", hint_in_pair: "From lens to floor", sigma_example: "0.05",
        ..GROUND
    };
    /// How far the optical axis points down.
    CAMERA_PITCH = FieldSpec {
        key: "camera-pitch", name: "Pitch of the camera, downwards", symbol: "θ", noun: "the pitch of the camera",
        kind: Kind::Angle, examples: &["10"], signed: true, has_sigma: true,
        hint: "0° level, + is downwards",
        option: option(
            "pitch",
            "How far the camera looks down: 0 is level, 90 straight down; bare: in degrees",
            "1 σ of the pitch, such as 0.5",
        ),
        label: "Pitch", sigma_example: "0.5",
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
        hint: "From the top edge",
        label: "Row", sigma_example: "1",
        ..GROUND
    };
    /// Column at which the point on the floor is seen.
    FLOOR_COLUMN = FieldSpec {
        key: "floor-column", name: "Column of the point on the floor", symbol: "u", noun: "the column of the point",
        examples: &["1100"],
        hint: "From the left edge",
        option: option(
            "u",
            "Column at which the point is seen, to get how far it is to the right",
            "",
        ),
        label: "Column",
        ..GROUND
    };
    /// Height of the target above the floor.
    TARGET_HEIGHT = FieldSpec {
        key: "target-height", name: "Height of the target", symbol: "h", noun: "the height of the target", examples: &["0"],
        kind: Kind::Length(LengthUnit::Meter), signed: true,
        hint: "0 is a point on the floor",
        option: option(
            "target-height",
            "Height of the point above the floor, if it does not lie on it; bare: in m",
            "",
        ),
        label: "Target height",
        ..GROUND
    };
    /// How far below the optical axis the point is seen, instead of its row.
    FLOOR_ANGLE = FieldSpec {
        key: "floor-angle", name: "Angle below the optical axis", symbol: "α", noun: "the angle below the axis",
        kind: Kind::Angle, examples: &["11.3"], signed: true,
        hint: "Instead of the row v; needs no focal length",
        option: option(
            "angle",
            "Angle of the point below the optical axis, instead of its row; bare: in degrees",
            "",
        ),
        label: "Angle below the axis", hint_in_pair: "Instead of the row v",
        ..GROUND
    };

    /// How wide the object is in the photograph from farther away.
    FAR_WIDTH = FieldSpec {
        key: "far-px", name: "Width in the first photograph", symbol: "w_1", noun: "the width in the first photograph",
        examples: &["1162"], hint: "First place, farther away",
        option: option("far-px", "Width of the object in the photograph from farther away", "1 σ of that width, such as 1"),
        label: "Width in first photo", sigma_example: "1",
        ..SHOT
    };
    /// How wide it is in the one from nearer.
    NEAR_WIDTH = FieldSpec {
        key: "near-px", name: "Width in the second photograph", symbol: "w_2", noun: "the width in the second photograph",
        examples: &["1429"], hint: "Second place, a step nearer",
        option: option("near-px", "Width of the object in the photograph from nearer", "1 σ of that width, such as 1"),
        label: "Width in second photo", sigma_example: "1",
        ..SHOT
    };
    /// How far the camera was moved between both.
    STEP = FieldSpec {
        key: "step", name: "Step between them", symbol: "s", noun: "the step", examples: &["0.5"],
        kind: Kind::Length(LengthUnit::Meter), hint: "Straight towards the object",
        option: option("step", "How far the camera was moved between them, towards the object; bare: in m", "1 σ of the step, such as 1mm"),
        label: "Step", behind_reading: ", towards the object", sigma_example: "0.001",
        ..SHOT
    };
    /// Column of the first of two points.
    FROM_COLUMN = FieldSpec {
        key: "from-u", name: "Column of the first point", symbol: "u_1", noun: "the column of the first point", examples: &["138"],
        label: "Column", hint: "First point, left image",
        ..OF_TWO
    };
    /// Row of the first of two points.
    FROM_ROW = FieldSpec {
        key: "from-v", name: "Row of the first point", symbol: "v_1", noun: "the row of the first point", examples: &["219"],
        label: "Row", hint: "From the top edge",
        ..OF_TWO
    };
    /// Disparity of the first of two points.
    FROM_DISPARITY = FieldSpec {
        key: "from-d", name: "Disparity of the first point", symbol: "d_1", noun: "the disparity of the first point", examples: &["36"],
        has_sigma: true,
        label: "Disparity", hint: "x left − x right", sigma_example: "0.5",
        ..OF_TWO
    };
    /// Column of the second of two points.
    TO_COLUMN = FieldSpec {
        key: "to-u", name: "Column of the second point", symbol: "u_2", noun: "the column of the second point", examples: &["264"],
        label: "Column", hint: "Second point, left image",
        ..OF_TWO
    };
    /// Row of the second of two points.
    TO_ROW = FieldSpec {
        key: "to-v", name: "Row of the second point", symbol: "v_2", noun: "the row of the second point", examples: &["216"],
        label: "Row", hint: "From the top edge",
        ..OF_TWO
    };
    /// Disparity of the second of two points.
    TO_DISPARITY = FieldSpec {
        key: "to-d", name: "Disparity of the second point", symbol: "d_2", noun: "the disparity of the second point", examples: &["30"],
        has_sigma: true,
        label: "Disparity", hint: "x left − x right", sigma_example: "0.5",
        ..OF_TWO
    };

    /// D, where something else is solved for.
    DISTANCE = FieldSpec {
        key: "distance", name: "Distance (D)", symbol: "D", noun: "the distance", examples: &["1.4"], has_sigma: true,
        hint: "Along the axis, from the lens",
        option: option(
            "distance",
            "With --solve-for: the distance along the optical axis; bare: in m",
            "1 σ of the distance, such as 1cm or 1%",
        ),
        label: "Object distance", sigma_example: "0.01",
        ..METERS
    };

    /// Focal length of a lens.
    LENS = FieldSpec {
        key: "lens", name: "Focal length of the lens", noun: "the focal length of the lens", examples: &["4"],
        label: "Focal length of the lens", hint: "Engraved on the lens",
        ..MILLIMETERS
    };
    /// Size of one pixel of a sensor.
    PIXEL_PITCH = FieldSpec {
        key: "pixel-pitch", name: "Pixel pitch", noun: "the pixel pitch", kind: Kind::Pitch, examples: &["3"],
        label: "Pixel pitch", hint: "From the datasheet of the sensor",
        ..BLANK
    };
    /// Width of a sensor.
    SENSOR_WIDTH = FieldSpec {
        key: "sensor-width", name: "Width of the sensor", noun: "the width of the sensor", examples: &["4.8"],
        label: "Width of the sensor", hint: "Of the part that takes the picture",
        ..MILLIMETERS
    };
    /// Width of a whole image.
    FRAME_WIDTH = FieldSpec {
        key: "frame-width", name: "Width of the image", noun: "the width of the image", examples: &["1280"],
        label: "Width of the image", hint: "Of the whole image that you have", hint_in_pair: "Of the whole image",
        ..PIXELS
    };
    /// Height of a whole image.
    FRAME_HEIGHT = FieldSpec {
        key: "frame-height", name: "Height of the image", noun: "the height of the image", examples: &["720"],
        label: "Height of the image", hint: "Of the whole image that you have", hint_in_pair: "Of the whole image",
        ..PIXELS
    };
    /// Field of view along the rows.
    HORIZONTAL_VIEW = FieldSpec {
        key: "horizontal-view", name: "Horizontal field of view", noun: "the field of view", examples: &["69"],
        label: "Horizontal field of view", hint: "From the left edge to the right one",
        ..VIEW
    };
    /// Field of view along the columns.
    VERTICAL_VIEW = FieldSpec {
        key: "vertical-view", name: "Vertical field of view", noun: "the field of view", examples: &["42"],
        label: "Vertical field of view", hint: "From the top edge to the bottom one",
        ..VIEW
    };
    /// Field of view from corner to corner.
    DIAGONAL_VIEW = FieldSpec {
        key: "diagonal-view", name: "Diagonal field of view", noun: "the field of view", examples: &["78"],
        label: "Diagonal field of view", hint: "From corner to corner",
        ..VIEW
    };
    /// fx among the facts of a camera.
    CAMERA_FX = FieldSpec {
        key: "camera-fx", name: "Focal length fx", noun: "fx", examples: &["700"],
        label: "fx", hint: "K[0][0]; K[0] in CameraInfo",
        ..PIXELS
    };
    /// fy among the facts of a camera.
    CAMERA_FY = FieldSpec {
        key: "camera-fy", name: "Focal length fy", noun: "fy", examples: &["700"],
        label: "fy", hint: "K[1][1]; K[4] in CameraInfo",
        ..PIXELS
    };
    /// Where a lens is in focus.
    FOCUSED_AT = FieldSpec {
        key: "focused-at", name: "In focus at", noun: "the distance in focus", examples: &["0.3"],
        label: "In focus at", hint: "Empty for far away",
        ..METERS
    };
    /// Height of a sensor.
    SENSOR_HEIGHT = FieldSpec {
        key: "sensor-height", name: "Height of the sensor", noun: "the height of the sensor", examples: &["3.6"],
        label: "Height of the sensor", hint: "Without what was cut",
        ..MILLIMETERS
    };
    /// Diagonal of a sensor.
    SENSOR_DIAGONAL = FieldSpec {
        key: "sensor-diagonal", name: "Diagonal of the sensor", noun: "the diagonal of the sensor", examples: &["6"],
        label: "Diagonal of the sensor", hint: "1/2.3 in is a name: 7.66 mm",
        ..MILLIMETERS
    };
    /// The equivalent lens for 35 mm film, by the diagonal.
    FILM_DIAGONAL = FieldSpec {
        key: "f35-diagonal", name: "35 mm equivalent, by the diagonal", noun: "the equivalent focal length", examples: &["26"],
        label: "By the diagonal", hint: "Phones and EXIF (CIPA)",
        ..MILLIMETERS
    };
    /// The equivalent lens for 35 mm film, by the width.
    FILM_WIDTH = FieldSpec {
        key: "f35-width", name: "35 mm equivalent, by the width", noun: "the equivalent focal length", examples: &["25"],
        label: "By the width", hint: "Blender, with 36 mm",
        ..MILLIMETERS
    };
    /// Row 0, column 0 of an OpenGL projection matrix.
    P00 = FieldSpec {
        key: "p00", name: "P00 of the projection matrix", noun: "P00", examples: &["1.09"],
        label: "P00", hint: "OpenGL, Unity: 2 · fx/width",
        ..BLANK
    };
    /// Row 1, column 1 of an OpenGL projection matrix.
    P11 = FieldSpec {
        key: "p11", name: "P11 of the projection matrix", noun: "P11", examples: &["1.94"],
        label: "P11", hint: "OpenGL, Unity: 2 · fy/height",
        ..BLANK
    };
    /// A focal length as a multiple of the image's width, or of half of it.
    MULTIPLE = FieldSpec {
        key: "multiple", name: "Multiple", noun: "the multiple", examples: &["0.97428"],
        label: "Multiple", hint: "fx divided by the width, or by half of it",
        ..BLANK
    };
    /// Width in a reference photograph.
    REFERENCE_IMAGE_WIDTH = FieldSpec {
        key: "reference-wimg", name: "Its width in the image", noun: "the width in the image", examples: &["150"],
        label: "Its width in the image", hint: "From edge to edge, in the undistorted image",
        ..PIXELS
    };
    /// Distance of what a reference photograph shows.
    REFERENCE_DISTANCE = FieldSpec {
        key: "reference-distance", name: "Its distance", noun: "the distance", examples: &["1.4"],
        label: "Its distance", hint: "From the lens, by tape",
        ..METERS
    };
    /// Width of what a reference photograph shows.
    REFERENCE_REAL_WIDTH = FieldSpec {
        key: "reference-wreal", name: "Its real width", noun: "the real width", examples: &["0.3"],
        label: "Its real width", hint: "From edge to edge, seen face on",
        ..METERS
    };
    /// A focal length at another resolution.
    KNOWN_FOCAL_LENGTH = FieldSpec {
        key: "known-fx", name: "Known focal length", noun: "the known focal length", examples: &["631.3"],
        label: "Known focal length", hint: "At the resolution of the calibration",
        ..PIXELS
    };
    /// Width of the image before it was resized.
    WIDTH_BEFORE = FieldSpec {
        key: "width-before", name: "Width of the image it belongs to", noun: "the width of the image", examples: &["1280"],
        label: "Width of the image it belongs to", hint: "The width at that resolution",
        ..PIXELS
    };
    /// Width of the image after it was resized.
    WIDTH_AFTER = FieldSpec {
        key: "width-after", name: "Width after resizing, before any crop", noun: "the width after resizing", examples: &["768"],
        label: "Width after resizing, before any crop", hint: "The width of the image that you have",
        ..PIXELS
    };

    /// Width of an image in another mode of its sensor, before it is cropped.
    MODE_WIDTH = FieldSpec {
        key: "mode-width", name: "Width after resizing or binning", noun: "the width after resizing", examples: &["768"],
        label: "Width after resizing", hint: "Before any crop; empty where only cropped",
        ..PIXELS
    };
    /// Width of the part of an image that is kept.
    CROP_WIDTH = FieldSpec {
        key: "crop-width", name: "Width of the part that is kept", noun: "the width of the part that is kept", examples: &["640"],
        label: "Width that is kept", hint: "Empty for all of it",
        ..PIXELS
    };
    /// Its height.
    CROP_HEIGHT = FieldSpec {
        key: "crop-height", name: "Height of the part that is kept", noun: "the height of the part that is kept", examples: &["480"],
        label: "Height that is kept", hint: "Empty for all of it",
        ..PIXELS
    };
    /// The column at which it begins.
    CROP_LEFT = FieldSpec {
        key: "crop-left", name: "Columns cut at the left", noun: "the number of columns cut at the left", examples: &["64"],
        label: "Cut at the left", hint: "Empty where it is the middle that is kept",
        ..PIXELS
    };
    /// The row at which it begins.
    CROP_TOP = FieldSpec {
        key: "crop-top", name: "Rows cut at the top", noun: "the number of rows cut at the top", examples: &["0"],
        label: "Cut at the top", hint: "Empty where it is the middle that is kept",
        ..PIXELS
    };

    /// Column of a point in the left image.
    LEFT_COLUMN = FieldSpec {
        key: "left-x", name: "x in the left image", noun: "x in the left image", examples: &["660"], signed: true,
        label: "x in the left image", hint: "Of the rectified image, from its left edge",
        ..PIXELS
    };
    /// Column of the point in the right image.
    RIGHT_COLUMN = FieldSpec {
        key: "right-x", name: "x in the right image", noun: "x in the right image", examples: &["610"], signed: true,
        label: "x in the right image", hint: "The same point, in the same row",
        ..PIXELS
    };
    /// The whole distance between two stations.
    STATIONS = FieldSpec {
        key: "stations", name: "Distance between the cameras", noun: "the distance between the cameras", examples: &["100"],
        label: "Distance between the cameras", hint: "In a straight line",
        ..METERS
    };
    /// The angle between the line from one station to the other and the line of sight.
    BASELINE_ANGLE = FieldSpec {
        key: "baseline-angle", name: "Angle to the line of sight", noun: "the angle", kind: Kind::Angle, examples: &["60"],
        label: "Angle to the line of sight", hint: "90° is square to the line of sight",
        ..BLANK
    };

    /// What a program stored for a disparity.
    STORED_VALUE = FieldSpec { key: "stored", name: "Stored value", noun: "the stored value", examples: &["800"], signed: true,
        label: "Stored value", hint: "As the file or the array has it",
        ..BLANK };
    /// The matcher's minDisparity.
    MIN_DISPARITY = FieldSpec {
        key: "min-disparity", name: "minDisparity", noun: "minDisparity", kind: Kind::Count, examples: &["0"], signed: true,
        label: "minDisparity", hint: "As the matcher was set up; usually 0",
        ..BLANK
    };
    /// Sub-pixel bits of DepthAI.
    SUBPIXEL_BITS = FieldSpec {
        key: "subpixel-bits", name: "Sub-pixel bits", noun: "the number of sub-pixel bits", kind: Kind::Count, examples: &["3"],
        signed: true,
        label: "Sub-pixel bits", hint: "3, 4 or 5",
        ..BLANK
    };
    /// What a program stores for one pixel of disparity more.
    STEPS_PER_PIXEL = FieldSpec { key: "steps-per-pixel", name: "Steps in a pixel", noun: "the number of steps in a pixel",
        examples: &["16"], signed: true,
        label: "Steps in a pixel", hint: "Negative where less is stored for what is nearer",
        ..BLANK };
    /// What a program stores for a disparity of 0.
    STORED_OFFSET = FieldSpec { key: "stored-offset", name: "Stored for 0 px", noun: "the offset", examples: &["0"], signed: true,
        label: "Stored for 0 px", hint: "The offset; empty: 0",
        ..BLANK };
    /// What a program stores where there is no disparity.
    NO_MATCH = FieldSpec { key: "no-match", name: "Stored without a match", noun: "the mark", examples: &["−1"], signed: true,
        label: "Stored without a match", hint: "Empty: every number is a disparity",
        ..BLANK };
    /// What a program stores for one meter more.
    STEPS_PER_METER = FieldSpec { key: "steps-per-meter", name: "Steps in a meter", noun: "the number of steps in a meter",
        examples: &["1000"],
        label: "Steps in a meter", hint: "1000 where millimeters are stored",
        ..BLANK };
    /// The red channel of a pixel.
    RED = FieldSpec { key: "red", name: "Red (R)", noun: "the red channel", examples: &["100"], label: "Red (R)", ..CHANNEL };
    /// The green channel of a pixel.
    GREEN = FieldSpec { key: "green", name: "Green (G)", noun: "the green channel", examples: &["20"], label: "Green (G)", ..CHANNEL };
    /// The blue channel of a pixel.
    BLUE = FieldSpec { key: "blue", name: "Blue (B)", noun: "the blue channel", examples: &["1"], label: "Blue (B)", ..CHANNEL };
    /// What a network gives for a pixel.
    NETWORK_OUTPUT = FieldSpec { key: "network-output", name: "Output of the network", noun: "the output", examples: &["0.6"],
        label: "Output of the network", hint: "As the array has it",
        ..BLANK };
    /// The distance for which a network gives 1.
    NEAR_PLANE = FieldSpec { key: "near-plane", name: "Near plane", noun: "the near plane", examples: &["0.1"],
        label: "Near plane", hint: "Where the output is 1; empty: 0.1",
        ..BLANK };
    /// The distance for which a network gives 0.
    FAR_PLANE = FieldSpec { key: "far-plane", name: "Far plane", noun: "the far plane", examples: &["100"],
        label: "Far plane", hint: "Where the output is 0; empty: 100",
        ..BLANK };
    /// The unit in which a network has its planes.
    NETWORK_SCALE = FieldSpec { key: "network-scale", name: "Scale", noun: "the scale", examples: &["1"],
        label: "Scale", hint: "Meters in its unit; empty: 1; monodepth2 on KITTI: 5.4",
        ..BLANK };
    /// A disparity as a part of the width of the image.
    FRACTION = FieldSpec { key: "fraction", name: "Fraction", noun: "the fraction", examples: &["0.039"], signed: true,
        label: "Fraction", hint: "Disparity divided by the width of the image",
        ..BLANK };
    /// A disparity with the opposite sign.
    ZED_DISPARITY = FieldSpec {
        key: "zed-disparity", name: "Disparity of the ZED", noun: "the disparity of the ZED", examples: &["−50"], signed: true,
        label: "Disparity of the ZED", hint: "Below zero",
        ..PIXELS
    };
    /// Column of the left principal point.
    LEFT_CX = FieldSpec {
        key: "left-cx", name: "cx of the left camera", noun: "cx of the left camera", examples: &["610"],
        label: "cx of the left camera", hint: "K[0][2] of the left camera",
        ..PIXELS
    };
    /// Column of the right principal point.
    RIGHT_CX = FieldSpec {
        key: "right-cx", name: "cx of the right camera", noun: "cx of the right camera", examples: &["650"],
        label: "cx of the right camera", hint: "K[0][2] of the right camera",
        ..PIXELS
    };
    /// doffs from a calibration file.
    FILE_DOFFS = FieldSpec { key: "file-doffs", name: "doffs", noun: "doffs", examples: &["131.1"], signed: true,
        label: "doffs", hint: "As in Middlebury’s calib.txt",
        ..PIXELS };

    /// Side of a square of a calibration board.
    SQUARE_SIZE = FieldSpec {
        key: "square-size", name: "Size of a square of the board", noun: "the size of a square", examples: &["25"],
        label: "Size of a square of the board", hint: "The side of one square",
        ..MILLIMETERS
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
        hint: "From top to bottom, in the undistorted image",
        description: "top to bottom, in the image",
        label: "Object height in image"
    }
    REAL_HEIGHT = REAL_WIDTH {
        name: "Object real height (w_real)", noun: "the real height",
        hint: "From top to bottom, seen face on",
        description: "top to bottom, seen face on",
        label: "Object real height"
    }
    BALL_IN_IMAGE = IMAGE_WIDTH {
        name: "Ball width in image (w_img)",
        hint: "From edge to edge, in the middle of the image",
        description: "edge to edge, in the image",
        label: "Ball width in image"
    }
    BALL_DIAMETER = REAL_WIDTH {
        name: "Ball real diameter (w_real)", noun: "the diameter",
        hint: "By caliper, or circumference / π",
        description: "through its center",
        label: "Ball real diameter", behind_reading: "; through its center"
    }
    VERTICAL_BASELINE = BASELINE {
        hint: "From the upper lens center to the lower one", behind_reading: ", from the upper lens center to the lower"
    }
    VERTICAL_DOFFS = DOFFS {
        hint: "cy lower − cy upper; added to the disparity", hint_in_pair: "cy lower − cy upper"
    }
    VERTICAL_DISPARITY = DISPARITY {
        hint: "y upper − y lower; good matching: ± 0.1 to 0.5 px",
        description: "shift between the two images",
        hint_in_pair: "y upper − y lower"
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
            assert!(!key.label.is_empty() || key.kind == Kind::Text, "{key:?}");
            assert_eq!(key.has_sigma, !key.sigma_example.is_empty(), "{key:?}");
        }
        for field in Field::ALL {
            assert_eq!(Key::from(field).input, Some(field));
        }
    }

    #[test]
    fn a_hint_fits_under_its_field_and_teaches() {
        let in_other_words = [
            IMAGE_HEIGHT,
            REAL_HEIGHT,
            BALL_IN_IMAGE,
            BALL_DIAMETER,
            VERTICAL_BASELINE,
            VERTICAL_DOFFS,
            VERTICAL_DISPARITY,
        ];
        for key in TABLE.iter().copied().chain(in_other_words).filter(|key| key.kind != Kind::Text) {
            let length = |text: &str| text.chars().count();
            assert!((1..=56).contains(&length(key.hint)), "{key:?}: {}", key.hint);
            let is_in_pair = key
                .section
                .is_some_and(|section| matches!(section, Section::Ground | Section::Point | Section::TwoPoints));
            if is_in_pair || [FOCAL_LENGTH, FY].contains(&key) {
                assert!(
                    length(key.hint_for(true)) <= 27 || key == TARGET_HEIGHT,
                    "{key:?}: {}",
                    key.hint_for(true)
                );
            }
            assert!(
                !key.hint.ends_with('.') && !key.hint.to_ascii_lowercase().starts_with(&key.label.to_ascii_lowercase()),
                "{key:?}"
            );
        }
    }

    #[test]
    fn the_fields_of_the_form_are_in_reading_order() {
        let in_sections: Vec<_> = Section::ALL.into_iter().flat_map(Section::keys).collect();
        assert_eq!(in_sections, Key::form().collect::<Vec<_>>());
        assert!(TABLE.is_sorted());
    }
}
