//! The colors of the program: a palette for each theme, and the one that `ui` is drawn in.

use egui::{Color32, Id, Ui};

/// The colors of one theme.
///
/// Text has a contrast of at least 4.5:1 and the border of a control of at least 3:1 against what is behind it; a test
/// below computes them.
#[derive(Debug)]
pub struct Palette {
    /// Behind everything.
    pub page: Color32,
    /// Cards and bars.
    pub surface: Color32,
    /// The inside of a text field.
    pub field: Color32,
    /// A control under the pointer, or the chosen tab.
    pub highlight: Color32,
    /// Lines that only separate.
    pub line: Color32,
    /// The border of a control.
    pub border: Color32,
    /// Text.
    pub text: Color32,
    /// Hints and captions.
    pub muted: Color32,
    /// Stereo, links, the main button.
    pub blue: Color32,
    /// Text on the main button.
    pub on_blue: Color32,
    /// Behind selected text and the stereo badge.
    pub blue_tint: Color32,
    /// Monocular.
    pub orange: Color32,
    /// Text in the color of monocular.
    pub orange_text: Color32,
    /// Behind the monocular badge.
    pub orange_tint: Color32,
    /// Agreement, and what was solved for.
    pub green: Color32,
    /// Behind that.
    pub green_tint: Color32,
    /// Errors.
    pub red: Color32,
    /// Behind the badge of disagreement.
    pub red_tint: Color32,
    /// Warnings.
    pub amber: Color32,
    /// What holds no longer, in a picture.
    pub stale: Color32,
    /// Behind it.
    pub stale_tint: Color32,
    /// The shares of a budget, the largest first.
    pub shares: [Color32; 4],
}

/// The colors of the light theme.
pub(super) const LIGHT: Palette = Palette {
    page: Color32::from_rgb(0xf4, 0xf6, 0xf8),
    surface: Color32::WHITE,
    field: Color32::WHITE,
    highlight: Color32::from_rgb(0xec, 0xf0, 0xf5),
    line: Color32::from_rgb(0xdc, 0xe1, 0xe7),
    border: Color32::from_rgb(0x84, 0x8d, 0x99),
    text: Color32::from_rgb(0x12, 0x16, 0x1c),
    muted: Color32::from_rgb(0x53, 0x5e, 0x6c),
    blue: Color32::from_rgb(0x1a, 0x62, 0xd6),
    on_blue: Color32::WHITE,
    blue_tint: Color32::from_rgb(0xdd, 0xe9, 0xfc),
    orange: Color32::from_rgb(0xd9, 0x73, 0x0d),
    orange_text: Color32::from_rgb(0x96, 0x4b, 0x00),
    orange_tint: Color32::from_rgb(0xfa, 0xe8, 0xd6),
    green: Color32::from_rgb(0x15, 0x6b, 0x3d),
    green_tint: Color32::from_rgb(0xd7, 0xee, 0xe1),
    red: Color32::from_rgb(0xb4, 0x23, 0x18),
    red_tint: Color32::from_rgb(0xfb, 0xe3, 0xe0),
    amber: Color32::from_rgb(0x8a, 0x53, 0x00),
    stale: Color32::from_rgb(0x6b, 0x75, 0x82),
    stale_tint: Color32::from_rgb(0xec, 0xef, 0xf3),
    shares: [
        Color32::from_rgb(0x41, 0x4a, 0x57),
        Color32::from_rgb(0x8b, 0x95, 0xa3),
        Color32::from_rgb(0xcb, 0xd1, 0xd9),
        Color32::from_rgb(0xe4, 0xe8, 0xed),
    ],
};

/// The colors of the dark theme.
pub(super) const DARK: Palette = Palette {
    page: Color32::from_rgb(0x0e, 0x12, 0x16),
    surface: Color32::from_rgb(0x18, 0x1d, 0x23),
    field: Color32::from_rgb(0x0f, 0x13, 0x18),
    highlight: Color32::from_rgb(0x23, 0x2a, 0x33),
    line: Color32::from_rgb(0x2b, 0x33, 0x3d),
    border: Color32::from_rgb(0x6c, 0x77, 0x85),
    text: Color32::from_rgb(0xec, 0xef, 0xf3),
    muted: Color32::from_rgb(0x9f, 0xaa, 0xb8),
    blue: Color32::from_rgb(0x5c, 0x9d, 0xff),
    on_blue: Color32::from_rgb(0x07, 0x11, 0x20),
    blue_tint: Color32::from_rgb(0x1d, 0x33, 0x55),
    orange: Color32::from_rgb(0xf0, 0x99, 0x4a),
    orange_text: Color32::from_rgb(0xf5, 0xa9, 0x62),
    orange_tint: Color32::from_rgb(0x45, 0x2d, 0x17),
    green: Color32::from_rgb(0x5a, 0xd0, 0x9a),
    green_tint: Color32::from_rgb(0x16, 0x3a, 0x2a),
    red: Color32::from_rgb(0xff, 0x8a, 0x80),
    red_tint: Color32::from_rgb(0x48, 0x1f, 0x1c),
    amber: Color32::from_rgb(0xf0, 0xb4, 0x5a),
    stale: Color32::from_rgb(0x8d, 0x98, 0xa6),
    stale_tint: Color32::from_rgb(0x2b, 0x33, 0x3d),
    shares: [
        Color32::from_rgb(0xc3, 0xca, 0xd4),
        Color32::from_rgb(0x7a, 0x85, 0x93),
        Color32::from_rgb(0x46, 0x50, 0x5d),
        Color32::from_rgb(0x33, 0x3b, 0x46),
    ],
};

