//! The position and size of a window, kept from one start to the next in a file of its own, as its state is.

use super::state;
use crate::app::App;
use egui::{Pos2, Rect, Vec2, ViewportBuilder, ViewportCommand, pos2, vec2};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use winit::dpi::PhysicalPosition;
use winit::window::Window;

/// The size at the first start, in points.
const DEFAULT_SIZE: Vec2 = vec2(1280.0, 900.0);
/// The smallest window that everything fits into.
pub const MIN_SIZE: Vec2 = vec2(360.0, 480.0);

/// What is remembered of a window.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Placement {
    /// Width and height without the frame, in points of the system, when it is not maximized.
    size: [f32; 2],
    /// The upper left corner of its frame on the desktop, in pixels, as the size of a point differs from monitor to monitor. `None` on
    /// Wayland, which does not tell it.
    place: Option<[f32; 2]>,
    /// Pixels per point where it was.
    scale: f32,
    maximized: bool,
}

impl Default for Placement {
    fn default() -> Self {
        Self {
            size: DEFAULT_SIZE.into(),
            place: None,
            scale: 1.0,
            maximized: false,
        }
    }
}

impl Placement {
    /// Parses the stored text; `None` where it is corrupt or no possible window.
    fn from_text(text: &str) -> Option<Self> {
        let stored: Self = serde_json::from_str(text).ok()?;
        let is_far = |place: [f32; 2]| place.iter().any(|part| !part.is_finite() || part.abs() > 1e6);
        let is_of_a_window = (0.25..=16.0).contains(&stored.scale) && !stored.place.is_some_and(is_far);
        let size = Vec2::from(stored.size).clamp(MIN_SIZE, Vec2::splat(16_000.0));
        is_of_a_window.then_some(Self {
            size: size.into(),
            ..stored
        })
    }

    /// Gives `window` this size and position. eframe limits the size to that of the largest monitor.
    pub fn apply(self, window: ViewportBuilder) -> ViewportBuilder {
        let window = window.with_inner_size(self.size).with_maximized(self.maximized);
        match self.place {
            Some(place) => window.with_position(Pos2::from(place) / self.scale),
            None => window,
        }
    }

    /// Moves a new window to where it was, or, if its monitor is gone, to where it can be reached.
    pub fn restore_position(self, window: &Window) {
        let Some(place) = self.place else { return };
        let monitors: Vec<Rect> = window
            .primary_monitor()
            .into_iter()
            .chain(window.available_monitors())
            .map(|monitor| {
                let (place, size) = (monitor.position().cast::<f32>(), monitor.size().cast::<f32>());
                Rect::from_min_size(pos2(place.x, place.y), vec2(size.width, size.height))
            })
            .collect();
        let wanted = Rect::from_min_size(place.into(), Vec2::from(self.size) * self.scale);
        let move_to = |place: Pos2| window.set_outer_position(PhysicalPosition::new(place.x, place.y));
        match monitors.first() {
            Some(monitor) if !is_reachable(wanted, &monitors) => move_to(monitor.min + Vec2::splat(40.0)),
            // Windows converts the position with the scale of another monitor.
            Some(_) if cfg!(target_os = "windows") && !self.maximized => move_to(wanted.min),
            _ => {}
        }
    }

    /// The placement of `window` now.
    fn observed(self, window: &Window, info: &egui::ViewportInfo) -> Self {
        let maximized = info.maximized.unwrap_or(false);
        if info.minimized == Some(true) || info.fullscreen == Some(true) {
            return self;
        }
        if maximized {
            return Self { maximized, ..self };
        }
        let size = window.inner_size().to_logical::<f32>(window.scale_factor());
        Self {
            size: [size.width, size.height],
            place: window.outer_position().ok().map(|place| place.cast::<f32>().into()),
            scale: PhysicalPosition::new(window.scale_factor(), 0.0).cast::<f32>().x,
            maximized,
        }
    }
}

/// Whether enough of the title bar of `window` is on one of `monitors` to drag it by.
fn is_reachable(window: Rect, monitors: &[Rect]) -> bool {
    let edge = Rect::from_min_size(window.min, vec2(window.width(), 30.0));
    monitors.iter().any(|monitor| {
        let visible = monitor.intersect(edge);
        visible.width() >= 100.0_f32.min(edge.width()) && visible.height() >= 15.0
    })
}

/// The name of the file of a placement. It contains the version of the format.
pub const NAME: &str = "window-v1";

/// The placement that is stored in `file`. Errors are ignored: the window then opens as at the first start.
pub fn load(file: Option<&Path>) -> Placement {
    let text = file.and_then(|file| std::fs::read_to_string(file).ok());
    text.and_then(|text| Placement::from_text(&text)).unwrap_or_default()
}

/// A placement and the file to keep it in, if there is one.
pub struct Kept {
    pub placement: Placement,
    pub file: Option<PathBuf>,
}

