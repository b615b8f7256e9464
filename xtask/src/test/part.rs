//! The parts of the tests.

use crate::browsers::Engine;

/// What can be tested by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Rust,
    Desktop,
    Size,
    Browser(Engine),
}

impl Part {
    pub(super) const ALL: [Self; 6] = [
        Self::Rust,
        Self::Desktop,
        Self::Size,
        Self::Browser(Engine::Chromium),
        Self::Browser(Engine::Firefox),
        Self::Browser(Engine::WebKit),
    ];

    /// The part that a word of the command line names.
    pub(super) fn named(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|part| part.name() == word)
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::Desktop => "desktop",
            Self::Size => "size",
            Self::Browser(engine) => engine.name(),
        }
    }

    pub(super) const fn description(self) -> &'static str {
        match self {
            Self::Rust => "tests and examples in Rust: the mathematics, the texts, the screens, the command line, these commands",
            Self::Desktop => "the desktop program as assistive technology meets it (Linux)",
            Self::Size => "what a first visit to the page downloads",
            Self::Browser(Engine::Chromium) => "the page in Chromium or Google Chrome",
            Self::Browser(Engine::Firefox) => "the page in Firefox",
            Self::Browser(Engine::WebKit) => "the page in WebKit (Linux)",
        }
    }

    /// Whether the page has to be built for it.
    pub(super) const fn needs_page(self) -> bool {
        matches!(self, Self::Size | Self::Browser(_))
    }
}
