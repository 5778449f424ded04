//! A cell file's tables from its text. Whoever reads them stops at the first thing that does not fit, so such a thing is told,
//! put right or taken out of the text, and reading goes on behind it: no mistake hides the others.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::format::CellFile;
use super::layers::{Slip, cell_file, laid, mistakes};
use crate::cell::CellError;
use crate::cell::error::{Problems, Source, meant};

/// A cell file as far as it can be read.
pub(crate) struct Read {
    /// Its tables; nothing if what is wrong with them leaves a gap.
    pub file: Option<CellFile>,
    /// What is no TOML, of another type, or unknown.
    pub problems: Option<Box<CellError>>,
    /// Where the tables hold something that nobody wrote, so that reading could go on: what is said of it does not count.
    guessed: Vec<Range<usize>>,
}

impl Read {
    /// `result` without problems of what nobody wrote.
    ///
    /// # Errors
    /// The other problems.
    pub(crate) fn counting<T>(&self, result: Result<T, Box<CellError>>) -> Result<Option<T>, Box<CellError>> {
        match result {
            Ok(value) => Ok(Some(value)),
            Err(problem) => problem.apart_from(&self.guessed).map_or(Ok(None), Err),
        }
    }
}

/// Most mistakes that are told at once.
const MOST: usize = 100;

/// Reads a cell file's tables.
#[must_use]
pub(crate) fn read(source: &Source) -> Read {
    let problems = Problems::default();
    mistakes(source).into_iter().for_each(|mistake| problems.tell(Box::new(mistake)));
    let mut text = source.whole();
    let (mut gaps, mut guessed) = (false, Vec::new());
    let mut left = MOST;
    let file = loop {
        let error = match cell_file(source, &text) {
            Ok(file) => break Some(file),
            Err(error) => error,
        };
        let place = error.span.clone().unwrap_or(0..0);
        problems.tell(source.parse_error(&error.message, place.clone()));
        left -= 1;
        match mended(source, &text, &error) {
            _ if left == 0 => break None,
            Some(Mended::AsMeant(rest)) => text = rest,
            Some(Mended::WithNumbers(rest)) => {
                text = rest;
                guessed.push(place);
            }
            Some(Mended::Otherwise(rest)) => (text, gaps) = (rest, true),
            None => break None,
        }
    };
    // Names that nobody wrote are not found, and so on.
    Read { file: file.filter(|_| !gaps), problems: problems.take_or(()).err(), guessed }
}

/// A text without the mistake that was complained about; all other places stay where they are.
enum Mended {
    /// What the user means.
    AsMeant(String),
    /// With some number, or some numbers, in its place.
    WithNumbers(String),
    /// Something that can be read, whatever it says.
    Otherwise(String),
}

fn mended(source: &Source, text: &str, error: &Slip) -> Option<Mended> {
    let span = error.span.clone().filter(|span| !span.is_empty())?;
    let message = error.message.as_str();
    let place = |of: &dyn Fn(&DeTable<'_>) -> Option<Range<usize>>| {
        laid(source, text, |tables, _| of(tables.get_ref())).ok().flatten()
    };
    if message.starts_with("unknown field") {
        let slip = with(text, &span, meant(message)).filter(|text| laid(source, text, |_, _| ()).is_ok());
        return slip
            .map(Mended::AsMeant)
            .or_else(|| without(text, place(&|table| value_of_key(table, span.start))?).map(Mended::Otherwise));
    }
    // Missing things cannot be put in, and what is no TOML has no values.
    let value = ["invalid type", "invalid value", "invalid length", "unknown variant"];
    if !value.iter().any(|kind| message.starts_with(kind)) {
        return None;
    }
    let key = place(&|table| key_of(table, &span));
    let lacking = key.clone().and_then(|key| text.get(key)?.split('=').next());
    let lacking = lacking.map(|name| format!("missing field `{}`", name.trim().trim_matches('"')));
    let from = begins(text, &span);
    // Without a value that has to be there nothing is won.
    let goes_on = |text: &String| {
        let next = cell_file(source, text).err();
        next.is_none_or(|next| {
            next.span.is_none_or(|next| next.end <= from || next.start >= span.end)
                && !lacking.as_ref().is_some_and(|lacking| next.message.starts_with(lacking))
        })
    };
    let written = text.get(span.clone())?;
    let likely = match message.starts_with("unknown variant") {
        true => meant(message).map(|meant| format!("\"{meant}\"")),
        false => as_number(written).or_else(|| as_text(written)),
    };
    if let Some(text) = with(text, &span, likely.as_deref()).filter(goes_on) {
        return Some(Mended::AsMeant(text));
    }
    let first_variant = message.split('`').nth(3).map(|variant| format!("\"{variant}\""));
    let fill = |filler| with(text, &span, Some(filler)).filter(goes_on);
    if let Some(text) = ["1", "[1,1]", "[1,1,1]", "[]"].into_iter().find_map(fill) {
        return Some(Mended::WithNumbers(text));
    }
    let filled = ["true", "\"\""].into_iter().chain(first_variant.as_deref()).find_map(fill);
    let out = key.and_then(|key| without(text, key));
    filled.or_else(|| out.filter(goes_on)).map(Mended::Otherwise)
}

