//! What a person wants of all colors on the screen.

use super::palette::Palette;
use egui::Color32;

/// What a person wants of all colors on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colors {
    /// Nothing else than what is usual.
    #[default]
    Usual,
    /// Quiet text and lines that stand out more.
    MoreContrast,
    /// These for everything.
    Chosen(SystemColors),
}

/// Colors that a person has chosen for everything on the screen, by the names that CSS has for them.
///
/// Source: CSS Color Module Level 4, 6.2 "System Colors".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SystemColors {
    /// Behind everything.
    pub canvas: Color32,
    /// Text on it.
    pub canvas_text: Color32,
    /// A link on it.
    pub link_text: Color32,
    /// Behind selected text.
    pub highlight: Color32,
    /// The border of a control.
    pub button_border: Color32,
}

impl SystemColors {
    /// The colors, each as the computed style of an element has it that is given the name: `color_of("Canvas")`. `None` where
    /// one is missing or in another form than `rgb(255, 255, 255)`.
    pub fn from_css(color_of: impl Fn(&str) -> Option<String>) -> Option<Self> {
        let color = |name| from_rgb(&color_of(name)?);
        Some(Self {
            canvas: color("Canvas")?,
            canvas_text: color("CanvasText")?,
            link_text: color("LinkText")?,
            highlight: color("Highlight")?,
            button_border: color("ButtonBorder")?,
        })
    }

    /// They are fewer than the colors of a palette, so some things differ only in words, positions and lines.
    pub(super) fn palette(self) -> Palette {
        let Self {
            canvas,
            canvas_text,
            link_text,
            highlight,
            button_border,
        } = self;
        Palette {
            page: canvas,
            surface: canvas,
            field: canvas,
            highlight: canvas,
            // A line behind a number must not strike it through.
            line: canvas.lerp_to_gamma(canvas_text, 0.35),
            border: button_border,
            text: canvas_text,
            muted: canvas_text,
            blue: link_text,
            on_blue: canvas,
            // The text that is selected keeps its color, so what is behind it must not come too near.
            blue_tint: canvas.lerp_to_gamma(highlight, 0.3),
            orange: canvas_text,
            orange_text: canvas_text,
            orange_tint: canvas,
            green: canvas_text,
            green_tint: canvas,
            red: canvas_text,
            red_tint: canvas,
            amber: canvas_text,
            stale: canvas_text,
            stale_tint: canvas,
            shares: [0.8, 0.55, 0.35, 0.2].map(|share| canvas.lerp_to_gamma(canvas_text, share)),
        }
    }
}

/// A color as computed styles have it, `rgb(255, 255, 255)`.
fn from_rgb(text: &str) -> Option<Color32> {
    let inside = text.split_once('(')?.1.trim_end_matches(')');
    let mut numbers = inside.split(',').map(|number| number.trim().parse::<u8>().ok());
    Some(Color32::from_rgb(numbers.next()??, numbers.next()??, numbers.next()??))
}

#[cfg(test)]
mod tests {
    use super::super::palette::contrast;
    use super::*;

    /// Themes like those of high contrast that Windows 11 comes with.
    #[test]
    fn chosen_colors_stay_legible() {
        let rgb = |hex: u32| {
            let [_, r, g, b] = hex.to_be_bytes();
            Color32::from_rgb(r, g, b)
        };
        for (name, [canvas, canvas_text, link_text, highlight, button_border]) in [
            ("Aquatic", [0x0020_2020, 0x00ff_ffff, 0x0075_e9fc, 0x008e_e3f0, 0x00ff_ffff]),
            ("Desert", [0x00ff_faef, 0x003d_3d3d, 0x001c_5e75, 0x0090_3909, 0x0020_2020]),
            ("Dusk", [0x002d_3236, 0x00ff_ffff, 0x0070_ebde, 0x00a1_bfde, 0x00b6_f6f0]),
            ("Night sky", [0x0000_0000, 0x00ff_ffff, 0x0080_80ff, 0x00d6_b4fd, 0x00ff_ee32]),
        ] {
            let colors = SystemColors {
                canvas: rgb(canvas),
                canvas_text: rgb(canvas_text),
                link_text: rgb(link_text),
                highlight: rgb(highlight),
                button_border: rgb(button_border),
            };
            let p = colors.palette();
            for (what, front, back) in [
                ("text", p.text, p.page),
                ("selected text", p.text, p.blue_tint),
                ("link", p.blue, p.surface),
                ("main button", p.on_blue, p.blue),
                ("error", p.red, p.surface),
            ] {
                let got = contrast(front, back);
                assert!(got >= 4.5, "{name}: {what} has {got:.2}");
            }
            assert!(contrast(p.border, p.field) >= 3.0, "{name}: border");
        }
    }

    #[test]
    fn colors_are_read_as_browsers_write_them() {
        let color_of = |name: &str| Some(if name == "LinkText" { "rgb(117, 233, 252)" } else { "rgb(0, 0, 0)" }.to_owned());
        let colors = SystemColors::from_css(color_of);
        assert_eq!(
            colors.map(|colors| (colors.canvas, colors.link_text)),
            Some((Color32::BLACK, Color32::from_rgb(117, 233, 252)))
        );
        for text in ["", "black", "rgb(1, 2)", "rgb(1, 2, 300)", "color(srgb 0 0 0)"] {
            assert_eq!(SystemColors::from_css(|_| Some(text.to_owned())), None, "{text}");
        }
    }
}
