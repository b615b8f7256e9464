//! A figure as SVG, for paper and for files.

use crate::measure::{SUBSCRIPT_DROP, SUBSCRIPT_SIZE};
use crate::{Align, Figure, Fill, Ink, Point, Shape, Stroke, Words};
use std::fmt::Write as _;

/// The color of `ink` on white paper.
pub const fn on_paper(ink: Ink) -> &'static str {
    match ink {
        Ink::Text => "#12161c",
        Ink::Muted => "#535e6c",
        Ink::Stale => "#848d99",
        Ink::StaleTint => "#eceff3",
        Ink::Line => "#dce1e7",
        Ink::Border => "#848d99",
        Ink::Surface | Ink::Tip | Ink::OnStereo => "#ffffff",
        Ink::Band => "#eceff3",
        Ink::Stereo => "#1a62d6",
        Ink::StereoTint => "#dde9fc",
        Ink::StereoBand => "#bcd4f8",
        Ink::Monocular => "#d9730d",
        Ink::MonocularText => "#964b00",
        Ink::MonocularTint => "#fae8d6",
        Ink::Error => "#b42318",
        Ink::ShareFirst => "#414a57",
        Ink::ShareSecond => "#8b95a3",
        Ink::ShareThird => "#cbd1d9",
        Ink::ShareRest => "#e4e8ed",
    }
}

/// `figure` as an `svg` element, named `title` and described by `description`.
pub fn of(figure: &Figure, title: &str, description: &str) -> String {
    let mut svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" width="{w}" height="{h}" role="img" font-family="Inter, system-ui, sans-serif"><title>{}</title><desc>{}</desc>"#,
        escape(title),
        escape(description),
        w = short(figure.width),
        h = short(figure.height),
    );
    for shape in &figure.shapes {
        shape_into(&mut svg, shape);
    }
    svg.push_str("</svg>");
    svg
}

fn shape_into(svg: &mut String, shape: &Shape) {
    let written = match shape {
        Shape::Path {
            points,
            is_closed,
            fill,
            stroke,
        } => {
            let name = if *is_closed { "polygon" } else { "polyline" };
            let points: Vec<String> = points
                .iter()
                .map(|point| format!("{},{}", short(point.x), short(point.y)))
                .collect();
            write!(svg, r#"<{name} points="{}"{}/>"#, points.join(" "), paint(*fill, *stroke))
        }
        Shape::Rect {
            rect,
            radius,
            fill,
            stroke,
        } => write!(
            svg,
            r#"<rect x="{}" y="{}" width="{}" height="{}" rx="{}"{}/>"#,
            short(rect.left),
            short(rect.top),
            short(rect.width()),
            short(rect.height()),
            short(*radius),
            paint(*fill, *stroke)
        ),
        Shape::Circle {
            center,
            radius,
            fill,
            stroke,
        } => write!(
            svg,
            r#"<circle cx="{}" cy="{}" r="{}"{}/>"#,
            short(center.x),
            short(center.y),
            short(*radius),
            paint(*fill, *stroke)
        ),
        Shape::Text { at, align, words, size } => {
            text_into(svg, *at, *align, words, *size);
            Ok(())
        }
    };
    // Writing into a text cannot fail.
    debug_assert!(written.is_ok(), "a shape was not written");
}

fn text_into(svg: &mut String, at: Point, align: Align, words: &Words, size: f32) {
    let anchor = match align {
        Align::Left => "start",
        Align::Center => "middle",
        Align::Right => "end",
    };
    // The middle of the letters' height is 0.36 of their size above the line that they stand on.
    let baseline = at.y + 0.36 * size;
    let mut line = format!(
        r#"<text x="{}" y="{}" font-size="{}" text-anchor="{anchor}" xml:space="preserve">"#,
        short(at.x),
        short(baseline),
        short(size)
    );
    let mut lowered = 0.0;
    for run in &words.runs {
        let drop = if run.is_subscript { SUBSCRIPT_DROP * size } else { 0.0 };
        let mut looks = format!(r#" fill="{}""#, on_paper(run.ink));
        if run.is_strong {
            looks.push_str(r#" font-weight="600""#);
        }
        if run.is_subscript {
            looks.push_str(&format!(r#" font-size="{}""#, short(size * SUBSCRIPT_SIZE)));
        }
        if drop != lowered {
            looks.push_str(&format!(r#" dy="{}""#, short(drop - lowered)));
            lowered = drop;
        }
        line.push_str(&format!("<tspan{looks}>{}</tspan>", escape(&run.text)));
    }
    line.push_str("</text>");
    svg.push_str(&line);
}

fn paint(fill: Option<Fill>, stroke: Option<Stroke>) -> String {
    let mut looks = match fill {
        None => r#" fill="none""#.to_owned(),
        Some(fill) if fill.opacity >= 1.0 => format!(r#" fill="{}""#, on_paper(fill.ink)),
        Some(fill) => format!(r#" fill="{}" fill-opacity="{}""#, on_paper(fill.ink), short(fill.opacity)),
    };
    if let Some(stroke) = stroke {
        looks.push_str(&format!(
            r#" stroke="{}" stroke-width="{}""#,
            on_paper(stroke.ink),
            short(stroke.width)
        ));
        if let Some([dash, gap]) = stroke.dash {
            looks.push_str(&format!(r#" stroke-dasharray="{} {}""#, short(dash), short(gap)));
        }
    }
    looks
}

/// A coordinate with no more digits than anybody can see.
fn short(number: f32) -> String {
    let text = format!("{number:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// `text` between tags.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_from_a_file_cannot_break_out_of_the_picture() {
        let mut figure = Figure::new(10.0, 10.0);
        figure.text(Point::new(0.0, 0.0), Align::Left, Words::new("<script>&\"", Ink::Text), 12.0);
        let svg = of(&figure, "<b>", "\"");
        assert!(!svg.contains("<script") && !svg.contains("<b>"), "{svg}");
    }

    #[test]
    fn a_subscript_is_lowered_and_what_follows_it_is_not() {
        let mut figure = Figure::new(10.0, 10.0);
        let words = Words::symbol("w_img", Ink::Text).then(" = 1", Ink::Text);
        figure.text(Point::new(0.0, 0.0), Align::Left, words, 10.0);
        let svg = of(&figure, "", "");
        assert!(svg.contains(r#"dy="2""#) && svg.contains(r#"dy="-2""#), "{svg}");
    }
}