/// The application in a window whose placement is kept.
pub struct PlacedApp {
    app: App,
    ctx: egui::Context,
    file: Option<PathBuf>,
    now: Placement,
    stored: Placement,
    /// When `now` last changed.
    changed_at: Instant,
    /// Frames since the start, while the window is still to be maximized: X11 ignores that before the window is shown.
    to_maximize: Option<u8>,
}

impl PlacedApp {
    /// `app` in a window that was opened with the placement in `kept`.
    pub fn new(app: App, ctx: &egui::Context, kept: Kept) -> Self {
        let Kept { placement, file } = kept;
        Self {
            app,
            ctx: ctx.clone(),
            file,
            now: placement,
            stored: placement,
            changed_at: Instant::now(),
            to_maximize: placement.maximized.then_some(0),
        }
    }

    /// Stores the placement once it has not changed for a second: it changes with every frame while the window is dragged.
    fn track(&mut self, ctx: &egui::Context, window: &Window) {
        const REST: Duration = Duration::from_secs(1);
        let info = ctx.input(|input| input.viewport().clone());
        match self.to_maximize {
            Some(0) => {
                self.to_maximize = Some(1);
                ctx.request_repaint();
                return;
            }
            Some(_) => {
                self.to_maximize = None;
                ctx.send_viewport_cmd(ViewportCommand::Maximized(true));
                return;
            }
            None => {}
        }
        let seen = self.now.observed(window, &info);
        if seen != self.now {
            self.now = seen;
            self.changed_at = Instant::now();
        }
        if self.now != self.stored {
            let rested = self.changed_at.elapsed();
            if rested >= REST {
                self.store();
            } else {
                ctx.request_repaint_after(REST - rested);
            }
        }
    }

    fn store(&mut self) {
        if self.now != self.stored {
            if let (Some(file), Ok(text)) = (&self.file, serde_json::to_string(&self.now)) {
                state::replace(file, &text).ok();
            }
            self.stored = self.now;
        }
    }
}

impl eframe::App for PlacedApp {
    fn logic(&mut self, ctx: &egui::Context, frame: &mut eframe::Frame) {
        self.app.logic(ctx, frame);
        if let Some(window) = frame.winit_window() {
            self.track(ctx, window);
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.app.ui(ui, frame);
    }

    // After the frame that egui runs when the window is asked to close.
    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.app.finish(&self.ctx);
        self.store();
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn what_is_stored_comes_back() {
        let placement = Placement {
            size: [800.0, 700.5],
            place: Some([-1900.0, 40.0]),
            scale: 1.5,
            maximized: true,
        };
        let text = serde_json::to_string(&placement).unwrap();
        assert_eq!(Placement::from_text(&text), Some(placement));
        let window = placement.apply(ViewportBuilder::default());
        assert_eq!(window.inner_size, Some(vec2(800.0, 700.5)));
        assert_eq!(window.position, Some(pos2(-1900.0, 40.0) / 1.5));
        assert_eq!(window.maximized, Some(true));
    }

    #[test]
    fn what_is_of_no_window_is_not_used() {
        let good = r#"{"size":[800,700],"place":[10,20],"scale":1,"maximized":false}"#;
        assert!(Placement::from_text(good).is_some());
        for bad in [
            "",
            "{}",
            "null",
            "\u{0}",
            &good.replace("\"scale\":1", "\"scale\":0"),
            &good.replace("\"scale\":1", "\"scale\":-2"),
            &good.replace("[10,20]", "[10]"),
            &good.replace("[10,20]", "[1e30,20]"),
            &good.replace("[800,700]", "\"large\""),
            &good.replace("\"maximized\"", "\"version\":2,\"maximized\""),
        ] {
            assert_eq!(Placement::from_text(bad), None, "{bad}");
        }
    }

    #[test]
    fn a_size_is_kept_between_what_can_be_used_and_what_can_be_had() {
        for (stored, expected) in [
            ("[1,2]", MIN_SIZE),
            ("[-5,700]", vec2(360.0, 700.0)),
            ("[1e30,700]", vec2(16_000.0, 700.0)),
        ] {
            let text = format!(r#"{{"size":{stored},"place":null,"scale":2,"maximized":false}}"#);
            assert_eq!(Vec2::from(Placement::from_text(&text).unwrap().size), expected);
        }
    }

    #[test]
    fn a_window_that_nobody_could_reach_is_moved() {
        let monitors = [
            Rect::from_min_size(pos2(0.0, 0.0), vec2(1920.0, 1080.0)),
            Rect::from_min_size(pos2(-1280.0, 0.0), vec2(1280.0, 1024.0)),
        ];
        let reachable = |x, y| is_reachable(Rect::from_min_size(pos2(x, y), vec2(800.0, 600.0)), &monitors);
        assert!(reachable(10.0, 10.0));
        assert!(reachable(-1000.0, 100.0));
        assert!(reachable(1800.0, 1050.0));
        assert!(!reachable(2500.0, 10.0), "on a monitor that is gone");
        assert!(!reachable(1900.0, 10.0), "a corner is not enough");
        assert!(!reachable(10.0, -100.0), "above the screen");
        assert!(!reachable(10.0, 1075.0), "below the screen");
    }
}
