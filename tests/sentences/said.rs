//! What is said about the cases of a file.

use crate::case::{Case, cases};
use depth_calculator::core::problem::{Field, Method, Problem};
use depth_calculator::core::quantity::LengthUnit;
use depth_text::camera_sheet::CameraSheet;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::note::{Issue, Note, Part, Severity};
use depth_text::report::{Mode, Shown, Strip};
use depth_text::sentences::{CommandLine, Statement};
use depth_text::ways::{BASELINES, DISPARITIES, FOCAL_LENGTHS, Way};
use depth_text::{q_matrix, report};
use std::collections::BTreeSet;
use std::fmt::Debug;

#[derive(Default)]
pub struct Said {
    /// The cases with what is said about them.
    pub text: String,
    /// The variants that were said, "Issue::NotANumber".
    pub variants: BTreeSet<String>,
    /// What the command line wrote.
    pub command_line: String,
}

impl Said {
    pub fn of(file: &str) -> Self {
        let mut said = Self::default();
        for case in cases(file) {
            let how = if case.how.is_empty() {
                String::new()
            } else {
                format!(", {}", case.how)
            };
            said.line(&format!("[{}{how}]", case.typed_into));
            case.typed.lines().for_each(|line| said.line(line));
            let before = said.text.len();
            said.case(&case);
            if said.text.len() == before {
                said.line("  (nothing)");
            }
            said.line("");
        }
        said
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line.trim_end());
        self.text.push('\n');
    }

    fn case(&mut self, case: &Case<'_>) {
        match case.typed_into {
            "form" => self.form(case),
            "Q matrix" => match q_matrix::read(case.typed) {
                Ok(geometry) if geometry.swapped => self.issue("warning", &Issue::QMatrixSwapped),
                Ok(_) => {}
                Err(issue) => self.issue("error", &issue),
            },
            "camera" => self.camera(case),
            "command line" => self.arguments(case),
            way => {
                let key = way.strip_prefix("way ").unwrap_or_else(|| panic!("what is [{way}]?"));
                let mut tables = [FOCAL_LENGTHS, BASELINES, DISPARITIES].into_iter();
                let way = tables.find_map(|ways| Way::named(ways, key)).unwrap();
                for note in &way.solve(&case.entries(), &Problem::default()).notes {
                    self.note(note);
                }
            }
        }
    }

    fn camera(&mut self, case: &Case<'_>) {
        let sheet = CameraSheet {
            entries: case.entries(),
            projection: case.how.to_owned(),
            is_under_water: case.how == "under water",
        };
        let solved = sheet.solve();
        solved.notes.iter().for_each(|note| self.note(note));
        for (severity, sentence) in &solved.said {
            self.line(&format!("  {severity:?}: {sentence}"));
        }
        if let Some(fx) = solved.following(fields::CAMERA_FX) {
            self.line(&format!("  fx would be {fx} px"));
        }
    }

    fn form(&mut self, case: &Case<'_>) {
        let inputs = case.inputs();
        let assessment = inputs.assess();
        if let Some(mode) = case.how.strip_prefix("strip ") {
            let mode = Mode::ALL.into_iter().find(|one| one.name() == mode).unwrap();
            return self.strip(mode, &inputs);
        }
        assessment.notes.iter().for_each(|note| self.note(note));
        if let Some(Err(issue)) = assessment.unknown.as_ref().map(|unknown| &unknown.outcome) {
            self.issue("in place of the result", issue);
        }
        if case.how == "to be calculated" {
            inputs.missing().iter().for_each(|note| self.note(note));
        }
        if case.how == "results" {
            let solution = &assessment.solution;
            if let Some(statement) = Statement::comparison(&assessment) {
                self.statement(&statement);
            }
            for suspect in &assessment.suspects() {
                self.statement(&Statement::suspect(&assessment, suspect));
            }
            if solution.combined.is_some() {
                self.statement(&Statement::Combined);
            }
            let causes = Method::ALL.map(|method| {
                solution
                    .uncertainty(method)
                    .and_then(|known| Statement::main_cause(&assessment, known))
            });
            causes.into_iter().flatten().for_each(|cause| self.statement(&cause));
            for key in Method::ALL.iter().filter_map(|&method| Some(assessment.refusal(method)?.key)) {
                self.statement(&Statement::SeeNote { key });
            }
            self.statement(&Statement::widths(&assessment));
            for remark in Method::ALL.into_iter().flat_map(|method| report::remarks(&assessment, method)) {
                self.statement(&remark);
            }
            if assessment.geometry.two_shots.is_some_and(|shots| shots.is_one_pixel_each) {
                self.statement(&Statement::OnePixelEach);
            }
            let is_poor = |method| {
                solution
                    .uncertainty(method)
                    .is_some_and(|uncertainty| !uncertainty.model.first_order_is_good())
            };
            if Method::ALL.into_iter().any(is_poor) {
                for has_simulation in [true, false] {
                    self.statement(&Statement::FirstOrderIsPoor { has_simulation });
                }
            }
        }
    }

    /// The cells of the answer: what was solved for is the disparity.
    fn strip(&mut self, mode: Mode, inputs: &Inputs) {
        let inputs = Inputs {
            unknown: (mode == Mode::Quantity).then_some((Method::Stereo, Field::Disparity)),
            ..inputs.clone()
        };
        let assessment = inputs.assess();
        let shown = Shown {
            inputs: &inputs,
            assessment: &assessment,
            unit: LengthUnit::Meter,
            was: None,
        };
        for cell in Strip::new(mode, &shown).cells {
            self.line(&format!("  {}", cell.text()));
            cell.remarks.iter().for_each(|remark| self.line(&format!("    {remark}")));
        }
    }

    fn note(&mut self, note: &Note) {
        let part = if note.part == Part::Sigma { "± " } else { "" };
        let severity = match note.severity {
            Severity::Warning => "warning",
            Severity::Error => "error",
        };
        self.issue(&format!("{severity} at {part}{}", note.key.as_str()), &note.issue);
        for fix in &note.fixes {
            self.line(&format!("    [{}]", fix.label()));
        }
    }

    fn issue(&mut self, place: &str, issue: &Issue) {
        self.variants.insert(format!("Issue::{}", variant(issue)));
        self.line(&format!("  {place}: {issue}"));
    }

    fn statement(&mut self, statement: &Statement) {
        self.variants.insert(format!("Statement::{}", variant(statement)));
        self.line(&format!("  {statement}"));
    }

    fn arguments(&mut self, case: &Case<'_>) {
        let words = case.typed.split_whitespace().map(|word| word.trim_matches('\'').into());
        let words = std::iter::once("depth-calculator".into()).chain(words);
        let (mut out, mut err) = (Vec::new(), Vec::new());
        if case.how == "disk full" {
            depth_calculator::cli::run(words, &mut Full, &mut err);
        } else {
            depth_calculator::cli::run(words, &mut out, &mut err);
        }
        let lines = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        let (out, err) = (lines(out), lines(err));
        let usage = |line: &&str| line.starts_with("depth-calculator: ");
        out.lines()
            .chain(err.lines().filter(usage))
            .for_each(|line| self.line(&format!("  {line}")));
        self.command_line.push_str(&err);
    }
}

