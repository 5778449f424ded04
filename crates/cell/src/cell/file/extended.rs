//! The files that a cell file extends: found and read, the next first.

use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::DeTable;

use crate::cell::CellError;
use crate::cell::error::{Base, Source};
use path_clean::clean;

/// Most files that one cell file extends, by way of each other.
const MOST: usize = 8;

/// The cell file with the texts of all files that it extends.
///
/// # Errors
/// When one of them cannot be read, when they go round in a circle, or are too many.
pub(crate) fn extended(mut source: Source) -> Result<Source, Box<CellError>> {
    let own = Path::new(source.name()).canonicalize().ok();
    let mut seen: Vec<PathBuf> = own.into_iter().collect();
    while let Some(named) = last_extends(&source) {
        let problem = |message: String, help: &str| source.error(named.span(), "here", message, Some(help.to_owned()));
        if source.bases().len() == MOST {
            let message = format!("more than {MOST} cell files extend each other here");
            return Err(problem(message, "put some of them together"));
        }
        let beside = source.bases().last().and_then(|base| base.path.parent()).unwrap_or(Path::new(""));
        let path = clean(beside.join(named.get_ref()));
        let file = source.folder().join(&path);
        let shown = file.display().to_string();
        let text = std::fs::read_to_string(&file).map_err(|error| {
            problem(format!("cannot read {shown}: {error}"), "the path is relative to the file that says `extends`")
        })?;
        let place = file.canonicalize().unwrap_or(file);
        if seen.contains(&place) {
            return Err(problem(
                format!("{shown} is extended by itself"),
                "cell files extend each other in a line, not in a circle: remove one `extends`",
            ));
        }
        seen.push(place);
        source = source.on(Base { name: shown, text, path });
    }
    Ok(source)
}

/// The same for a cell file inside an FMU, where nothing is beside it.
///
/// # Errors
/// When it extends another file.
pub(crate) fn alone(source: Source) -> Result<Source, Box<CellError>> {
    match last_extends(&source) {
        None => Ok(source),
        Some(named) => Err(source.error(
            named.span(),
            "here",
            "a cell file inside an FMU cannot extend another",
            Some("put the whole cell in: `fmi-hazard pack VARIANT.toml` does that".to_owned()),
        )),
    }
}

/// What the last of the files extends, with its place; nothing if it is no TOML, which is told when it is read.
fn last_extends(source: &Source) -> Option<Spanned<String>> {
    let (start, text) = source.parts().last()?;
    let table = DeTable::parse(text).ok()?;
    let value = table.get_ref().get("extends")?;
    let (span, named) = (value.span(), value.get_ref().as_str()?);
    Some(Spanned::new(start + span.start..start + span.end, named.to_owned()))
}
