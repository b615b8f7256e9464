//! Text as large as it is painted, so that what a browser marks in it covers the painted words.

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{CanvasRenderingContext2d, Document, HtmlCanvasElement, HtmlElement};

use super::host::FONT_SIZE;
use crate::element::Lettering;

/// Measures text in the font of the mirror, without a layout of the page.
pub(crate) struct Measure {
    context: CanvasRenderingContext2d,
}

/// The style of text of which nothing is known.
const PLAIN: [(&str, &str); 5] = [
    ("white-space", "nowrap"),
    ("font-size", "inherit"),
    ("line-height", "normal"),
    ("padding-left", "0"),
    ("padding-top", "0"),
];

impl Measure {
    pub(crate) fn new(document: &Document) -> Option<Self> {
        let canvas: HtmlCanvasElement = document.create_element("canvas").ok()?.dyn_into().ok()?;
        let context: CanvasRenderingContext2d = canvas.get_context("2d").ok()??.dyn_into().ok()?;
        context.set_font(&format!("{FONT_SIZE}px sans-serif"));
        Some(Self { context })
    }

    /// Gives the text of an element the width that it is painted in, by its size: the font is another.
    pub(crate) fn fit(&self, element: &HtmlElement, lettering: Option<Lettering>) -> Result<(), JsValue> {
        // Where it is not known how the text is painted, it is as it was made.
        let Some(lettering) = lettering else {
            return PLAIN.iter().try_for_each(|(name, value)| element.style().set_property(name, value));
        };
        let Lettering {
            left,
            top,
            width,
            line,
            lines,
        } = lettering;
        let text = element.text_content().unwrap_or_default();
        let measured = self.context.measure_text(&text)?.width();
        if measured <= 0.0 {
            return Ok(());
        }
        let size = FONT_SIZE * width / measured;
        let wrapping = if lines > 1 { "normal" } else { "nowrap" };
        let style = element.style();
        style.set_property("white-space", wrapping)?;
        for (name, pixels) in [
            ("font-size", size),
            ("line-height", line),
            ("padding-left", left),
            ("padding-top", top),
        ] {
            style.set_property(name, &format!("{pixels}px"))?;
        }
        Ok(())
    }
}
