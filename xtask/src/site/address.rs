//! Where the site will be, and what only a whole address can say: canonical links, the sitemap, robots.txt.

use super::folder::LEARN_PAGE;
use super::html::replace_once;

/// `url` with one slash at its end, `None` if it is empty.
pub(super) fn site_url(url: &str) -> Result<Option<String>, String> {
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

/// A page with what only a whole address can say: where it is, and which picture announces it elsewhere.
pub(super) fn addressed(page: &str, url: Option<&str>, name: &str) -> Result<String, String> {
    let Some(url) = url else {
        return Ok(page.to_owned());
    };
    let page = replace_once(page, "content=\"og.png\"", &format!("content=\"{url}og.png\""))?;
    let here = format!("  <link rel=\"canonical\" href=\"{url}{name}\">\n  <meta property=\"og:url\" content=\"{url}{name}\">\n</head>");
    replace_once(&page, "</head>", &here)
}

pub(super) fn robots(url: Option<&str>) -> String {
    let sitemap = url.map(|url| format!("Sitemap: {url}sitemap.xml\n"));
    format!("User-agent: *\nAllow: /\n{}", sitemap.unwrap_or_default())
}

pub(super) fn sitemap(url: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n\
         \x20 <url><loc>{url}</loc></url>\n\
         \x20 <url><loc>{url}{LEARN_PAGE}</loc></url>\n\
         </urlset>\n"
    )
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::site_url;

    #[test]
    fn a_site_url_is_a_folders_address() {
        assert_eq!(site_url("").unwrap(), None);
        for url in [
            "https://example.org/depth",
            "https://example.org/depth/",
            "https://example.org/depth//",
        ] {
            assert_eq!(site_url(url).unwrap().unwrap(), "https://example.org/depth/");
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
}
