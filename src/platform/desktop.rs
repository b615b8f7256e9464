//! The desktop program: one window, its icon, and a file for what was entered.

use crate::app::{App, Platform};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

const NAME: &str = "Depth Calculator";

/// With arguments answers on the terminal; without any opens the window and runs until it is closed.
pub fn main() -> ExitCode {
    if crate::cli::is_asked() {
        return crate::cli::main();
    }
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title(NAME)
            .with_app_id("depth-calculator")
            .with_inner_size([1280.0, 900.0])
            .with_min_inner_size([360.0, 480.0])
            .with_icon(icon().unwrap_or_default()),
        ..Default::default()
    };
    let outcome = eframe::run_native(
        NAME,
        options,
        Box::new(|cc| Ok(Box::new(App::new(cc, Box::new(Desktop::default()))))),
    );
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let reason = error.to_string();
            let _ = writeln!(
                std::io::stderr(),
                "depth-calculator: The window could not be opened: {}. It needs a desktop with OpenGL 2 or newer; in a terminal use: depth-calculator calculate --help",
                without_source_line(&reason).trim_end_matches('.')
            );
            ExitCode::FAILURE
        }
    }
}

/// `reason` without what winit writes in front of it, the line of its own source that noticed.
fn without_source_line(reason: &str) -> &str {
    reason.split_once(".rs:").map_or(reason, |(_, rest)| {
        rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == ':' || c == ' ')
    })
}

fn icon() -> Option<egui::IconData> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(include_bytes!("../../assets/icons/icon-256.png")))
        .read_info()
        .ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    (info.color_type == png::ColorType::Rgba && info.bit_depth == png::BitDepth::Eight).then_some(egui::IconData {
        rgba,
        width: info.width,
        height: info.height,
    })
}

/// Keeps the state in a file of the user's configuration folder, and copies through egui.
struct Desktop {
    file: Result<PathBuf, String>,
    copied: bool,
}

impl Default for Desktop {
    fn default() -> Self {
        let file = directories::ProjectDirs::from("", "", "depth-calculator")
            .map(|folders| folders.config_dir().join("state-v1.json"))
            .ok_or_else(|| "There is no home folder to store anything in.".to_owned());
        Self { file, copied: false }
    }
}

impl Platform for Desktop {
    fn load(&self) -> Result<Option<String>, String> {
        let file = self.file.as_ref().map_err(Clone::clone)?;
        match std::fs::read(file) {
            // What is not text is as corrupt as text that is not a state.
            Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(format!("What was stored in {} cannot be read: {error}.", file.display())),
        }
    }

    fn save(&mut self, text: &str) -> Result<(), String> {
        let file = self.file.as_ref().map_err(Clone::clone)?;
        let write = || {
            if let Some(folder) = file.parent() {
                std::fs::create_dir_all(folder)?;
            }
            // Written beside and moved over, so that a crash leaves the old state or the new one, never half of it.
            let beside = file.with_extension("new");
            std::fs::write(&beside, text)?;
            std::fs::rename(&beside, file)
        };
        write().map_err(|error| format!("What you entered cannot be stored in {}: {error}.", file.display()))
    }

    fn set_aside(&mut self, text: &str) -> Result<(), String> {
        let file = self.file.as_ref().map_err(Clone::clone)?;
        std::fs::write(file.with_extension("old"), text).map_err(|error| format!("{error}."))
    }

    fn copy(&mut self, ctx: &egui::Context, text: String) {
        ctx.copy_text(text);
        self.copied = true;
        ctx.request_repaint();
    }

    fn copied(&mut self) -> Option<Result<(), String>> {
        std::mem::take(&mut self.copied).then_some(Ok(()))
    }
}
