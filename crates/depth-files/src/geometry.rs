//! Where cameras are to each other.
//!
//! Source: Hartley, Zisserman: Multiple View Geometry, 2nd ed., section 6.1: a camera that sees a point X at R·X + t stands at −Rᵀ·t.

use crate::format::Format;
use crate::node::Node;
use crate::refusal::Refusal;

/// A place or a direction.
pub(crate) type Vector = [f64; 3];

/// A rotation and a shift: a point X of one frame is at R·X + t in another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transform {
    rotation: [Vector; 3],
    pub(crate) shift: Vector,
}

impl Transform {
    pub(crate) const fn new(rotation: [Vector; 3], shift: Vector) -> Self {
        Self { rotation, shift }
    }

    /// Of a 4 × 4 matrix, row after row.
    pub(crate) fn read(node: &Node, format: Format, name: &str) -> Result<Self, Refusal> {
        let [a, b, c, x, d, e, f, y, g, h, i, z, ..] = node.array::<16>(format, name, "16")?;
        Ok(Self {
            rotation: [[a, b, c], [d, e, f], [g, h, i]],
            shift: [x, y, z],
        })
    }

    /// The way back, of a rotation that is one: (Rᵀ, −Rᵀ·t).
    pub(crate) fn inverse(self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        Self {
            rotation: [[a, d, g], [b, e, h], [c, f, i]],
            shift: self.origin(),
        }
    }

    /// First `before`, then this one.
    pub(crate) fn after(self, before: Self) -> Self {
        let product = |row: Vector, column: Vector| {
            let ([a, b, c], [x, y, z]) = (row, column);
            a * x + b * y + c * z
        };
        let [[a, b, c], [d, e, f], [g, h, i]] = before.rotation;
        let columns = [[a, d, g], [b, e, h], [c, f, i]];
        let [x, y, z] = self.shift;
        let [u, v, w] = self.rotation.map(|row| product(row, before.shift));
        Self {
            rotation: self.rotation.map(|row| columns.map(|column| product(row, column))),
            shift: [u + x, v + y, w + z],
        }
    }

    /// Where the origin of the other frame is in the first: −Rᵀ·t.
    pub(crate) fn origin(self) -> Vector {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        let [x, y, z] = self.shift;
        [-(a * x + d * y + g * z), -(b * x + e * y + h * z), -(c * x + f * y + i * z)]
    }
}

pub(crate) fn distance(from: Vector, to: Vector) -> f64 {
    let [x, y, z] = from;
    let [u, v, w] = to;
    length([u - x, v - y, w - z])
}

pub(crate) fn length([x, y, z]: Vector) -> f64 {
    x.hypot(y).hypot(z)
}

#[cfg(test)]
mod tests {
    use super::{Transform, distance, length};

    /// A quarter turn about the axis of sight, and a shift: in a drawing, x goes to y and y to −x.
    const QUARTER: Transform = Transform::new([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [1.0, 2.0, 3.0]);

    #[test]
    fn there_and_back_is_nowhere_else() {
        assert!(length(QUARTER.inverse().after(QUARTER).shift) < 1e-15);
        assert!(length(QUARTER.after(QUARTER.inverse()).shift) < 1e-15);
    }

    #[test]
    fn the_second_of_two_steps_turns_the_first() {
        // (1, 2, 3) turned is (−2, 1, 3); with (1, 2, 3) more it is (−1, 3, 6).
        assert!(distance(QUARTER.after(QUARTER).shift, [-1.0, 3.0, 6.0]) < 1e-15);
    }
}
