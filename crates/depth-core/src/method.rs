//! [`Method`]: the two ways to a distance.

use crate::field::Field;

/// The two ways to a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Method {
    /// Two cameras: D = fx·b/d.
    Stereo,
    /// One camera and an object of known width: D = w_real·fx/w_img.
    Monocular,
}

impl Method {
    /// Both, stereo first.
    pub const ALL: [Self; 2] = [Self::Stereo, Self::Monocular];

    /// The inputs of the method, in reading order.
    ///
    /// ```
    /// use depth_core::problem::{Field, Method};
    ///
    /// assert_eq!(Method::Stereo.fields(), [Field::FocalLength, Field::Baseline, Field::Disparity]);
    /// ```
    pub const fn fields(self) -> [Field; 3] {
        match self {
            Self::Stereo => [Field::FocalLength, Field::Baseline, Field::Disparity],
            Self::Monocular => [Field::FocalLength, Field::ImageWidth, Field::RealWidth],
        }
    }

    /// The inputs that only this method uses: filling one of them means that the person wants this method.
    ///
    /// ```
    /// use depth_core::problem::{Field, Method};
    ///
    /// assert_eq!(Method::Monocular.own_fields(), [Field::ImageWidth, Field::RealWidth]);
    /// ```
    pub const fn own_fields(self) -> [Field; 2] {
        match self {
            Self::Stereo => [Field::Baseline, Field::Disparity],
            Self::Monocular => [Field::ImageWidth, Field::RealWidth],
        }
    }

    /// The inputs that may be left out, each with a value that it has then.
    ///
    /// ```
    /// use depth_core::problem::{Field, Method};
    ///
    /// assert!(Method::Stereo.optional_fields().contains(&Field::Doffs));
    /// assert!(Method::Monocular.optional_fields().contains(&Field::Tilt));
    /// ```
    pub const fn optional_fields(self) -> [Field; 4] {
        [self.own_optional_field(), Field::Lens, Field::Fy, Field::Zero]
    }

    /// That of them which only this method uses: doffs, or the tilt of the object.
    ///
    /// ```
    /// use depth_core::problem::{Field, Method};
    ///
    /// assert_eq!(Method::Stereo.own_optional_field(), Field::Doffs);
    /// ```
    pub const fn own_optional_field(self) -> Field {
        match self {
            Self::Stereo => Field::Doffs,
            Self::Monocular => Field::Tilt,
        }
    }

    /// What its equation can be solved for besides the distance, in reading order. A tilt is not among it: a width hardly depends
    /// on a small one.
    ///
    /// ```
    /// use depth_core::problem::{Field, Method};
    ///
    /// assert_eq!(Method::Stereo.unknowns().count(), 4);
    /// assert_eq!(Method::Monocular.unknowns().last(), Some(Field::RealWidth));
    /// ```
    pub fn unknowns(self) -> impl Iterator<Item = Field> {
        let doffs = Some(self.own_optional_field()).filter(|&field| field != Field::Tilt);
        self.fields().into_iter().chain(doffs)
    }
}
