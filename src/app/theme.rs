//! Every colour, size and spacing of the program, once, and the style and fonts that egui is given.

use egui::{Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Shadow, Stroke, TextStyle, vec2};
use std::sync::Arc;

/// The colours of one theme.
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
    /// Text in the colour of monocular.
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
}

const LIGHT: Palette = Palette {
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
};

const DARK: Palette = Palette {
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
};

/// Colours that a person has chosen for everything on the screen, by the names that CSS has for them.
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
    /// There are few of them, so what colour told apart is left to words, places and lines.
    fn palette(self) -> Palette {
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
            // The text that is selected keeps its colour, so what is behind it must not come too near.
            blue_tint: canvas.lerp_to_gamma(highlight, 0.3),
            orange: canvas_text,
            orange_text: canvas_text,
            orange_tint: canvas,
            green: canvas_text,
            green_tint: canvas,
            red: canvas_text,
            red_tint: canvas,
            amber: canvas_text,
        }
    }
}

fn forced_id() -> egui::Id {
    egui::Id::unique("palette of system colors")
}

/// The colours of the theme that `ui` is drawn in.
pub fn palette(ui: &egui::Ui) -> &'static Palette {
    match ui.data(|data| data.get_temp(forced_id())) {
        Some(forced) => forced,
        None if ui.visuals().dark_mode => &DARK,
        None => &LIGHT,
    }
}

/// The step that all distances are multiples of.
pub const STEP: f32 = 4.0;
/// Between cards, and from the cards to the edge of the window.
pub const GAP: f32 = 4.0 * STEP;
/// [`GAP`] on a phone.
pub const GAP_PHONE: f32 = 3.0 * STEP;
/// Inside a card.
pub const CARD_PADDING: i8 = 16;
/// The corners of a card.
pub const CARD_RADIUS: u8 = 10;
/// The corners of a control.
pub const CONTROL_RADIUS: u8 = 6;
/// Height of a control for the mouse.
pub const CONTROL_HEIGHT: f32 = 36.0;
/// Height of a control for a finger.
pub const CONTROL_HEIGHT_TOUCH: f32 = 44.0;
/// Width of the form beside the results.
pub const FORM_WIDTH: f32 = 372.0;
/// Height of a picture.
pub const PICTURE_HEIGHT: f32 = 216.0;
/// The widest the content grows.
pub const CONTENT_WIDTH: f32 = 1880.0;
/// The widest a column of text grows.
pub const TEXT_WIDTH: f32 = 720.0;

/// The number that answers the question.
pub const RESULT_SIZE: f32 = 34.0;
/// The unit behind it.
pub const RESULT_UNIT_SIZE: f32 = 18.0;
/// The heading of a card.
pub const CARD_HEADING_SIZE: f32 = 13.5;
/// Hints, captions and labels in pictures.
pub const SMALL_SIZE: f32 = 12.5;
/// Text.
pub const BODY_SIZE: f32 = 14.5;

const SEMIBOLD: &str = "semibold";

/// The family of headings, names of fields and results.
pub fn semibold() -> FontFamily {
    FontFamily::Name(SEMIBOLD.into())
}

/// Text of `size` in the semibold family.
pub fn strong(size: f32) -> FontId {
    FontId::new(size, semibold())
}

/// Text of `size` in the regular family.
pub fn regular(size: f32) -> FontId {
    FontId::new(size, FontFamily::Proportional)
}

/// How much room there is, and what fits into it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Everything in one column, controls for fingers, the result in a bar at the bottom.
    Phone,
    /// The form beside one column of results.
    Tablet,
    /// The form beside two columns of results.
    Desktop,
    /// The form beside three columns of results.
    Wide,
}

impl Layout {
    /// The layout for a window `width` points wide.
    pub fn of_width(width: f32) -> Self {
        match width {
            w if w < 720.0 => Self::Phone,
            w if w < 1080.0 => Self::Tablet,
            w if w < 1640.0 => Self::Desktop,
            _ => Self::Wide,
        }
    }

    /// Columns of cards in the results.
    pub const fn columns(self) -> usize {
        match self {
            Self::Phone | Self::Tablet => 1,
            Self::Desktop => 2,
            Self::Wide => 3,
        }
    }

    /// Between cards.
    pub const fn gap(self) -> f32 {
        match self {
            Self::Phone => GAP_PHONE,
            _ => GAP,
        }
    }

    /// Height of a control.
    pub const fn control_height(self) -> f32 {
        match self {
            // A window that narrow is a phone or a tablet as often as not.
            Self::Phone | Self::Tablet => CONTROL_HEIGHT_TOUCH,
            Self::Desktop | Self::Wide => CONTROL_HEIGHT,
        }
    }
}

/// Gives `ctx` the fonts and the style of both themes.
pub fn install(ctx: &egui::Context) {
    install_fonts(ctx);
    force(ctx, None);
}

