//! Paragraphs of a terminal.

/// Width of a line where no terminal says another one.
pub const WIDTH: usize = 100;

/// A paragraph, each line behind an indent.
pub fn wrapped(text: &str, indent: &str) -> String {
    let options = options(WIDTH).initial_indent(indent).subsequent_indent(indent);
    textwrap::fill(text, options) + "\n"
}

/// Names of options and files stay whole: no line ends at a hyphen within them.
fn options<'a>(width: usize) -> textwrap::Options<'a> {
    textwrap::Options::new(width)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .word_splitter(textwrap::WordSplitter::NoHyphenation)
}

/// Text after a head, further lines below its own beginning.
pub fn wrapped_under(head: &str, text: &str) -> String {
    wrapped_to(WIDTH, head, text)
}

/// The same in lines of so many columns.
pub fn wrapped_to(width: usize, head: &str, text: &str) -> String {
    let under = " ".repeat(head.len());
    let options = options(width.max(head.len() + 20)).initial_indent(head).subsequent_indent(&under);
    textwrap::fill(text, options) + "\n"
}
