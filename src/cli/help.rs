//! What `--help` and the manual page say below the options. The lines are short enough for a manual page in 80 columns.

/// Of `calculate`.
pub(super) const CALCULATE: &str = "\
Formulas:
  stereo     D = fx · b / (d + doffs)   needs --fx, --baseline, --disparity
  monocular  D = w_real · fx / w_img    needs --fx, --w-img, --w-real

Units:
  A length may carry nm, um, mm, cm, m, km, in, ft, yd or mi (100mm,
  \"1 1/8 in\", 5'11\"), or squares of a calibration board (\"1.695
  squares of 23.6 mm\"). Bare, --baseline, --lens and --zero are in mm,
  the others in m. An angle may carry deg, arcmin, arcsec, rad, mrad, MOA
  or mil (6400 to the circle); bare, --tilt is in degrees. --w-img and
  --disparity may be angles, which need no --fx; with --fx as a length
  they may be lengths on the sensor. 1/3 and 2*50 are computed. An
  uncertainty is one standard deviation: with a unit, in percent (1%),
  or bare in the unit of its value; \"700 ± 2 px\" is both. A raw value of
  OpenCV's StereoBM or StereoSGBM is 16 times the disparity: divide it.

Answer:
  The first line starts with the distance; with both methods and their
  uncertainties it is the two combined, unless they disagree. Warnings go
  to standard error, or with --json into \"warnings\".

Examples:
  depth-calculator calculate --fx 700 --baseline 100mm --disparity 50
      a coffee mug, 1.400 m away
  depth-calculator calculate --fx 950 --w-img 200 --w-real 0.9m --unit ft
      a doorway, 14.03 ft away
  depth-calculator calculate --fx 700 --baseline 100 --disparity 50 \\
      --sigma-fx 2 --sigma-baseline 0.5mm --sigma-disparity 0.5 --json
      how sure one can be of the mug, for a program to read
  depth-calculator calculate --fx 700 --baseline 100 --distance 2 \\
      --solve-for disparity
      at 2 m the disparity is 35 px
  depth-calculator calculate --fx 700 --baseline 100 --disparity 50 \\
      --cx 640 --cy 360 --u 1000 --v 360
      where the mug is, and how far by tape: 1.574 m
  depth-calculator calculate --w-img \"0.75 ± 0.05 mrad\" --w-real 10in
      a target in a scope, 339 m away, give or take 23 m
  depth-calculator calculate --fx 600 --fy 853 --w-img 100 --w-real 1.8 \\
      --object height
      a person who is 100 rows high, 15.35 m away
  depth-calculator calculate --fx 152.44mm --disparity 36.25mm \\
      --baseline 576.66ft --unit ft
      two aerial photographs on film, 2425 ft above the point

Exit status:
  0 with an answer, 2 with a one-line reason on standard error,
  1 if the answer could not be written";

/// Of `ground`.
pub(super) const GROUND: &str = "\
The ray of a pixel meets a level floor, or the level plane at the height
of the target. The camera has no roll. Pitch and --angle count downwards.

Example:
  depth-calculator ground --fx 700 --cx 640 --cy 360 --height 1.2 \\
      --pitch 10 --u 1100 --row 500
      3.740 m along the floor: 3.076 m ahead, 2.128 m to the right";

/// Of `step`.
pub(super) const STEP: &str = "\
The camera goes straight towards the object. Its size need not be
known; with --fx it is computed too. An error in a width counts as many
times more than elsewhere as the distance is longer than the step.

Example:
  depth-calculator step --far-px 1162 --near-px 1429 --step 419.1mm \\
      --sigma-px 3 --unit mm
      2243 mm from the first place, give or take 32 mm";

/// Of `between`.
pub(super) const BETWEEN: &str = "\
Both points are given as column and row in the left image (or the upper
one) and disparity, with commas between.

Example:
  depth-calculator between --fx 452.9 --baseline 75mm --cx 298.85 \\
      --cy 245.52 --from 138,219,36 --to 264,216,30 --sigma-disparity 0.5
      0.312 m, give or take 0.011 m";

/// Of `import`.
pub(super) const IMPORT: &str = "\
A file is recognized by what is in it. Where it does not say its unit, as
those of OpenCV do not, --file-unit does: 1mm, or 25mm for squares of 25 mm.
Where it has several cameras or pairs, --camera chooses, and of a photograph
(JPEG) the way from its EXIF to a focal length: --camera diagonal.
`calculate --from FILE...` takes fx, baseline and doffs from it.

Examples:
  depth-calculator import extrinsics.yml intrinsics.yml --file-unit 1mm
  depth-calculator import cam0/sensor.yaml cam1/sensor.yaml --json
  depth-calculator import SN1234.conf --camera 'left HD,right HD'
  depth-calculator calculate --from calib.txt --disparity 50";

/// Of `camera`.
pub(super) const CAMERA: &str = "\
Examples:
  depth-calculator camera --width 1920 --height 1080 --dfov 78
  depth-calculator camera --width 4032 --height 3024 --f35 26mm
  depth-calculator camera --width 1600 --height 800 --lens 8mm \\
      --sensor-width 9.6mm --sensor-height 7.2mm";

/// Of `decode`.
pub(super) const DECODE: &str = "\
Examples:
  depth-calculator decode 12345 --as kitti --fx 718.856 --baseline 0.54m
  depth-calculator decode -800 --divide -16 --fx 700 --baseline 100mm
  depth-calculator decode 1400 --as depth-mm --json
  depth-calculator decode 100,20,1 --as carla";

/// Of `presets`.
pub(super) const PRESETS: &str = "\
Examples:
  depth-calculator presets realsense-d435i --width 640 --json
  depth-calculator calculate --preset realsense-d435i --width 640 --disparity 20";

/// Of `sizes`.
pub(super) const SIZES: &str = "\
Example:
  depth-calculator calculate --fx 700 --w-img 310 --known card";

/// Of `q`.
pub(super) const Q: &str = "\
The matrix is read from a calibration file of OpenCV (YAML, XML, JSON),
from what numpy or MATLAB print, or from sixteen numbers.

Example:
  echo '1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 0.01 0.4' |
      depth-calculator q - --file-unit 1mm
      fx 700 px, baseline 100 mm, doffs 40 px";
