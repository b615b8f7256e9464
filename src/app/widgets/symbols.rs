//! Symbols of quantities with true subscripts, in the color of their method, and which of them is pointed at.

use crate::app::theme::{self, Palette};
use depth_figures::Words;
use depth_text::field::{Key, Section};
use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, Id, Label, Response, Ui};

/// The color of what belongs to `key`: of its method, or of text.
pub fn color(palette: &Palette, key: Key) -> Color32 {
    match key.section {
        Some(Section::Stereo) => palette.blue,
        Some(Section::Monocular | Section::Target) => palette.orange_text,
        _ => palette.text,
    }
}

/// Appends `symbol` to `job`, its subscript as a subscript.
pub fn append(job: &mut LayoutJob, symbol: &str, format: &TextFormat) {
    let (letter, below) = depth_figures::split_symbol(symbol);
    job.append(letter, 0.0, format.clone());
    if below.is_empty() {
        return;
    }
    let mut small = format.clone();
    let size = format.font_id.size;
    small.font_id.size = size * theme::SUBSCRIPT_SIZE;
    // Text of two sizes is aligned at the bottom of the line; a line lower than its text lets that hang below.
    small.line_height = Some(small.font_id.size * theme::SUBSCRIPT_LINE);
    small.valign = egui::Align::BOTTOM;
    job.append(below, 0.0, small);
}

/// `text` with every symbol of a field in it as a symbol, in the color of its method where `is_colored`.
pub fn job(palette: &Palette, text: &str, format: &TextFormat, is_colored: bool) -> LayoutJob {
    let mut job = LayoutJob::default();
    for (part, key) in depth_figures::symbols_in(text) {
        match key {
            Some(key) => {
                let mut format = format.clone();
                if is_colored {
                    let own = color(palette, key);
                    format.color = if own == palette.text { format.color } else { own };
                }
                append(&mut job, part, &format);
            }
            None => job.append(part, 0.0, format.clone()),
        }
    }
    job
}

/// Has assistive technology read `text`, with its underscores, where a label shows subscripts.
pub fn say(ui: &Ui, label: &Response, text: &str) {
    ui.accesskit_node_builder(label.id, |node| node.set_value(text));
}

/// The label of a field: its name, and its symbol in the color of its method.
pub fn label_ui(ui: &mut Ui, key: Key) -> Response {
    let palette = theme::palette(ui);
    let mut format = TextFormat::simple(theme::strong(theme::BODY_SIZE), palette.text);
    let mut job = LayoutJob::simple_singleline(key.label.to_owned(), format.font_id.clone(), palette.text);
    if !key.symbol.is_empty() && key.shows_symbol() {
        job.append(" ", 0.0, format.clone());
        format.color = color(palette, key);
        append(&mut job, key.symbol, &format);
    }
    job.wrap = egui::text::TextWrapping::truncate_at_width(ui.available_width());
    let response = ui.add(Label::new(job).selectable(false));
    ui.accesskit_node_builder(response.id, |node| node.set_value(key.name));
    response
}

/// `words` of a figure as text of `size`.
pub fn of_words(words: &Words, size: f32, color: impl Fn(depth_figures::Ink) -> Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for run in &words.runs {
        let font = if run.is_strong { theme::strong(size) } else { theme::regular(size) };
        let mut format = TextFormat::simple(font, color(run.ink));
        if run.is_subscript {
            format.font_id.size = size * theme::SUBSCRIPT_SIZE;
            format.line_height = Some(format.font_id.size * theme::SUBSCRIPT_LINE);
            format.valign = egui::Align::BOTTOM;
        }
        job.append(&run.text, 0.0, format);
    }
    job
}

/// The field whose number is pointed at, as of the last frame.
pub fn lit(ctx: &Context) -> Option<Key> {
    ctx.data(|data| data.get_temp(lit_id()))
}

/// Lights up the field `key` in the next frame, or none.
pub fn light_up(ctx: &Context, key: Option<Key>) {
    if lit(ctx) == key {
        return;
    }
    ctx.data_mut(|data| match key {
        Some(key) => _ = data.insert_temp(lit_id(), key),
        None => data.remove::<Key>(lit_id()),
    });
    ctx.request_repaint();
}

fn lit_id() -> Id {
    Id::unique("the field that is pointed at")
}
