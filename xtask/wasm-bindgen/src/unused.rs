//! Takes out what a library brings along for something that this program never does, and that no feature of it switches off. The
//! compiler cannot know: whether it is asked for is decided while the program runs.

use crate::order::Functions;
use crate::reach::reached;
use anyhow::{Result, ensure};
use std::convert::Infallible;
use std::ops::Range;
use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{CodeSection, DataSection, Elements, Function, Instruction, Module};
use wasmparser::{CustomSectionReader, Data, ElementItems, FunctionBody, Parser};

/// The functions that are never called, by parts of their mangled names. Everything that only they call goes with them.
///
/// Each is long and of one purpose: short ones may be shared, as the compiler keeps one of several functions with the same code, under
/// one of their names.
const UNUSED: &[&[&str]] = &[
    // eframe encodes an image that is to be put on the clipboard; this program copies text. 15 kB with brotli.
    &["image", "6codecs3png", "12encode_inner"],
    // What draws the outlines of letters can do more than fill them with one color in the fast way: gradients and images, a finer
    // way, and blurs. 35 kB.
    &["9vello_cpu4fine", "12indexed_fill"],
    &["9vello_cpu8dispatch15single_threaded", "20bucket_and_rasterize", "9F32Kernel"],
    &["9vello_cpu6filter13gaussian_blur", "10apply_blur"],
    // Letters are drawn without hinting: see the style of the program. 22 kB.
    &["6skrifa7outline8autohint4hint", "12hint_outline"],
    &["6skrifa7outline8autohint7metrics", "23UnscaledStyleMetricsSet3get"],
    &["6skrifa7outline8autohint7outline", "7Outline4fill"],
    &["6skrifa7outline8autohint5shape", "11GsubHandler14process_lookup"],
    &["6skrifa7outline8autohint5style", "13GlyphStyleMap9new_inner"],
    &["6skrifa7outline4glyf4hint8instance", "12HintInstance11reconfigure"],
    // Nor are they drawn in the style of HarfBuzz. 4 kB.
    &["6skrifa7outline4glyf", "14HarfBuzzScaler", "11load_simple"],
    &["6skrifa7outline4glyf", "14HarfBuzzScaler", "4load"],
    // The page asks for WebGL 2, and says so where there is none.
    &["6eframe3web16web_painter_glow", "11init_webgl1"],
    // Nor does it blend anything with what is below, clip, or draw lines: the triangles of everything else are egui's. 35 kB.
    &["15vectorize_inner", "4fine4lowp7compose", "9BlendMode"],
    &["15vectorize_inner", "4fine4lowp5blend3mix"],
    &["15vectorize_inner", "4fine5highp5blend3mix"],
    &["9vello_cpu4fine4lowp5blend", "10Difference3mix"],
    &["9vello_cpu4fine4lowp5blend", "7Lighten3mix"],
    &["9vello_cpu4fine4lowp5blend", "6Darken3mix"],
    &["9vello_cpu4fine4lowp5blend", "9HardLight3mix"],
    &["9vello_cpu4fine4lowp5blend", "7Overlay3mix"],
    &["9vello_cpu4fine4lowp5blend", "9Exclusion3mix"],
    &["12vello_common4clip", "11ClipContext9push_clip"],
    &["15vectorize_inner", "12vello_common4clip9intersect"],
    &["8dispatch15single_threaded", "10Dispatcher11stroke_path"],
    &["5kurbo6offset", "11CubicOffset10offset_rec"],
    &["5kurbo6offset", "12offset_cubic"],
    // There are no gradients, no filters, and nobody prints what draws the letters for a debugger. 20 kB.
    &["8dispatch15single_threaded", "24SingleThreadedDispatcher", "5Debug3fmt"],
    &["5color7dynamic", "12DynamicColor7convert"],
    &["21spec_from_iter_nested", "12encode_stops"],
    &["9vello_cpu6filter5shift", "13offset_pixels"],
    &["12vello_common6filter", "14PreparedFilter3new"],
    // The fonts, which come with the program, have TrueType outlines without instructions: no PostScript, no variable components, no
    // bytecode, and no tables of Apple's. 25 kB.
    &["10read_fonts2ps2cs", "17evaluate_operator"],
    &["6skrifa7outline3cff", "7subfont"],
    &["6skrifa7outline3cff", "8Outlines4draw"],
    &["6skrifa7outline3cff", "7TopDict3new"],
    &["6skrifa7outline4varc", "30max_component_memory_for_glyph"],
    &["6skrifa7outline4varc", "10draw_glyph"],
    &["6skrifa7outline4glyf4hint6engine", "14dispatch_inner"],
    &["8harfrust2hb3aat6layout", "10substitute"],
    &["8harfrust2hb3aat3map", "13AatMapBuilder7compile"],
    &["10read_fonts6tables4morx", "8Subtable4kind"],
    &["10read_fonts6tables4kerx", "8Subtable4kind"],
    &["10read_fonts2ps3cff4dict", "11parse_entry"],
    // No language is named to the shaper.
    &["8harfrust2hb9tag_table", "26tags_from_complex_language"],
];

