//! Does the work, a piece at a time.

use crate::found::calibration;
use crate::protocol::{Attachment, End, Failure, Job, Outcome, Report, Request, Run};
use std::collections::VecDeque;

/// One job, cut into pieces of some 20 ms where it can be cut. What comes of it does not depend on the cut.
trait Work {
    /// Does the next piece. Returns the outcome with the last one.
    fn step(&mut self) -> Result<Option<Outcome>, Failure>;
    /// So many pieces are done, of so many.
    fn progress(&self) -> (u32, u32);
}

/// Does the jobs that it is asked for, one after the other.
#[derive(Default)]
pub struct Engine {
    left: VecDeque<(Run, Box<dyn Work>)>,
    reports: VecDeque<Report>,
}

impl Engine {
    /// Takes a request, with the attachments of its header.
    pub fn receive(&mut self, request: Request, attachments: Vec<Attachment>) {
        match request {
            Request::Start { run, job } => self.left.push_back((run, work(job, attachments))),
            Request::Cancel { run } => {
                let before = self.left.len();
                self.left.retain(|(other, _)| *other != run);
                // What has ended already has said so.
                if self.left.len() < before {
                    self.reports.push_back(Report::Ended { run, end: End::Cancelled });
                }
            }
        }
    }

    /// Does a piece of work. Returns whether any is left.
    pub fn step(&mut self) -> bool {
        let Some((run, work)) = self.left.front_mut() else { return false };
        let run = *run;
        let report = match work.step() {
            Ok(None) => {
                let (done, of) = work.progress();
                Report::Progress { run, done, of }
            }
            Ok(Some(outcome)) => Report::Ended {
                run,
                end: End::Done(outcome),
            },
            Err(failure) => Report::Ended {
                run,
                end: End::Failed(failure),
            },
        };
        if matches!(report, Report::Ended { .. }) {
            self.left.pop_front();
        }
        self.reports.push_back(report);
        !self.left.is_empty()
    }

    /// The next report that was not taken yet.
    pub fn report(&mut self) -> Option<Report> {
        self.reports.pop_front()
    }
}

fn work(job: Job, attachments: Vec<Attachment>) -> Box<dyn Work> {
    match job {
        Job::ReadCalibration { names } => Box::new(ReadCalibration { names, files: attachments }),
    }
}

/// Calibration files are small: they are read in one piece.
struct ReadCalibration {
    names: Vec<String>,
    files: Vec<Attachment>,
}

impl Work for ReadCalibration {
    fn step(&mut self) -> Result<Option<Outcome>, Failure> {
        let files: Vec<&[u8]> = self.files.iter().map(Vec::as_slice).collect();
        let names: Vec<&str> = self.names.iter().map(String::as_str).collect();
        let found = depth_files::read(&files).map_err(|refusal| Failure::Refused(refusal.sentence(&names)))?;
        Ok(Some(Outcome::Calibration(Box::new(calibration(&found, &names)))))
    }

    fn progress(&self) -> (u32, u32) {
        (0, 1)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]
mod tests {
    use super::Engine;
    use crate::protocol::{End, Failure, Job, Outcome, Report, Request};

    const MIDDLEBURY: &[u8] =
        b"cam0=[700 0 320; 0 700 240; 0 0 1]\ncam1=[700 0 330; 0 700 240; 0 0 1]\ndoffs=10\nbaseline=100\nwidth=640\nheight=480\n";

    fn start(engine: &mut Engine, run: u32, file: &[u8]) {
        let job = Job::ReadCalibration {
            names: vec!["calib.txt".into()],
        };
        engine.receive(Request::Start { run, job }, vec![file.to_vec()]);
    }

    #[test]
    fn the_window_knows_a_photograph_and_the_largest_file_as_the_readers_do() {
        assert_eq!(crate::LARGEST_FILE, depth_files::LARGEST);
        for begin in [
            b"\xff\xd8\xff\xe0".as_slice(),
            b"\xff\xd8\xff",
            b"\xff\xd8",
            b"",
            b"%YAML",
            b"\x89PNG",
        ] {
            assert_eq!(crate::is_photograph(begin), depth_files::is_jpeg(begin), "{begin:?}");
        }
    }

