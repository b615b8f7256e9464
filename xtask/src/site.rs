//! What surrounds the program on a web site, as plain files beside it in dist/: the Learn text as a page of its own, what
//! search engines and installers read, the service worker that keeps it all on the computer.

mod learn;
mod mathml;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::Path;

use crate::files::collect_files;
use crate::origin::commit;
use crate::step::root;

const PROGRAM_PAGE: &str = "index.html";
const LEARN_PAGE: &str = "learn.html";
const LICENSES_PAGE: &str = "licenses.html";
const WORKER: &str = "sw.js";

/// Copied as they are: from assets/, to dist/.
const COPIES: &[(&str, &str)] = &[
    ("web/manifest.webmanifest", "manifest.webmanifest"),
    ("icons/icon-192.png", "icons/icon-192.png"),
    ("icons/icon-512.png", "icons/icon-512.png"),
    ("icons/maskable-192.png", "icons/maskable-192.png"),
    ("icons/maskable-512.png", "icons/maskable-512.png"),
    ("icons/og.png", "og.png"),
    ("fonts/OFL.txt", "fonts/OFL.txt"),
    ("fonts/DejaVu-LICENSE.txt", "fonts/DejaVu-LICENSE.txt"),
];

/// What a visitor's browser does not ask for, unless the visitor does. It keeps everything else.
const NOT_FOR_VISITORS: &[&str] = &[WORKER, HEADERS, LICENSES_PAGE, "og.png", "robots.txt", "sitemap.xml"];

/// Read by some hosts, and served by none of those.
const HEADERS: &str = "_headers";

/// Adds everything to the freshly built `dist`. The environment variable `SITE_URL` says where it will be, for what must
/// not be relative. Err: a sentence saying what failed.
pub(crate) fn build(dist: &Path) -> Result<(), String> {
    let url = std::env::var("SITE_URL").unwrap_or_default();
    build_at(dist, site_url(&url)?.as_deref())
}

/// `url` with one slash at its end, `None` if it is empty.
fn site_url(url: &str) -> Result<Option<String>, String> {
    if url.is_empty() {
        return Ok(None);
    }
    let written_whole = url.starts_with("https://") || url.starts_with("http://");
    if !written_whole || url.contains(|c: char| c.is_whitespace() || "\"'<>&?#".contains(c)) {
        return Err(format!(
            "SITE_URL should be the address of the page's folder, such as https://example.org/depth/, not \"{url}\"."
        ));
    }
    Ok(Some(format!("{}/", url.trim_end_matches('/'))))
}

fn build_at(dist: &Path, url: Option<&str>) -> Result<(), String> {
    let assets = root().join("assets");
    for (from, to) in COPIES {
        let content = fs::read(assets.join(from)).map_err(|error| format!("assets/{from} cannot be read: {error}."))?;
        write(dist, to, content)?;
    }

    let program = read(&dist.join(PROGRAM_PAGE))?;
    let policy = policy(&program)?.to_owned();
    let style = style(&assets, dist)?;
    let learn = learn_page(&assets, &style, &policy)?;
    write(dist, LEARN_PAGE, addressed(&learn, url, LEARN_PAGE)?)?;
    write(dist, LICENSES_PAGE, licenses_page(&assets, &style, &policy)?)?;
    write(dist, "robots.txt", robots(url))?;
    match url {
        Some(url) => write(dist, "sitemap.xml", sitemap(url))?,
        None => println!(
            "There is no sitemap and no canonical address: the environment variable SITE_URL does not say where this page will be."
        ),
    }

    let program = addressed(&program, url, "")?;
    let program = replace_once(
        &program,
        "<meta name=\"commit\" content=\"\">",
        &format!("<meta name=\"commit\" content=\"{}\">", commit().unwrap_or_default()),
    )?;
    write(dist, PROGRAM_PAGE, &program)?;
    let worker = read(&assets.join("web").join(WORKER))?;
    let build = build_id(dist, &worker)?;
    // The page has to know which build it is of, to tell whether another one is newer.
    let program = replace_once(
        &program,
        "<meta name=\"build\" content=\"\">",
        &format!("<meta name=\"build\" content=\"{build}\">"),
    )?;
    write(dist, PROGRAM_PAGE, program)?;
    write(dist, HEADERS, headers(&names(dist)?, &policy))?;
    write(dist, WORKER, service_worker(dist, &worker, &build)?)
}

