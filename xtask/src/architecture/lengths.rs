//! A file that is too long to be read at once holds more than one idea: at most three files have more than 400 lines, and each says
//! why in its first lines, with the words "Longer than".

use crate::files::collect_files;
use std::path::Path;

const LONGEST: usize = 400;
const MOST: usize = 3;
const FOLDERS: &[&str] = &["src", "crates", "tests", "benches", "xtask"];

/// The files that are too long without a reason, or too many of them.
pub(super) fn broken(root: &Path) -> Result<Vec<String>, String> {
    let mut files = vec![root.join("build.rs")];
    for folder in FOLDERS {
        collect_files(&root.join(folder), &mut files).map_err(|error| format!("{folder} cannot be read: {error}."))?;
    }
    let is_code = |file: &Path| {
        file.extension()
            .is_some_and(|extension| ["rs", "mjs", "js"].iter().any(|known| extension == *known))
    };
    let is_own = |file: &Path| {
        !file
            .components()
            .any(|part| ["node_modules", "target"].iter().any(|other| part.as_os_str() == *other))
    };
    files.retain(|file| is_code(file) && is_own(file));
    files.sort();
    let mut texts = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))?;
        let name = file.strip_prefix(root).unwrap_or(&file).display().to_string();
        texts.push((name, text));
    }
    Ok(complaints(&texts))
}

fn complaints(texts: &[(String, String)]) -> Vec<String> {
    let long: Vec<_> = texts.iter().filter(|(_, text)| text.lines().count() > LONGEST).collect();
    let without_reason = long
        .iter()
        .filter(|(_, text)| !text.lines().take(5).any(|line| line.contains("Longer than")));
    let mut complaints: Vec<String> = without_reason
        .map(|(name, text)| format!("{name} has {} lines and does not say why: divide it by idea.", text.lines().count()))
        .collect();
    if long.len() > MOST {
        let names: Vec<&str> = long.iter().map(|(name, _)| name.as_str()).collect();
        complaints.push(format!(
            "{} files have more than {LONGEST} lines, {MOST} may: {}.",
            long.len(),
            names.join(", ")
        ));
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_file_needs_a_reason_and_few_may_have_one() {
        let file = |head: &str, lines: usize| ("a.rs".to_owned(), format!("{head}\n{}", "x\n".repeat(lines)));
        assert!(complaints(&[file("", 399)]).is_empty());
        assert_eq!(complaints(&[file("", 400)]).len(), 1);
        let explained = || file("//! Longer than a file should be, as it is a table.", 400);
        assert!(complaints(&[explained(), explained(), explained()]).is_empty());
        assert_eq!(complaints(&[explained(), explained(), explained(), explained()]).len(), 1);
    }
}
