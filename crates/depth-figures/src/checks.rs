//! What holds of every picture, for tests.

use crate::{Align, Figure, InterWidths, Measure, Point, Rect, Shape};
use depth_core::problem::{Field, Problem, Solution};

/// fx, b, d, w_img, w_real, each with its σ.
pub(crate) type Inputs = [(f64, f64); 5];

/// The mug of the examples.
pub(crate) const MUG: Inputs = [(700.0, 2.0), (0.1, 0.0005), (50.0, 0.5), (150.0, 2.0), (0.3, 0.01)];

/// What is solved from `inputs`, of which NaN is not known.
pub(crate) fn solved(inputs: Inputs) -> Solution {
    let fields = [
        Field::FocalLength,
        Field::Baseline,
        Field::Disparity,
        Field::ImageWidth,
        Field::RealWidth,
    ];
    let mut problem = Problem::default();
    for (field, (value, sigma)) in fields.into_iter().zip(inputs) {
        problem.set(field, (!value.is_nan()).then_some(value));
        problem.set_sigma(field, sigma);
    }
    problem.solve()
}

/// Cases that a picture must survive: tiny and huge σ, none, disagreement, tiny and huge distances, one method only.
pub(crate) fn cases() -> Vec<(&'static str, Solution)> {
    let with = |changes: &[(usize, (f64, f64))]| {
        let mut inputs = MUG;
        for &(index, input) in changes {
            *inputs.get_mut(index).unwrap() = input;
        }
        solved(inputs)
    };
    let none = (f64::NAN, 0.0);
    vec![
        ("mug", with(&[])),
        ("nothing", Problem::default().solve()),
        ("no σ", solved(MUG.map(|(value, _)| (value, 0.0)))),
        ("σ of 1 ppm", solved(MUG.map(|(value, _)| (value, value * 1e-6)))),
        ("σ of 1e-12", solved(MUG.map(|(value, _)| (value, value * 1e-12)))),
        ("d 50 ± 20", with(&[(2, (50.0, 20.0))])),
        ("d 50 ± 60", with(&[(2, (50.0, 60.0))])),
        ("w_img 150 ± 120", with(&[(3, (150.0, 120.0))])),
        ("10 times as far", with(&[(4, (3.0, 0.1))])),
        ("10 times as near", with(&[(4, (0.03, 0.001))])),
        ("21 % farther", with(&[(4, (0.363, 0.001)), (3, (150.0, 0.1))])),
        ("1e9 times as far", with(&[(4, (3e8, 1e6))])),
        ("1e-6 m", with(&[(1, (1e-7, 1e-9)), (4, (3e-7, 1e-8))])),
        ("1e7 m", with(&[(1, (1e6, 5e3)), (4, (2.9e6, 1e5))])),
        ("1e200 m", with(&[(1, (1e199, 5e197)), (4, (2.9e199, 1e198))])),
        ("stereo", with(&[(3, none), (4, none)])),
        ("monocular", with(&[(1, none), (2, none)])),
        ("d −12", with(&[(2, (-12.0, 0.5))])),
        ("no d", with(&[(2, none)])),
        ("d 0.3 ± 0.5", with(&[(2, (0.3, 0.5))])),
        ("d 4000", with(&[(2, (4000.0, 0.5))])),
    ]
}

/// Panics where `figure` draws outside of itself, or text over text.
pub(crate) fn assert_tidy(figure: &Figure, what: &str) {
    let all = Rect::new(0.0, 0.0, figure.width, figure.height);
    let mut texts: Vec<(Rect, String)> = Vec::new();
    for shape in &figure.shapes {
        let bounds = bounds(shape);
        let is_inside =
            bounds.left >= all.left - 0.6 && bounds.top >= -0.6 && bounds.right <= all.right + 0.6 && bounds.bottom <= all.bottom + 0.6;
        assert!(is_inside, "{what}: {shape:?} at {bounds:?} leaves {all:?}");
        if let Shape::Text { words, .. } = shape {
            let text = words.text();
            for (other, said) in &texts {
                assert!(!other.overlaps(bounds), "{what}: “{text}” is over “{said}”: {bounds:?}, {other:?}");
            }
            texts.push((bounds, text));
        }
    }
}

/// What a shape covers.
pub(crate) fn bounds(shape: &Shape) -> Rect {
    let of = |points: &[Point], half: f32| {
        let mut rect = Rect::new(f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY);
        for point in points {
            assert!(point.x.is_finite() && point.y.is_finite(), "{shape:?}");
            rect.left = rect.left.min(point.x - half);
            rect.right = rect.right.max(point.x + half);
            rect.top = rect.top.min(point.y - half);
            rect.bottom = rect.bottom.max(point.y + half);
        }
        rect
    };
    match shape {
        // The ends of lines are cut off straight.
        Shape::Path { points, .. } => of(points, 0.0),
        Shape::Rect { rect, .. } => of(&[Point::new(rect.left, rect.top), Point::new(rect.right, rect.bottom)], 0.0),
        Shape::Circle {
            center, radius, stroke, ..
        } => of(&[*center], radius + stroke.map_or(0.0, |stroke| stroke.width / 2.0)),
        Shape::Text { at, align, words, size } => {
            let width = InterWidths.width(words, *size);
            let left = match align {
                Align::Left => at.x,
                Align::Center => at.x - width / 2.0,
                Align::Right => at.x - width,
            };
            Rect::new(left, at.y - 0.45 * size, left + width, at.y + 0.45 * size)
        }
    }
}
