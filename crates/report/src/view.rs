//! How a result is shown at a terminal.

use fmi_hazard_record::paragraph::WIDTH;

/// How the result is shown.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Columns of the terminal.
    pub width: usize,
    /// Also every hazard, and what the search covered.
    pub verbose: bool,
    /// Whether colours are wanted.
    pub colour: bool,
}

impl Default for View {
    /// As where nobody looks: wide, short, plain.
    fn default() -> Self {
        Self { width: WIDTH, verbose: false, colour: false }
    }
}

impl View {
    /// What begins and ends text of a kind.
    pub(super) const fn ink(self, kind: &'static str) -> (&'static str, &'static str) {
        if self.colour { (kind, "\u{1b}[0m") } else { ("", "") }
    }
}
