//! What can be typed: commands, their arguments and their help.

use super::between::Between;
use super::camera::Camera;
use super::decode::Decode;
use super::help;
use super::import::Import;
use super::options::{Calculate, Ground};
use super::presets::Presets;
use super::q::Q;
use super::sizes::Sizes;
use super::step::Step;
use clap::{Parser, Subcommand};
use clap_complete::Shell;

/// What the program is called.
pub(super) const NAME: &str = "depth-calculator";

#[cfg(feature = "app")]
const LONG_ABOUT: &str = "\
How far away is it, and how sure can I be?

Without arguments the program opens its window. With `calculate` it answers here and needs no display.";
#[cfg(not(feature = "app"))]
const LONG_ABOUT: &str = "\
How far away is it, and how sure can I be?

This is the command line alone: it was built without the window.";

/// How far away is it, and how sure can I be?
#[derive(Debug, Parser)]
#[command(name = NAME, version, about, long_about = LONG_ABOUT)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Option<Task>,
}

#[derive(Debug, Subcommand)]
pub(super) enum Task {
    /// Compute the distance from a disparity (two cameras), from a known size (one camera), or both
    #[command(after_long_help = help::CALCULATE)]
    Calculate(Box<Calculate>),
    /// Compute where a pixel's ray meets the floor, from the height and the pitch of the camera
    #[command(after_long_help = help::GROUND)]
    Ground(Box<Ground>),
    /// Compute how far away something of unknown size is, from two photographs and the step between them
    #[command(after_long_help = help::STEP)]
    Step(Box<Step>),
    /// Compute the length between two points that a stereo pair sees
    #[command(after_long_help = help::BETWEEN)]
    Between(Box<Between>),
    /// Read a calibration file: of OpenCV, ROS, Kalibr, Middlebury, KITTI, COLMAP, ORB-SLAM, ZED, RealSense or EuRoC, or the EXIF of a photograph
    #[command(after_long_help = help::IMPORT)]
    Import(Import),
    /// Read focal length, baseline and doffs from a Q matrix of stereoRectify
    #[command(after_long_help = help::Q)]
    Q(Q),
    /// Turn what a data sheet or a simulator says of a camera into its focal length in pixels, and back
    #[command(after_long_help = help::CAMERA)]
    Camera(Box<Camera>),
    /// Decode a number that a picture or a network stores for a pixel: to a disparity, and to a distance
    #[command(after_long_help = help::DECODE)]
    Decode(Box<Decode>),
    /// List the cameras that are known, or show one: focal length, baseline, zero point, each with its source
    #[command(after_long_help = help::PRESETS)]
    Presets(Presets),
    /// List the objects of known size, or show one: for one camera and no tape
    #[command(after_long_help = help::SIZES)]
    Sizes(Sizes),
    /// Print the completions of a shell, to be stored where it looks for them
    #[command(after_long_help = COMPLETIONS_HELP)]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page, in the format of man
    #[command(after_long_help = MAN_HELP)]
    Man,
}

pub(super) const COMPLETIONS_HELP: &str = "\
Examples:
  depth-calculator completions bash \\
      > ~/.local/share/bash-completion/completions/depth-calculator
  depth-calculator completions zsh > ~/.zfunc/_depth-calculator
      where ~/.zfunc is a folder of fpath
  depth-calculator completions fish \\
      > ~/.config/fish/completions/depth-calculator.fish
  depth-calculator completions powershell >> $PROFILE";

const MAN_HELP: &str = "\
Examples:
  depth-calculator man > ~/.local/share/man/man1/depth-calculator.1
  depth-calculator man | man -l -";