/// The functions that are called, and whose work is not seen: they may do nothing, and answer that they changed nothing.
const UNSEEN: &[&[&str]] = &[
    // No font of the program has signs of the scripts whose syllables are put into another order, or whose letters are joined. Where the
    // browser has none either, each is a box, in whatever order. 20 kB.
    &["8harfrust2hb", "33preprocess_text_vowel_constraints"],
    &["8harfrust2hb15ot_shaper_indic", "18initial_reordering"],
    &["8harfrust2hb15ot_shaper_indic", "16final_reordering"],
    &["8harfrust2hb15ot_shaper_indic", "16would_substitute"],
    &["8harfrust2hb16ot_shaper_hangul", "22preprocess_text_hangul"],
    &["8harfrust2hb13ot_shaper_use", "15setup_syllables"],
    &["8harfrust2hb15ot_shaper_khmer", "13reorder_khmer"],
    &["8harfrust2hb17ot_shaper_myanmar", "15reorder_myanmar"],
    &["8harfrust2hb15ot_shaper_indic", "15setup_syllables"],
    &["8harfrust2hb15ot_shaper_khmer", "15setup_syllables"],
    &["8harfrust2hb17ot_shaper_myanmar", "15setup_syllables"],
    &["8harfrust2hb13ot_shaper_use", "11reorder_use"],
    &["8harfrust2hb14ot_shaper_thai", "15preprocess_text"],
    &["8harfrust2hb16ot_shaper_arabic", "17setup_masks_inner"],
    &["8harfrust2hb16ot_shaper_arabic", "21arabic_fallback_shape"],
    &["8harfrust2hb16ot_shaper_arabic", "25postprocess_glyphs_arabic"],
    &["8harfrust2hb16ot_shaper_arabic", "20reorder_marks_arabic"],
    // Signs that stand above or below others come in clusters with these. One that stands alone is drawn too. 8 kB.
    &["6epaint4text7unicode", "17is_combining_mark"],
];

/// `module` with an instruction that traps in place of what [`UNUSED`] names, nothing in place of what [`UNSEEN`] names, and neither the
/// functions nor the data that only these reach. The lists are of a module that `draws`.
///
/// # Errors
/// Where a function of the lists is not in the module: then they are too long.
pub fn without_unused(module: &[u8], draws: bool) -> Result<Vec<u8>> {
    if draws {
        without(module, UNUSED, UNSEEN)
    } else {
        without(module, &[], &[])
    }
}

fn without(module: &[u8], unused: &[&[&str]], unseen: &[&[&str]]) -> Result<Vec<u8>> {
    let functions = Functions::read(module)?;
    let is_named = |name: &str, parts: &[&str]| parts.iter().all(|part| name.contains(part));
    for parts in unused.iter().chain(unseen) {
        let found = (0..functions.len()).any(|at| is_named(functions.name(at), parts));
        ensure!(found, "no function of the module is called {}", parts.join("…"));
    }
    let instead = (0..functions.len()).map(|at| {
        let is_in = |list: &[&[&str]]| list.iter().any(|parts| is_named(functions.name(at), parts));
        if is_in(unused) {
            return Some(vec![Instruction::Unreachable]);
        }
        is_in(unseen).then(|| vec![Instruction::I32Const(0); functions.results(at)])
    });
    let mut instead: Vec<Option<Vec<Instruction<'static>>>> = instead.collect();
    let emptied: Vec<bool> = instead.iter().map(Option::is_some).collect();
    let mut writer = Writer {
        imported: functions.imported(),
        ..Writer::default()
    };
    if let Some(reached) = reached(module, &emptied)? {
        for (instead, _) in instead.iter_mut().zip(&reached.functions).filter(|(_, reached)| !**reached) {
            *instead = Some(vec![Instruction::Unreachable]);
        }
        writer.functions = reached.functions;
        writer.unreached = reached.unreached;
    }
    writer.instead = instead;
    let mut out = Module::new();
    writer.parse_core_module(&mut out, Parser::new(0), module)?;
    Ok(out.finish())
}

#[derive(Default)]
struct Writer {
    imported: u32,
    /// For each function, imports left out, what is put in place of its body.
    instead: Vec<Option<Vec<Instruction<'static>>>>,
    /// For each function, imports left out, whether it is reached; empty where that is not known.
    functions: Vec<bool>,
    /// In each data segment, the bytes that are not.
    unreached: Vec<Vec<Range<usize>>>,
    function: usize,
    segment: usize,
}

impl Writer {
    /// The function at `index`, or the first that is not reached in place of any that is not: the table then names one of them only.
    fn one_for_all(&self, index: u32) -> u32 {
        let own = |index: u32| usize::try_from(index.checked_sub(self.imported)?).ok();
        if own(index).and_then(|own| self.functions.get(own)) != Some(&false) {
            return index;
        }
        let first = self.functions.iter().position(|reached| !reached);
        first
            .and_then(|first| u32::try_from(first).ok())
            .map_or(index, |first| first + self.imported)
    }
}

