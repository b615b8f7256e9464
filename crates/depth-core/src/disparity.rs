//! What a file or a program calls a disparity, and how many pixels that is.
//!
//! Here a disparity is d = x_left − x_right in pixels of the rectified image, positive for what lies in front of the
//! cameras. Forgetting a scale is the commonest blunder with stereo: 16 times too near, or all of it behind the camera.

use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// How a disparity is written down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Encoding {
    /// Pixels as a real number (Middlebury's and most programs' floating-point images); not finite where there is none.
    Pixels,
    /// 16-bit signed fixed point, 1/16 px, of OpenCV's StereoBM and StereoSGBM; (minDisparity − 1)·16 where there is none.
    ///
    /// Source: OpenCV, `StereoMatcher::compute`; the invalid value as measured with OpenCV 4.14 and 5.0.
    OpenCv {
        /// The matcher's minDisparity.
        min_disparity: i32,
    },
    /// 16-bit unsigned fixed point, 1/256 px; 0 where there is none.
    ///
    /// Source: the KITTI stereo benchmark's development kit.
    Kitti,
    /// 16-bit unsigned fixed point with sub-pixel bits; 0 where there is none.
    ///
    /// Source: Luxonis, DepthAI, StereoDepth: subpixel fractional bits.
    DepthAi(SubpixelBits),
    /// A fraction of the image's width, as some networks give it.
    FractionOfWidth {
        /// Width of the image in which the disparity is wanted.
        image_width: Pixels,
    },
    /// Pixels with the opposite sign; not finite where there is none.
    ///
    /// Source: Stereolabs, ZED SDK, the DISPARITY measure.
    Zed,
    /// 16-bit unsigned fixed point, 1/256 px, one more than the disparity; 0 where there is none: d = (p − 1)/256.
    ///
    /// Source: Cityscapes, cityscapesScripts, the README on disparity maps.
    Cityscapes,
    /// 16-bit unsigned fixed point, 1/32 px; 0 where there is none.
    ///
    /// Source: librealsense, the disparity transform of the D400 series.
    RealSense,
    /// 16-bit signed fixed point, 1/16 px; 0x8000 where there is none.
    ///
    /// Source: Ensenso SDK, DisparityMap.
    Ensenso,
    /// The 11-bit number of the first Kinect, d = (1090 − p)/8 for its 580 px and 75 mm; 2047 where there is none.
    ///
    /// Source: ROS wiki, kinect_calibration/technical.
    KinectV1,
    /// Any other linear one.
    Linear(Linear),
}

/// A disparity that is stored as p = factor·d + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Stored steps in a pixel; negative where more is stored for what lies farther away.
    pub factor: f64,
    /// What is stored for a disparity of 0.
    pub offset: f64,
    /// What is stored where there is no disparity.
    pub no_match: Option<f64>,
}

/// The focal length of the first Kinect, to which its disparities belong.
pub const KINECT_V1_FOCAL_LENGTH: Pixels = Pixels::new(580.0);
/// The baseline of the first Kinect.
pub const KINECT_V1_BASELINE: Length = Length::from_m(0.075);

impl Linear {
    fn decode(self, stored: f64) -> Result<f64, NoDisparity> {
        if self.no_match == Some(stored) {
            return Err(NoDisparity::Invalid);
        }
        Ok((stored - self.offset) / self.factor)
    }
}

/// Sub-pixel bits of DepthAI's disparity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SubpixelBits {
    /// 1/8 px
    Three,
    /// 1/16 px
    Four,
    /// 1/32 px
    Five,
}

/// Why a number is no disparity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDisparity {
    /// It is how the encoding marks a pixel for which the matcher found nothing.
    Invalid,
    /// The encoding stores whole numbers, and this is none: it may have been divided already.
    NotWhole,
    /// The encoding cannot hold the number, as one of whole numbers cannot hold what is not finite.
    OutOfRange,
}

