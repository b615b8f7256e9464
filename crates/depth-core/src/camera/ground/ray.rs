//! The ray of a point that meets its plane: the results along it, each with its derivatives.

use crate::arithmetic::root_sum_of_squares;
use crate::judge::{Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::Length;

/// A result with its derivatives.
pub(super) struct Partials {
    pub(super) value: f64,
    pub(super) per_meter_of_height: f64,
    pub(super) per_radian_of_pitch: f64,
    /// With respect to the slope y.
    pub(super) per_slope: f64,
    /// With respect to the slope x.
    pub(super) per_slope_right: f64,
}

/// The ray of a point that meets its plane.
pub(super) struct Ray {
    /// (u − cx)/fx
    pub(super) x: f64,
    /// (v − cy)/fy
    pub(super) y: f64,
    /// Height of the camera above the plane, m; negative below it.
    pub(super) h: f64,
    /// cos θ
    pub(super) cos: f64,
    /// How far the ray (x, y, 1) goes down: sin θ + y·cos θ.
    pub(super) down: f64,
    /// How far it goes ahead: cos θ − y·sin θ.
    pub(super) forward: f64,
    /// At which multiple of (x, y, 1) it meets the plane, m.
    pub(super) s: f64,
    pub(super) sigmas: Sigmas,
}

/// The σ of what a ray depends on.
pub(super) struct Sigmas {
    pub(super) height: f64,
    pub(super) pitch: f64,
    pub(super) slope: f64,
    /// What the focal length does to both slopes, together.
    pub(super) focal_slope: f64,
    pub(super) focal_slope_right: f64,
}

impl Ray {
    pub(super) fn ahead(&self) -> Partials {
        let Self {
            y, h, down, forward, s, ..
        } = *self;
        Partials {
            value: s * forward,
            per_meter_of_height: s * forward / h,
            per_radian_of_pitch: -(s / down) * (1.0 + y * y),
            per_slope: -s / down,
            per_slope_right: 0.0,
        }
    }

    pub(super) fn right(&self) -> Partials {
        let Self {
            x,
            h,
            cos,
            down,
            forward,
            s,
            ..
        } = *self;
        Partials {
            value: s * x,
            per_meter_of_height: s * x / h,
            per_radian_of_pitch: -(s / down) * x * forward,
            per_slope: -(s / down) * x * cos,
            per_slope_right: s,
        }
    }

    pub(super) fn depth(&self) -> Partials {
        let Self {
            h, cos, down, forward, s, ..
        } = *self;
        Partials {
            value: s,
            per_meter_of_height: s / h,
            per_radian_of_pitch: -(s / down) * forward,
            per_slope: -(s / down) * cos,
            per_slope_right: 0.0,
        }
    }

    pub(super) fn slant(&self) -> Partials {
        let Self {
            x,
            y,
            h,
            cos,
            down,
            forward,
            s,
            ..
        } = *self;
        let length = root_sum_of_squares(&[1.0, x, y]);
        Partials {
            value: s * length,
            per_meter_of_height: s * length / h,
            per_radian_of_pitch: -(s / down) * length * forward,
            per_slope: -(s / down) * length * cos + s * y / length,
            per_slope_right: s * x / length,
        }
    }

    /// What each term adds to the σ of a result: height, pitch, slope and focal length.
    pub(super) fn shares(&self, of: &Partials) -> [f64; 4] {
        let sigmas = &self.sigmas;
        [
            of.per_meter_of_height * sigmas.height,
            of.per_radian_of_pitch * sigmas.pitch,
            of.per_slope * sigmas.slope,
            of.per_slope * sigmas.focal_slope + of.per_slope_right * sigmas.focal_slope_right,
        ]
    }

    /// A result with its σ.
    pub(super) fn measured(&self, of: &Partials) -> Result<Measured<Length>, Unsolvable> {
        let sigma = root_sum_of_squares(&self.shares(of));
        if of.value.is_finite() && sigma.is_finite() {
            Ok(Measured::from_base(of.value, sigma))
        } else {
            Err(Unsolvable::too_extreme(Term::Distance))
        }
    }
}

/// √(ahead² + right²) with its derivatives. At the point below the camera, where it has none, the length of those of both.
pub(super) fn along_floor(ahead: &Partials, right: &Partials) -> Partials {
    let value = root_sum_of_squares(&[ahead.value, right.value]);
    let derivative = |of_ahead: f64, of_right: f64| {
        if value == 0.0 {
            root_sum_of_squares(&[of_ahead, of_right])
        } else {
            ahead.value / value * of_ahead + right.value / value * of_right
        }
    };
    Partials {
        value,
        per_meter_of_height: derivative(ahead.per_meter_of_height, right.per_meter_of_height),
        per_radian_of_pitch: derivative(ahead.per_radian_of_pitch, right.per_radian_of_pitch),
        per_slope: derivative(ahead.per_slope, right.per_slope),
        per_slope_right: derivative(ahead.per_slope_right, right.per_slope_right),
    }
}
