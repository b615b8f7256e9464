//! `cargo xtask dist desktop`: the archive that is given away, with nothing of the builder's computer in it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::origin::{cargo_home, commit, commit_time, nameless};
use crate::prerequisites::{self, Needs};
use crate::step::{cargo, command, on_path, output, root, run, step, target};
use crate::tools;

/// Bytes on the disk, as measured with `du`.
const BUILD_BYTES: u64 = 2_000_000_000;
const NAME: &str = "depth-calculator";

/// Copied into the archive as they are: from the workspace's folder, to the archive's.
const COPIES: &[(&str, &str)] = &[
    ("assets/archive.md", "README.md"),
    ("CHANGELOG.md", "CHANGELOG.md"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
    ("assets/licenses.txt", "licenses-of-others.txt"),
];
/// What a Linux desktop wants besides: the layout of /usr and of ~/.local.
const LINUX: &[(&str, &str)] = &[
    (
        "assets/linux/depth-calculator.desktop",
        "share/applications/depth-calculator.desktop",
    ),
    ("assets/icons/icon-256.png", "share/icons/hicolor/256x256/apps/depth-calculator.png"),
    ("assets/icons/icon.svg", "share/icons/hicolor/scalable/apps/depth-calculator.svg"),
];
/// Shell, and what its completions are called there.
const SHELLS: &[(&str, &str)] = &[
    ("bash", "completions/depth-calculator.bash"),
    ("zsh", "completions/_depth-calculator"),
    ("fish", "completions/depth-calculator.fish"),
    ("powershell", "completions/depth-calculator.ps1"),
];

/// Builds the program for `triple`, or for this computer, and packs it. The last line printed is the archive's path.
pub(crate) fn desktop(triple: Option<&str>) -> Result<(), String> {
    prerequisites::check(Needs {
        node: false,
        build_bytes: BUILD_BYTES,
    })?;
    let host = host()?;
    let triple = triple.unwrap_or(&host);
    let program = step("Build the desktop program (2 to 5 minutes on two cores)", || build(triple))?;
    step("Look for folders of this computer in it", || find_names(&program))?;
    let archive = step("Pack it", || pack(triple, &program))?;
    println!("{}", archive.display());
    Ok(())
}

/// What Rust calls this computer.
fn host() -> Result<String, String> {
    let version = output(&mut command("rustc", &["--version", "--verbose"])).ok_or("rustc could not be run.")?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned)
        .ok_or_else(|| "rustc does not say what this computer is.".to_owned())
}

/// The program's version.
fn version() -> Result<String, String> {
    let id = output(&mut cargo(&["pkgid", "--locked", "--package", NAME])).ok_or("cargo does not say which version this is.")?;
    let version = id.rsplit(['#', '@']).next();
    version.map(str::to_owned).ok_or_else(|| format!("No version stands in {id}."))
}

