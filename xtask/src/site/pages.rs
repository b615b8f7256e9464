//! The pages that need no program: the Learn text and the licenses of others.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::Path;

use super::folder::{LEARN_PAGE, LICENSES_PAGE, read, write};
use super::html::{escaped, replace_once};
use super::learn;
use super::worker::integrity;

/// The style of these pages.
pub(super) struct Style {
    /// Of its file in dist/.
    name: String,
    digest: String,
}

/// Writes the style of these pages into `dist`.
pub(super) fn style(assets: &Path, dist: &Path) -> Result<Style, String> {
    let style = read(&assets.join("web/learn.css"))?;
    let mut hasher = DefaultHasher::new();
    style.hash(&mut hasher);
    let name = format!("learn-{:016x}.css", hasher.finish());
    write(dist, &name, style)?;
    let digest = integrity(&dist.join(&name))?;
    Ok(Style { name, digest })
}

/// The text of assets/learn.md as a page.
pub(super) fn learn(assets: &Path, style: &Style, policy: &str) -> Result<String, String> {
    let learn = learn::read(&read(&assets.join("learn.md"))?)?;
    let page = template(assets, LEARN_PAGE, style, policy)?;
    let page = replace_once(&page, "{questions}", &learn.structured_data())?;
    let page = replace_once(&page, "{contents}", &learn.contents())?;
    // Last, because what it brings in is not ours to search for places.
    replace_once(&page, "{text}", &learn.html)
}

/// The texts of assets/licenses.txt as a page.
pub(super) fn licenses(assets: &Path, style: &Style, policy: &str) -> Result<String, String> {
    let page = template(assets, LICENSES_PAGE, style, policy)?;
    replace_once(&page, "{text}", &escaped(&read(&assets.join("licenses.txt"))?))
}

/// The page `name` of assets/web, with its style and its Content-Security-Policy.
fn template(assets: &Path, name: &str, style: &Style, policy: &str) -> Result<String, String> {
    let page = read(&assets.join("web").join(name))?;
    let page = replace_once(&page, "{policy}", policy)?;
    let page = replace_once(&page, "{style}", &style.name)?;
    replace_once(&page, "{digest}", &style.digest)
}
