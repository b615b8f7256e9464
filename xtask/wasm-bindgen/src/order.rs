//! Puts the functions of a module into an order in which a compressor finds more that repeats.
//!
//! A compiler makes many functions from one source: a method for each type that has it, a generic function for each type that it is
//! used with. They differ little, and compress well where they stand side by side; wasm-bindgen leaves them sorted by their size alone.
//! Nothing about the module changes but the places of its functions.

use anyhow::{Context as _, Result};
use std::collections::HashMap;
use std::convert::Infallible;
use wasm_encoder::reencode::{Error, Reencode};
use wasm_encoder::{CodeSection, FunctionSection, ImportSection, Module};
use wasmparser::{CodeSectionReader, CustomSectionReader, FunctionSectionReader, ImportSectionReader};
use wasmparser::{KnownCustom, Name, Parser, Payload, TypeRef};

/// A module in its new order.
pub struct Ordered {
    pub module: Vec<u8>,
    /// The names of its functions, imports left out, in that order.
    pub names: Vec<String>,
}

/// The functions of a module as they are.
#[derive(Default)]
pub struct Functions {
    imported: u32,
    /// By number of the function, imports included.
    names: HashMap<u32, String>,
    types: Vec<u32>,
    /// How many values a function of each type returns.
    results: Vec<usize>,
    bytes: Vec<usize>,
}

impl Functions {
    /// Those of `module`.
    pub fn read(module: &[u8]) -> Result<Self> {
        let mut functions = Self::default();
        for payload in Parser::new(0).parse_all(module) {
            match payload? {
                Payload::ImportSection(section) => {
                    for import in section.into_imports() {
                        functions.imported += u32::from(matches!(import?.ty, TypeRef::Func(_)));
                    }
                }
                Payload::TypeSection(section) => {
                    for ty in section.into_iter_err_on_gc_types() {
                        functions.results.push(ty?.results().len());
                    }
                }
                Payload::FunctionSection(section) => functions.types = section.into_iter().collect::<Result<_, _>>()?,
                Payload::CodeSectionEntry(body) => functions.bytes.push(body.range().len()),
                Payload::CustomSection(section) => functions.read_names(&section)?,
                _ => {}
            }
        }
        Ok(functions)
    }

    fn read_names(&mut self, section: &CustomSectionReader<'_>) -> Result<()> {
        if let KnownCustom::Name(parts) = section.as_known() {
            for part in parts {
                if let Name::Function(names) = part? {
                    for name in names {
                        let name = name?;
                        self.names.insert(name.index, name.name.to_owned());
                    }
                }
            }
        }
        Ok(())
    }

    /// The name of the function at `at`, imports not counted; empty where it has none.
    pub fn name(&self, at: usize) -> &str {
        let index = u32::try_from(at).ok().and_then(|at| at.checked_add(self.imported));
        index.and_then(|index| self.names.get(&index)).map_or("", String::as_str)
    }

    /// How many values the function at `at` returns.
    pub fn results(&self, at: usize) -> usize {
        let ty = self.types.get(at).and_then(|&ty| usize::try_from(ty).ok());
        ty.and_then(|ty| self.results.get(ty)).copied().unwrap_or_default()
    }

    /// How many functions are imported.
    pub const fn imported(&self) -> u32 {
        self.imported
    }

    /// How many there are, imports left out.
    pub const fn len(&self) -> usize {
        self.types.len()
    }

    /// The places of the functions in their new order.
    fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.types.len()).collect();
        order.sort_by_cached_key(|&at| {
            let bytes = self.bytes.get(at).copied().unwrap_or_default();
            (family(self.name(at)), self.types.get(at).copied(), bytes, at)
        });
        order
    }
}

/// What functions have in common that were made from one source: `core::fmt::Debug>::fmt` of
/// `<depth_core::Camera as core::fmt::Debug>::fmt::h0123456789abcdef`, and the whole path of any other.
fn family(name: &str) -> String {
    let path = name.rsplit_once("::h").map_or(name, |(path, _)| path);
    path.split_once(" as ").map_or(path, |(_, of_trait)| of_trait).to_owned()
}

/// `module` in its new order, without custom sections, and with its imports called as `renamed` says.
pub fn ordered(module: &[u8], renamed: &HashMap<String, String>) -> Result<Ordered> {
    let functions = Functions::read(module)?;
    let order = functions.order();
    let mut new_places = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        *new_places.get_mut(old).context("a function without a place")? = u32::try_from(new)?;
    }
    let names = order.iter().map(|&at| functions.name(at).to_owned()).collect();
    let mut writer = Writer {
        imported: functions.imported,
        order,
        new_places,
        renamed,
    };
    let mut out = Module::new();
    writer.parse_core_module(&mut out, Parser::new(0), module)?;
    Ok(Ordered {
        module: out.finish(),
        names,
    })
}

struct Writer<'a> {
    imported: u32,
    /// The old places in the new order.
    order: Vec<usize>,
    /// The new places in the old order.
    new_places: Vec<u32>,
    renamed: &'a HashMap<String, String>,
}

impl Writer<'_> {
    /// `all` in the new order.
    fn sorted<T: Clone>(&self, all: &[T]) -> Vec<T> {
        self.order.iter().filter_map(|&at| all.get(at).cloned()).collect()
    }
}

