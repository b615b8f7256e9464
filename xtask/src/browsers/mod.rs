//! Real browsers for the tests: which there are, how what is missing is installed, and how tests/browser runs in one.

mod engine;
mod find;
mod install;
mod run;

pub(crate) use engine::{Engine, Places, Programs};
pub(crate) use install::{find_or_install, install_packages, plan};
pub(crate) use run::{Tests, test_files};