impl Reencode for Writer {
    type Error = Infallible;

    fn parse_function_body(&mut self, code: &mut CodeSection, body: FunctionBody<'_>) -> Result<(), Error> {
        let instead = self.instead.get_mut(self.function).and_then(Option::take);
        self.function += 1;
        let Some(instead) = instead else {
            return utils::parse_function_body(self, code, body);
        };
        let mut function = Function::new([]);
        for instruction in instead.iter().chain([&Instruction::End]) {
            function.instruction(instruction);
        }
        code.function(&function);
        Ok(())
    }

    fn element_items<'a>(&mut self, items: ElementItems<'a>) -> Result<Elements<'a>, Error> {
        let ElementItems::Functions(functions) = items else {
            return utils::element_items(self, items);
        };
        let functions = functions.into_iter().map(|index| Ok(self.one_for_all(index?)));
        Ok(Elements::Functions(functions.collect::<Result<Vec<_>, Error>>()?.into()))
    }

    fn parse_data(&mut self, data: &mut DataSection, datum: Data<'_>) -> Result<(), Error> {
        let unreached = self.unreached.get(self.segment).map(Vec::as_slice).unwrap_or_default();
        self.segment += 1;
        let mut bytes = datum.data.to_vec();
        for range in unreached {
            // Nobody looks, and zeros cost nothing to download.
            bytes.get_mut(range.clone()).unwrap_or_default().fill(0);
        }
        utils::parse_data(self, data, Data { data: &bytes, ..datum })
    }

    fn parse_custom_section(&mut self, module: &mut Module, section: CustomSectionReader<'_>) -> Result<(), Error> {
        // What stands there is of the module as it was.
        if section.name() == "linking" || section.name().starts_with("reloc.") {
            return Ok(());
        }
        utils::parse_custom_section(self, module, section)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

    use super::without;
    use crate::order::tests::module;
    use wasm_encoder::{CodeSection, Function, FunctionSection, Instruction, Module, NameMap, NameSection, TypeSection, ValType};
    use wasmparser::{Parser, Payload};

    /// The first instruction of each function.
    fn first(module: &[u8]) -> Vec<String> {
        let bodies = Parser::new(0).parse_all(module).filter_map(|payload| match payload.unwrap() {
            Payload::CodeSectionEntry(body) => Some(format!("{:?}", body.get_operators_reader().unwrap().read().unwrap())),
            _ => None,
        });
        bodies.collect()
    }

    #[test]
    fn only_what_is_named_is_emptied() {
        let before = first(&module());
        let after = first(&without(&module(), &[&["A as", "T>"]], &[]).unwrap());
        assert_eq!(after, [before[0].as_str(), "Unreachable", before[2].as_str()]);
    }

    #[test]
    fn what_is_not_seen_does_nothing_and_returns() {
        let emptied = without(&module(), &[], &[&["A as", "T>"]]).unwrap();
        assert_eq!(first(&emptied)[1], "End");
        wasmparser::validate(&emptied).unwrap();

        let emptied = without(&answers(), &[], &[&["answers"]]).unwrap();
        assert_eq!(first(&emptied), ["I32Const { value: 0 }"]);
        wasmparser::validate(&emptied).unwrap();
    }

    /// A module of a function that answers with 7.
    fn answers() -> Vec<u8> {
        let (mut types, mut functions, mut code) = (TypeSection::new(), FunctionSection::new(), CodeSection::new());
        let (mut names, mut name_section) = (NameMap::new(), NameSection::new());
        types.ty().function([], [ValType::I32]);
        functions.function(0);
        let mut function = Function::new([]);
        function.instruction(&Instruction::I32Const(7)).instruction(&Instruction::End);
        code.function(&function);
        names.append(0, "answers");
        name_section.functions(&names);
        let mut module = Module::new();
        module.section(&types).section(&functions).section(&code).section(&name_section);
        module.finish()
    }

    #[test]
    fn what_only_an_emptied_function_reaches_goes_with_it() {
        let emptied = without(&crate::reach::tests::module(), &[&["print"]], &[]).unwrap();
        wasmparser::validate(&emptied).unwrap();
        assert_eq!(first(&emptied), ["Nop", "Nop", "Unreachable", "Unreachable"]);
        let mut names = Vec::new();
        for payload in Parser::new(0).parse_all(&emptied) {
            match payload.unwrap() {
                Payload::DataSection(section) => {
                    let data = section.into_iter().next().unwrap().unwrap();
                    assert_eq!(data.data, [7, 7, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0, 7, 7, 7, 7]);
                }
                Payload::CustomSection(section) => names.push(section.name().to_owned()),
                _ => {}
            }
        }
        assert_eq!(names, ["name"]);
    }

    #[test]
    fn what_is_not_there_is_an_error() {
        assert!(without(&module(), &[&["no such function"]], &[]).is_err());
        assert!(without(&module(), &[], &[&["no such function"]]).is_err());
    }
}
