//! Drawing without a window, with Mesa's software renderer llvmpipe and with nothing else: no two renderers agree on every pixel.
//! Its versions 22.3 and 25.0 do.

use crate::images;
use egui::{Context, FullOutput, TexturesDelta};
use egui_kittest::TestRenderer;
use egui_wgpu::{Renderer, RendererOptions, ScreenDescriptor};
use image::{DynamicImage, RgbImage, RgbaImage};
use std::cell::RefCell;
use std::io::Write as _;
use std::rc::Rc;
use std::sync::OnceLock;
use wgpu::{Backends, DeviceType, Extent3d, TextureFormat, TextureUsages};

const FORMAT: TextureFormat = TextureFormat::Rgba8Unorm;

/// Where everything is drawn.
struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
    version: String,
}

/// The renderer's name and version, without how many bits it works on at a time: that is the processor's. Nothing where it is
/// not here.
pub fn version() -> Option<&'static str> {
    device().map(|device| device.version.as_str())
}

/// Draws the frames of one program; a clone is the same painter.
#[derive(Clone)]
pub struct Painter {
    on: &'static Device,
    /// With the program's textures.
    renderer: Rc<RefCell<Renderer>>,
}

impl Painter {
    /// Nothing where there is no llvmpipe.
    pub fn new() -> Option<Self> {
        let on = device()?;
        let renderer = Renderer::new(&on.device, FORMAT, RendererOptions::PREDICTABLE);
        Some(Self {
            on,
            renderer: Rc::new(RefCell::new(renderer)),
        })
    }

    /// The image of a frame.
    pub fn draw(&self, ctx: &Context, output: &FullOutput) -> RgbImage {
        let Device { device, queue, .. } = self.on;
        let triangles = ctx.tessellate(output.shapes.clone(), ctx.pixels_per_point());
        let size = ctx.viewport_rect().size() * ctx.pixels_per_point();
        let (width, height) = (size.x.round() as u32, size.y.round() as u32);
        let screen = ScreenDescriptor {
            size_in_pixels: [width, height],
            pixels_per_point: ctx.pixels_per_point(),
        };
        let target = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: extent(width, height),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut renderer = self.renderer.borrow_mut();
        let buffers = renderer.update_buffers(device, queue, &mut encoder, &triangles, &screen);
        let mut pass = encoder
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                        store: wgpu::StoreOp::Store,
                    },
                    depth_slice: None,
                })],
                ..Default::default()
            })
            .forget_lifetime();
        renderer.render(&mut pass, &triangles, &screen);
        drop(pass);
        queue.submit(buffers.into_iter().chain([encoder.finish()]));
        self.on.read(&target)
    }
}

impl TestRenderer for Painter {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let Device { device, queue, .. } = self.on;
        let mut renderer = self.renderer.borrow_mut();
        for (id, images) in delta.set.drain() {
            for image in images {
                renderer.update_texture(device, queue, id, &image);
            }
        }
        for id in delta.free.drain() {
            renderer.free_texture(&id);
        }
    }
}

impl Device {
    /// The pixels of a texture.
    fn read(&self, texture: &wgpu::Texture) -> RgbImage {
        let (width, height) = (texture.width(), texture.height());
        let row = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(row * height),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(row),
            rows_per_image: None,
        };
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(texture.as_image_copy(), to, extent(width, height));
        self.queue.submit([encoder.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., Result::unwrap);
        self.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        let bytes = buffer.get_mapped_range(..).unwrap();
        let rows = bytes.chunks_exact(row as usize);
        let pixels = rows.flat_map(|row| &row[..4 * width as usize]).copied().collect();
        DynamicImage::from(RgbaImage::from_raw(width, height, pixels).unwrap()).into_rgb8()
    }
}

const fn extent(width: u32, height: u32) -> Extent3d {
    Extent3d {
        width,
        height,
        depth_or_array_layers: 1,
    }
}

/// The only one. Where there is none, says why on the terminal, and in a file that `cargo xtask test` reads.
fn device() -> Option<&'static Device> {
    static DEVICE: OnceLock<Option<Device>> = OnceLock::new();
    let device = DEVICE.get_or_init(|| match find() {
        Ok(device) => Some(device),
        Err(reason) => {
            std::fs::write(images::output_folder().join("left-out.txt"), &reason).unwrap();
            // The harness keeps to itself what a test that passes says with eprintln!.
            let text = format!("left out: the images of the screens. {reason}\n");
            std::io::stderr().write_all(text.as_bytes()).unwrap();
            None
        }
    });
    device.as_ref()
}

/// Err: a sentence, where there is no llvmpipe.
fn find() -> Result<Device, String> {
    // Unlike OpenGL, Vulkan offers the software renderer beside a graphics card too.
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = Backends::VULKAN;
    let adapters = pollster::block_on(wgpu::Instance::new(descriptor).enumerate_adapters(Backends::VULKAN));
    let adapter = adapters.into_iter().find(is_llvmpipe).ok_or(
        "They are compared where Mesa's llvmpipe draws with Vulkan, and it is not here: \
         on Debian and Ubuntu `apt-get install mesa-vulkan-drivers`.",
    )?;
    let (device, queue) =
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).map_err(|error| format!("llvmpipe: {error}."))?;
    let info = adapter.get_info();
    Ok(Device {
        device,
        queue,
        version: format!("{}, {}", info.driver, info.driver_info),
    })
}

fn is_llvmpipe(adapter: &wgpu::Adapter) -> bool {
    let info = adapter.get_info();
    info.device_type == DeviceType::Cpu && info.driver == "llvmpipe"
}
