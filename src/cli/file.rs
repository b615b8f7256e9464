//! Files that are named on the command line; - is standard input.

use depth_files::{LARGEST, is_jpeg};
use depth_text::sentences::CommandLine;
use std::io::Read as _;
use std::path::Path;

/// What is in `file`, or a sentence that says why it cannot be read.
pub(super) fn bytes(file: &Path) -> Result<Vec<u8>, String> {
    let name = || file.display().to_string();
    let unreadable = |error: &std::io::Error| {
        let reason = error.to_string();
        let reason = reason.split(" (os error").next().unwrap_or_default().to_owned();
        CommandLine::UnreadableFile { file: name(), reason }.to_string()
    };
    let mut bytes = Vec::new();
    // One byte more tells whether there is more.
    let most = u64::try_from(LARGEST).unwrap_or(u64::MAX).saturating_add(1);
    let read = if file == Path::new("-") {
        std::io::stdin().lock().take(most).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(file).and_then(|file| file.take(most).read_to_end(&mut bytes))
    };
    read.map_err(|error| unreadable(&error))?;
    if bytes.len() > LARGEST && is_jpeg(&bytes) {
        bytes.truncate(LARGEST);
    } else if bytes.len() > LARGEST {
        return Err(CommandLine::FileTooLarge { file: name() }.to_string());
    }
    Ok(bytes)
}
