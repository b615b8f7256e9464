//! The modules of one crate: where each stands, what it defines, what it imports and what it names by a path.

use proc_macro2::{Delimiter, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::source::{self, group, ident, is_ident, is_path_separator, is_punct};

/// The words that a path begins or goes on with.
pub(super) type Words = Vec<String>;

/// What stands in a `use`.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Import {
    pub(super) path: Words,
    /// What it is called here; `None` for everything in it.
    pub(super) name: Option<String>,
    /// Whether others may import it from here.
    pub(super) is_public: bool,
    pub(super) line: usize,
}

/// A path of two words or more in the code.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Mention {
    pub(super) path: Words,
    pub(super) line: usize,
}

#[derive(Debug, Default)]
pub(super) struct Module {
    pub(super) file: usize,
    pub(super) children: BTreeSet<String>,
    pub(super) items: BTreeSet<String>,
    pub(super) imports: Vec<Import>,
    pub(super) mentions: Vec<Mention>,
}

/// The modules of a crate by their paths; the path of the crate itself is empty.
#[derive(Debug, Default)]
pub(super) struct Crate {
    pub(super) files: Vec<PathBuf>,
    pub(super) modules: BTreeMap<Words, Module>,
}

impl Crate {
    /// Reads the file `root` and every file whose module it declares.
    pub(super) fn read(root: &Path) -> Result<Self, String> {
        let mut krate = Self::default();
        let folder = root.parent().unwrap_or(root).to_path_buf();
        krate.add_file(root, &folder, &[])?;
        Ok(krate)
    }

    /// Adds the module `path`, which is in `file`; the files of its children are in `folder`.
    fn add_file(&mut self, file: &Path, folder: &Path, path: &[String]) -> Result<(), String> {
        self.files.push(file.to_path_buf());
        let tokens = source::read(file)?;
        self.add_module(&tokens, folder, path)
    }

    fn add_module(&mut self, tokens: &[TokenTree], folder: &Path, path: &[String]) -> Result<(), String> {
        let file = self.files.len().saturating_sub(1);
        let mut reader = Reader::default();
        reader.items(tokens);
        let Reader { mut module, children } = reader;
        module.file = file;
        let mut own_files = Vec::new();
        for (name, body) in children {
            module.children.insert(name.clone());
            let path: Words = path.iter().cloned().chain([name.clone()]).collect();
            match body {
                Some(tokens) => self.add_module(&tokens, &folder.join(&name), &path)?,
                None => own_files.push((name, path)),
            }
        }
        self.modules.insert(path.to_vec(), module);
        for (name, path) in own_files {
            let inside = folder.join(&name);
            let beside = folder.join(format!("{name}.rs"));
            let file = if beside.is_file() { beside } else { inside.join("mod.rs") };
            self.add_file(&file, &inside, &path)?;
        }
        Ok(())
    }
}

/// Collects what stands in one module.
#[derive(Default)]
struct Reader {
    module: Module,
    /// The modules inside, with their tokens where they stand in the same file.
    children: Vec<(String, Option<Vec<TokenTree>>)>,
}

impl Reader {
    /// Reads the tokens between the braces of a module.
    fn items(&mut self, tokens: &[TokenTree]) {
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let name = ident(tokens.get(at + 1)).map(ToString::to_string);
            let word = ident(Some(token)).map(ToString::to_string).unwrap_or_default();
            at += match (word.as_str(), name) {
                ("mod", Some(name)) => {
                    let body = tokens.get(at + 2).and_then(|token| group(token, Delimiter::Brace));
                    self.children.push((name, body.map(|group| group.stream().into_iter().collect())));
                    3
                }
                ("fn" | "struct" | "enum" | "union" | "trait" | "type" | "static", Some(name)) => {
                    self.module.items.insert(name);
                    2
                }
                ("const", Some(name)) if name != "fn" && name != "unsafe" => {
                    self.module.items.insert(name);
                    2
                }
                _ => self.code(tokens, at),
            };
        }
    }

    /// Reads what stands at `at`, wherever in the code that is. Returns how many tokens it is.
    fn code(&mut self, tokens: &[TokenTree], at: usize) -> usize {
        let Some(token) = tokens.get(at) else { return 1 };
        match token {
            TokenTree::Group(group) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let mut at = 0;
                while at < inside.len() {
                    at += self.code(&inside, at);
                }
                1
            }
            TokenTree::Ident(word) if word == "use" => self.imports(tokens, at),
            TokenTree::Ident(word) => {
                let path = path_at(tokens, at);
                let length = path.len() * 3 - 2;
                // What goes on from a type, or begins with two colons, is no module of this crate.
                let goes_on = at >= 2 && is_path_separator(tokens, at - 2);
                if path.len() > 1 && !goes_on {
                    let line = word.span().start().line;
                    self.module.mentions.push(Mention { path, line });
                }
                length
            }
            _ => 1,
        }
    }

    /// Reads the `use` at `at`. Returns how many tokens it is.
    fn imports(&mut self, tokens: &[TokenTree], at: usize) -> usize {
        let rest = tokens.get(at + 1..).unwrap_or_default();
        let end = rest.iter().position(|token| is_punct(token, ';')).unwrap_or(rest.len());
        let tree = rest.get(..end).unwrap_or_default();
        let before = at.checked_sub(1).and_then(|before| tokens.get(before));
        // `pub use`, `pub(crate) use`: nothing else stands in front of one but an attribute.
        let is_public = is_ident(before, "pub") || before.is_some_and(|token| group(token, Delimiter::Parenthesis).is_some());
        // With two colons in front it is of another crate.
        if !is_path_separator(tree, 0) {
            self.tree(tree, &[], is_public);
        }
        end + 2
    }

    /// One tree of a `use`: `a::b`, `a as b`, `a::*`, `a::{b, c}`.
    fn tree(&mut self, tokens: &[TokenTree], prefix: &[String], is_public: bool) {
        let path = path_at(tokens, 0);
        let length = if path.is_empty() { 0 } else { path.len() * 3 - 2 };
        let line = ident(tokens.first()).map_or(0, |word| word.span().start().line);
        let mut path: Words = prefix.iter().cloned().chain(path).collect();
        let mut rest = tokens.get(length..).unwrap_or_default();
        if is_path_separator(rest, 0) {
            rest = rest.get(2..).unwrap_or_default();
        }
        match rest.first() {
            Some(token) if group(token, Delimiter::Brace).is_some() => {
                let inside: Vec<TokenTree> = group(token, Delimiter::Brace)
                    .into_iter()
                    .flat_map(|group| group.stream())
                    .collect();
                for part in inside.split(|token| is_punct(token, ',')).filter(|part| !part.is_empty()) {
                    self.tree(part, &path, is_public);
                }
            }
            Some(token) if is_punct(token, '*') => self.module.imports.push(Import {
                path,
                name: None,
                is_public,
                line: token.span().start().line,
            }),
            other => {
                if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
                    path.pop();
                }
                let renamed = is_ident(other, "as").then(|| ident(rest.get(1))).flatten().map(ToString::to_string);
                let name = renamed.or_else(|| path.last().cloned());
                self.module.imports.push(Import {
                    path,
                    name,
                    is_public,
                    line,
                });
            }
        }
    }
}

/// The words of the path that begins at `at`; none where there is no word.
fn path_at(tokens: &[TokenTree], at: usize) -> Words {
    let mut path = Vec::new();
    let mut at = at;
    while let Some(word) = ident(tokens.get(at)) {
        path.push(word.to_string());
        if !is_path_separator(tokens, at + 1) {
            break;
        }
        at += 3;
    }
    path
}
