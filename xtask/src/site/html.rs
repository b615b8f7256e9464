//! Text that becomes HTML.

/// Fills a place that must be there exactly once.
pub(super) fn replace_once(text: &str, place: &str, by: &str) -> Result<String, String> {
    match text.matches(place).count() {
        1 => Ok(text.replace(place, by)),
        count => Err(format!("A page of the site should have one place {place}; it has {count}.")),
    }
}

/// Text as it stands in HTML, also between double quotes.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