/// The Content-Security-Policy in a page, which is that of the whole site.
fn policy(page: &str) -> Result<&str, String> {
    page.split_once("http-equiv=\"Content-Security-Policy\" content=\"")
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(policy, _)| policy)
        .ok_or_else(|| format!("{PROGRAM_PAGE} has no Content-Security-Policy."))
}

/// Writes the style of the pages that need no program. Returns its name.
fn style(assets: &Path, dist: &Path) -> Result<String, String> {
    let style = read(&assets.join("web/learn.css"))?;
    let mut hasher = DefaultHasher::new();
    style.hash(&mut hasher);
    let name = format!("learn-{:016x}.css", hasher.finish());
    write(dist, &name, style)?;
    Ok(name)
}

/// The texts of assets/licenses.txt.
fn licenses_page(assets: &Path, style: &str, policy: &str) -> Result<String, String> {
    let page = read(&assets.join("web").join(LICENSES_PAGE))?;
    let page = replace_once(&page, "{policy}", policy)?;
    let page = replace_once(&page, "{style}", style)?;
    replace_once(&page, "{text}", &escaped(&read(&assets.join("licenses.txt"))?))
}

fn learn_page(assets: &Path, style: &str, policy: &str) -> Result<String, String> {
    let learn = learn::read(&read(&assets.join("learn.md"))?)?;
    let page = read(&assets.join("web").join(LEARN_PAGE))?;
    let page = replace_once(&page, "{policy}", policy)?;
    let page = replace_once(&page, "{style}", style)?;
    let page = replace_once(&page, "{questions}", &learn.structured_data())?;
    let page = replace_once(&page, "{contents}", &learn.contents())?;
    // Last, because what it brings in is not ours to search for places.
    replace_once(&page, "{text}", &learn.html)
}

/// A page with what only a whole address can say: where it is, and which picture announces it elsewhere.
fn addressed(page: &str, url: Option<&str>, name: &str) -> Result<String, String> {
    let Some(url) = url else {
        return Ok(page.to_owned());
    };
    let page = replace_once(page, "content=\"og.png\"", &format!("content=\"{url}og.png\""))?;
    let here = format!("  <link rel=\"canonical\" href=\"{url}{name}\">\n  <meta property=\"og:url\" content=\"{url}{name}\">\n</head>");
    replace_once(&page, "</head>", &here)
}

fn robots(url: Option<&str>) -> String {
    let sitemap = url.map(|url| format!("Sitemap: {url}sitemap.xml\n"));
    format!("User-agent: *\nAllow: /\n{}", sitemap.unwrap_or_default())
}

fn sitemap(url: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n\
         \x20 <url><loc>{url}</loc></url>\n\
         \x20 <url><loc>{url}{LEARN_PAGE}</loc></url>\n\
         </urlset>\n"
    )
}

/// For hosts that read this file at the root of a site: the policy as a header, and which files never change.
fn headers(names: &[String], policy: &str) -> String {
    // A policy in the page itself cannot say who may put it into a frame.
    let everywhere = format!("/*\n  Content-Security-Policy: {policy}; frame-ancestors 'self'\n  X-Content-Type-Options: nosniff\n");
    let unchanging = names
        .iter()
        .filter(|name| is_hashed(name))
        .map(|name| format!("/{name}\n  Cache-Control: public, max-age=31536000, immutable\n"));
    std::iter::once(everywhere)
        .chain(unchanging)
        .chain([format!("/{WORKER}\n  Cache-Control: no-cache\n")])
        .collect()
}

