//! What egui is given: fonts, and the style of both themes.

use super::fonts::{self, regular, strong};
use super::palette::{self, DARK, DARK_CONTRAST, LIGHT, LIGHT_CONTRAST, Palette};
use super::sizes::{
    BODY_SIZE, CARD_PADDING, CARD_RADIUS, CONTROL_HEIGHT, CONTROL_RADIUS, HEADING_SIZE, MENU_HEIGHT, MENU_MARGIN, SMALL_SIZE, STEP,
};
use super::system_colors::Colors;
use egui::{Color32, Context, CornerRadius, FontFamily, FontId, Frame, Margin, Shadow, Stroke, Style, TextStyle, Theme, vec2};

/// Gives `ctx` the fonts and the style of both themes.
pub fn install(ctx: &Context) {
    fonts::install(ctx);
    color(ctx, Colors::Usual);
}

/// Draws both themes in these colors.
pub fn color(ctx: &Context, colors: Colors) {
    let palettes = match colors {
        Colors::Usual => None,
        Colors::MoreContrast => Some([&LIGHT_CONTRAST, &DARK_CONTRAST]),
        // Leaked, because the memory of egui holds a `'static` reference to it: a few bytes each time that a person chooses other ones.
        Colors::Chosen(colors) => Some([&*Box::leak(Box::new(colors.palette())); 2]),
    };
    palette::choose(ctx, palettes);
    let [light, dark] = palettes.unwrap_or([&LIGHT, &DARK]);
    for (theme, palette) in [(Theme::Light, light), (Theme::Dark, dark)] {
        ctx.style_mut_of(theme, |style| set_style(style, palette));
    }
}

fn set_style(style: &mut Style, palette: &Palette) {
    style.text_styles = [
        (TextStyle::Small, regular(SMALL_SIZE)),
        (TextStyle::Body, regular(BODY_SIZE)),
        (TextStyle::Button, regular(BODY_SIZE)),
        (TextStyle::Monospace, FontId::new(BODY_SIZE, FontFamily::Monospace)),
        (TextStyle::Heading, strong(HEADING_SIZE)),
    ]
    .into();
    style.spacing.item_spacing = vec2(2.0 * STEP, STEP);
    style.spacing.button_padding = vec2(3.0 * STEP, STEP);
    style.spacing.interact_size = vec2(CONTROL_HEIGHT, CONTROL_HEIGHT);
    // Menus show all their choices where the window allows.
    style.spacing.combo_height = MENU_HEIGHT;
    style.spacing.menu_margin = Margin::same(MENU_MARGIN);
    set_scroll(&mut style.spacing.scroll);
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
    // The page leaves out what would hint letters: 22 kB of its download for a difference that only a coarse screen shows.
    visuals.text_options.font_hinting = false;
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

fn set_scroll(scroll: &mut egui::style::ScrollStyle) {
    *scroll = egui::style::ScrollStyle::thin();
    // What is below the edge is cut by a line, not faded: bars and buttons keep their contrast.
    scroll.fade.strength = 0.0;
    // The bar alone, without a track.
    scroll.foreground_color = true;
    scroll.dormant_handle_opacity = 0.25;
    scroll.active_handle_opacity = 0.5;
    scroll.dormant_background_opacity = 0.0;
    scroll.active_background_opacity = 0.0;
    scroll.interact_background_opacity = 0.0;
}

/// A card: a rounded surface with a thin line around it.
pub fn card(palette: &Palette) -> Frame {
    Frame::new()
        .fill(palette.surface)
        .stroke(Stroke::new(1.0, palette.line))
        .corner_radius(CARD_RADIUS)
        .inner_margin(Margin::same(CARD_PADDING))
}
