//! Folders of files.

use std::fs;
use std::path::{Path, PathBuf};

/// Adds the files in `folder` and below to `files`.
pub(crate) fn collect_files(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect_files(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
