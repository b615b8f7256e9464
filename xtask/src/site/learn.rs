//! The Learn text as HTML: `assets/learn.md`, which the program shows, too.

use std::fmt::Write as _;

use pulldown_cmark::{CodeBlockKind, CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use super::html::escaped;
use super::mathml;

/// The heading above the questions that search engines are told about.
const QUESTIONS: &str = "Questions";

/// What becomes of the text.
#[derive(Debug, Default)]
pub(super) struct Learn {
    /// Everything below the text's own title, which the page replaces by one that also stands alone.
    pub(super) html: String,
    /// The chapters: id and title as HTML.
    pub(super) chapters: Vec<(String, String)>,
    /// The questions and their answers, as plain text.
    pub(super) questions: Vec<(String, String)>,
}

/// Reads Markdown. Err: a sentence that names a formula which is none.
pub(super) fn read(markdown: &str) -> Result<Learn, String> {
    let mut writer = Writer::default();
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        writer.take(event)?;
    }
    Ok(writer.learn)
}

/// The start of what is being collected, until its end comes.
#[derive(Default)]
enum Open {
    #[default]
    Nothing,
    Heading {
        html: String,
        text: String,
    },
    Formulas(String),
}

#[derive(Default)]
struct Writer {
    learn: Learn,
    open: Open,
    ids: Vec<String>,
    among_questions: bool,
    in_table_head: bool,
    first_in_row: bool,
}

impl Writer {
    fn take(&mut self, event: Event<'_>) -> Result<(), String> {
        match (&mut self.open, event) {
            (_, Event::Start(Tag::Heading { .. })) => {
                self.open = Open::Heading {
                    html: String::new(),
                    text: String::new(),
                };
            }
            (_, Event::End(TagEnd::Heading(level))) => {
                if let Open::Heading { html, text } = std::mem::take(&mut self.open) {
                    self.heading(level, &html, text);
                }
            }
            (Open::Heading { html, text }, event) => {
                text.push_str(plain(&event));
                html::push_html(html, std::iter::once(event));
            }
            (_, Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language)))) if *language == *"math" => {
                self.open = Open::Formulas(String::new());
            }
            (Open::Formulas(lines), Event::Text(text)) => lines.push_str(&text),
            (Open::Formulas(lines), Event::End(TagEnd::CodeBlock)) => {
                let formulas = lines.lines().map(mathml::block).collect::<Result<String, String>>()?;
                self.write(&format!("<div class=\"formulas\">\n{formulas}</div>\n"));
                self.open = Open::Nothing;
            }
            (_, event) => {
                if let Some((_, answer)) = self.learn.questions.last_mut().filter(|_| self.among_questions) {
                    answer.push_str(plain(&event));
                }
                let event = self.table(event);
                html::push_html(&mut self.learn.html, event.map(to_the_calculator).into_iter());
            }
        }
        Ok(())
    }

    fn write(&mut self, html: &str) {
        self.learn.html.push_str(html);
    }

    fn heading(&mut self, level: HeadingLevel, html: &str, text: String) {
        if level == HeadingLevel::H1 {
            return;
        }
        let id = self.new_id(&text);
        // Writing into a text cannot fail.
        writeln!(self.learn.html, "<{level} id=\"{id}\">{html}</{level}>").ok();
        if level == HeadingLevel::H2 {
            self.among_questions = text == QUESTIONS;
            self.learn.chapters.push((id, html.to_owned()));
        } else if self.among_questions {
            self.learn.questions.push((text, String::new()));
        }
    }

    /// A heading's words joined by hyphens; counted where two headings have the same.
    fn new_id(&mut self, text: &str) -> String {
        let lower_case = text.to_ascii_lowercase();
        let words: Vec<&str> = lower_case
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .collect();
        let name = words.join("-");
        let mut id = name.clone();
        let mut count = 1;
        while self.ids.contains(&id) {
            count += 1;
            id = format!("{name}-{count}");
        }
        self.ids.push(id.clone());
        id
    }

    /// Tables with headings for their columns and rows, in a frame that scrolls where the window is narrow.
    fn table<'a>(&mut self, event: Event<'a>) -> Option<Event<'a>> {
        let html = match event {
            Event::Start(Tag::Table(_)) => {
                let chapter = self.learn.chapters.last().map_or("", |(id, _)| id.as_str());
                // With a tabindex, so that the keyboard can scroll it.
                let frame = format!("<div class=\"table\" role=\"region\" aria-labelledby=\"{chapter}\" tabindex=\"0\">");
                return Some(Event::Html(CowStr::from(frame + "<table>\n")));
            }
            Event::End(TagEnd::Table) => "</tbody>\n</table></div>\n",
            Event::Start(Tag::TableHead) => {
                self.in_table_head = true;
                "<thead>\n<tr>"
            }
            Event::End(TagEnd::TableHead) => {
                self.in_table_head = false;
                "</tr>\n</thead>\n<tbody>\n"
            }
            Event::Start(Tag::TableRow) => {
                self.first_in_row = true;
                "<tr>"
            }
            Event::Start(Tag::TableCell) if self.in_table_head => "<th scope=\"col\">",
            Event::Start(Tag::TableCell) if self.first_in_row => "<th scope=\"row\">",
            Event::Start(Tag::TableCell) => "<td>",
            Event::End(TagEnd::TableCell) if self.in_table_head || std::mem::take(&mut self.first_in_row) => "</th>",
            Event::End(TagEnd::TableCell) => "</td>",
            other => return Some(other),
        };
        Some(Event::Html(CowStr::from(html)))
    }
}

