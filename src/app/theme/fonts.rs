//! The fonts: one family for text, one for headings, names of fields and results, both with the symbols that Inter lacks.

use egui::{FontData, FontDefinitions, FontFamily, FontId};
use std::sync::Arc;

const SEMIBOLD: &str = "semibold";

const INTER_REGULAR: &[u8] = include_bytes!("../../../assets/fonts/Inter-Regular.ttf");
const INTER_SEMIBOLD: &[u8] = include_bytes!("../../../assets/fonts/Inter-SemiBold.ttf");

/// The files of the family Inter by their weights in CSS: what measures the pictures of a report is also what writes them.
pub const INTER: [(&str, &[u8]); 2] = [("400", INTER_REGULAR), ("600", INTER_SEMIBOLD)];

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

/// Gives `ctx` the fonts.
pub(super) fn install(ctx: &egui::Context) {
    const REGULAR: &str = "Inter";
    const SEMI: &str = "Inter SemiBold";
    const SYMBOLS: &str = "Symbols";
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [
        (REGULAR, INTER_REGULAR),
        (SEMI, INTER_SEMIBOLD),
        (SYMBOLS, include_bytes!("../../../assets/fonts/Symbols.ttf")),
    ] {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
    }
    // Inter SemiBold has what headings, names and results need; what somebody types may have other signs.
    let chain = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    fonts.families.insert(FontFamily::Proportional, chain(&[REGULAR, SYMBOLS]));
    fonts.families.insert(FontFamily::Monospace, chain(&[REGULAR, SYMBOLS]));
    fonts.families.insert(semibold(), chain(&[SEMI, REGULAR, SYMBOLS]));
    ctx.set_fonts(fonts);
}
