// What `cargo xtask test` decides for these tests: its options are documented by `cargo xtask test --help`.

const TEXT = process.env.BROWSER_TESTS;
if (!TEXT) throw new Error('Run these tests with `cargo xtask test chromium`, or firefox, or webkit: it finds the browsers and the page.');

/**
 * `engine`: chromium, firefox or webkit; `browser` and `driver`: the programs; `dist`: the folder of the page; `screenshots`: where
 * pictures go; `seed` and `batches`: of the random walk; `names`: of the tests to run, none for all; `isHeard`: a screen reader
 * listens, on a desktop of its own. With `lists`, tests are only listed, and nothing else is there.
 */
export const settings = JSON.parse(TEXT);
