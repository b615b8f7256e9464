//! YAML and JSON as a [`Node`], also as OpenCV and ORB-SLAM write it, which is no YAML.

use crate::node::{Node, Value};
use crate::place::Place;
use crate::refusal::Refusal;
use crate::warning::Warning;
use saphyr_parser::{Event, Parser, ScanError, Span, StrInput};
use std::collections::{HashMap, HashSet};

/// No calibration nests deeper: OpenCV’s have three levels, DepthAI’s eight.
const DEEPEST: usize = 64;
/// No calibration holds more numbers and names: point lists of OpenCV have 10 000, a scene of a thousand images 30 000.
const MOST: usize = 200_000;
/// Nor more between them: a scene of a thousand images has 30 000.
const MOST_SEPARATORS: usize = 100_000;
/// PyYAML writes a line for each number, and so does `ros2 topic echo`.
const MOST_LINES: usize = 2 * MOST;
/// Of so many keys it is said that they stand twice.
const MOST_DOUBLED: usize = 4;

/// Every document that holds something in `text`, which is the `file`th. What stands twice in it is added to `warnings`.
pub(crate) fn documents(text: &str, file: usize, warnings: &mut Vec<Warning>) -> Result<Vec<Node>, Refusal> {
    // The parser keeps all of a list that may be the key of a map, before anything of it is counted here.
    let count = |signs: &[u8]| text.bytes().filter(|byte| signs.contains(byte)).count();
    if count(b",:[{") > MOST_SEPARATORS || text.lines().count() > MOST_LINES {
        let open = count(b"[{").saturating_sub(count(b"]}"));
        return Err(if open > DEEPEST { Refusal::TooDeep } else { Refusal::TooMuch });
    }
    let repaired = repaired(text);
    let mut builder = Builder {
        file,
        ..Builder::default()
    };
    for event in Parser::new(StrInput::new(&repaired)) {
        let (event, span) = event.map_err(|error| syntax(text, file, &error))?;
        builder.take(event, span)?;
    }
    warnings.append(&mut builder.doubled);
    Ok(builder.documents)
}

fn syntax(text: &str, file: usize, error: &ScanError) -> Refusal {
    // The parser’s own limit, deeper than this one’s.
    if error.info().contains("recursion") {
        return Refusal::TooDeep;
    }
    let what = if text.trim_start().starts_with(['{', '[']) {
        "JSON"
    } else {
        "YAML"
    };
    Refusal::Syntax {
        what,
        place: Place {
            file,
            line: error.marker().line(),
        },
        reason: error.info().to_owned(),
    }
}

/// What a parser of YAML 1.2 reads, line for line: without OpenCV’s header and its tags, with the blank behind a colon that OpenCV does not
/// ask for, and with blanks for tabs.
fn repaired(text: &str) -> String {
    let mut all = String::with_capacity(text.len());
    for line in text.lines() {
        if !line.starts_with('%') {
            // A list goes on further in than its key stands, which one blank would not be; of so many tabs that is no question.
            let blanks = if all.len() > 2 * text.len() { " " } else { "        " };
            all.push_str(&spaced(&untagged(&line.replace('\t', blanks))));
        }
        all.push('\n');
    }
    all
}

fn untagged(line: &str) -> String {
    let Some(at) = line.find(": !") else { return line.to_owned() };
    let (before, tag) = line.split_at(at + 2);
    let end = tag.find(char::is_whitespace).unwrap_or(tag.len());
    format!("{before}{}", tag.get(end..).unwrap_or_default())
}

/// `data:[1, 2]` and `Viewer.PointSize:2` with a blank behind the colon.
fn spaced(line: &str) -> String {
    let Some((key, value)) = line.split_once(':') else {
        return line.to_owned();
    };
    let is_key = !key.trim().is_empty() && key.trim().chars().all(|one| one.is_ascii_alphanumeric() || "_.-".contains(one));
    let begins = |first: char| first == '[' || first.is_ascii_digit() || "-.".contains(first);
    // A time of the day has colons too, behind a key of its own.
    let is_number = crate::number::number(value.split('#').next().unwrap_or_default()).is_some();
    if is_key && value.starts_with(begins) && (value.starts_with('[') || is_number) {
        format!("{key}: {value}")
    } else {
        line.to_owned()
    }
}