impl Encoding {
    /// The disparity in pixels that `stored` stands for. Its sign is not judged: doffs may make up for it.
    ///
    /// ```
    /// use depth_core::disparity::Encoding;
    /// use depth_core::quantity::Pixels;
    ///
    /// // Sixteenths of a pixel.
    /// assert_eq!(Encoding::OpenCv { min_disparity: 0 }.decode(800.0), Ok(Pixels::new(50.0)));
    /// ```
    ///
    /// # Errors
    /// [`NoDisparity`].
    pub fn decode(self, stored: f64) -> Result<Pixels, NoDisparity> {
        const UNSIGNED: (f64, f64) = (0.0, 65_535.0);
        const SIGNED: (f64, f64) = (-32_768.0, 32_767.0);
        let is_real = matches!(self, Self::Pixels | Self::Zed | Self::FractionOfWidth { .. } | Self::Linear(_));
        if is_real && !stored.is_finite() {
            return Err(NoDisparity::Invalid);
        }
        let pixels = match self {
            Self::Pixels => stored,
            Self::Zed => 0.0 - stored,
            // A pixel is not seen farther aside than the image is wide: more is in pixels already.
            Self::FractionOfWidth { .. } if stored.abs() > 1.0 => return Err(NoDisparity::OutOfRange),
            Self::FractionOfWidth { image_width } => stored * image_width.px(),
            Self::OpenCv { min_disparity } => {
                let invalid = f64::from(min_disparity) - 1.0;
                let pixels = fixed_point(stored, SIGNED, invalid * 16.0, 16.0)?;
                // The mark of another minDisparity, or one that was divided by 16 already: a matcher stores nothing between its
                // mark and minDisparity.
                let is_mark = is_no_match(pixels) || stored == invalid;
                if is_mark && pixels < f64::from(min_disparity) {
                    return Err(NoDisparity::Invalid);
                }
                pixels
            }
            Self::Kitti => fixed_point(stored, UNSIGNED, 0.0, 256.0)?,
            Self::DepthAi(bits) => fixed_point(stored, UNSIGNED, 0.0, bits.scale())?,
            Self::Cityscapes => (fixed_point(stored, UNSIGNED, 0.0, 1.0)? - 1.0) / 256.0,
            Self::RealSense => fixed_point(stored, UNSIGNED, 0.0, 32.0)?,
            // The mark as a file without a sign has it.
            Self::Ensenso if stored == 32_768.0 => return Err(NoDisparity::Invalid),
            Self::Ensenso => fixed_point(stored, SIGNED, -32_768.0, 16.0)?,
            Self::KinectV1 => (1090.0 - fixed_point(stored, (0.0, 2047.0), 2047.0, 1.0)?) / 8.0,
            Self::Linear(linear) => linear.decode(stored)?,
        };
        if pixels.is_finite() {
            Ok(Pixels::new(pixels))
        } else {
            Err(NoDisparity::OutOfRange)
        }
    }
}

/// Whether `pixels` is how OpenCV's StereoBM and StereoSGBM mark a pixel for which they found nothing: (m − 1)·16 as stored,
/// or m − 1 after the division by 16, for a minDisparity m of 0, −16, −32 and so on.
///
/// ```
/// use depth_core::disparity::is_no_match;
///
/// assert!([-16.0, -1.0, -272.0, -17.0].into_iter().all(is_no_match));
/// assert!(![-10.0, 0.0, 16.0].into_iter().any(is_no_match));
/// ```
///
/// Source: OpenCV, `StereoMatcher::compute`, as measured with OpenCV 4.14 and 5.0; minDisparity is zero in most programs, and
/// where it is negative a multiple of 16 like numDisparities.
pub fn is_no_match(pixels: f64) -> bool {
    // A 16-bit number stores no lower one.
    let is = |pixels: f64| (-2049.0..0.0).contains(&pixels) && (pixels + 1.0) % 16.0 == 0.0;
    is(pixels) || is(pixels / 16.0)
}

