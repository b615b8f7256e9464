//! The Content-Security-Policy, and headers for hosts that read them from a file.

use super::folder::{PROGRAM_PAGE, WORKER, is_hashed};

/// The Content-Security-Policy in a page, which is that of the whole site.
pub(super) fn policy(page: &str) -> Result<&str, String> {
    page.split_once("http-equiv=\"Content-Security-Policy\" content=\"")
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(policy, _)| policy)
        .ok_or_else(|| format!("{PROGRAM_PAGE} has no Content-Security-Policy."))
}

/// For hosts that read this file at the root of a site: the policy as a header, and which files never change.
pub(super) fn headers(names: &[String], policy: &str) -> String {
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
