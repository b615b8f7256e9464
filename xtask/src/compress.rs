//! Sizes as a good host sends files: compressed by Node.js at its best.

use std::path::PathBuf;

use crate::step::{command, output};

/// The bytes of a file: as it is, with gzip, and with brotli.
pub(crate) type Sizes = [u64; 3];

/// The sizes of each file. Err: a sentence, also without Node.js.
pub(crate) fn sizes(files: &[PathBuf]) -> Result<Vec<Sizes>, String> {
    const SCRIPT: &str = "const zlib = require('zlib');
        for (const file of process.argv.slice(1)) {
            const content = require('fs').readFileSync(file);
            const gzip = zlib.gzipSync(content, { level: 9 });
            console.log(content.length, gzip.length, zlib.brotliCompressSync(content).length);
        }";
    let text = output(command("node", &["--eval", SCRIPT]).args(files)).ok_or("Compressed sizes need Node.js on PATH.")?;
    let sizes: Vec<Sizes> = text.lines().filter_map(three_numbers).collect();
    if sizes.len() == files.len() {
        Ok(sizes)
    } else {
        Err(format!(
            "Node.js should have printed {} lines of sizes; it printed: {text}",
            files.len()
        ))
    }
}

fn three_numbers(line: &str) -> Option<Sizes> {
    let numbers: Option<Vec<u64>> = line.split(' ').map(|number| number.parse().ok()).collect();
    numbers?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::three_numbers;

    #[test]
    fn a_line_has_three_numbers() {
        assert_eq!(three_numbers("1 2 3"), Some([1, 2, 3]));
        assert_eq!(three_numbers("1 2"), None);
    }
}
