//! A cell file laid over those that it extends: their tables as one, each value with the place where it stands.
//!
//! Tables are laid over each other key by key, entries of lists by their names; what else there is takes the place of what
//! was there. Of keys that exclude each other those of the file on top count (`INSTEAD`).

use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

use super::format::CellFile;
use crate::cell::CellError;
use crate::cell::error::{Source, nearest};
use path_clean::clean;

/// What the `toml` crate complains about, or why files cannot be laid over each other.
pub(super) struct Slip {
    pub message: String,
    /// Counted through all files.
    pub span: Option<Range<usize>>,
}

impl From<toml::de::Error> for Slip {
    fn from(error: toml::de::Error) -> Self {
        Self { message: error.message().to_owned(), span: error.span() }
    }
}

/// Lists whose entries are laid over each other by name.
const NAMED: [&str; 8] = ["unit", "robot", "obstacle", "sensor", "control", "human", "robot.joint", "robot.frame"];

/// The list in which several entries may share a name: all of a name take the place of all of that name.
const SHARED: &str = "robot.link";

/// Tables whose values are not laid over each other.
const WHOLE: [&str; 4] = ["explain.parameters", "explain.sensor", "explain.obstacle", "explain.robot"];

/// Keys that exclude others of their table: the table, the key, and what it takes the place of.
const INSTEAD: &[(&str, &str, &[&str])] = &[
    ("", "fmu", &["unit", "connection"]),
    ("", "unit", &["fmu"]),
    ("robot", "joint", &["frame"]),
    ("robot", "frame", &["joint"]),
    ("robot", "payload", &["payload_kg"]),
    ("robot", "payload_kg", &["payload"]),
    ("robot.joint", "angle", &["position", "held_deg", "held_m", "speed"]),
    ("robot.joint", "position", &["angle", "held_deg", "held_m", "speed"]),
    ("robot.joint", "held_deg", &["angle", "position", "held_m", "speed"]),
    ("robot.joint", "held_m", &["angle", "position", "held_deg", "speed"]),
    ("robot.frame", "quaternion", &["rotation_matrix"]),
    ("robot.frame", "rotation_matrix", &["quaternion"]),
    ("obstacle", "mesh", &["centre_m", "size_m", "rpy_deg"]),
    ("obstacle", "centre_m", &["mesh", "resolution_m"]),
    ("obstacle", "size_m", &["mesh", "resolution_m"]),
];

/// Where files are named: seen from the file that names them.
const PATHS: [&[&str]; 6] = [
    &["fmu"],
    &["unit", "fmu"],
    &["robot", "urdf"],
    &["robot", "link", "mesh", "file"],
    &["obstacle", "mesh", "file"],
    &["fail_on", "baseline"],
];

