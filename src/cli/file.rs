//! Files that are named on the command line; - is standard input.

use depth_text::sentences::CommandLine;
use std::io::Read as _;
use std::path::Path;

/// The largest file that is read: one with hundreds of cameras is smaller.
const LARGEST: u64 = 16 << 20;

/// What is in `file`, or a sentence that says why it cannot be read.
pub(super) fn bytes(file: &Path) -> Result<Vec<u8>, String> {
    let name = || file.display().to_string();
    let unreadable = |error: &std::io::Error| {
        let reason = error.to_string();
        let reason = reason.split(" (os error").next().unwrap_or_default().to_owned();
        CommandLine::UnreadableFile { file: name(), reason }.to_string()
    };
    let mut bytes = Vec::new();
    let read = if file == Path::new("-") {
        std::io::stdin().lock().take(LARGEST + 1).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(file).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
    };
    let length = read.map_err(|error| unreadable(&error))?;
    let is_large = u64::try_from(length).is_ok_and(|length| length > LARGEST);
    if is_large && depth_jobs::is_photograph(&bytes) {
        bytes.pop();
    } else if is_large {
        return Err(CommandLine::FileTooLarge { file: name() }.to_string());
    }
    Ok(bytes)
}