impl Palette {
    /// The color of the rig at a place of the list.
    pub fn rig(&self, at: usize) -> Color32 {
        let colors = [self.blue, self.orange_text, self.green, self.red, self.amber, self.muted];
        colors.get(at).copied().unwrap_or(self.text)
    }
}

/// What quiet text and lines become for who asks for more contrast: hints and examples 7:1, as WCAG 2.2 asks for at level AAA.
const fn with_more_contrast(usual: Palette, muted: Color32, line: Color32) -> Palette {
    Palette {
        line,
        border: muted,
        muted,
        stale: muted,
        ..usual
    }
}

/// The colors of the light theme with more contrast.
pub(super) const LIGHT_CONTRAST: Palette =
    with_more_contrast(LIGHT, Color32::from_rgb(0x2b, 0x33, 0x3d), Color32::from_rgb(0x84, 0x8d, 0x99));

/// The colors of the dark theme with more contrast.
pub(super) const DARK_CONTRAST: Palette =
    with_more_contrast(DARK, Color32::from_rgb(0xd3, 0xd9, 0xe1), Color32::from_rgb(0x6c, 0x77, 0x85));

/// The id under which the memory of egui holds the palettes of the light and the dark theme, where they are not the usual ones.
fn chosen_id() -> Id {
    Id::unique("chosen palettes")
}

/// Replaces the palettes of the light and the dark theme by these, or restores them.
pub(super) fn choose(ctx: &egui::Context, palettes: Option<[&'static Palette; 2]>) {
    ctx.data_mut(|data| match palettes {
        Some(palettes) => _ = data.insert_temp(chosen_id(), palettes),
        None => data.remove::<[&'static Palette; 2]>(chosen_id()),
    });
}

/// The colors of the theme that `ui` is drawn in.
pub fn palette(ui: &Ui) -> &'static Palette {
    let [light, dark] = ui.data(|data| data.get_temp(chosen_id())).unwrap_or([&LIGHT, &DARK]);
    if ui.visuals().dark_mode { dark } else { light }
}

/// Contrast of two colors as WCAG 2.2 defines it, from their relative luminance.
#[cfg(test)]
pub(super) fn contrast(a: Color32, b: Color32) -> f32 {
    let luminance = |color: Color32| {
        let [r, g, b, _] = egui::Rgba::from(color).to_array();
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_asks_for_more_contrast_gets_seven_to_one_for_hints_and_examples() {
        for (theme, p) in [("light", &LIGHT_CONTRAST), ("dark", &DARK_CONTRAST)] {
            for (name, back) in [
                ("page", p.page),
                ("card", p.surface),
                ("field", p.field),
                ("highlight", p.highlight),
            ] {
                let got = contrast(p.muted, back);
                assert!(got >= 7.0, "{theme}: a hint on {name} has {got:.2}");
            }
            assert!(contrast(p.border, p.field) >= 7.0 && contrast(p.line, p.surface) >= 3.0, "{theme}");
        }
    }

    #[test]
    fn text_and_borders_have_the_contrast_that_wcag_asks_for() {
        for (theme, p) in [("light", &LIGHT), ("dark", &DARK)] {
            for (name, front, back, least) in [
                ("text on page", p.text, p.page, 4.5),
                ("text on card", p.text, p.surface, 4.5),
                ("text on highlight", p.text, p.highlight, 4.5),
                ("text on selection", p.text, p.blue_tint, 4.5),
                ("muted on page", p.muted, p.page, 4.5),
                ("muted on card", p.muted, p.surface, 4.5),
                ("muted on highlight", p.muted, p.highlight, 4.5),
                ("muted in field", p.muted, p.field, 4.5),
                ("link on card", p.blue, p.surface, 4.5),
                ("link on page", p.blue, p.page, 4.5),
                ("main button", p.on_blue, p.blue, 4.5),
                ("stereo badge", p.blue, p.blue_tint, 4.5),
                ("monocular badge", p.orange_text, p.orange_tint, 4.5),
                ("agreement badge", p.green, p.green_tint, 4.5),
                ("disagreement badge", p.red, p.red_tint, 4.5),
                ("error", p.red, p.surface, 4.5),
                ("warning", p.amber, p.surface, 4.5),
                ("border on card", p.border, p.surface, 3.0),
                ("border on page", p.border, p.page, 3.0),
                ("border around field", p.border, p.field, 3.0),
                ("stereo bar", p.blue, p.surface, 3.0),
                ("monocular bar", p.orange, p.surface, 3.0),
            ] {
                let got = contrast(front, back);
                assert!(got >= least, "{theme}: {name} has {got:.2}, needs {least}");
            }
        }
    }
}
