//! What of a module is reached from its exports, once the functions are emptied that the program never calls. The linker has kept all of
//! it: it cannot know of those. With `--emit-relocs` it leaves in the module where each function and each piece of data refers to others.
//!
//! Source: WebAssembly tool conventions, "WebAssembly Object File Linking", sections "Symbol Table" and "Relocation Sections".

use anyhow::{Context as _, Result};
use std::ops::Range;
use wasmparser::{ExternalKind, KnownCustom, Linking, Parser, Payload, RelocationType, SymbolInfo};

/// What is reached.
pub struct Reached {
    /// For each function, imports left out, whether it is.
    pub functions: Vec<bool>,
    /// In each data segment, the bytes that nothing reaches.
    pub unreached: Vec<Vec<Range<usize>>>,
}

/// What can refer to something: a function, or a piece of data.
#[derive(Clone, Copy)]
enum Place {
    Function(usize),
    Data(usize),
}

/// A piece of data that has a name.
struct Piece {
    segment: usize,
    bytes: Range<usize>,
}

/// Where something stands in the module, and what is referred to there: the number of a symbol.
struct Reference {
    at: usize,
    symbol: usize,
}

/// What is read of a module.
#[derive(Default)]
struct Links {
    imported: u32,
    /// Where the body of each function stands in the module.
    bodies: Vec<Range<usize>>,
    /// Where the bytes of each data segment stand.
    segments: Vec<Range<usize>>,
    pieces: Vec<Piece>,
    /// What each symbol is the name of, where that is in the module.
    symbols: Vec<Option<Place>>,
    /// In the order of the module.
    references: Vec<Reference>,
    roots: Vec<Place>,
}

/// What is reached of `module` where the functions in `emptied`, imports left out, refer to nothing. None where the module does not say
/// what refers to what.
///
/// # Errors
/// Where the module cannot be read.
pub fn reached(module: &[u8], emptied: &[bool]) -> Result<Option<Reached>> {
    let links = Links::read(module)?;
    if links.references.is_empty() {
        return Ok(None);
    }
    let mut functions = vec![false; links.bodies.len()];
    let mut pieces = vec![false; links.pieces.len()];
    let mut left = links.roots.clone();
    while let Some(place) = left.pop() {
        let is_new = match place {
            Place::Function(at) => functions.get_mut(at),
            Place::Data(at) => pieces.get_mut(at),
        };
        if is_new.is_none_or(|reached| std::mem::replace(reached, true)) {
            continue;
        }
        let is_emptied = matches!(place, Place::Function(at) if emptied.get(at) == Some(&true));
        if let Some(bytes) = links.place(place).filter(|_| !is_emptied) {
            left.extend(links.referred(bytes));
        }
    }
    let unreached = links.unreached(&pieces);
    Ok(Some(Reached { functions, unreached }))
}

