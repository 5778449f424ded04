//! XML files that a cell file names: errors that point into them.

use roxmltree::{Document, Node, ParsingOptions};

use crate::cell::CellError;
use crate::cell::error::Source;

/// What a check of an XML file gives.
pub(super) type Result<T> = std::result::Result<T, Box<CellError>>;

/// An XML file.
#[derive(Clone, Copy)]
pub(super) struct Xml<'a> {
    pub source: &'a Source,
}

impl<'a> Xml<'a> {
    /// The document; `help` is what to do when it is none.
    pub(super) fn parse(self, help: &str) -> Result<Document<'a>> {
        // Entities could blow up; none of the formats needs them.
        let options = ParsingOptions { allow_dtd: false, ..ParsingOptions::default() };
        Document::parse_with_options(self.source.text(), options).map_err(|error| {
            let place = offset(self.source.text(), error.pos());
            self.source.error(place..place + 1, "here", format!("it is no XML: {error}"), Some(help.to_owned()))
        })
    }

    /// An error at an element.
    pub(super) fn wrong(
        self,
        node: Node<'_, '_>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Box<CellError> {
        // The start tag alone: an element may be long.
        let range = node.range();
        let tag = self.source.text()[range.clone()].find('>').map_or(range.end, |end| range.start + end + 1);
        self.source.error(range.start..tag, "here", message, Some(help.into()))
    }

    /// An attribute that has to be there.
    pub(super) fn text<'n>(self, node: Node<'n, '_>, attribute: &str) -> Result<&'n str> {
        let tag = node.tag_name().name().to_owned();
        node.attribute(attribute).ok_or_else(|| {
            self.wrong(node, format!("<{tag}> has no `{attribute}`"), format!("add {attribute}=\"...\""))
        })
    }

    /// An attribute of `N` numbers, `or` if it is not there.
    pub(super) fn numbers<const N: usize>(self, node: Node<'_, '_>, attribute: &str, or: [f64; N]) -> Result<[f64; N]> {
        let Some(text) = node.attribute(attribute) else { return Ok(or) };
        let all: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let wanted = <[f64; N]>::try_from(all).ok().filter(|all| all.iter().all(|v| v.is_finite()));
        wanted.filter(|_| text.split_whitespace().count() == N).ok_or_else(|| {
            let message = format!("`{attribute}` is \"{text}\"");
            self.wrong(node, message, format!("it takes {N} number{}", if N == 1 { "" } else { "s" }))
        })
    }
}

fn offset(text: &str, position: roxmltree::TextPos) -> usize {
    let row = usize::try_from(position.row).unwrap_or(1).max(1);
    let line: usize = text.split_inclusive('\n').take(row - 1).map(str::len).sum();
    line.min(text.len().saturating_sub(1))
}

/// The child elements of this name, in whatever namespace.
pub(super) fn children<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |child| child.has_tag_name(name))
}

/// The first of them.
pub(super) fn child<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> Option<Node<'a, 'i>> {
    children(node, name).next()
}