/// Makes nodes of events, and refuses what grows beyond any calibration.
#[derive(Default)]
struct Builder {
    file: usize,
    documents: Vec<Node>,
    /// What is not closed yet.
    open: Vec<Open>,
    /// What aliases stand for, by their numbers.
    anchors: Vec<(usize, Node)>,
    /// How many nodes there are, those of aliases too.
    count: usize,
    /// What stands twice.
    doubled: Vec<Warning>,
}

struct Open {
    node: Node,
    anchor: usize,
    /// Of a map: the key whose value comes next.
    key: Option<(String, usize)>,
}

impl Builder {
    fn take(&mut self, event: Event<'_>, span: Span) -> Result<(), Refusal> {
        let place = Place {
            file: self.file,
            line: span.start.line(),
        };
        let node = |value| Node { place, value };
        match event {
            Event::Scalar(text, _, anchor, _) => self.add(node(Value::Text(text.into_owned())), anchor),
            Event::SequenceStart(anchor, _) => self.begin(node(Value::List(Vec::new())), anchor),
            Event::MappingStart(anchor, _) => self.begin(node(Value::Map(Vec::new())), anchor),
            Event::SequenceEnd | Event::MappingEnd => match self.open.pop() {
                Some(Open { mut node, anchor, .. }) => {
                    self.take_last(&mut node);
                    self.add(node, anchor)
                }
                None => Ok(()),
            },
            Event::Alias(anchor) => {
                let known = self.anchors.iter().find(|(number, _)| *number == anchor);
                let node = known.map_or_else(|| node(Value::Text(String::new())), |(_, node)| node.clone());
                self.count += size(&node);
                self.add(node, 0)
            }
            _ => Ok(()),
        }
    }

    /// Of a key that stands twice in a map the last value counts, as for Python’s parsers of YAML and JSON.
    fn take_last(&mut self, node: &mut Node) {
        let Value::Map(entries) = &mut node.value else { return };
        let mut last: HashMap<&str, Place> = HashMap::new();
        let mut first: HashMap<&str, Place> = HashMap::new();
        for (key, node) in entries.iter() {
            first.entry(key).or_insert(node.place);
            last.insert(key, node.place);
        }
        if last.len() == entries.len() {
            return;
        }
        for (key, node) in entries.iter() {
            let places = [first.get(key.as_str()), last.get(key.as_str())];
            if let [Some(first), Some(last)] = places
                && *first == node.place
                && first != last
                && self.doubled.len() < MOST_DOUBLED
            {
                let (key, places) = (key.clone(), [*first, *last]);
                self.doubled.push(Warning::Doubled { key, places });
            }
        }
        let mut seen = HashSet::new();
        let mut kept: Vec<(String, Node)> = entries.drain(..).rev().filter(|(key, _)| seen.insert(key.clone())).collect();
        kept.reverse();
        *entries = kept;
    }

    fn begin(&mut self, node: Node, anchor: usize) -> Result<(), Refusal> {
        if self.open.len() >= DEEPEST {
            return Err(Refusal::TooDeep);
        }
        self.open.push(Open { node, anchor, key: None });
        Ok(())
    }

    fn add(&mut self, node: Node, anchor: usize) -> Result<(), Refusal> {
        self.count += 1;
        if self.count > MOST {
            return Err(Refusal::TooMuch);
        }
        if anchor > 0 {
            self.anchors.push((anchor, node.clone()));
            self.count += size(&node);
        }
        let Some(open) = self.open.last_mut() else {
            if !matches!(&node.value, Value::Text(text) if text.is_empty()) {
                self.documents.push(node);
            }
            return Ok(());
        };
        match &mut open.node.value {
            Value::List(items) => items.push(node),
            Value::Map(entries) => match open.key.take() {
                // What is said of a value is said with the line of its key, below which it may begin.
                Some((key, line)) => {
                    let place = Place { line, ..node.place };
                    entries.push((key, Node { place, ..node }));
                }
                None => open.key = Some((node.text().unwrap_or_default().to_owned(), node.place.line)),
            },
            Value::Text(_) => {}
        }
        Ok(())
    }
}

fn size(node: &Node) -> usize {
    let inside: usize = match &node.value {
        Value::Text(_) => 0,
        Value::List(items) => items.iter().map(size).sum(),
        Value::Map(entries) => entries.iter().map(|(_, node)| size(node)).sum(),
    };
    1 + inside
}
