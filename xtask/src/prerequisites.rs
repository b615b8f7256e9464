//! What must be there before minutes are spent: looked for in a second, and said all at once.

use crate::step::{command, on_path, output, target, version};

/// What a command needs besides Rust.
#[derive(Clone, Copy, Default)]
pub(crate) struct Needs {
    /// Node.js and npm.
    pub(crate) node: bool,
    /// Bytes on the disk for a build from nothing.
    pub(crate) build_bytes: u64,
}

/// Oldest Node.js with `import.meta.dirname`, which the browser tests use: major and minor version.
const OLDEST_NODE: (u32, u32) = (20, 11);
/// What a build takes where another one has been.
const REBUILD_BYTES: u64 = 1_000_000_000;

/// Looks for everything and prints what it found. Err: what is missing, a line each.
pub(crate) fn check(needs: Needs) -> Result<(), String> {
    let mut found = vec![linker(), room(needs.build_bytes)];
    if needs.node {
        found.extend([node(), npm()]);
    }
    let missing: Vec<String> = found.iter().filter_map(|one| one.as_ref().err().cloned()).collect();
    println!("Prerequisites");
    for one in &found {
        match one {
            Ok(what) => println!("  ok       {what}"),
            Err(what) => println!("  missing  {what}"),
        }
    }
    if missing.is_empty() {
        Ok(())
    } else {
        Err(format!("Before this can start:\n{}", missing.join("\n")))
    }
}

/// Rust links with the C compiler of the system; on Windows it finds the one of Visual Studio by itself.
fn linker() -> Result<String, String> {
    if cfg!(windows) {
        return Ok("C linker: Rust's own search".to_owned());
    }
    let first_line = |text: String| text.lines().next().unwrap_or_default().to_owned();
    version("cc")
        .map(|version| format!("C linker: {}", first_line(version)))
        .ok_or_else(|| {
            "A C linker, the program `cc`: on Debian and Ubuntu `apt-get install gcc libc6-dev`, on macOS `xcode-select --install`."
                .to_owned()
        })
}

fn room(build_bytes: u64) -> Result<String, String> {
    const MB: u64 = 1_000_000;
    let folder = target();
    // A build of the program was here before; what holds this command alone is small.
    let is_built = folder
        .join("debug")
        .join(format!("depth-calculator{}", std::env::consts::EXE_SUFFIX))
        .is_file();
    let needed = if is_built { REBUILD_BYTES.min(build_bytes) } else { build_bytes };
    match fs4::available_space(folder.parent().unwrap_or(&folder)) {
        Ok(free) if free < needed => Err(format!(
            "Room on the disk: {} holds {} MB more, and the builds need about {} MB.",
            folder.display(),
            free / MB,
            needed / MB
        )),
        Ok(free) => Ok(format!("disk: {} MB free, about {} needed", free / MB, needed / MB)),
        // Not worth a refusal: the build itself says when the disk is full.
        Err(error) => Ok(format!("disk: unknown ({error})")),
    }
}

/// The version of Node.js. Err: a sentence, where there is none that will do.
pub(crate) fn node() -> Result<String, String> {
    let (major, minor) = OLDEST_NODE;
    let wanted = format!("Node.js {major}.{minor} or newer on PATH");
    let found = output(&mut command("node", &["--version"])).ok_or_else(|| format!("{wanted}, from nodejs.org or your system."))?;
    if parse_node(&found).is_some_and(|version| version >= OLDEST_NODE) {
        Ok(format!("Node.js {}", found.trim_start_matches('v')))
    } else {
        Err(format!("{wanted}; this is {found}."))
    }
}

/// Major and minor version, of "v20.11.0".
fn parse_node(text: &str) -> Option<(u32, u32)> {
    let mut numbers = text.strip_prefix('v')?.split('.').map(str::parse);
    Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
}

fn npm() -> Result<String, String> {
    let npm = on_path("npm").ok_or("npm on PATH: it comes with Node.js, on Debian and Ubuntu as the package `npm`.")?;
    Ok(format!("npm {}", version(npm).unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::{OLDEST_NODE, parse_node};

    #[test]
    fn node_20_10_is_too_old_and_20_11_is_not() {
        let old_enough = |text| parse_node(text).is_some_and(|version| version >= OLDEST_NODE);
        assert!(!old_enough("v18.19.0") && !old_enough("v20.10.0") && !old_enough("20.11.0") && !old_enough("v20"));
        assert!(old_enough("v20.11.0") && old_enough("v20.20.2") && old_enough("v22.0.0"));
    }
}