/// A link to an example names inputs; from this page it has to open the calculator, which reads them.
fn to_the_calculator(event: Event<'_>) -> Event<'_> {
    match event {
        Event::Start(Tag::Link {
            link_type,
            dest_url,
            title,
            id,
        }) if dest_url.starts_with('#') && dest_url.contains('=') => Event::Start(Tag::Link {
            link_type,
            dest_url: CowStr::from(format!("./{dest_url}")),
            title,
            id,
        }),
        other => other,
    }
}

/// What an event adds to plain text.
fn plain<'a>(event: &'a Event<'_>) -> &'a str {
    match event {
        Event::Text(text) | Event::Code(text) => text,
        Event::SoftBreak | Event::HardBreak => " ",
        Event::End(TagEnd::Paragraph | TagEnd::Item) => "\n",
        _ => "",
    }
}

impl Learn {
    /// The table of contents: a list of links to the chapters.
    pub(super) fn contents(&self) -> String {
        let links = self
            .chapters
            .iter()
            .map(|(id, title)| format!("<li><a href=\"#{id}\">{title}</a></li>\n"));
        format!("<ol>\n{}</ol>", links.collect::<String>())
    }

    /// The questions as search engines read them (schema.org, FAQPage), safe inside a script element.
    pub(super) fn structured_data(&self) -> String {
        let questions: Vec<serde_json::Value> = self
            .questions
            .iter()
            .map(|(question, answer)| {
                serde_json::json!({
                    "@type": "Question",
                    "name": question,
                    "acceptedAnswer": { "@type": "Answer", "text": escaped(answer.trim()) },
                })
            })
            .collect();
        let page = serde_json::json!({ "@context": "https://schema.org", "@type": "FAQPage", "mainEntity": questions });
        // Else an answer could end the element.
        page.to_string().replace('<', "\\u003c")
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::read;

    #[test]
    fn headings_have_ids_that_differ_and_the_title_is_left_to_the_page() {
        let learn = read("# Learn\n\n## Depth & `D`\n\n### Why?\n\n### Why?\n").unwrap();
        assert_eq!(
            learn.html,
            "<h2 id=\"depth-d\">Depth &amp; <code>D</code></h2>\n<h3 id=\"why\">Why?</h3>\n<h3 id=\"why-2\">Why?</h3>\n"
        );
        assert_eq!(
            learn.contents(),
            "<ol>\n<li><a href=\"#depth-d\">Depth &amp; <code>D</code></a></li>\n</ol>"
        );
    }

    #[test]
    fn a_table_says_what_its_headings_head() {
        let html = read("## Units\n\n| a | b |\n|---|---|\n| 1 | 2 |\n").unwrap().html;
        assert!(
            html.contains("<tr><th scope=\"col\">a</th><th scope=\"col\">b</th></tr>\n</thead>"),
            "{html}"
        );
        assert!(html.contains("<tr><th scope=\"row\">1</th><td>2</td></tr>\n</tbody>"), "{html}");
        assert!(html.contains("aria-labelledby=\"units\""), "{html}");
    }

    #[test]
    fn examples_open_the_calculator_and_other_links_stay() {
        let html = read("[a](#fx=700&d=50) [b](#units)").unwrap().html;
        assert_eq!(html, "<p><a href=\"./#fx=700&amp;d=50\">a</a> <a href=\"#units\">b</a></p>\n");
    }

    #[test]
    fn formulas_become_mathml_line_by_line_and_other_code_stays() {
        let html = read("```math\na = b\nc = d\n```\n\n```\ne = f\n```\n").unwrap().html;
        assert_eq!(html.matches("<math display=\"block\"").count(), 2);
        assert!(html.ends_with("<pre><code>e = f\n</code></pre>\n"), "{html}");
        assert!(read("```math\na = ?\n```").unwrap_err().contains("a = ?"));
    }

    #[test]
    fn only_what_stands_under_questions_is_a_question() {
        let learn =
            read("### No?\n\nx\n\n## Questions\n\n### Is `d` an\n\n### Is it </script>?\n\nNot *a*\nbit.\n\n## After\n\n### No?\n\ny\n")
                .unwrap();
        let expected = [("Is d an", ""), ("Is it ?", "Not a bit.\n")].map(|(q, a)| (q.to_owned(), a.to_owned()));
        assert_eq!(learn.questions, expected);
    }
}