/// The disparity as OpenCV's StereoBM and StereoSGBM store it, in sixteenths of a pixel.
///
/// ```
/// use depth_core::disparity::as_stored_by_opencv;
/// use depth_core::measured::Measured;
///
/// assert_eq!(as_stored_by_opencv(Measured::from_base(50.0, 0.5)), Measured::new(800.0, 8.0));
/// ```
///
/// Source: OpenCV, `StereoMatcher::DISP_SCALE`.
pub fn as_stored_by_opencv(disparity: Measured<Pixels>) -> Measured<f64> {
    let scale = 16.0;
    Measured::new(disparity.value.px() * scale, disparity.sigma.px() * scale)
}

/// The smallest numDisparities with which OpenCV's matchers find `disparity` from minDisparity 0 on: a multiple of 16 above it. `None`
/// where that would not fit into an image.
///
/// ```
/// use depth_core::disparity::num_disparities;
/// use depth_core::quantity::Pixels;
///
/// assert_eq!(num_disparities(Pixels::new(50.5)), Some(64));
/// assert_eq!(num_disparities(Pixels::new(64.0)), Some(80));
/// assert_eq!(num_disparities(Pixels::new(-3.0)), None);
/// ```
///
/// Source: OpenCV, `StereoSGBM`: numDisparities is divisible by 16, and disparities are below minDisparity + numDisparities.
pub fn num_disparities(disparity: Pixels) -> Option<u32> {
    (0..4096_u32)
        .map(|steps| (steps + 1) * 16)
        .find(|&range| disparity.px() >= 0.0 && f64::from(range) > disparity.px())
}

impl SubpixelBits {
    /// What to divide by.
    ///
    /// ```
    /// use depth_core::disparity::SubpixelBits;
    ///
    /// assert_eq!(SubpixelBits::Five.scale(), 32.0);
    /// ```
    pub const fn scale(self) -> f64 {
        match self {
            Self::Three => 8.0,
            Self::Four => 16.0,
            Self::Five => 32.0,
        }
    }
}

fn fixed_point(stored: f64, (lowest, highest): (f64, f64), invalid: f64, scale: f64) -> Result<f64, NoDisparity> {
    if !(lowest..=highest).contains(&stored) {
        Err(NoDisparity::OutOfRange)
    } else if stored.fract() != 0.0 {
        Err(NoDisparity::NotWhole)
    } else if stored == invalid {
        Err(NoDisparity::Invalid)
    } else {
        Ok(stored / scale)
    }
}

/// Disparity in pixels from the columns at which the same point is seen, d = x_left − x_right, with σ_d² = σ_l² + σ_r².
///
/// ```
/// use depth_core::disparity::from_columns;
/// use depth_core::measured::Measured;
///
/// let d = from_columns(Measured::from_base(660.0, 0.3), Measured::from_base(610.0, 0.4));
/// assert_eq!(d.value.px(), 50.0);
/// assert!((d.sigma.px() - 0.5).abs() < 1e-12);
/// ```
///
/// Source: the definition in ROS stereo_msgs/DisparityImage and Middlebury 2014, before any correction for the principal
/// points: that is [`doffs`].
pub fn from_columns(x_left: Measured<Pixels>, x_right: Measured<Pixels>) -> Measured<Pixels> {
    x_left.minus(x_right)
}

/// δ = cx_right − cx_left in pixels: what to add to a disparity where the principal points differ.
///
/// A disparity from ROS stereo_msgs/DisparityImage contains it already.
///
/// ```
/// use depth_core::disparity::doffs;
/// use depth_core::measured::Measured;
///
/// assert_eq!(doffs(Measured::from_base(610.0, 0.0), Measured::from_base(650.0, 0.0)).value.px(), 40.0);
/// ```
///
/// Source: Middlebury 2014 calibration format, `doffs`.
pub fn doffs(cx_left: Measured<Pixels>, cx_right: Measured<Pixels>) -> Measured<Pixels> {
    from_columns(cx_right, cx_left)
}
