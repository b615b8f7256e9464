//! The parts of a WebAssembly module.
//!
//! Source: WebAssembly Core Specification 2.0, 5.5 "Modules".

/// A section: its number, and its content.
pub(super) type Section<'a> = (u8, &'a [u8]);

pub(super) const CODE: u8 = 10;
pub(super) const DATA: u8 = 11;

/// What stands in a section with this number.
pub(super) const fn section_name(id: u8) -> &'static str {
    match id {
        CODE => "code",
        DATA => "data: fonts, texts, tables",
        9 => "tables of functions that are called by reference",
        3 => "types of the functions",
        2 => "imports",
        _ => "everything else",
    }
}

/// The sections in their order. `None` for what is no module.
pub(super) fn sections(module: &[u8]) -> Option<Vec<Section<'_>>> {
    let mut rest = module.strip_prefix(b"\0asm\x01\0\0\0")?;
    let mut sections = Vec::new();
    while let Some((&id, after_id)) = rest.split_first() {
        let (size, content) = leb128(after_id)?;
        let (section, after) = content.split_at_checked(size)?;
        sections.push((id, section));
        rest = after;
    }
    Some(sections)
}

/// How many bytes each function has, in the content of the section of code.
pub(super) fn functions(code: &[u8]) -> Option<Vec<usize>> {
    let (count, mut rest) = leb128(code)?;
    let mut functions = Vec::new();
    for _ in 0..count {
        let (size, body) = leb128(rest)?;
        let after = body.get(size..)?;
        functions.push(rest.len() - after.len());
        rest = after;
    }
    Some(functions)
}

/// An unsigned number in LEB128, seven bits to a byte, and what follows it.
fn leb128(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let mut number = 0_usize;
    for (at, &byte) in bytes.iter().enumerate() {
        let shift = u32::try_from(at).ok()?.checked_mul(7)?;
        number |= usize::from(byte & 0x7f).checked_shl(shift)?;
        if byte & 0x80 == 0 {
            return Some((number, bytes.get(at + 1..)?));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{functions, leb128, sections};

    #[test]
    fn sections_are_read_to_the_end() {
        let long = [&[10, 0x80, 0x01][..], &[0; 128]].concat();
        let module = [b"\0asm\x01\0\0\0".as_slice(), &[11, 2, 7, 7], &long, &[0, 1, 0]].concat();
        let parts: Vec<(u8, usize)> = sections(&module)
            .unwrap()
            .iter()
            .map(|(id, content)| (*id, content.len()))
            .collect();
        assert_eq!(parts, [(11, 2), (10, 128), (0, 1)]);
        assert_eq!(sections(module.get(..module.len() - 4).unwrap()), None, "cut off");
        assert_eq!(sections(b"<!doctype html>"), None);
    }

    #[test]
    fn functions_are_counted_with_their_lengths() {
        assert_eq!(functions(&[2, 3, 0, 1, 11, 2, 0, 11]), Some(vec![4, 3]));
        assert_eq!(functions(&[2, 3, 0, 1, 11]), None, "cut off");
    }

    #[test]
    fn numbers_are_read_as_they_are_written() {
        // An example of the DWARF standard, section 7.6.
        assert_eq!(leb128(&[0xb9, 0x64, 5]), Some((12857, [5].as_slice())));
        assert_eq!(leb128(&[0x80]), None);
    }
}