/// Draws both themes in `colors`, or each in its own.
pub fn force(ctx: &egui::Context, colors: Option<SystemColors>) {
    // Leaked, because whoever draws keeps it: some bytes each time that a person chooses other colours.
    let forced = colors.map(|colors| &*Box::leak(Box::new(colors.palette())));
    ctx.data_mut(|data| match forced {
        Some(palette) => _ = data.insert_temp(forced_id(), palette),
        None => data.remove::<&'static Palette>(forced_id()),
    });
    for (theme, palette) in [(egui::Theme::Light, &LIGHT), (egui::Theme::Dark, &DARK)] {
        ctx.style_mut_of(theme, |style| set_style(style, forced.unwrap_or(palette)));
    }
}

fn install_fonts(ctx: &egui::Context) {
    const REGULAR: &str = "Inter";
    const SEMI: &str = "Inter SemiBold";
    const SYMBOLS: &str = "Symbols";
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [
        (REGULAR, &include_bytes!("../../assets/fonts/Inter-Regular.ttf")[..]),
        (SEMI, &include_bytes!("../../assets/fonts/Inter-SemiBold.ttf")[..]),
        (SYMBOLS, &include_bytes!("../../assets/fonts/Symbols.ttf")[..]),
    ] {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
    }
    let chain = |first: &str| vec![first.to_owned(), SYMBOLS.to_owned()];
    fonts.families.insert(FontFamily::Proportional, chain(REGULAR));
    fonts.families.insert(FontFamily::Monospace, chain(REGULAR));
    fonts.families.insert(semibold(), chain(SEMI));
    ctx.set_fonts(fonts);
}

fn set_style(style: &mut egui::Style, palette: &Palette) {
    style.text_styles = [
        (TextStyle::Small, regular(SMALL_SIZE)),
        (TextStyle::Body, regular(BODY_SIZE)),
        (TextStyle::Button, regular(BODY_SIZE)),
        (TextStyle::Monospace, FontId::new(BODY_SIZE, FontFamily::Monospace)),
        (TextStyle::Heading, strong(20.0)),
    ]
    .into();
    style.spacing.item_spacing = vec2(2.0 * STEP, STEP);
    style.spacing.button_padding = vec2(3.0 * STEP, STEP);
    style.spacing.interact_size = vec2(CONTROL_HEIGHT, CONTROL_HEIGHT);
    // Menus show all their choices where the window allows.
    style.spacing.combo_height = 440.0;
    style.spacing.menu_margin = Margin::same(6);
    style.spacing.scroll = egui::style::ScrollStyle::thin();
    style.interaction.selectable_labels = true;

    let visuals = &mut style.visuals;
    visuals.override_text_color = None;
    visuals.panel_fill = palette.page;
    visuals.window_fill = palette.surface;
    visuals.window_stroke = Stroke::new(1.0, palette.line);
    visuals.window_corner_radius = CornerRadius::same(CARD_RADIUS);
    visuals.menu_corner_radius = CornerRadius::same(CONTROL_RADIUS);
    visuals.popup_shadow = Shadow {
        offset: [0, 4],
        blur: 16,
        spread: 0,
        color: Color32::from_black_alpha(48),
    };
    visuals.extreme_bg_color = palette.field;
    visuals.text_edit_bg_color = Some(palette.field);
    visuals.faint_bg_color = palette.highlight;
    visuals.code_bg_color = palette.highlight;
    visuals.hyperlink_color = palette.blue;
    visuals.warn_fg_color = palette.amber;
    visuals.error_fg_color = palette.red;
    visuals.weak_text_color = Some(palette.muted);
    visuals.selection.bg_fill = palette.blue_tint;
    visuals.selection.stroke = Stroke::new(2.0, palette.blue);
    visuals.text_cursor.stroke = Stroke::new(2.0, palette.blue);
    // A caret that blinks would draw the page twice a second for ever.
    visuals.text_cursor.blink = false;
    let control = |widget: &mut egui::style::WidgetVisuals, fill, border: Stroke| {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = border;
        widget.fg_stroke = Stroke::new(1.0, palette.text);
        widget.corner_radius = CornerRadius::same(CONTROL_RADIUS);
        widget.expansion = 0.0;
    };
    let widgets = &mut visuals.widgets;
    control(&mut widgets.noninteractive, palette.surface, Stroke::new(1.0, palette.line));
    control(&mut widgets.inactive, palette.surface, Stroke::new(1.0, palette.border));
    control(&mut widgets.hovered, palette.highlight, Stroke::new(1.0, palette.text));
    control(&mut widgets.active, palette.highlight, Stroke::new(2.0, palette.blue));
    control(&mut widgets.open, palette.highlight, Stroke::new(1.0, palette.blue));
}

/// A card: a rounded surface with a thin line around it.
pub fn card(palette: &Palette) -> egui::Frame {
    egui::Frame::new()
        .fill(palette.surface)
        .stroke(Stroke::new(1.0, palette.line))
        .corner_radius(CARD_RADIUS)
        .inner_margin(Margin::same(CARD_PADDING))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance and contrast as WCAG 2.2 defines them.
    fn contrast(a: Color32, b: Color32) -> f32 {
        let luminance = |color: Color32| {
            let [r, g, b, _] = egui::Rgba::from(color).to_array();
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// Themes like those of high contrast that Windows 11 comes with.
    #[test]
    fn chosen_colours_stay_legible() {
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