/// Whether a hash of its content stands in a file's name.
fn is_hashed(name: &str) -> bool {
    name.split(['-', '.', '_'])
        .any(|part| part.len() == 16 && part.chars().all(|c| c.is_ascii_hexdigit()))
}

/// Stands for every byte of the site.
fn build_id(dist: &Path, worker: &str) -> Result<String, String> {
    let mut hasher = DefaultHasher::new();
    worker.hash(&mut hasher);
    for name in names(dist)?.iter().filter(|name| ![WORKER, HEADERS].contains(&name.as_str())) {
        name.hash(&mut hasher);
        fs::read(dist.join(name))
            .map_err(|error| format!("dist/{name} cannot be read: {error}."))?
            .hash(&mut hasher);
    }
    Ok(format!("{:016x}", hasher.finish()))
}

fn service_worker(dist: &Path, template: &str, build: &str) -> Result<String, String> {
    let mut files = Vec::new();
    for name in names(dist)?.iter().filter(|name| !NOT_FOR_VISITORS.contains(&name.as_str())) {
        // Some hosts redirect from the long name, and all of them show it under the short one.
        let address = if name == PROGRAM_PAGE { "./" } else { name };
        files.push((address.to_owned(), integrity(&dist.join(name))?));
    }
    let worker = replace_once(template, "const BUILD = '';", &format!("const BUILD = '{build}';"))?;
    replace_once(
        &worker,
        "const FILES = [];",
        &format!("const FILES = {};", serde_json::json!(files)),
    )
}

/// The digest of a file as an `integrity` attribute has it. Source: W3C, Subresource Integrity, 3.1.
fn integrity(file: &Path) -> Result<String, String> {
    let content = fs::read(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))?;
    Ok(format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(content))))
}

/// Every file in `dist` by its name in an address, in order.
fn names(dist: &Path) -> Result<Vec<String>, String> {
    let mut files = Vec::new();
    collect_files(dist, &mut files).map_err(|error| format!("dist/ cannot be read: {error}."))?;
    let mut names: Vec<String> = files
        .iter()
        .filter_map(|file| file.strip_prefix(dist).ok()?.to_str())
        .map(|name| name.replace(std::path::MAIN_SEPARATOR, "/"))
        .collect();
    names.sort();
    Ok(names)
}

fn read(file: &Path) -> Result<String, String> {
    fs::read_to_string(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))
}

fn write(dist: &Path, name: &str, content: impl AsRef<[u8]>) -> Result<(), String> {
    let file = dist.join(name);
    file.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(&file, content))
        .map_err(|error| format!("dist/{name} cannot be written: {error}."))
}

/// Fills a place that must be there exactly once.
fn replace_once(text: &str, place: &str, by: &str) -> Result<String, String> {
    match text.matches(place).count() {
        1 => Ok(text.replace(place, by)),
        count => Err(format!("A page of the site should have one place {place}; it has {count}.")),
    }
}

