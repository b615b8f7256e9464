//! The whole site, built into a folder.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use super::build_at;
use super::folder::{is_hashed, names};
use super::headers::policy;
use super::worker::integrity;
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
fn search_engines_get_the_questions_with_their_answers() {
    let data = structured_data(&Dist::built("questions", None).text("learn.html"));
    assert_eq!(data["@type"], "FAQPage");
    let questions = data["mainEntity"].as_array().unwrap();
    assert_eq!(questions.len(), 10);
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
            integrity(&dist.0.join(file)).unwrap(),
            "{name}: of the file as it is served"
        );
    }
    let listed: BTreeSet<String> = pairs.into_iter().map(|(name, _)| name).collect();
    let mut there: BTreeSet<String> = names(&dist.0).unwrap().into_iter().collect();
    for not_for_visitors in [
        "sw.js",
        "_headers",
        "licenses.html",
        "icons/screenshot.png",
        "icons/screenshot-phone.png",
        "og.png",
        "robots.txt",
        "sitemap.xml",
    ] {
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
