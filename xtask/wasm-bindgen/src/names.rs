//! Short names for what the module imports from JavaScript.
//!
//! wasm-bindgen calls each import by a name with a hash in it, such as `__wbg_fillText_0123456789abcdef`, once in the module and once in
//! the script. Nobody reads them, and a hash does not compress.

use anyhow::{Result, ensure};
use std::collections::{BTreeSet, HashMap};
use wasmparser::{Parser, Payload};

/// A short name for each import of `module` that has a hash in its name, and that `script` does not have yet.
pub fn short(module: &[u8], script: &str) -> Result<HashMap<String, String>> {
    let mut long = BTreeSet::new();
    for payload in Parser::new(0).parse_all(module) {
        if let Payload::ImportSection(section) = payload? {
            for import in section.into_imports() {
                let name = import?.name;
                if name.starts_with("__wb") {
                    long.insert(name.to_owned());
                }
            }
        }
    }
    let names: HashMap<String, String> = long
        .into_iter()
        .enumerate()
        .map(|(number, long)| (long, format!("i{number}")))
        .collect();
    let taken: BTreeSet<&str> = words(script).filter(|(is_word, _)| *is_word).map(|(_, word)| word).collect();
    for (long, short) in &names {
        ensure!(
            taken.contains(long.as_str()),
            "the script does not have {long}, which the module imports"
        );
        ensure!(!taken.contains(short.as_str()), "the script has {short} already");
    }
    Ok(names)
}

/// `script` with its names replaced by those in `names`, and without comments and indentation.
pub fn shortened(script: &str, names: &HashMap<String, String>) -> String {
    let renamed: String = words(script)
        .map(|(is_word, part)| names.get(part).filter(|_| is_word).map_or(part, String::as_str))
        .collect();
    let lines = renamed
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with("//"));
    let short = lines.clone().collect::<Vec<_>>().join("\n") + "\n";
    // A text between backticks may run over several lines, and white space in it counts.
    let has_long_text = lines.into_iter().any(|line| line.matches('`').count() % 2 != 0);
    if has_long_text { renamed } else { short }
}

/// `script` cut into names and what stands between them, each with whether it is a name.
fn words(script: &str) -> impl Iterator<Item = (bool, &str)> {
    let is_of_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
    let mut rest = script;
    std::iter::from_fn(move || {
        let is_word = rest.chars().next().map(is_of_word)?;
        let end = rest.find(|c| is_of_word(c) != is_word).unwrap_or(rest.len());
        let (part, after) = rest.split_at_checked(end)?;
        rest = after;
        Some((is_word, part))
    })
}

#[cfg(test)]
mod tests {
    use super::shortened;
    use std::collections::HashMap;

    fn names() -> HashMap<String, String> {
        HashMap::from([("__wbg_a_01".to_owned(), "i0".to_owned())])
    }

    #[test]
    fn whole_names_are_replaced_and_comments_and_indentation_are_gone() {
        let script =
            "const import0 = {\n    // A comment.\n    __wbg_a_01: function(x) {\n        return __wbg_a_012 + `// ${x}`;\n    },\n};\n";
        assert_eq!(
            shortened(script, &names()),
            "const import0 = {\ni0: function(x) {\nreturn __wbg_a_012 + `// ${x}`;\n},\n};\n"
        );
    }

    #[test]
    fn a_text_over_several_lines_keeps_its_white_space() {
        let script = "const text = `one\n    // two`;\n__wbg_a_01();\n";
        assert_eq!(shortened(script, &names()), "const text = `one\n    // two`;\ni0();\n");
    }
}