/// Text as it stands in HTML, also between double quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

    use std::collections::BTreeSet;
    use std::fs;
    use std::path::PathBuf;

    use serde_json::Value;

    use super::{build_at, is_hashed, names, policy, site_url};
    use crate::step::root;

    const URL: &str = "https://example.org/depth/";

    /// A folder as Trunk leaves it, which goes away with the test.
    struct Dist(PathBuf);

    impl Dist {
        fn new(test: &str) -> Self {
            let folder = std::env::temp_dir().join(format!("depth-calculator-site-{}-{test}", std::process::id()));
            fs::create_dir_all(&folder).unwrap();
            fs::copy(root().join("index.html"), folder.join("index.html")).unwrap();
            fs::write(folder.join("depth-calculator-0123456789abcdef_bg.wasm"), "a program").unwrap();
            Self(folder)
        }

        fn built(test: &str, url: Option<&str>) -> Self {
            let dist = Self::new(test);
            build_at(&dist.0, url).unwrap();
            dist
        }

        fn text(&self, name: &str) -> String {
            fs::read_to_string(self.0.join(name)).unwrap()
        }
    }

    impl Drop for Dist {
        fn drop(&mut self) {
            fs::remove_dir_all(&self.0).ok();
        }
    }

    /// What stands in the page's script element for structured data; it must have no other script of its own.
    fn structured_data(page: &str) -> Value {
        let (_, rest) = page.split_once("<script type=\"application/ld+json\">").unwrap();
        serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
    }

    #[test]
    fn the_learn_page_is_whole_and_needs_no_script() {
        let dist = Dist::built("learn", None);
        let page = dist.text("learn.html");
        assert_eq!(page.matches("<h1").count(), 1);
        assert_eq!(page.matches("<script").count(), 1, "only the structured data");
        for attribute in [" style=", " onclick=", "{text}", "{policy}"] {
            assert!(!page.contains(attribute), "{attribute}");
        }
        for example in ["./#fx=700&amp;b=100mm&amp;d=50", "./#fx=950&amp;wimg=200&amp;wreal=0.9m"] {
            assert!(page.contains(&format!("<a href=\"{example}\">")), "{example}");
        }
        let markdown = fs::read_to_string(root().join("assets/learn.md")).unwrap();
        let formulas = markdown.split("```math\n").skip(1);
        let lines: usize = formulas.map(|block| block.split("```").next().unwrap().lines().count()).sum();
        assert!(lines >= 10);
        assert_eq!(
            page.matches("<math ").count(),
            lines,
            "every formula, and all of them were understood"
        );
        for part in ["href=\"", "src=\""] {
            for address in page.split(part).skip(1) {
                let address = address.split('"').next().unwrap();
                let inside = address.strip_prefix('#').is_some_and(|id| page.contains(&format!("id=\"{id}\"")));
                let file = address.split('#').next().unwrap();
                let there = file == "./" || (!file.is_empty() && dist.0.join(file).is_file());
                // Trunk copies these, as the other page asks it to.
                let by_trunk = root().join("assets").join(file).is_file();
                assert!(inside || there || by_trunk, "{address} leads nowhere");
            }
        }
    }

    #[test]
    fn search_engines_get_the_eight_questions_with_their_answers() {
        let data = structured_data(&Dist::built("questions", None).text("learn.html"));
        assert_eq!(data["@type"], "FAQPage");
        let questions = data["mainEntity"].as_array().unwrap();
        assert_eq!(questions.len(), 8);
        for question in questions {
            assert!(question["name"].as_str().unwrap().ends_with('?'), "{question}");
            assert!(question["acceptedAnswer"]["text"].as_str().unwrap().len() > 60, "{question}");
        }
        assert_eq!(questions[3]["name"], "Which units should I use?");
    }

    #[test]
    fn the_programs_page_describes_itself() {
        let dist = Dist::built("program", None);
        let page = dist.text("index.html");
        assert_eq!(structured_data(&page)["@type"], "WebApplication");
        assert!(page.contains("href=\"learn.html\""));
        assert_eq!(policy(&page).unwrap(), policy(&dist.text("learn.html")).unwrap());
        assert!(dist.text("_headers").contains(policy(&page).unwrap()));
        for unsafe_source in ["unsafe-inline", "'unsafe-eval'", "*", "http", "data:"] {
            assert!(!policy(&page).unwrap().contains(unsafe_source), "{unsafe_source}");
        }
    }

    #[test]
    fn the_licenses_are_a_page_of_their_own_and_the_program_knows_its_commit() {
        let dist = Dist::built("licenses", None);
        let page = dist.text("licenses.html");
        for part in ["MPL-2.0", "SIL Open Font License", "  egui ", "default-src 'none'"] {
            assert!(page.contains(part), "{part}");
        }
        assert!(!page.contains("<script") && !page.contains("{text}") && !page.contains("<me@"));
        let program = dist.text("index.html");
        let commit = program
            .split_once("<meta name=\"commit\" content=\"")
            .unwrap()
            .1
            .split_once('"')
            .unwrap()
            .0;
        assert_eq!(commit, crate::origin::commit().unwrap_or_default());
    }

    #[test]
    fn the_service_worker_keeps_every_file_that_a_visitor_needs() {
        let dist = Dist::built("worker", Some(URL));
        let worker = dist.text("sw.js");
        let list = worker.split_once("const FILES = ").unwrap().1.split_once(';').unwrap().0;
        let pairs: Vec<(String, String)> = serde_json::from_str(list).unwrap();
        for (name, digest) in &pairs {
            let file = if name == "./" { "index.html" } else { name };
            assert_eq!(
                *digest,
                super::integrity(&dist.0.join(file)).unwrap(),
                "{name}: of the file as it is served"
            );
        }
        let listed: BTreeSet<String> = pairs.into_iter().map(|(name, _)| name).collect();
        let mut there: BTreeSet<String> = names(&dist.0).unwrap().into_iter().collect();
        for not_for_visitors in ["sw.js", "_headers", "licenses.html", "og.png", "robots.txt", "sitemap.xml"] {
            assert!(there.remove(not_for_visitors), "{not_for_visitors}");
        }
        assert!(there.remove("index.html") && there.insert("./".to_owned()));
        assert_eq!(listed, there);
        let build = worker.split_once("const BUILD = '").unwrap().1.split_once('\'').unwrap().0;
        assert!(is_hashed(build), "{build}");
        assert!(
            dist.text("index.html")
                .contains(&format!("<meta name=\"build\" content=\"{build}\">"))
        );
    }

    #[test]
    fn a_build_is_named_by_its_content() {
        let build = |dist: &Dist| dist.text("sw.js").split('\'').nth(1).unwrap().to_owned();
        let [first, same, other] = ["first", "same", "other"].map(Dist::new);
        fs::write(other.0.join("depth-calculator-0123456789abcdef_bg.wasm"), "another program").unwrap();
        for dist in [&first, &same, &other] {
            build_at(&dist.0, None).unwrap();
        }
        assert_eq!(build(&first), build(&same));
        assert_ne!(build(&first), build(&other));
    }

    #[test]
    fn whole_addresses_stand_where_the_site_is_known_and_nowhere_else() {
        let known = Dist::built("known", Some(URL));
        for (page, here) in [("index.html", URL.to_owned()), ("learn.html", format!("{URL}learn.html"))] {
            let text = known.text(page);
            assert!(text.contains(&format!("<link rel=\"canonical\" href=\"{here}\">")), "{page}");
            assert!(text.contains(&format!("content=\"{URL}og.png\"")), "{page}");
            assert!(known.text("sitemap.xml").contains(&format!("<loc>{here}</loc>")), "{page}");
        }
        assert!(known.text("robots.txt").contains(&format!("Sitemap: {URL}sitemap.xml")));

        let unknown = Dist::built("unknown", None);
        assert!(!unknown.0.join("sitemap.xml").exists());
        assert!(!unknown.text("robots.txt").contains("Sitemap"));
        for page in ["index.html", "learn.html"] {
            let text = unknown.text(page);
            assert!(!text.contains("canonical") && !text.contains("og:url"), "{page}");
        }
    }

    #[test]
    fn a_site_url_is_a_folders_address() {
        assert_eq!(site_url("").unwrap(), None);
        for url in [
            "https://example.org/depth",
            "https://example.org/depth/",
            "https://example.org/depth//",
        ] {
            assert_eq!(site_url(url).unwrap().unwrap(), URL);
        }
        for url in [
            "example.org",
            "/depth/",
            "https://example.org/?a",
            "https://example.org/\"",
            "javascript:x",
        ] {
            assert!(site_url(url).is_err(), "{url}");
        }
    }

    #[test]
    fn the_manifest_can_be_installed() {
        let dist = Dist::built("manifest", None);
        let manifest: Value = serde_json::from_str(&dist.text("manifest.webmanifest")).unwrap();
        assert_eq!(
            (&manifest["start_url"], &manifest["scope"]),
            (&Value::from("./"), &Value::from("./"))
        );
        assert_eq!(manifest["display"], "standalone");
        let icons = manifest["icons"].as_array().unwrap();
        let mut kinds: Vec<String> = Vec::new();
        for icon in icons {
            // Width and height stand in bytes 16 to 24 of a PNG.
            let png = fs::read(dist.0.join(icon["src"].as_str().unwrap())).unwrap();
            let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
            assert_eq!(icon["sizes"], format!("{}x{}", side(16), side(20)), "{icon}");
            kinds.push(format!("{} {}", side(16), icon["purpose"].as_str().unwrap()));
        }
        assert_eq!(kinds, ["192 any", "512 any", "192 maskable", "512 maskable"]);
    }

    /// The colours of a palette in the program's theme: its fields' names and `#rrggbb`.
    fn palette(theme: &str, name: &str) -> Vec<(String, String)> {
        let (_, rest) = theme.split_once(&format!("const {name}: Palette = Palette {{")).unwrap();
        let fields = rest
            .split_once("};")
            .unwrap()
            .0
            .lines()
            .filter_map(|line| line.trim().split_once(": "));
        fields
            .map(|(field, value)| {
                let colour = value.replace("Color32::WHITE", "ffffff").replace("Color32::from_rgb", "");
                let digits = colour.replace("0x", "").replace(['(', ')', ',', ' '], "");
                (field.to_owned(), format!("#{digits}"))
            })
            .collect()
    }

    #[test]
    fn the_pages_have_the_colours_of_the_program() {
        let theme = fs::read_to_string(root().join("src/app/theme/palette.rs")).unwrap();
        for file in ["assets/web/learn.css", "assets/web/page.css"] {
            let style = fs::read_to_string(root().join(file)).unwrap();
            let (light, rest) = style.split_once("@media (prefers-color-scheme: dark)").unwrap();
            let dark = rest.split_once("\n}").unwrap().0;
            for (part, name) in [(light, "LIGHT"), (dark, "DARK")] {
                let palette = palette(&theme, name);
                let variables: Vec<(&str, &str)> = part
                    .lines()
                    .filter_map(|line| line.trim().strip_prefix("--")?.split_once(": "))
                    .collect();
                assert!(variables.len() >= 6, "{file}");
                for (variable, colour) in variables {
                    let field = (variable.replace('-', "_"), colour.trim_end_matches(';').to_owned());
                    assert!(palette.contains(&field), "{file}, {name}: {field:?}");
                }
            }
        }
        let page = |name| palette(&theme, name).into_iter().find(|(field, _)| field == "page").unwrap().1;
        for file in ["index.html", "assets/web/learn.html"] {
            let html = fs::read_to_string(root().join(file)).unwrap();
            for (name, scheme) in [("LIGHT", "light"), ("DARK", "dark")] {
                let meta = format!(
                    "<meta name=\"theme-color\" content=\"{}\" media=\"(prefers-color-scheme: {scheme})\">",
                    page(name)
                );
                assert!(html.contains(&meta), "{file}: {meta}");
            }
        }
        let manifest = fs::read_to_string(root().join("assets/web/manifest.webmanifest")).unwrap();
        assert_eq!(manifest.matches(&page("LIGHT")).count(), 2);
    }

    #[test]
    fn files_with_a_hash_in_their_names_are_told_from_the_others() {
        assert!(is_hashed("depth-calculator-ba709360be7a27e3_bg.wasm"));
        assert!(is_hashed("learn-0123456789abcdef.css"));
        for name in ["index.html", "icons/icon-192.png", "sw.js"] {
            assert!(!is_hashed(name), "{name}");
        }
    }
}