impl Reencode for Writer<'_> {
    type Error = Infallible;

    fn function_index(&mut self, index: u32) -> Result<u32, Error> {
        let own = index.checked_sub(self.imported).and_then(|own| usize::try_from(own).ok());
        Ok(own
            .and_then(|own| self.new_places.get(own))
            .map_or(index, |place| place + self.imported))
    }

    fn parse_import_section(&mut self, imports: &mut ImportSection, section: ImportSectionReader<'_>) -> Result<(), Error> {
        for import in section.into_imports() {
            let import = import?;
            let name = self.renamed.get(import.name).map_or(import.name, String::as_str);
            imports.import(import.module, name, self.entity_type(import.ty)?);
        }
        Ok(())
    }

    fn parse_function_section(&mut self, functions: &mut FunctionSection, section: FunctionSectionReader<'_>) -> Result<(), Error> {
        let types = section.into_iter().collect::<Result<Vec<u32>, _>>()?;
        for kind in self.sorted(&types) {
            functions.function(self.type_index(kind)?);
        }
        Ok(())
    }

    fn parse_code_section(&mut self, code: &mut CodeSection, section: CodeSectionReader<'_>) -> Result<(), Error> {
        let bodies = section.into_iter().collect::<Result<Vec<_>, _>>()?;
        for body in self.sorted(&bodies) {
            self.parse_function_body(code, body)?;
        }
        Ok(())
    }

    fn parse_custom_section(&mut self, _: &mut Module, _: CustomSectionReader<'_>) -> Result<(), Error> {
        Ok(())
    }
}

#[cfg(test)]
pub mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Parser, Payload, family, ordered};
    use std::collections::HashMap;
    use wasm_encoder::{
        CodeSection, EntityType, ExportKind, ExportSection, Function, FunctionSection, ImportSection, Instruction, Module, NameMap,
        NameSection, TypeSection,
    };
    use wasmparser::Operator;

    /// A module that imports a function and has three: each calls the one before it, and is called `x::z`, `<A as T>::m`, `<B as T>::m`.
    pub fn module() -> Vec<u8> {
        let mut module = Module::new();
        let mut types = TypeSection::new();
        types.ty().function([], []);
        let mut imports = ImportSection::new();
        imports.import("./d_bg.js", "__wbg_a_01", EntityType::Function(0));
        let (mut functions, mut code, mut names) = (FunctionSection::new(), CodeSection::new(), NameMap::new());
        for (at, name) in [(1, "x::z::h0123456789abcdef"), (2, "<A as a::T>::m"), (3, "<B as a::T>::m")] {
            functions.function(0);
            let mut function = Function::new([]);
            function.instruction(&Instruction::Call(at - 1)).instruction(&Instruction::End);
            code.function(&function);
            names.append(at, name);
        }
        let mut exports = ExportSection::new();
        exports.export("z", ExportKind::Func, 1);
        let mut name_section = NameSection::new();
        name_section.functions(&names);
        module
            .section(&types)
            .section(&imports)
            .section(&functions)
            .section(&exports)
            .section(&code)
            .section(&name_section);
        module.finish()
    }

    #[test]
    fn functions_change_their_places_and_everything_still_calls_what_it_called() {
        let renamed = HashMap::from([("__wbg_a_01".to_owned(), "i0".to_owned())]);
        let ordered = ordered(&module(), &renamed).unwrap();
        assert_eq!(ordered.names, ["<A as a::T>::m", "<B as a::T>::m", "x::z::h0123456789abcdef"]);
        let (mut imports, mut calls, mut exports, mut customs) = (Vec::new(), Vec::new(), Vec::new(), 0);
        for payload in Parser::new(0).parse_all(&ordered.module) {
            match payload.unwrap() {
                Payload::ImportSection(section) => imports.extend(section.into_imports().map(|import| import.unwrap().name.to_owned())),
                Payload::ExportSection(section) => exports.extend(section.into_iter().map(|export| export.unwrap().index)),
                Payload::CodeSectionEntry(body) => match body.get_operators_reader().unwrap().read().unwrap() {
                    Operator::Call { function_index } => calls.push(function_index),
                    other => assert_eq!(format!("{other:?}"), "a call"),
                },
                Payload::CustomSection(_) => customs += 1,
                _ => {}
            }
        }
        assert_eq!(imports, ["i0"]);
        // z, now the last, calls the import; A's calls z; B's calls A's.
        assert_eq!(calls, [3, 1, 0]);
        assert_eq!(exports, [3]);
        assert_eq!(customs, 0);
    }

    #[test]
    fn what_is_made_from_one_source_has_one_family() {
        let debug = "core::fmt::Debug>::fmt";
        assert_eq!(family("<depth_core::Camera as core::fmt::Debug>::fmt::h0123456789abcdef"), debug);
        assert_eq!(family("<u8 as core::fmt::Debug>::fmt::hfedcba9876543210"), debug);
        assert_eq!(family("egui::ui::Ui::label::h0123456789abcdef"), "egui::ui::Ui::label");
        assert_eq!(family(""), "");
    }
}