/// The folders that could stand in the program, and what stands there instead.
fn folders() -> Result<[(Option<PathBuf>, &'static str); 3], String> {
    let std_sources = tools::sysroot()?.join("lib/rustlib/src/rust");
    Ok([(cargo_home(), "cargo"), (Some(std_sources), "rust"), (Some(root()), NAME)])
}

fn build(triple: &str) -> Result<PathBuf, String> {
    let flags = nameless(&folders()?).ok_or("A folder's name has a space in it, which cargo cannot remap: build in another folder.")?;
    let variable = format!("CARGO_TARGET_{}_RUSTFLAGS", triple.to_ascii_uppercase().replace('-', "_"));
    let mut build = cargo(&["build", "--release", "--locked", "--package", NAME, "--target", triple]);
    build.env(variable, flags);
    if let Some(commit) = commit() {
        build.env("DEPTH_CALCULATOR_COMMIT", commit);
    }
    // For the manual page, unless whoever builds has a date of their own.
    if let Some(time) = commit_time().filter(|_| std::env::var_os("SOURCE_DATE_EPOCH").is_none()) {
        build.env("SOURCE_DATE_EPOCH", time);
    }
    run(&mut build)?;
    let suffix = if triple.contains("windows") { ".exe" } else { "" };
    Ok(target().join(triple).join("release").join(format!("{NAME}{suffix}")))
}

/// Err: a sentence, where the program names a folder of this computer.
fn find_names(program: &Path) -> Result<(), String> {
    let content = fs::read(program).map_err(|error| format!("{} cannot be read: {error}.", program.display()))?;
    let own = [std::env::home_dir(), cargo_home(), Some(tools::sysroot()?), Some(root())];
    for folder in own.into_iter().flatten() {
        // A short one, such as /root, is also a word of D-Bus; what it holds is looked for by itself.
        let Some(name) = folder.to_str().filter(|_| folder.components().count() > 2) else {
            continue;
        };
        let count = occurrences(&content, name.as_bytes());
        println!("{count:>6}  {name}");
        if count > 0 {
            return Err(format!(
                "The program names {name} {count} times; see --remap-path-prefix in xtask/src/package.rs."
            ));
        }
    }
    Ok(())
}

/// How often `name` stands in `content` as the start of a path.
fn occurrences(content: &[u8], name: &[u8]) -> usize {
    let starts = content.windows(name.len() + 1).filter(|window| window.starts_with(name));
    starts
        .filter(|window| window.last().is_some_and(|&next| next == b'/' || next == b'\\'))
        .count()
}

fn pack(triple: &str, program: &Path) -> Result<PathBuf, String> {
    let name = format!("{NAME}-{}-{triple}", version()?);
    let parent = target().join("desktop");
    let folder = parent.join(&name);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("{} cannot be emptied: {error}.", folder.display()))?;
    }
    let linux = if triple.contains("linux") { LINUX } else { &[] };
    for (from, to) in COPIES.iter().chain(linux) {
        copy(&root().join(from), &folder.join(to))?;
    }
    copy(program, &folder.join(program.file_name().unwrap_or_default()))?;
    for (shell, file) in SHELLS {
        write(&folder.join(file), &said(program, &["completions", shell])?)?;
    }
    if !triple.contains("windows") {
        write(&folder.join("share/man/man1/depth-calculator.1"), &said(program, &["man"])?)?;
    }

    let is_zip = triple.contains("windows");
    let archive = parent.join(format!("{name}{}", if is_zip { ".zip" } else { ".tar.gz" }));
    // Windows has a tar that also writes zip; another one, of a shell, may stand before it on PATH.
    let windows = std::env::var_os("SystemRoot").map(|folder| PathBuf::from(folder).join("System32").join("tar.exe"));
    let tar = windows
        .filter(|tar| tar.is_file())
        .or_else(|| on_path("tar"))
        .ok_or("There is no `tar` to pack with.")?;
    let mut pack = command(tar, &[if is_zip { "-acf" } else { "-czf" }]);
    pack.arg(&archive);
    if cfg!(target_os = "linux") {
        // Not the name of whoever builds.
        pack.args(["--owner=0", "--group=0", "--numeric-owner"]);
    } else if cfg!(target_os = "macos") {
        pack.args(["--uid", "0", "--gid", "0", "--uname", "", "--gname", ""])
            .env("COPYFILE_DISABLE", "1");
    }
    run(pack.arg("-C").arg(&parent).arg(&name))?;
    Ok(archive)
}

/// What the program prints. It has to run on this computer.
fn said(program: &Path, arguments: &[&str]) -> Result<String, String> {
    output(&mut command(program, arguments)).ok_or_else(|| format!("`{NAME} {}` failed on this computer.", arguments.join(" ")))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    make_parent(to)?;
    fs::copy(from, to)
        .map(drop)
        .map_err(|error| format!("{} cannot be copied: {error}.", from.display()))
}

fn write(file: &Path, text: &str) -> Result<(), String> {
    make_parent(file)?;
    fs::write(file, format!("{text}\n")).map_err(|error| format!("{} cannot be written: {error}.", file.display()))
}

fn make_parent(file: &Path) -> Result<(), String> {
    let parent = file.parent().unwrap_or(file);
    fs::create_dir_all(parent).map_err(|error| format!("{} cannot be made: {error}.", parent.display()))
}

#[cfg(test)]
mod tests {
    use super::occurrences;

    #[test]
    fn a_folder_is_found_where_a_path_starts_with_it() {
        let content = b"at /home/ann/x.rs, /home/anna/y.rs, /home/ann and /home/ann\\z";
        assert_eq!(occurrences(content, b"/home/ann"), 2);
        assert_eq!(occurrences(content, b"/root"), 0);
    }
}
