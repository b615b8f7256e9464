//! Writes a page with every view in many cases and widths: `cargo run -p depth-figures --example views -- views.html`.

use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_figures::ground::{self, Above, ImageView, SideView};
use depth_figures::top_view::{Drag, Model, Options, Source, TopView};
use depth_figures::{Figure, InterWidths, letters, svg};
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use std::path::Path;

const WIDTHS: [f32; 5] = [326.0, 368.0, 437.0, 560.0, 784.0];

fn main() -> std::io::Result<()> {
    let Some(path) = std::env::args().nth(1) else {
        eprintln!("Say where to write the page: views.html");
        return Ok(());
    };
    let fonts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/fonts");
    let mut page = format!(
        "<!doctype html><meta charset=utf-8><style>@font-face{{font-family:Inter;src:url(file://{0}/Inter-Regular.ttf)}}\
         @font-face{{font-family:Inter;font-weight:600;src:url(file://{0}/Inter-SemiBold.ttf)}}\
         body{{font:12px Inter;margin:12px;background:#f4f6f8}}div{{display:inline-block;vertical-align:top;background:#fff;\
         border:1px solid #dce1e7;border-radius:8px;padding:12px 16px;margin:4px}}b{{font-size:14.5px;font-weight:600}}\
         p{{margin:4px 0;color:#535e6c}}svg{{display:block}}i{{float:right;font-style:normal;color:#535e6c}}</style>",
        fonts.display()
    );
    for (width, symbol) in WIDTHS.into_iter().zip([Some("w_real"), None, Some("d"), Some("b"), Some("fx")]) {
        let figure = letters::figure(width, symbol, false, &InterWidths);
        let caption = if width < 560.0 { letters::SHORT_CAPTION } else { letters::CAPTION };
        card(&mut page, ["What the letters mean", caption, ""], &figure);
    }
    page.push_str("<br>");
    grounds(&mut page);
    top_views(&mut page);
    std::fs::write(path, page)
}

/// A card as wide as its picture.
fn card(page: &mut String, [title, caption, note]: [&str; 3], figure: &Figure) {
    page.push_str(&format!(
        "<div style='width:{}px'><i>{}</i><b>{}</b>{}<p>{}</p></div>",
        figure.width,
        svg::escape(caption),
        svg::escape(title),
        svg::of(figure, title, note),
        svg::escape(note),
    ));
}

fn typed(values: &[(Key, &str, &str)]) -> Inputs {
    let mut inputs = Inputs { ..Inputs::default() };
    for (key, value, sigma) in values {
        inputs.entry_mut(*key).text = (*value).to_owned();
        inputs.set_sigma(*key, *sigma);
    }
    inputs
}

fn parcel(b: &str, d: &str, w_img: &str, w_real: &str) -> Inputs {
    typed(&[
        (fields::FOCAL_LENGTH, "700", "2"),
        (fields::BASELINE, b, "0.5 %"),
        (fields::DISPARITY, d, "1 %"),
        (fields::IMAGE_WIDTH, w_img, "2"),
        (fields::REAL_WIDTH, w_real, "3.33 %"),
    ])
}

