//! Literals that must and must not be found.

use super::{Literal, in_tokens, sentences, source};

fn found(text: &str) -> Vec<(usize, Literal)> {
    source::parse(text).map(|tokens| in_tokens(&tokens)).unwrap_or_default()
}

#[test]
fn colors_are_found_with_their_lines() {
    for color in [
        "egui::Color32::from_rgb(1, 2, 3)",
        "Color32::from_gray(9)",
        "Color32::RED",
        "Color32::from_hex(\"#123456\")",
        "Rgba::from_rgb(0.1, red, 0.3)",
        "egui::hex_color!(\"#123456\")",
    ] {
        let lines: Vec<usize> = found(&format!("fn f() {{\n    paint({color});\n}}"))
            .into_iter()
            .map(|(line, _)| line)
            .collect();
        assert_eq!(lines, [2], "{color}");
    }
    for none in [
        "Color32::TRANSPARENT",
        "Color32::from_rgb(r, g, b)",
        "palette.blue",
        "\"Color32::RED\"",
    ] {
        assert_eq!(found(&format!("fn f() {{ paint({none}); }}")), [], "{none}");
    }
}

#[test]
fn sizes_in_points_are_found() {
    for size in [
        "FontId::proportional(17.0)",
        "egui::FontId::new(17.0, family)",
        "RichText::new(text).size(17.0)",
        "theme::strong(17.0)",
        "regular(13)",
        "egui::Stroke::new(1.5, palette.line)",
        "frame.corner_radius(6)",
        "painter.rect_filled(rect.expand(padding), 3.0, palette.surface)",
        "painter.circle_filled(at, 4.5, color)",
        "painter.circle(at, 7.0, fill, stroke)",
        "Shape::dashed_line(&points, stroke, dash, 3.0)",
        "job.append(text, 2.0, format)",
        "ui.add_space(4.0)",
        "vec2(12.0, height)",
        "egui::vec2(0.0, -1.0)",
        "Vec2::splat(12_f32)",
        "Margin::symmetric(margin, 4)",
        "egui::Margin { left: 14, right, top: 0, bottom: 0 }",
        "frame.inner_margin(6)",
        "ui.set_width(300.0)",
        "ui.allocate_exact_size(vec2(ui.available_width(), 120.0), Sense::hover())",
        "line.width(2.5)",
        "rect.expand(2.0)",
        "rect.shrink(0.5)",
        "DialogFrame { id, max_width: 640.0 }",
        "width.min(300.0)",
        "rect.right() - 8.0",
        "14.0 + at.x",
        "frame.bottom() - 12.0 - height",
        "x - 5.0..=x",
    ] {
        assert_eq!(found(&format!("fn f() {{ draw({size}); }}")).len(), 1, "{size}");
    }
}

#[test]
fn names_ratios_and_zero_are_no_sizes() {
    for none in [
        "theme::strong(theme::BODY_SIZE)",
        "theme::strong(if big { 2.0 } else { 1.0 })",
        "galley.size()",
        "ui.add_space(2.0 * theme::STEP)",
        "ui.add_space(0.0)",
        "ui.add_space(theme::STEP)",
        "vec2(0.0, height)",
        "vec2(rect.width() * 0.36, -up)",
        "Vec2::splat(1_000.0 * STEP)",
        "Margin { left: margin, bottom: 0, ..Margin::ZERO }",
        "bar.width(0.56)",
        "rect.expand(3.0 * WIDTH)",
        "value.max(1.0)",
        "end(length).min(2.0)",
        "DialogFrame { id, max_width: theme::ABOUT_WIDTH }",
        "Rect { width: f32::MAX }",
        "columns - 2",
        "x - 0.06",
        "1.0 - share",
        "value * (1.0 + 1e-9)",
        "rect.width() - 2.0 * side",
        "total / 100.0 - rest",
        "-2.5",
        "1.0..=-4.0",
        "width < 480.0",
        "painter.rect_filled(rect, 0.0, color)",
        "Stroke::new(width, color)",
        "tree.strong(17.0)",
    ] {
        assert_eq!(found(&format!("fn f() {{ draw({none}); }}")), [], "{none}");
    }
}

#[test]
fn sizes_that_are_assigned_are_found() {
    for size in [
        "ui.spacing_mut().item_spacing.x = 6.0;",
        "ui.spacing_mut().item_spacing = vec2(6.0, STEP);",
        "const GAP: f32 = 6.0;",
        "const MARGIN: i8 = 6;",
    ] {
        assert_eq!(found(&format!("fn f() {{ {size} }}")).len(), 1, "{size}");
    }
    for none in [
        "ui.spacing_mut().item_spacing.x = 0.0;",
        "ui.spacing_mut().item_spacing.x = gap;",
        "ui.spacing_mut().item_spacing.x = 2.0 * theme::STEP;",
        "const COUNT: usize = 6;",
        "const NAME: &str = \"6.0\";",
        "const FULL: f32 = 0.0;",
    ] {
        assert_eq!(found(&format!("fn f() {{ {none} }}")), [], "{none}");
    }
}

#[test]
fn one_color_or_one_size_more_than_are_left_is_named_with_its_line() {
    let color = ("a.rs".to_owned(), 3, Literal::Color("Color32::RED".to_owned()));
    let size = ("b.rs".to_owned(), 4, Literal::Size("Stroke::new".to_owned(), "1.5".to_owned()));
    let found = [color, size];
    assert_eq!(
        sentences(&found, 1),
        ["a.rs:3 has the color Color32::RED: give it a name in the theme."]
    );
    assert_eq!(
        sentences(&found, 0).get(1).map(String::as_str),
        Some("b.rs:4 has the size 1.5 in Stroke::new: give it a name in the theme.")
    );
}

#[test]
fn tests_may_have_literals() {
    assert_eq!(found("#[cfg(test)] mod tests { fn f() { Color32::RED; } }"), []);
}
