//! Work beside the page: a Worker with a WebAssembly module of its own, made when there is the first work for it. One that fails is
//! ended, and what it was working on with it; the next work gets a new one.

use std::cell::RefCell;
use std::rc::Rc;

use depth_jobs::{Attachment, End, Failure, Job, PROTOCOL, Report, Request, Run};
use js_sys::{Array, Uint8Array};
use serde::Deserialize;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;

use super::inbox::{Inbox, sentence};
use super::listeners::on;
use crate::app::Event;

/// So long a worker may take to say that it has given up.
const PATIENCE_MS: i32 = 1000;

/// Whoever works for the page. Clones are the same one.
#[derive(Clone)]
pub(super) struct Worker {
    inbox: Inbox,
    state: Rc<RefCell<State>>,
}

#[derive(Default)]
struct State {
    worker: Option<web_sys::Worker>,
    /// Whether it has said that it is there.
    is_ready: bool,
    /// What it has not reported the end of.
    running: Vec<Run>,
    /// Those of them that it was told to give up.
    given_up: Vec<Run>,
    /// The number of the worker: what one says that was ended is not heard.
    number: u32,
}

/// What assets/web/worker.js says when it cannot go on.
#[derive(Deserialize)]
struct Failed {
    failed: String,
}

impl Worker {
    /// Nobody yet.
    pub(super) fn new(inbox: &Inbox) -> Self {
        Self {
            inbox: inbox.clone(),
            state: Rc::default(),
        }
    }

    /// Starts work. Nobody waits for a worker that has not given up yet what came before: there will be a new one.
    pub(super) fn start(&self, run: Run, job: Job, attachments: Vec<Attachment>) {
        self.end_given_up();
        self.state.borrow_mut().running.push(run);
        if let Err(reason) = self.ask(&Request::Start { run, job }, attachments) {
            self.end_all(&Failure::NotLoaded { reason });
        }
    }

    /// Gives work up.
    pub(super) fn cancel(&self, run: Run) {
        if !self.state.borrow().running.contains(&run) {
            return;
        }
        self.state.borrow_mut().given_up.push(run);
        self.ask(&Request::Cancel { run }, Vec::new()).ok();
        let worker = self.clone();
        let give_up = Closure::once_into_js(move || {
            if worker.state.borrow().given_up.contains(&run) {
                worker.end_given_up();
            }
        });
        if let Some(window) = web_sys::window() {
            window
                .set_timeout_with_callback_and_timeout_and_arguments_0(give_up.unchecked_ref(), PATIENCE_MS)
                .ok();
        }
    }

    /// Ends a worker that has not given up what it was told to.
    fn end_given_up(&self) {
        let given_up = self.state.borrow().given_up.clone();
        if given_up.is_empty() {
            return;
        }
        for run in given_up {
            self.tell(run, End::Cancelled);
        }
        self.end_all(&Failure::Stopped {
            reason: "it did not answer".to_owned(),
        });
    }

    /// Err: why there is nobody to ask.
    fn ask(&self, request: &Request, attachments: Vec<Attachment>) -> Result<(), String> {
        let header = serde_json::to_string(request).map_err(|error| error.to_string())?;
        let (message, moved) = (Array::of1(&header.into()), Array::new());
        for bytes in attachments {
            let bytes = Uint8Array::from(bytes.as_slice());
            moved.push(&bytes.buffer());
            message.push(&bytes);
        }
        let there = self.state.borrow().worker.clone();
        let worker = match there {
            Some(worker) => worker,
            None => self.make()?,
        };
        worker
            .post_message_with_transfer(&message, &moved)
            .map_err(|error| sentence(&error))
    }

    fn make(&self) -> Result<web_sys::Worker, String> {
        let script = script().ok_or("the page does not name it")?;
        let made = web_sys::Worker::new(&script).map_err(|error| sentence(&error))?;
        let number = {
            let mut state = self.state.borrow_mut();
            state.number += 1;
            state.is_ready = false;
            state.worker = Some(made.clone());
            state.number
        };
        let is_heard = {
            let state = self.state.clone();
            move || state.borrow().number == number
        };
        let (worker, heard) = (self.clone(), is_heard.clone());
        on(&made, "message", move |event| {
            if heard() {
                worker.hear(&event);
            }
        });
        let worker = self.clone();
        on(&made, "error", move |event| {
            if is_heard() {
                event.prevent_default();
                let message = event.dyn_ref::<web_sys::ErrorEvent>().map(web_sys::ErrorEvent::message);
                worker.fail(
                    message
                        .filter(|message| !message.is_empty())
                        .as_deref()
                        .unwrap_or("it did not arrive"),
                );
            }
        });
        Ok(made)
    }

    fn hear(&self, event: &web_sys::Event) {
        let data = event.dyn_ref::<web_sys::MessageEvent>().map(web_sys::MessageEvent::data);
        let header = data
            .and_then(|data| data.dyn_into::<Array>().ok()?.get(0).as_string())
            .unwrap_or_default();
        match serde_json::from_str(&header) {
            Ok(Report::Ready { protocol: PROTOCOL }) => self.state.borrow_mut().is_ready = true,
            Ok(Report::Ready { .. }) => self.end_all(&Failure::OtherBuild),
            Ok(Report::Ended { run, end }) => self.tell(run, end),
            Ok(report @ Report::Progress { .. }) => self.inbox.add(Event::Job(report)),
            Err(_) => {
                let failed = serde_json::from_str::<Failed>(&header);
                self.fail(&failed.map_or_else(|_| "its answer could not be parsed".to_owned(), |failed| failed.failed));
            }
        }
    }

    fn tell(&self, run: Run, end: End) {
        {
            let mut state = self.state.borrow_mut();
            state.running.retain(|other| *other != run);
            state.given_up.retain(|other| *other != run);
        }
        self.inbox.add(Event::Job(Report::Ended { run, end }));
    }

    fn fail(&self, reason: &str) {
        let reason = reason.to_owned();
        let is_ready = self.state.borrow().is_ready;
        self.end_all(&if is_ready {
            Failure::Stopped { reason }
        } else {
            Failure::NotLoaded { reason }
        });
    }

    /// Ends the worker, and all that it was working on.
    fn end_all(&self, failure: &Failure) {
        let (worker, running) = {
            let mut state = self.state.borrow_mut();
            state.number += 1;
            (state.worker.take(), std::mem::take(&mut state.running))
        };
        if let Some(worker) = worker {
            worker.terminate();
        }
        for run in running {
            self.tell(run, End::Failed(failure.clone()));
        }
    }
}

/// What the script of the worker is called, which has a hash of its content in its name.
fn script() -> Option<String> {
    let document = web_sys::window()?.document()?;
    let name = document.query_selector("meta[name=worker]").ok()??.get_attribute("content")?;
    (!name.is_empty()).then_some(name)
}
