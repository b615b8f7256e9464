//! Saving a chart as a picture: what the window shows of it, without the menu that asked for it, and without what follows the pointer.
//!
//! That takes some frames: the menu closes and the chart is scrolled into view, then the window is asked for its pixels, which come with
//! a frame after that.

use super::sentences::PlatformError;
use egui::mutex::Mutex;
use egui::{Area, ColorImage, Context, Id, Order, Pos2, Rect, Sense, Ui, vec2};
use std::sync::Arc;

/// For so many frames a chart must stand still: until then it is scrolled into view.
const STILL: u32 = 2;
/// After so many frames there is no picture to wait for.
const MOST: u32 = 120;

/// A chart on its way into a file.
pub struct ChartPicture {
    title: &'static str,
    chart: Id,
    /// Where it was drawn last, in points.
    place: Option<Rect>,
    still: u32,
    frames: u32,
    is_asked_for: bool,
    /// The pixels of the window, as soon as they are there.
    window: Arc<Mutex<Option<Arc<ColorImage>>>>,
}

impl ChartPicture {
    /// A picture of the widget `chart`, named `title`.
    pub fn new(title: &'static str, chart: Id) -> Self {
        Self {
            title,
            chart,
            place: None,
            still: 0,
            frames: 0,
            is_asked_for: false,
            window: Arc::default(),
        }
    }

    /// The name of its file: "distance-against-disparity.png".
    pub fn file_name(&self) -> String {
        format!("{}.png", file_name(self.title))
    }

    /// Goes on by a frame. Returns the picture when it is there, or that there will be none.
    pub fn advance(&mut self, ctx: &Context) -> Option<Result<ColorImage, PlatformError>> {
        let window = self.window.lock().take();
        if let (Some(window), Some(place)) = (window, self.place) {
            return Some(crop(&window, place, ctx.pixels_per_point()).ok_or(PlatformError::NoPicture));
        }
        self.frames += 1;
        if self.frames > MOST {
            return Some(Err(PlatformError::NoPicture));
        }
        ctx.request_repaint();
        if self.is_asked_for {
            return None;
        }
        let place = ctx.read_response(self.chart).map(|response| response.interact_rect);
        self.still = if place == self.place { self.still + 1 } else { 0 };
        self.place = place;
        if self.still >= STILL && place.is_some() {
            self.is_asked_for = true;
            let (window, ctx_of_window) = (Arc::clone(&self.window), ctx.clone());
            ctx.request_screenshot(move |pixels| {
                *window.lock() = Some(pixels);
                ctx_of_window.request_repaint();
            });
        }
        None
    }

    /// Keeps the pointer from what is drawn meanwhile: no tip is in the picture.
    pub fn shield_ui(&self, ui: &Ui) {
        let all = ui.ctx().content_rect();
        let area = Area::new(Id::unique("shield of a picture"))
            .order(Order::Foreground)
            .fixed_pos(all.min);
        area.fade_in(false)
            .show(ui.ctx(), |ui| ui.allocate_exact_size(all.size(), Sense::hover()));
    }
}

/// What of the pixels of a window is in `place`, in points; `None` where nothing is.
fn crop(window: &ColorImage, place: Rect, pixels_per_point: f32) -> Option<ColorImage> {
    let [width, height] = window
        .size
        .map(|pixels| u16::try_from(pixels).map_or(f32::from(u16::MAX), f32::from));
    let pixels = Rect::from_min_max(
        (place.min.to_vec2() * pixels_per_point).round().to_pos2(),
        (place.max.to_vec2() * pixels_per_point).round().to_pos2(),
    );
    let seen = pixels.intersect(Rect::from_min_size(Pos2::ZERO, vec2(width, height)));
    if !seen.is_positive() {
        return None;
    }
    let mut picture = window.region(&seen, None);
    // What lies below a window is no part of a chart.
    for pixel in &mut picture.pixels {
        *pixel = pixel.to_opaque();
    }
    Some(picture)
}

/// `title` as the name of a file: lower case, with hyphens.
pub fn file_name(title: &str) -> String {
    let words = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("-")
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]
mod tests {
    use super::*;
    use egui::{Color32, pos2};

    #[test]
    fn a_picture_is_the_chart_in_the_pixels_of_the_window() {
        let mut window = ColorImage::filled([100, 80], Color32::WHITE);
        let corner = 20 * 100 + 10;
        window.pixels[corner] = Color32::RED;
        let place = Rect::from_min_max(pos2(5.0, 10.0), pos2(25.0, 30.0));
        let picture = crop(&window, place, 2.0).unwrap();
        assert_eq!(picture.size, [40, 40]);
        assert_eq!(picture.pixels.first(), Some(&Color32::RED));
        assert_eq!(picture.pixels.get(1), Some(&Color32::WHITE));
    }

    #[test]
    fn a_chart_outside_the_window_gives_no_picture() {
        let window = ColorImage::filled([10, 10], Color32::WHITE);
        let outside = Rect::from_min_max(pos2(20.0, 2.0), pos2(30.0, 8.0));
        assert_eq!(crop(&window, outside, 1.0), None);
        let half = Rect::from_min_max(pos2(-5.0, 2.0), pos2(5.0, 80.0));
        assert_eq!(crop(&window, half, 1.0).map(|picture| picture.size), Some([5, 8]));
    }

    #[test]
    fn a_file_has_the_name_of_its_chart() {
        assert_eq!(file_name("Distance against disparity"), "distance-against-disparity");
        assert_eq!(file_name("Stereo, simulated"), "stereo-simulated");
    }
}
