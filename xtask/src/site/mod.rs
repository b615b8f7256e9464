//! What surrounds the program on a web site, as plain files beside it in dist/: the Learn text as a page of its own, what
//! search engines and installers read, the service worker that keeps it all on the computer.

mod address;
#[cfg(test)]
mod colors;
mod folder;
mod headers;
mod html;
mod learn;
mod mathml;
mod pages;
#[cfg(test)]
mod tests;
mod worker;

use std::fs;
use std::path::Path;

use crate::origin::commit;
use crate::step::root;
use folder::{HEADERS, LEARN_PAGE, LICENSES_PAGE, PROGRAM_PAGE, WORKER, names, read, write};
use html::replace_once;

/// Copied as they are: from assets/, to dist/.
const COPIES: &[(&str, &str)] = &[
    ("web/manifest.webmanifest", "manifest.webmanifest"),
    ("icons/icon-192.png", "icons/icon-192.png"),
    ("icons/icon-512.png", "icons/icon-512.png"),
    ("icons/maskable-192.png", "icons/maskable-192.png"),
    ("icons/maskable-512.png", "icons/maskable-512.png"),
    ("screenshot.png", "icons/screenshot.png"),
    ("screenshot-phone.png", "icons/screenshot-phone.png"),
    ("icons/og.png", "og.png"),
    ("fonts/OFL.txt", "fonts/OFL.txt"),
    ("fonts/DejaVu-LICENSE.txt", "fonts/DejaVu-LICENSE.txt"),
];

/// Adds everything to the freshly built `dist`. The environment variable `SITE_URL` says where it will be, for what must
/// not be relative. Err: a sentence saying what failed.
pub(crate) fn build(dist: &Path) -> Result<(), String> {
    let url = std::env::var("SITE_URL").unwrap_or_default();
    build_at(dist, address::site_url(&url)?.as_deref())
}

fn build_at(dist: &Path, url: Option<&str>) -> Result<(), String> {
    let assets = root().join("assets");
    for (from, to) in COPIES {
        let content = fs::read(assets.join(from)).map_err(|error| format!("assets/{from} cannot be read: {error}."))?;
        write(dist, to, content)?;
    }

    let program = read(&dist.join(PROGRAM_PAGE))?;
    let policy = headers::policy(&program)?.to_owned();
    let style = pages::style(&assets, dist)?;
    let learn = pages::learn(&assets, &style, &policy)?;
    write(dist, LEARN_PAGE, address::addressed(&learn, url, LEARN_PAGE)?)?;
    write(dist, LICENSES_PAGE, pages::licenses(&assets, &style, &policy)?)?;
    write(dist, "robots.txt", address::robots(url))?;
    match url {
        Some(url) => write(dist, "sitemap.xml", address::sitemap(url))?,
        None => println!(
            "There is no sitemap and no canonical address: the environment variable SITE_URL does not say where this page will be."
        ),
    }

    let program = address::addressed(&program, url, "")?;
    let program = with_meta(&program, "commit", &commit().unwrap_or_default())?;
    write(dist, PROGRAM_PAGE, &program)?;
    let worker = read(&assets.join("web").join(WORKER))?;
    let build = worker::build_id(dist, &worker)?;
    // The page has to know which build it is of, to tell whether another one is newer.
    write(dist, PROGRAM_PAGE, with_meta(&program, "build", &build)?)?;
    write(dist, HEADERS, headers::headers(&names(dist)?, &policy))?;
    write(dist, WORKER, worker::service_worker(dist, &worker, &build)?)
}

/// `page` with the content of its empty `<meta name="{name}">`.
fn with_meta(page: &str, name: &str, content: &str) -> Result<String, String> {
    let place = |content: &str| format!("<meta name=\"{name}\" content=\"{content}\">");
    replace_once(page, &place(""), &place(content))
}
