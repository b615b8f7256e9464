//! `cargo xtask serve`: builds the page and serves it on this computer.

use std::fs::File;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Component, Path, PathBuf};

use tiny_http::{Header, Request, Response, Server};

use crate::dist;
use crate::step::command;

/// Builds the page, then answers requests at `http://127.0.0.1:{port}/` until it is interrupted.
pub(crate) fn run(port: u16) -> Result<(), String> {
    // Before the build, so that nobody waits minutes for this refusal.
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| match error.kind() {
        io::ErrorKind::AddrInUse => {
            format!(
                "Port {port} is in use by another program. Choose another one: cargo xtask serve --port {}",
                port.saturating_add(1).max(1024)
            )
        }
        _ => format!("Port {port} cannot be opened: {error}."),
    })?;
    let dist = dist::checked_build(false)?;
    let server = Server::from_listener(listener, None).map_err(|error| format!("The server cannot start: {error}."))?;

    let address = format!("http://127.0.0.1:{port}/");
    println!("\nDepth Calculator is at {address}\nEnd with Ctrl+C. After a change, start this command again.");
    if has_desktop() {
        open_browser(&address);
    }
    for request in server.incoming_requests() {
        let dist = dist.clone();
        // A browser that stops listening in the middle of an answer is no concern of ours.
        std::thread::spawn(move || answer(request, &dist).ok());
    }
    Ok(())
}

fn answer(request: Request, dist: &Path) -> io::Result<()> {
    let Some(file) = file_for(request.url(), dist) else {
        return request.respond(Response::from_string("There is no such file.").with_status_code(404));
    };
    let content = File::open(&file)?;
    let mut response = Response::from_file(content);
    // Else the browser might show the page of the build before.
    for (name, value) in [("Content-Type", content_type(&file)), ("Cache-Control", "no-cache")] {
        if let Ok(header) = Header::from_bytes(name, value) {
            response.add_header(header);
        }
    }
    request.respond(response)
}

/// The file that a request means, if there is one inside `dist`.
fn file_for(url: &str, dist: &Path) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.trim_start_matches('/');
    let inside = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
    let file = dist.join(if path.is_empty() { "index.html" } else { path });
    (inside && file.is_file()).then_some(file)
}

fn content_type(file: &Path) -> &'static str {
    match file.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("json") => "application/json",
        Some("txt") => "text/plain; charset=utf-8",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    }
}

/// Whether somebody sits in front of this computer.
fn has_desktop() -> bool {
    let set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("CI") && (cfg!(windows) || cfg!(target_os = "macos") || set("DISPLAY") || set("WAYLAND_DISPLAY"))
}

fn open_browser(address: &str) {
    let mut open = if cfg!(windows) {
        command("cmd", &["/C", "start", address])
    } else if cfg!(target_os = "macos") {
        command("open", &[address])
    } else {
        command("xdg-open", &[address])
    };
    // The address stands on the terminal anyway.
    open.stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .ok();
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::file_for;

    #[test]
    fn only_files_inside_the_folder_are_served() {
        let root = crate::step::root();
        let folder = root.join("src");
        assert_eq!(file_for("/main.rs?x=1", &folder).unwrap(), folder.join("main.rs"));
        assert_eq!(file_for("/../Cargo.toml", &folder), None, "a path out of the folder");
        assert_eq!(file_for("/app/../../Cargo.toml", &folder), None, "a path out of the folder");
        assert_eq!(file_for("//etc/hostname", &folder), None, "an absolute path");
        assert_eq!(file_for("/app", &folder), None, "a folder");
    }
}