/// The tables of the files of `source`, whose texts are now `whole`, as one, given to `use_them`; also what is wrong with how
/// they are laid over each other.
///
/// # Errors
/// When one of the texts is no TOML.
pub(super) fn laid<T>(
    source: &Source,
    whole: &str,
    use_them: impl FnOnce(Spanned<DeTable<'_>>, Vec<(Slip, String)>) -> T,
) -> Result<T, Slip> {
    // Each behind as many blanks as there is text before it: so its places are counted through all.
    let part = |(start, text): (usize, &str)| {
        let own = whole.get(start..start + text.len()).unwrap_or(text);
        format!("{:start$}{own}", "")
    };
    let texts: Vec<String> = source.parts().map(part).collect();
    let mut tables = Vec::new();
    for text in &texts {
        tables.push(DeTable::parse(text)?);
    }
    for (table, base) in tables[1..].iter_mut().zip(source.bases()) {
        let folder = base.path.parent().unwrap_or(Path::new(""));
        PATHS.iter().for_each(|path| move_files(table.get_mut(), path, folder));
        move_packages(table.get_mut(), folder);
    }
    let mut laying = Laying { slips: Vec::new() };
    let mut tables = tables.into_iter().rev();
    let Some(mut all) = tables.next() else { return Err(Slip { message: "it is empty".to_owned(), span: None }) };
    let mut left = source.bases().len();
    for mut table in tables {
        left -= 1;
        let under = &source.bases()[left].name;
        let extends = table.get_mut().remove("extends").map(|value| value.span());
        if left == 0 {
            laying.own_name(table.get_ref(), all.get_ref(), extends);
        }
        let span = table.span();
        laying.over(all.get_mut(), table.into_inner(), "", under);
        all = Spanned::new(span, all.into_inner());
    }
    Ok(use_them(all, laying.slips))
}

/// The cell file that these tables are.
///
/// # Errors
/// What is no TOML, or does not fit.
pub(super) fn cell_file(source: &Source, whole: &str) -> Result<CellFile, Slip> {
    laid(source, whole, |tables, _| CellFile::deserialize(toml::Deserializer::from(tables)))?.map_err(Slip::from)
}

/// The cell file and those that it extends as one text, which extends nothing; its own text if it does not either, or if
/// they cannot be read.
#[must_use]
pub fn as_one(source: &Source) -> String {
    let own = || source.text().to_owned();
    if source.bases().is_empty() {
        return own();
    }
    let table = laid(source, &source.whole(), |tables, _| toml::Table::deserialize(toml::Deserializer::from(tables)));
    table.ok().and_then(Result::ok).and_then(|table| toml::to_string(&table).ok()).unwrap_or_else(own)
}

/// What is wrong with how the files of `source` are laid over each other.
pub(super) fn mistakes(source: &Source) -> Vec<CellError> {
    if source.bases().is_empty() {
        return Vec::new();
    }
    let slips = laid(source, &source.whole(), |_, slips| slips).unwrap_or_default();
    let error =
        |(slip, help): (Slip, String)| *source.error(slip.span.unwrap_or(0..0), "here", slip.message, Some(help));
    slips.into_iter().map(error).collect()
}

struct Laying {
    slips: Vec<(Slip, String)>,
}

impl Laying {
    fn tell(&mut self, span: Option<Range<usize>>, message: String, help: String) {
        self.slips.push((Slip { message, span }, help));
    }

    /// Whether the variant has a name of its own.
    fn own_name(&mut self, variant: &DeTable<'_>, base: &DeTable<'_>, extends: Option<Range<usize>>) {
        let of = |table: &DeTable<'_>| table.get("name").and_then(|name| name.get_ref().as_str().map(str::to_owned));
        let help = "add name = \"...\": results are kept by it";
        match of(variant) {
            None if !variant.contains_key("name") => {
                self.tell(extends, "the variant has no name of its own".to_owned(), help.to_owned());
            }
            Some(name) if Some(&name) == of(base).as_ref() => {
                let message = format!("the variant is called `{name}`, as what it extends");
                let span = variant.get("name").map(Spanned::span);
                self.tell(span, message, "give it a name of its own: results are kept by it".to_owned());
            }
            _ => {}
        }
    }

    /// Lays `variant` over `base`, the table at `path`.
    fn over<'i>(&mut self, base: &mut DeTable<'i>, mut variant: DeTable<'i>, path: &str, under: &str) {
        if (path.is_empty() || path == "robot")
            && variant.get("remove").is_some_and(is_removal)
            && let Some(removal) = variant.remove("remove")
        {
            self.remove(base, &removal, path, under);
        }
        for (_, given, others) in INSTEAD.iter().filter(|(table, ..)| *table == path) {
            if variant.contains_key(*given) && !base.contains_key(*given) {
                others.iter().for_each(|other| drop(base.remove(*other)));
            }
        }
        let text =
            |table: &DeTable<'_>, key: &str| table.get(key).and_then(|v| v.get_ref().as_str().map(str::to_owned));
        if path == "sensor" && variant.contains_key("kind") && text(&variant, "kind") != text(base, "kind") {
            ["zone", "delay_ms"].iter().for_each(|key| drop(base.remove(*key)));
        }
        for (key, value) in variant {
            let inner = if path.is_empty() { key.get_ref().to_string() } else { format!("{path}.{}", key.get_ref()) };
            let before = base.remove(key.get_ref().as_ref());
            let value = match before {
                Some(before) if !WHOLE.contains(&path) => self.one_over(before, value, &inner, under),
                _ => value,
            };
            base.insert(key, value);
        }
    }

    fn one_over<'i>(
        &mut self,
        base: Spanned<DeValue<'i>>,
        variant: Spanned<DeValue<'i>>,
        path: &str,
        under: &str,
    ) -> Spanned<DeValue<'i>> {
        let span = variant.span();
        match (base.into_inner(), variant.into_inner()) {
            // What says how a file is read goes with the file.
            (_, DeValue::Table(variant)) if path.ends_with(".mesh") && variant.contains_key("file") => {
                Spanned::new(span, DeValue::Table(variant))
            }
            (DeValue::Table(mut base), DeValue::Table(variant)) => {
                self.over(&mut base, variant, path, under);
                Spanned::new(span, DeValue::Table(base))
            }
            (DeValue::Array(base), DeValue::Table(_)) if path == "human" => {
                let message = format!("{under} has `[[human]]`, a list, and this has `[human]`");
                let help = "write [[human]] with the name that the person has there; remove = { human = [\"name\"] } leaves one out";
                self.tell(Some(span.clone()), message, help.to_owned());
                Spanned::new(span, DeValue::Array(base))
            }
            (DeValue::Table(base), DeValue::Array(_)) if path == "human" => {
                let message = format!("{under} has `[human]`, one person, and this has `[[human]]`, a list");
                let help = "write both people here, and remove = { human = [...] } with the keys that are there";
                self.tell(Some(span.clone()), message, help.to_owned());
                Spanned::new(span, DeValue::Table(base))
            }
            (DeValue::Array(base), DeValue::Array(variant)) if NAMED.contains(&path) => {
                Spanned::new(span, DeValue::Array(self.by_name(base, variant, path, under)))
            }
            (DeValue::Array(base), DeValue::Array(variant)) if path == SHARED => {
                let named: Vec<String> = variant.iter().filter_map(name).collect();
                let stays = |entry: &Spanned<DeValue<'_>>| name(entry).is_none_or(|name| !named.contains(&name));
                Spanned::new(span, DeValue::Array(base.into_iter().filter(stays).chain(variant).collect()))
            }
            (_, variant) => Spanned::new(span, variant),
        }
    }

    /// Entries of `variant` over those of `base` of the same name, new ones behind.
    fn by_name<'i>(&mut self, base: DeArray<'i>, variant: DeArray<'i>, path: &str, under: &str) -> DeArray<'i> {
        let mut all: Vec<Spanned<DeValue<'i>>> = base.into_iter().collect();
        let mut done: Vec<String> = Vec::new();
        for entry in variant {
            let named = name(&entry).filter(|name| !done.contains(name));
            let known = |other: &Spanned<DeValue<'_>>| named.is_some() && name(other) == named;
            let places: Vec<usize> = (0..all.len()).filter(|place| known(&all[*place])).collect();
            match places.as_slice() {
                [place] => {
                    let before = all.remove(*place);
                    let laid = self.one_over(before, entry, path, under);
                    all.insert(*place, laid);
                }
                [] => all.push(entry),
                several => {
                    let (what, name) = (last(path), named.clone().unwrap_or_default());
                    let message = format!("{under} has {} times the {what} `{name}`", several.len());
                    self.tell(Some(entry.span()), message, "give each its own name there".to_owned());
                }
            }
            done.extend(named);
        }
        all.into_iter().collect()
    }

    /// Takes out of `base` what a removal names.
    fn remove(&mut self, base: &mut DeTable<'_>, removal: &Spanned<DeValue<'_>>, path: &str, under: &str) {
        for (section, names) in removal.get_ref().as_table().into_iter().flatten() {
            let list = section.get_ref().as_ref();
            for wanted in names.get_ref().as_array().into_iter().flatten() {
                let Some(name_of) = wanted.get_ref().as_str() else { continue };
                let inner = if path.is_empty() { list.to_owned() } else { format!("{path}.{list}") };
                let known = match base.get_mut(list).map(Spanned::get_mut) {
                    Some(DeValue::Table(table)) => {
                        if table.remove(name_of).is_some() {
                            continue;
                        }
                        table.keys().map(|key| key.get_ref().to_string()).collect()
                    }
                    Some(DeValue::Array(entries)) if NAMED.contains(&inner.as_str()) || inner == SHARED => {
                        let before = entries.len();
                        let stays = |entry: &Spanned<DeValue<'_>>| name(entry).as_deref() != Some(name_of);
                        let all = std::mem::replace(entries, DeArray::new());
                        *entries = all.into_iter().filter(stays).collect();
                        if entries.len() < before {
                            continue;
                        }
                        entries.iter().filter_map(name).collect()
                    }
                    _ => Vec::new(),
                };
                let message = format!("{under} has no {list} `{name_of}` that could be removed");
                let help = match nearest(name_of, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if known.is_empty() => {
                        "remove = { obstacle = [\"name\"], parameters = [\"name\"] }: entries of lists by their names, keys \
                         of tables"
                            .to_owned()
                    }
                    None => format!("it has {}", known.join(", ")),
                };
                self.tell(Some(wanted.span()), message, help);
            }
        }
    }
}