/// A disk without room.
struct Full;

impl std::io::Write for Full {
    fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
        Err(std::io::Error::other("No space left on device"))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The name of the variant that `value` is.
fn variant(value: &impl Debug) -> String {
    format!("{value:?}").chars().take_while(|c| c.is_alphanumeric()).collect()
}

/// Fails where a sentence is in no case.
pub fn assert_complete(variants: &BTreeSet<String>, command_line: &str) {
    let issues = Issue::NAMES.iter().map(|name| format!("Issue::{name}"));
    let statements = Statement::NAMES.iter().map(|name| format!("Statement::{name}"));
    let missing: Vec<String> = issues.chain(statements).filter(|name| !variants.contains(name)).collect();
    assert!(missing.is_empty(), "no case in tests/sentences/cases has {missing:?}");

    let examples = examples();
    assert_eq!(examples.iter().map(variant).collect::<Vec<_>>(), CommandLine::NAMES);
    for example in examples {
        assert!(
            command_line.contains(&example.to_string()),
            "no case in tests/sentences/cases has: {example}"
        );
    }
}

/// What the command line writes is text: one example of each variant, as some case has it.
fn examples() -> Vec<CommandLine> {
    vec![
        CommandLine::EmptyOption { option: "fx".into() },
        CommandLine::EmptySigma { option: "fx".into() },
        CommandLine::NoDistance {
            ways: vec![
                (vec!["baseline".into(), "disparity".into()], "Stereo"),
                (vec!["w-img".into(), "w-real".into()], "Monocular"),
            ],
        },
        CommandLine::NoCommand,
        CommandLine::NotWritten {
            reason: "No space left on device".into(),
        },
        CommandLine::UnusedDoffs,
        CommandLine::UnusedTilt,
        CommandLine::UnusedPoint {
            options: vec!["cx".into(), "cy".into(), "v".into()],
        },
        CommandLine::NoPoint {
            options: vec!["fx".into(), "cy".into()],
        },
        CommandLine::UnusedDistance,
        CommandLine::UnusedUnknown,
        CommandLine::UnusedWithAngle,
        CommandLine::UnusedFocalLength,
        CommandLine::NoKnownDistance,
        CommandLine::UnusedChoice { method: Method::Stereo },
        CommandLine::UnusedBesideAngle,
        CommandLine::UnusedFy,
        CommandLine::UnusedLens,
        CommandLine::UnusedBesideLengths,
        CommandLine::NotAPoint,
        CommandLine::WhichEquation,
        CommandLine::NoWay {
            options: vec!["cy".into(), "pitch".into(), "row".into()],
        },
        CommandLine::UnreadableFile {
            file: "/no/such/file".into(),
            reason: "No such file or directory".into(),
        },
        CommandLine::NotSolved {
            unknown: Key::named("d").unwrap(),
            options: vec!["baseline".into()],
        },
        CommandLine::FileTooLarge { file: "/dev/zero".into() },
        CommandLine::FileNotText {
            file: "assets/fonts/Inter-Regular.ttf".into(),
        },
        CommandLine::UnusedSigma { option: "w-real".into() },
    ]
}
