//! Images of the screens, compared with those in `snapshots/`: only where Mesa's software renderer draws, because no two
//! renderers agree on every pixel. `snapshots/renderer.txt` says which version drew the images; 22.3 and 25.0 draw the same.

use eframe::egui_wgpu::{RenderState, Renderer, RendererOptions, WgpuConfiguration, WgpuSetup};
use eframe::wgpu::{self, Backends, DeviceType};
use egui::mutex::RwLock;
use egui_kittest::wgpu::{WgpuTestRenderer, default_wgpu_setup};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{Rgb, RgbImage};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// How far a red, green or blue of 0 to 255 may be off: 1 is another processor's rounding, 2 is another color.
const TOLERANCE: u8 = 1;
/// In it stands what drew the images.
const RENDERER: &str = "renderer.txt";
const HOW_TO_ACCEPT: &str = "If the screens should look like this now: UPDATE_SNAPSHOTS=1 cargo test --locked --test screens look";

/// What draws the images; nothing where they cannot be compared.
pub fn renderer() -> Option<WgpuTestRenderer> {
    let state = state()?.clone();
    // One device for all of them, but each program has textures of its own.
    let textures = Renderer::new(&state.device, state.target_format, RendererOptions::PREDICTABLE);
    Some(WgpuTestRenderer::from_render_state(RenderState {
        renderer: Arc::new(RwLock::new(textures)),
        ..state
    }))
}

/// The only instance of [`llvmpipe`]. Where there is none, says why on the terminal, and in a file that `cargo xtask test` reads.
fn state() -> Option<&'static RenderState> {
    static STATE: OnceLock<Option<RenderState>> = OnceLock::new();
    let state = STATE.get_or_init(|| match llvmpipe() {
        Ok(state) => Some(state),
        Err(reason) => {
            std::fs::write(output_folder().join("left-out.txt"), &reason).unwrap();
            // The harness keeps to itself what a test that passes says with eprintln!.
            let text = format!("left out: the images of the screens. {reason}\n");
            std::io::stderr().write_all(text.as_bytes()).unwrap();
            None
        }
    });
    state.as_ref()
}

/// Mesa's software renderer. Err: a sentence, where that is not here.
fn llvmpipe() -> Result<RenderState, String> {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(new) = &mut setup {
        // Unlike OpenGL, Vulkan offers the software renderer beside a graphics card too.
        new.instance_descriptor.backends = Backends::VULKAN;
        new.native_adapter_selector = Some(Arc::new(|adapters, _| {
            let found = adapters.iter().find(|adapter| is_llvmpipe(adapter));
            found.cloned().ok_or_else(|| "Mesa's llvmpipe for Vulkan is not here".to_owned())
        }));
    }
    let instance = pollster::block_on(setup.new_instance());
    let configuration = WgpuConfiguration {
        wgpu_setup: setup,
        ..WgpuConfiguration::default()
    };
    let state = RenderState::create(&configuration, &instance, None, RendererOptions::PREDICTABLE);
    pollster::block_on(state).map_err(|error| format!("{error}. On Debian and Ubuntu: apt-get install mesa-vulkan-drivers."))
}

fn is_llvmpipe(adapter: &wgpu::Adapter) -> bool {
    let info = adapter.get_info();
    info.device_type == DeviceType::Cpu && info.driver == "llvmpipe"
}

/// Name and version of what draws here, without how many bits it works on at a time: that is the processor's.
fn version() -> String {
    let info = state().map(|state| state.adapter.get_info());
    info.map_or_else(String::new, |info| format!("{}, {}", info.driver, info.driver_info))
}

fn is_updating() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| !value.is_empty() && value != "0")
}

/// Compares with the image of that name, or puts it in its place if that is asked for. Err: what is different, and where to look.
pub fn compare(new: &RgbImage, name: &str) -> Result<(), String> {
    let file = snapshots().join(format!("{name}.png"));
    let [new_file, marked_file] = ["new", "marked"].map(|kind| output_folder().join(format!("{name}.{kind}.png")));
    for old_output in [&new_file, &marked_file] {
        let _ = std::fs::remove_file(old_output);
    }
    let problem = match image::open(&file) {
        Err(error) => format!("it cannot be read: {error}"),
        Ok(old) => match differences(&old.to_rgb8(), new) {
            Ok((0, _)) => return Ok(()),
            Ok((count, marked)) => {
                save(&marked, &marked_file);
                format!("{count} pixels differ, marked in {}", marked_file.display())
            }
            Err(sizes) => sizes,
        },
    };
    if is_updating() {
        save(new, &file);
        std::fs::write(snapshots().join(RENDERER), format!("{}\n", version())).unwrap();
        return Ok(());
    }
    save(new, &new_file);
    Err(format!("{name}: {problem}. New: {}", new_file.display()))
}

/// How many pixels differ, and the old image, faint, with these in red. Err: the sizes, where they differ.
fn differences(old: &RgbImage, new: &RgbImage) -> Result<(usize, RgbImage), String> {
    if old.dimensions() != new.dimensions() {
        return Err(format!("it was {:?} large and is {:?}", old.dimensions(), new.dimensions()));
    }
    let mut count = 0;
    let mut marked = old.clone();
    for (marked, new) in marked.pixels_mut().zip(new.pixels()) {
        let differs = marked.0.iter().zip(new.0).any(|(old, new)| old.abs_diff(new) > TOLERANCE);
        count += usize::from(differs);
        *marked = if differs {
            Rgb([255, 0, 0])
        } else {
            Rgb(marked.0.map(|value| 192 + value / 4))
        };
    }
    Ok((count, marked))
}

/// Fails with all that [`compare`] found.
pub fn report(problems: &[String]) {
    if problems.is_empty() {
        return;
    }
    let drew = std::fs::read_to_string(snapshots().join(RENDERER)).unwrap_or_default();
    let (drew, draws) = (drew.trim(), version());
    let versions = if drew == draws {
        String::new()
    } else {
        format!("The images to compare with were drawn by {drew}, the new ones by {draws}.\n")
    };
    panic!("\n{}\n{versions}{HOW_TO_ACCEPT}", problems.join("\n"));
}

/// Writes a small file: for flat areas and letters no filter is the best one.
fn save(image: &RgbImage, file: &Path) {
    let to = std::io::BufWriter::new(std::fs::File::create(file).unwrap());
    let encoder = PngEncoder::new_with_quality(to, CompressionType::Best, FilterType::NoFilter);
    image.write_with_encoder(encoder).unwrap();
}

fn snapshots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/screens/snapshots")
}

fn output_folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("screens");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