fn grounds(page: &mut String) {
    let camera = |height: &str, pitch: &str, row: &str, column: &str| {
        typed(&[
            (fields::FOCAL_LENGTH, "700", ""),
            (fields::CX, "640", ""),
            (fields::CY, "360", ""),
            (fields::CAMERA_HEIGHT, height, "4.2 %"),
            (fields::CAMERA_PITCH, pitch, "0.5"),
            (fields::FLOOR_ROW, row, ""),
            (fields::FLOOR_COLUMN, column, ""),
        ])
    };
    let mut raised = camera("1.20 m", "10", "400", "300");
    raised.entry_mut(fields::TARGET_HEIGHT).text = "0.5 m".into();
    let mut higher = camera("1.20 m", "-10", "300", "300");
    higher.entry_mut(fields::TARGET_HEIGHT).text = "3 m".into();
    let mut by_angle = camera("1.20 m", "10", "", "");
    by_angle.entry_mut(fields::FLOOR_ANGLE).text = "11.31".into();
    let cases = [
        ("Mast", camera("1.20 m", "10", "500", "1100")),
        ("Raised", raised),
        ("Higher than the camera", higher),
        ("Straight down", camera("3 m", "80", "500", "700")),
        ("Far", camera("1.20 m", "2", "345", "500")),
        ("Drone", camera("80 m", "45", "300", "200")),
        ("Far aside", camera("1.20 m", "10", "719", "1279")),
        ("By angle", by_angle),
    ];
    for (title, inputs) in cases {
        let Some(model) = ground::Model::new(&inputs.assess(), LengthUnit::Meter) else {
            continue;
        };
        for (width, above_width) in [(548.0, 368.0), (326.0, 326.0)] {
            let side = SideView::new(&model, [width, 222.0], &InterWidths);
            let caption = if width > 500.0 { &side.caption } else { &side.short_caption };
            card(page, [title, caption, ""], &side.figure);
            if width > 500.0
                && let Some(image) = ImageView::new(&model, 208.0, &InterWidths)
            {
                card(page, ["In the image", &image.caption, &image.note], &image.figure);
            }
            let above = Above::new(&model, [above_width, 290.0], &InterWidths);
            card(page, ["Top view", &above.caption, &above.note], &above.figure);
        }
        page.push_str("<hr>");
    }
}

fn top_views(page: &mut String) {
    let plain = parcel("100 mm", "50", "150", "0.30 m");
    let mut given = parcel("100 mm", "", "", "");
    given.unknown = Some((Method::Stereo, Field::Disparity));
    given.entry_mut(fields::DISTANCE).text = "1.40 m".into();
    given.set_sigma(fields::DISTANCE, "1 cm");
    let mut refused = plain.clone();
    refused.entry_mut(fields::DISPARITY).text = "-12".into();
    let mut zero = plain.clone();
    zero.entry_mut(fields::ZERO).text = "0.2 m".into();
    let cases = [
        ("Parcel", plain.clone(), None),
        ("Given", given, Some("(4.091 ± 0.036)°")),
        ("Refused", refused, None),
        ("Zero", zero, None),
        ("Stereo alone", parcel("100 mm", "50", "", ""), None),
        ("Door", parcel("", "", "200", "0.9 m"), None),
        ("10 times as far", parcel("100 mm", "50", "150", "3.0 m"), None),
        ("Nearer", parcel("100 mm", "50", "1500", "0.30 m"), None),
        ("Wide baseline", parcel("10 m", "7000", "150", "0.2 m"), None),
        ("Far", parcel("1 mm", "0.007", "2", "0.3 m"), None),
        ("Wide object", parcel("1 m", "233", "11667", "50 m"), None),
        ("Far and near", parcel("100 mm", "0.007", "150", "0.30 m"), None),
        ("100 times", parcel("100 mm", "50", "150", "300 m"), None),
        ("Ultrawide", parcel("200 m", "70000", "150", "0.3 m"), None),
    ];
    let before = plain.assess();
    for (title, inputs, angle) in cases {
        for width in WIDTHS {
            let height = if width < 500.0 { 290.0 } else { 330.0 };
            top_view(page, title, (&inputs.assess(), &before, angle), [width, height]);
        }
        page.push_str("<br>");
    }
}

fn top_view(page: &mut String, title: &str, (now, before, angle): (&Assessment, &Assessment, Option<&str>), size: [f32; 2]) {
    let source = Source {
        now,
        before: Some(before),
        unit: LengthUnit::Meter,
        angle,
    };
    let Some(model) = Model::new(source) else { return };
    let options = Options {
        drag: Drag::PointerAndKeys,
        hold: None,
    };
    let view = TopView::new(&model, size, options, &InterWidths);
    card(page, [title, &view.caption, &view.note], &view.figure);
}