impl Links {
    fn read(module: &[u8]) -> Result<Self> {
        let mut links = Self::default();
        // Where the contents of each section begin, by its number.
        let mut sections = Vec::new();
        for payload in Parser::new(0).parse_all(module) {
            let payload = payload?;
            if let Some((_, range)) = payload.as_section() {
                sections.push(range.start);
            }
            match payload {
                Payload::ImportSection(section) => {
                    for import in section.into_imports() {
                        links.imported += u32::from(matches!(import?.ty, wasmparser::TypeRef::Func(_)));
                    }
                }
                Payload::ExportSection(section) => {
                    for export in section {
                        let export = export?;
                        links
                            .roots
                            .extend((export.kind == ExternalKind::Func).then(|| links.function(export.index)).flatten());
                    }
                }
                Payload::StartSection { func, .. } => links.roots.extend(links.function(func)),
                Payload::CodeSectionEntry(body) => links.bodies.push(body.range()),
                Payload::DataSection(section) => {
                    for data in section {
                        let data = data?;
                        links.segments.push(data.range.end - data.data.len()..data.range.end);
                    }
                }
                Payload::CustomSection(section) => match section.as_known() {
                    KnownCustom::Linking(linking) => links.read_symbols(linking)?,
                    KnownCustom::Reloc(relocations) => {
                        let of = usize::try_from(relocations.section_index())?;
                        let start = *sections.get(of).context("references of a section that is not there")?;
                        links.read_references(start, relocations.entries())?;
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        links.references.sort_by_key(|reference| reference.at);
        links.keep_nameless();
        Ok(links)
    }

    fn read_symbols(&mut self, linking: wasmparser::LinkingSectionReader<'_>) -> Result<()> {
        for part in linking {
            let Linking::SymbolTable(symbols) = part? else { continue };
            for symbol in symbols {
                let place = match symbol? {
                    SymbolInfo::Func { index, .. } => self.function(index),
                    SymbolInfo::Data { symbol: Some(data), .. } => {
                        let start = usize::try_from(data.offset)?;
                        self.pieces.push(Piece {
                            segment: usize::try_from(data.index)?,
                            bytes: start..start + usize::try_from(data.size)?,
                        });
                        Some(Place::Data(self.pieces.len() - 1))
                    }
                    _ => None,
                };
                self.symbols.push(place);
            }
        }
        Ok(())
    }

    fn read_references(&mut self, start: usize, entries: wasmparser::RelocationEntryReader<'_>) -> Result<()> {
        for entry in entries {
            let entry = entry?;
            // The number of a type is no number of a symbol.
            if entry.ty != RelocationType::TypeIndexLeb {
                self.references.push(Reference {
                    at: start + usize::try_from(entry.offset)?,
                    symbol: usize::try_from(entry.index)?,
                });
            }
        }
        Ok(())
    }

    /// What bytes refer to that belong to nothing with a name is reached: nobody knows whether they are.
    fn keep_nameless(&mut self) {
        let everything = vec![true; self.pieces.len()];
        for (segment, bytes) in self.segments.iter().enumerate() {
            let mut named = vec![false; bytes.len()];
            for range in self.covered(segment, &everything, true) {
                named.get_mut(range).unwrap_or_default().fill(true);
            }
            let nameless = self
                .between(bytes)
                .iter()
                .filter(|reference| named.get(reference.at - bytes.start) == Some(&false));
            let places: Vec<Place> = nameless.filter_map(|reference| *self.symbols.get(reference.symbol)?).collect();
            self.roots.extend(places);
        }
    }

    fn function(&self, index: u32) -> Option<Place> {
        let own = index.checked_sub(self.imported)?;
        usize::try_from(own).ok().map(Place::Function)
    }

    /// Where a place stands in the module.
    fn place(&self, place: Place) -> Option<Range<usize>> {
        match place {
            Place::Function(at) => self.bodies.get(at).cloned(),
            Place::Data(at) => {
                let piece = self.pieces.get(at)?;
                let segment = self.segments.get(piece.segment)?;
                Some(segment.start + piece.bytes.start..segment.start + piece.bytes.end)
            }
        }
    }

    fn between(&self, bytes: &Range<usize>) -> &[Reference] {
        let first = self.references.partition_point(|reference| reference.at < bytes.start);
        let end = self.references.partition_point(|reference| reference.at < bytes.end);
        self.references.get(first..end).unwrap_or_default()
    }

    fn referred(&self, bytes: Range<usize>) -> impl Iterator<Item = Place> {
        self.between(&bytes)
            .iter()
            .filter_map(|reference| *self.symbols.get(reference.symbol)?)
    }

    /// The bytes of the pieces of `segment` that are reached, or of those that are not.
    fn covered(&self, segment: usize, reached: &[bool], is_reached: bool) -> impl Iterator<Item = Range<usize>> {
        let pieces = self.pieces.iter().zip(reached);
        pieces
            .filter(move |(piece, reached)| piece.segment == segment && **reached == is_reached)
            .map(|(piece, _)| piece.bytes.clone())
    }

    /// In each segment the bytes that have names, none of which is reached.
    fn unreached(&self, reached: &[bool]) -> Vec<Vec<Range<usize>>> {
        let of_segment = |(segment, bytes): (usize, &Range<usize>)| {
            let mut is_unreached = vec![false; bytes.len()];
            for kind in [false, true] {
                for range in self.covered(segment, reached, kind) {
                    is_unreached.get_mut(range).unwrap_or_default().fill(!kind);
                }
            }
            let chunks = is_unreached.chunk_by(|a, b| a == b);
            let mut start = 0;
            let ranges = chunks.filter_map(move |chunk| {
                let range = start..start + chunk.len();
                start = range.end;
                (chunk.first() == Some(&true)).then_some(range)
            });
            ranges.collect()
        };
        self.segments.iter().enumerate().map(of_segment).collect()
    }
}

#[cfg(test)]
pub mod tests {
    #![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::single_range_in_vec_init, reason = "tests")]

    use super::reached;
    use wasm_encoder::{
        CodeSection, ConstExpr, CustomSection, DataSection, DataSymbolDefinition, Encode, ExportKind, ExportSection, Function,
        FunctionSection, Instruction, LinkingSection, MemorySection, MemoryType, Module, NameMap, NameSection, SymbolTable, TypeSection,
    };
    use wasmparser::{Parser, Payload};

    const FUNCTION_INDEX: u8 = 0;
    const TABLE_INDEX_I32: u8 = 2;
    const MEMORY_ADDRESS: u8 = 4;

    /// Where bodies and data begin, each within its section.
    fn places(module: &[u8]) -> (Vec<u32>, u32) {
        let (mut start, mut bodies, mut data) = (0, Vec::new(), 0);
        for payload in Parser::new(0).parse_all(module) {
            match payload.unwrap() {
                Payload::CodeSectionStart { range, .. } => start = range.start,
                Payload::CodeSectionEntry(body) => bodies.push(u32::try_from(body.range().start - start).unwrap()),
                Payload::DataSection(section) => {
                    let start = section.range().start;
                    let one = section.into_iter().next().unwrap().unwrap();
                    data = u32::try_from(one.range.end - one.data.len() - start).unwrap();
                }
                _ => {}
            }
        }
        (bodies, data)
    }

    /// The entries of a section of references: kind, place, symbol.
    fn references(section: u32, entries: &[(u8, u32, u32)]) -> Vec<u8> {
        let mut bytes = Vec::new();
        section.encode(&mut bytes);
        entries.len().encode(&mut bytes);
        for &(kind, at, symbol) in entries {
            bytes.push(kind);
            at.encode(&mut bytes);
            symbol.encode(&mut bytes);
            if kind == MEMORY_ADDRESS {
                // What is added to the address.
                bytes.push(0);
            }
        }
        bytes
    }

    /// The names of its functions and of its data, but for the last four bytes.
    fn symbols() -> SymbolTable {
        let mut symbols = SymbolTable::new();
        for at in 0..4 {
            symbols.function(0, at, Some(["start", "read", "print", "write"][usize::try_from(at).unwrap()]));
        }
        for (at, name) in ["numbers", "words", "nothing"].into_iter().enumerate() {
            let offset = 4 * u32::try_from(at).unwrap();
            symbols.data(0, name, Some(DataSymbolDefinition { index: 0, offset, size: 4 }));
        }
        symbols
    }

    /// A module of four functions and sixteen bytes of data. `start` is exported; it calls `read`, which refers to the bytes 0 to 4, and
    /// `print`, which refers to the bytes 4 to 8, where a reference to `write` stands. Nothing refers to the bytes 8 to 12, and the last
    /// four have no name.
    pub fn module() -> Vec<u8> {
        let (mut types, mut functions, mut code, mut names) =
            (TypeSection::new(), FunctionSection::new(), CodeSection::new(), NameMap::new());
        types.ty().function([], []);
        for (at, name) in ["start", "read", "print", "write"].into_iter().enumerate() {
            functions.function(0);
            let mut function = Function::new([]);
            function
                .instruction(&Instruction::Nop)
                .instruction(&Instruction::Nop)
                .instruction(&Instruction::End);
            code.function(&function);
            names.append(u32::try_from(at).unwrap(), name);
        }
        let mut exports = ExportSection::new();
        exports.export("start", ExportKind::Func, 0);
        let mut memories = MemorySection::new();
        memories.memory(MemoryType {
            minimum: 1,
            maximum: None,
            memory64: false,
            shared: false,
            page_size_log2: None,
        });
        let mut data = DataSection::new();
        data.active(0, &ConstExpr::i32_const(1024), [7; 16]);
        let mut name_section = NameSection::new();
        name_section.functions(&names);
        let symbols = symbols();
        let mut linking = LinkingSection::new();
        linking.symbol_table(&symbols);
        let mut module = Module::new();
        module
            .section(&types)
            .section(&functions)
            .section(&memories)
            .section(&exports)
            .section(&code)
            .section(&data);
        let (bodies, first) = places(&module.clone().finish());
        let of_code = references(
            4,
            &[
                (FUNCTION_INDEX, bodies[0] + 1, 1),
                (FUNCTION_INDEX, bodies[0] + 2, 2),
                (MEMORY_ADDRESS, bodies[1] + 1, 4),
                (MEMORY_ADDRESS, bodies[2] + 1, 5),
            ],
        );
        let of_data = references(5, &[(TABLE_INDEX_I32, first + 4, 3)]);
        module.section(&linking);
        for (name, data) in [("reloc.CODE", of_code), ("reloc.DATA", of_data)] {
            module.section(&CustomSection {
                name: name.into(),
                data: data.into(),
            });
        }
        module.section(&name_section);
        module.finish()
    }

    #[test]
    fn everything_is_reached_but_what_nothing_refers_to() {
        let all = reached(&module(), &[]).unwrap().unwrap();
        assert_eq!(all.functions, [true; 4]);
        assert_eq!(all.unreached, [vec![8..12]]);
    }

    #[test]
    fn with_a_function_goes_what_only_it_reaches() {
        let less = reached(&module(), &[false, false, true, false]).unwrap().unwrap();
        assert_eq!(
            less.functions,
            [true, true, true, false],
            "what is emptied is called still, and traps"
        );
        assert_eq!(less.unreached, [vec![4..12]]);
    }

    #[test]
    fn a_module_that_does_not_say_what_refers_to_what_is_left_whole() {
        assert!(reached(&crate::order::tests::module(), &[]).unwrap().is_none());
    }
}
