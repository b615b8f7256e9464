//! Whatever is given to the readers, there is an answer: without a panic, within a second, in 64 MB.
//!
//! `cargo test --release -p depth-files --test fuzz -- --seconds 60` takes a minute for each format; `--seed 7` begins elsewhere. Without
//! optimization files are smaller and a second is ten. What fails is kept in the target folder.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::cast_precision_loss,
    missing_docs,
    reason = "tests"
)]

mod corpus;
mod judge;
mod mutate;
mod photo;

use mutate::{Random, mutated};
use peak_alloc::PeakAlloc;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const IS_SLOW: bool = cfg!(debug_assertions);
const LONGEST: Duration = Duration::from_secs(if IS_SLOW { 10 } else { 1 });
const MOST_MEMORY: usize = 64 << 20;
/// Files are made as large as the largest that is read.
const INFLATED: usize = if IS_SLOW { 20_000 } else { 4 << 20 };

/// When the answer began that is waited for, in milliseconds since the start; 0 between two.
static BEGAN: AtomicU64 = AtomicU64::new(0);

/// What one kind of files came to.
#[derive(Default)]
struct Tally {
    runs: u64,
    refused: u64,
    slowest: Duration,
    most_memory: usize,
    faults: Vec<String>,
}

impl Tally {
    fn run(&mut self, files: &[&[u8]], start: Instant) {
        BEGAN.store(u64::try_from(start.elapsed().as_millis()).unwrap().max(1), Ordering::Relaxed);
        let before = MEMORY.current_usage();
        MEMORY.reset_peak_usage();
        let begin = Instant::now();
        let answer = catch_unwind(AssertUnwindSafe(|| depth_files::read(files)));
        let mut time = begin.elapsed();
        let given: usize = files.iter().map(|bytes| bytes.len()).sum();
        let memory = given + MEMORY.peak_usage().saturating_sub(before);
        BEGAN.store(0, Ordering::Relaxed);
        // Another program may have had the processor meanwhile.
        for _ in 0..3 {
            if time > LONGEST {
                let (begin, used) = (Instant::now(), processor_time());
                _ = catch_unwind(AssertUnwindSafe(|| depth_files::read(files)));
                let used = processor_time().zip(used).map(|(now, before)| now.saturating_sub(before));
                time = time.min(used.unwrap_or_else(|| begin.elapsed()));
            }
        }
        self.runs += 1;
        self.slowest = self.slowest.max(time);
        self.most_memory = self.most_memory.max(memory);
        let fault = match answer {
            Err(_) => Some("a panic".to_owned()),
            Ok(_) if time > LONGEST => Some(format!("an answer after {} ms", time.as_millis())),
            Ok(_) if memory > MOST_MEMORY => Some(format!("{} MB", memory >> 20)),
            Ok(answer) => {
                self.refused += u64::from(answer.is_err());
                catch_unwind(AssertUnwindSafe(|| judge::judge(&answer)))
                    .unwrap_or_else(|_| Err("a panic in what is said".to_owned()))
                    .err()
            }
        };
        if let Some(fault) = fault {
            let path = kept(files);
            let fault: String = fault.chars().take(200).collect();
            self.faults.push(format!("{fault} ({})", path.display()));
        }
    }

    fn row(&self, name: &str, count: usize) -> String {
        let refused = 100.0 * self.refused as f64 / self.runs.max(1) as f64;
        let memory = self.most_memory as f64 / f64::from(1 << 20);
        let slowest = self.slowest.as_secs_f64() * 1000.0;
        format!(
            "{name:<12} {count:>5} {:>9} {refused:>7.1}% {slowest:>9.1} ms {memory:>7.1} MB {:>6}",
            self.runs,
            self.faults.len()
        )
    }
}

/// How long this thread has had a processor, in steps of 10 ms; `None` where the system does not say.
fn processor_time() -> Option<Duration> {
    let stat = std::fs::read_to_string("/proc/thread-self/stat").ok()?;
    // The name of the program, in brackets, may hold blanks. Behind it: state, ten numbers, then the time in the program and in the system.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |at: usize| fields.get(at)?.parse::<u64>().ok();
    Some(Duration::from_millis(10 * (ticks(11)? + ticks(12)?)))
}

/// Keeps the files of a fault for whoever mends it.
fn kept(files: &[&[u8]]) -> PathBuf {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let path = |at: usize| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fault-{number}-{at}"));
    for (at, bytes) in files.iter().enumerate() {
        std::fs::write(path(at), bytes).unwrap();
    }
    path(0)
}

/// What is given with `--name`.
fn argument(name: &str) -> Option<f64> {
    let mut all = std::env::args().skip_while(|argument| argument != name);
    all.nth(1)?.parse().ok()
}

/// Ends the program where no answer comes: nothing else can.
fn watch(start: Instant) {
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(Duration::from_secs(1));
            let began = BEGAN.load(Ordering::Relaxed);
            let now = u64::try_from(start.elapsed().as_millis()).unwrap();
            if began > 0 && now > began + 60_000 {
                println!("No answer for a minute.");
                std::process::exit(1);
            }
        }
    });
}

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == "--list") {
        return ExitCode::SUCCESS;
    }
    let seconds = argument("--seconds").unwrap_or(0.2);
    let mut random = Random(argument("--seed").map_or(1, f64::to_bits));
    let start = Instant::now();
    watch(start);
    // Of the faults a line is printed below, where they can be read.
    std::panic::set_hook(Box::new(|_| {}));
    let files = corpus::files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data"));
    let all: Vec<Vec<u8>> = files.values().flatten().cloned().collect();
    println!("format       files      runs  refused      slowest       peak faults");
    let mut faults = Vec::new();
    for (format, files) in &files {
        let mut tally = Tally::default();
        for file in files {
            // Every beginning, where there is time for it.
            let step = if seconds < 1.0 { 1 + file.len() / 50 } else { 1 };
            let beginnings = (0..file.len()).step_by(step);
            beginnings.for_each(|length| tally.run(&[&file[..length]], start));
        }
        let begin = Instant::now();
        while begin.elapsed().as_secs_f64() < seconds {
            let large = corpus::repeated(random.of::<Vec<u8>>(files), INFLATED, &mut random);
            tally.run(&[&large], start);
        }
        let begin = Instant::now();
        while begin.elapsed().as_secs_f64() < seconds {
            let file = mutated(random.of::<Vec<u8>>(files), &all, &mut random);
            let beside = random.of::<Vec<u8>>(files);
            match random.below(8) {
                0 => tally.run(&[&file, beside], start),
                1 => tally.run(&[beside, &file], start),
                _ => tally.run(&[&file], start),
            }
        }
        println!("{}", tally.row(format, files.len()));
        faults.append(&mut tally.faults);
    }
    let mut tally = Tally::default();
    corpus::inflated(INFLATED).iter().for_each(|large| tally.run(&[large], start));
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < seconds {
        let length = random.below(2_000);
        tally.run(&[&random.bytes(length)], start);
    }
    println!("{}", tally.row("arbitrary", 0));
    faults.append(&mut tally.faults);
    for fault in &faults {
        println!("{fault}");
    }
    if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