/// Whether a removal has the form of one; what has not is told when the tables are read.
fn is_removal(value: &Spanned<DeValue<'_>>) -> bool {
    let names = |value: &Spanned<DeValue<'_>>| {
        value.get_ref().as_array().is_some_and(|names| names.iter().all(|name| name.get_ref().is_str()))
    };
    value.get_ref().as_table().is_some_and(|table| table.values().all(names))
}

/// The name of a list's entry.
fn name(entry: &Spanned<DeValue<'_>>) -> Option<String> {
    entry.get_ref().as_table()?.get("name")?.get_ref().as_str().map(str::to_owned)
}

fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// Names of files at `path` as they are seen from the cell file.
fn move_files(table: &mut DeTable<'_>, path: &[&str], folder: &Path) {
    let [key, rest @ ..] = path else { return };
    let Some(value) = table.get_mut(*key) else { return };
    match value.get_mut() {
        DeValue::String(named) if rest.is_empty() => moved(named, folder),
        DeValue::Table(inner) => move_files(inner, rest, folder),
        DeValue::Array(entries) => {
            for entry in entries.iter_mut() {
                if let DeValue::Table(inner) = entry.get_mut() {
                    move_files(inner, rest, folder);
                }
            }
        }
        _ => {}
    }
}

/// The same for the folders of packages.
fn move_packages(table: &mut DeTable<'_>, folder: &Path) {
    let Some(DeValue::Array(robots)) = table.get_mut("robot").map(Spanned::get_mut) else { return };
    for robot in robots.iter_mut() {
        let DeValue::Table(robot) = robot.get_mut() else { continue };
        let Some(DeValue::Table(packages)) = robot.get_mut("packages").map(Spanned::get_mut) else { continue };
        for (_, value) in packages.iter_mut() {
            if let DeValue::String(named) = value.get_mut() {
                moved(named, folder);
            }
        }
    }
}

fn moved(named: &mut DeString<'_>, folder: &Path) {
    *named = Cow::Owned(clean(folder.join(named.as_ref())).display().to_string());
}