/// The number, or truth value, that is written as a text, maybe with its unit.
fn as_number(written: &str) -> Option<String> {
    let inner = written.strip_prefix('"')?.strip_suffix('"')?.trim();
    let number = inner.split(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c))).next()?;
    let is_one =
        |text: &str| text.parse::<f64>().is_ok() && toml::from_str::<toml::Table>(&format!("x = {text}")).is_ok();
    match inner {
        "true" | "false" => Some(inner.to_owned()),
        _ => Some(number.to_owned()).filter(|number| is_one(number)),
    }
}

/// The text that is written without quotes.
fn as_text(written: &str) -> Option<String> {
    let bare = !written.is_empty() && !written.contains(['"', '\'', '[', '{', '\n']);
    bare.then(|| format!("\"{written}\""))
}

/// `text` with `new` at `span`, if there is room for it with the blanks around.
fn with(text: &str, span: &Range<usize>, new: Option<&str>) -> Option<String> {
    let (new, after) = (new?, text.get(span.end..)?);
    let end = span.end + after.len() - after.trim_start_matches(' ').len();
    let put =
        |from: usize, new: &str| Some(format!("{}{new:<width$}{}", &text[..from], &text[end..], width = end - from));
    if new.len() <= end - span.start {
        return put(span.start, new);
    }
    // The `=` of a value may move too.
    let from = begins(text, span);
    (from < span.start && new.len() < end - from).then(|| put(from, &format!("={new}"))).flatten()
}

/// Where the key ends whose value is at `span`, or where that begins.
fn begins(text: &str, span: &Range<usize>) -> usize {
    let before = text.get(..span.start).unwrap_or_default();
    let key = before.trim_end_matches(' ').strip_suffix('=');
    key.map_or(span.start, |key| key.trim_end_matches(' ').len())
}

/// `text` without the key and the value at `from` and `to`.
fn without(text: &str, Range { start, end }: Range<usize>) -> Option<String> {
    let before = text.get(..start)?;
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    let (mut from, mut to) = (start, end);
    if !before[line..].trim().is_empty() {
        // In an inline table, where commas stand between.
        let rest = &text[end..];
        match (rest.trim_start().starts_with(','), before.trim_end().ends_with(',')) {
            (true, _) => to += rest.find(',')? + 1,
            (false, true) => from = before.rfind(',')?,
            (false, false) => {}
        }
    }
    let blank = text[from..to].chars().map(|c| if c == '\n' { "\n".to_owned() } else { " ".repeat(c.len_utf8()) });
    Some(format!("{}{}{}", &text[..from], blank.collect::<String>(), &text[to..]))
}

/// Where the key at `key` begins and its value ends.
fn value_of_key(table: &DeTable<'_>, key: usize) -> Option<Range<usize>> {
    found(table, &|name, _| name.start == key)
}

/// Where the key begins whose value is at `value`, and where that ends.
fn key_of(table: &DeTable<'_>, value: &Range<usize>) -> Option<Range<usize>> {
    found(table, &|_, of| of == value)
}

/// The first key that `is` the one, with its value.
fn found(table: &DeTable<'_>, is: &dyn Fn(&Range<usize>, &Range<usize>) -> bool) -> Option<Range<usize>> {
    table.iter().find_map(|(name, value)| {
        let (name, of) = (name.span(), value.span());
        if is(&name, &of) {
            return (of.end >= name.end).then_some(name.start..of.end);
        }
        in_value(value.get_ref(), is)
    })
}

fn in_value(value: &DeValue<'_>, is: &dyn Fn(&Range<usize>, &Range<usize>) -> bool) -> Option<Range<usize>> {
    match value {
        DeValue::Table(table) => found(table, is),
        DeValue::Array(list) => list.iter().find_map(|item| in_value(item.get_ref(), is)),
        _ => None,
    }
}
