//! Parses assets/learn.md at build time, so that the wasm needs no Markdown parser, and gives the program for Windows its icon.
//!
//! Writes `learn.rs` into the build's folder: one expression, the blocks of `src/app/learn/document.rs`.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    // Without the application there is no Learn text to show.
    #[cfg(feature = "app")]
    {
        learn::write()?;
        windows::embed()?;
    }
    Ok(())
}

#[cfg(feature = "app")]
mod windows {
    use std::env;

    const ICON: &str = "assets/icons/icon.ico";
    const MANIFEST: &str = "assets/windows/depth-calculator.manifest";

    /// Puts the icon, the version and the manifest into the program where it is for Windows.
    pub fn embed() -> Result<(), Box<dyn std::error::Error>> {
        println!("cargo::rerun-if-changed={ICON}");
        println!("cargo::rerun-if-changed={MANIFEST}");
        // Of the target: this runs on the computer that builds.
        if env::var("CARGO_CFG_TARGET_OS")? != "windows" {
            return Ok(());
        }
        let outcome = winresource::WindowsResource::new()
            .set("ProductName", "Depth Calculator")
            .set("FileDescription", "Depth Calculator")
            .set_icon(ICON)
            .set_manifest_file(MANIFEST)
            .compile_for("depth-calculator");
        match outcome {
            // Whoever only checks the program on another system need not have a compiler of resources.
            Err(error) if cfg!(not(windows)) => {
                println!("cargo::warning=The program gets no icon, as it was not compiled on Windows: {error}")
            }
            outcome => outcome?,
        }
        Ok(())
    }
}

#[cfg(feature = "app")]
mod learn {
    use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
    use std::path::Path;
    use std::{env, fs};

    const TEXT: &str = "assets/learn.md";

    pub fn write() -> Result<(), Box<dyn std::error::Error>> {
        println!("cargo::rerun-if-changed={TEXT}");
        let markdown = fs::read_to_string(TEXT)?;
        let mut events = Parser::new_ext(&markdown, Options::ENABLE_TABLES);
        let expression = blocks(&mut events);
        let folder = env::var("OUT_DIR")?;
        fs::write(Path::new(&folder).join("learn.rs"), expression)?;
        Ok(())
    }

    /// A slice of these expressions.
    fn slice(items: impl IntoIterator<Item = String>) -> String {
        format!("&[{}]", Vec::from_iter(items).join(", "))
    }

    /// The blocks up to the end of the element that `events` is inside of. What `Block` does not know is left as the text in it.
    fn blocks(events: &mut Parser<'_>) -> String {
        let mut blocks = Vec::new();
        // Text that stands in a list item without a paragraph of its own.
        let mut loose = Inline::default();
        while let Some(event) = events.next() {
            let block = match event {
                Event::Start(Tag::Paragraph) => format!("Block::Paragraph({})", spans(events).code()),
                Event::Start(Tag::Heading { level, .. }) => {
                    format!("Block::Heading({}, {:?})", level as usize, spans(events).plain())
                }
                Event::Start(Tag::List(first)) => format!("Block::List {{ first: {first:?}, items: {} }}", items(events)),
                Event::Start(Tag::BlockQuote(_)) => format!("Block::Quote({})", self::blocks(events)),
                Event::Start(Tag::CodeBlock(_)) => {
                    let text = spans(events).plain();
                    format!("Block::Formula({})", slice(text.lines().map(|line| format!("{line:?}"))))
                }
                Event::Start(Tag::Table(_)) => table(events),
                Event::End(TagEnd::Item | TagEnd::BlockQuote(_)) => break,
                other => {
                    loose.take(other);
                    continue;
                }
            };
            blocks.extend(loose.paragraph());
            blocks.push(block);
        }
        blocks.extend(loose.paragraph());
        slice(blocks)
    }

    fn items(events: &mut Parser<'_>) -> String {
        let mut items = Vec::new();
        while let Some(event) = events.next() {
            match event {
                Event::Start(Tag::Item) => items.push(blocks(events)),
                Event::End(TagEnd::List(_)) => break,
                _ => {}
            }
        }
        slice(items)
    }

    fn table(events: &mut Parser<'_>) -> String {
        let mut header = Vec::new();
        let mut rows: Vec<Vec<String>> = Vec::new();
        while let Some(event) = events.next() {
            match event {
                Event::Start(Tag::TableRow) => rows.push(Vec::new()),
                Event::Start(Tag::TableCell) => {
                    let cell = spans(events).code();
                    rows.last_mut().unwrap_or(&mut header).push(cell);
                }
                Event::End(TagEnd::Table) => break,
                _ => {}
            }
        }
        format!(
            "Block::Table {{ header: {}, rows: {} }}",
            slice(header),
            slice(rows.into_iter().map(slice))
        )
    }

    /// The inline text up to the end of the block that `events` is inside of.
    fn spans(events: &mut Parser<'_>) -> Inline {
        let mut inline = Inline::default();
        for event in events {
            match event {
                Event::End(TagEnd::Paragraph | TagEnd::Heading(_) | TagEnd::CodeBlock | TagEnd::TableCell) => break,
                other => inline.take(other),
            }
        }
        inline
    }

    /// Text that runs on, and what is open around its end.
    #[derive(Default)]
    struct Inline {
        spans: Vec<(String, Style)>,
        open: Style,
    }

    #[derive(Clone, Default, PartialEq)]
    struct Style {
        strong: bool,
        emphasis: bool,
        code: bool,
        link: Option<String>,
    }

    impl Inline {
        fn take(&mut self, event: Event<'_>) {
            match event {
                Event::Text(text) | Event::Html(text) | Event::InlineHtml(text) => self.push(&text, self.open.clone()),
                Event::Code(text) => self.push(
                    &text,
                    Style {
                        code: true,
                        ..self.open.clone()
                    },
                ),
                Event::SoftBreak | Event::HardBreak => self.push(" ", self.open.clone()),
                Event::Start(Tag::Strong) => self.open.strong = true,
                Event::End(TagEnd::Strong) => self.open.strong = false,
                Event::Start(Tag::Emphasis) => self.open.emphasis = true,
                Event::End(TagEnd::Emphasis) => self.open.emphasis = false,
                Event::Start(Tag::Link { dest_url, .. }) => self.open.link = Some(dest_url.to_string()),
                Event::End(TagEnd::Link) => self.open.link = None,
                _ => {}
            }
        }

        /// The parser cuts text at every character that might have meant something; here what looks the same is one again.
        fn push(&mut self, text: &str, style: Style) {
            match self.spans.last_mut() {
                Some((before, same)) if *same == style => before.push_str(text),
                _ => self.spans.push((text.to_owned(), style)),
            }
        }

        fn plain(&self) -> String {
            self.spans.iter().map(|(text, _)| text.as_str()).collect()
        }

        fn code(&self) -> String {
            slice(self.spans.iter().map(|(text, style)| {
                let Style {
                    strong,
                    emphasis,
                    code,
                    link,
                } = style;
                format!(
                    "Span {{ text: {text:?}, style: Style {{ strong: {strong}, emphasis: {emphasis}, code: {code} }}, link: {link:?} }}"
                )
            }))
        }

        /// What has been collected, as a paragraph, if it is anything.
        fn paragraph(&mut self) -> Option<String> {
            let collected = std::mem::take(self);
            (!collected.spans.is_empty()).then(|| format!("Block::Paragraph({})", collected.code()))
        }
    }
}