    #[test]
    fn a_calibration_comes_out_with_what_it_says_and_where() {
        let mut engine = Engine::default();
        start(&mut engine, 7, MIDDLEBURY);
        assert!(!engine.step());
        let Some(Report::Ended {
            run: 7,
            end: End::Done(Outcome::Calibration(found)),
        }) = engine.report()
        else {
            panic!("no calibration");
        };
        let names: Vec<&str> = found.choices.iter().map(|choice| choice.name.as_str()).collect();
        assert_eq!(names, ["cam0 and cam1", "cam0 alone", "cam1 alone"]);
        let [pair, _, right] = found.choices.as_slice() else {
            panic!("three choices")
        };
        assert_eq!(pair.camera.intrinsics_px, [700.0, 700.0, 320.0, 240.0]);
        assert_eq!(pair.baseline.unwrap().length(None).unwrap().m(), 0.1);
        assert_eq!(pair.doffs_px, Some(10.0));
        assert!(pair.baseline_origin.contains("line 4"), "{}", pair.baseline_origin);
        assert_eq!(right.camera.intrinsics_px, [700.0, 700.0, 330.0, 240.0]);
        assert_eq!(right.baseline, None);
        assert!(engine.report().is_none());
    }

    #[test]
    fn of_two_pairs_each_has_its_own_baseline() {
        let row = |name: &str, tx: f64| format!("{name}: 700 0 320 {tx} 0 700 240 0 0 0 1 0\n");
        let kitti = [row("P0", 0.0), row("P1", -350.0), row("P2", 42.0), row("P3", -378.0)].concat();
        let mut engine = Engine::default();
        start(&mut engine, 1, kitti.as_bytes());
        engine.step();
        let Some(Report::Ended {
            end: End::Done(Outcome::Calibration(found)),
            ..
        }) = engine.report()
        else {
            panic!("no calibration");
        };
        let baselines: Vec<(String, f64)> = found
            .choices
            .iter()
            .filter_map(|choice| Some((choice.name.clone(), choice.baseline?.length(None)?.m())))
            .collect();
        let [(gray, b_gray), (color, b_color), ..] = baselines.as_slice() else {
            panic!("{baselines:?}")
        };
        assert_eq!([gray.as_str(), color.as_str()], ["camera 0 and camera 1", "camera 2 and camera 3"]);
        assert!((b_gray - 0.5).abs() < 1e-12 && (b_color - 0.6).abs() < 1e-12, "{baselines:?}");
        assert!(
            found
                .choices
                .iter()
                .any(|choice| choice.name.ends_with(" alone") && choice.baseline.is_none())
        );
    }

    #[test]
    fn what_cannot_be_read_is_refused_in_a_sentence() {
        let mut engine = Engine::default();
        start(&mut engine, 1, b"");
        engine.step();
        let Some(Report::Ended {
            end: End::Failed(Failure::Refused(why)),
            ..
        }) = engine.report()
        else {
            panic!("read");
        };
        assert!(why.ends_with('.'), "{why}");
    }

    #[test]
    fn what_is_given_up_says_so_once_and_the_rest_goes_on() {
        let mut engine = Engine::default();
        start(&mut engine, 1, MIDDLEBURY);
        start(&mut engine, 2, MIDDLEBURY);
        for _ in 0..2 {
            engine.receive(Request::Cancel { run: 1 }, Vec::new());
        }
        engine.step();
        assert_eq!(
            engine.report(),
            Some(Report::Ended {
                run: 1,
                end: End::Cancelled
            })
        );
        assert!(matches!(engine.report(), Some(Report::Ended { run: 2, end: End::Done(_) })));
        assert_eq!(engine.report(), None);
    }

    #[test]
    fn reports_and_requests_survive_the_way() {
        let mut engine = Engine::default();
        start(&mut engine, 3, MIDDLEBURY);
        engine.step();
        let report = engine.report().unwrap();
        let header = serde_json::to_string(&report).unwrap();
        assert_eq!(serde_json::from_str::<Report>(&header).unwrap(), report);
    }
}
