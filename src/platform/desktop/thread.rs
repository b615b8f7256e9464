//! Work beside the window: a thread, which ends with its work.

use crate::app::Event;
use depth_jobs::engine::Engine;
use depth_jobs::{Attachment, End, Failure, Job, Report, Request, Run};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;

/// What is being worked on.
#[derive(Default)]
pub struct Worker {
    /// What tells each to give up.
    running: Vec<(Run, Arc<AtomicBool>)>,
}

impl Worker {
    /// Starts work, which reports to `events`.
    pub fn start(&mut self, ctx: &egui::Context, events: &Sender<Event>, (run, job, attachments): (Run, Job, Vec<Attachment>)) {
        let is_given_up = Arc::new(AtomicBool::new(false));
        self.running.retain(|(_, flag)| Arc::strong_count(flag) > 1);
        self.running.push((run, Arc::clone(&is_given_up)));
        let (events, ctx) = (events.clone(), ctx.clone());
        std::thread::spawn(move || {
            let tell = |report| {
                // The window may be closed by now.
                events.send(Event::Job(report)).ok();
                ctx.request_repaint();
            };
            // What a piece of work leaves behind when it panics is thrown away.
            let outcome = catch_unwind(AssertUnwindSafe(|| work(run, job, attachments, &is_given_up, &tell)));
            if outcome.is_err() {
                let reason = "it panicked".to_owned();
                tell(Report::Ended {
                    run,
                    end: End::Failed(Failure::Stopped { reason }),
                });
            }
        });
    }

    /// Gives work up, before its next piece.
    pub fn cancel(&self, run: Run) {
        for (_, flag) in self.running.iter().filter(|(other, _)| *other == run) {
            flag.store(true, Ordering::Relaxed);
        }
    }
}

fn work(run: Run, job: Job, attachments: Vec<Attachment>, is_given_up: &AtomicBool, tell: &impl Fn(Report)) {
    let mut engine = Engine::default();
    engine.receive(Request::Start { run, job }, attachments);
    loop {
        if is_given_up.load(Ordering::Relaxed) {
            engine.receive(Request::Cancel { run }, Vec::new());
        }
        let is_left = engine.step();
        while let Some(report) = engine.report() {
            tell(report);
        }
        if !is_left {
            return;
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::Worker;
    use crate::app::Event;
    use depth_jobs::{End, Failure, Job, Report};
    use std::sync::mpsc;

    #[test]
    fn a_thread_answers_and_refuses_as_the_engine_does() {
        let (sender, events) = mpsc::channel();
        let mut worker = Worker::default();
        let job = Job::ReadCalibration {
            names: vec!["empty".into()],
        };
        worker.start(&egui::Context::default(), &sender, (4, job, vec![Vec::new()]));
        let Event::Job(Report::Ended {
            run: 4,
            end: End::Failed(Failure::Refused(why)),
        }) = events.recv().unwrap()
        else {
            panic!("not refused");
        };
        assert!(!why.is_empty());
    }
}
