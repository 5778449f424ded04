//! `fmi-hazard pack`: a copy of an FMU, or of a system, that carries its cell file and geometry, so that it can be scanned
//! alone. Every other entry of the archive stays as it is, to the byte.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufReader, BufWriter, Write as _};
use std::path::{Component, Path, PathBuf};

use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

use super::exit::{Failure, NO_HAZARD};
use super::output;
use crate::cell::EXTRA_FOLDER;
use crate::cell::file::layers::as_one;
use crate::cell::find::open;
use crate::cell::foreign::ssp::is_ssp;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The cell file; it names one FMU or system
    cell: PathBuf,
    /// The copy (default: <FMU>-packed.fmu beside the FMU)
    #[arg(long, short)]
    out: Option<PathBuf>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let opened = open(&arguments.cell, None)?;
    let folder = opened.source.folder().to_owned();
    let named = match opened.cell.fmus.as_slice() {
        [only] if only.name.is_empty() => folder.join(only.path.get_ref()),
        _ => {
            return Err(Failure::unusable_with_help(
                "this cell couples several FMUs, which have no archive in common",
                "make them a system (.ssp) and name that with `fmu`",
            ));
        }
    };
    let bare = is_ssp(&named) && named.extension().is_some_and(|e| e.eq_ignore_ascii_case("ssd"));
    if bare {
        return Err(Failure::unusable_with_help(
            format!("{} is no archive", named.display()),
            "put it and its FMUs into an .ssp archive",
        ));
    }
    let out = arguments.out.clone().unwrap_or_else(|| {
        let (stem, ending) = (named.file_stem().unwrap_or_default(), named.extension().unwrap_or_default());
        named.with_file_name(format!("{}-packed.{}", stem.to_string_lossy(), ending.to_string_lossy()))
    });
    if out.exists() && !arguments.force {
        let help = "another name with --out, or --force to replace it";
        return Err(Failure::unusable_with_help(format!("{} is there already", out.display()), help));
    }
    let mut added: Vec<(String, Vec<u8>)> =
        vec![(format!("{EXTRA_FOLDER}/cell.toml"), as_one(&opened.source).into_bytes())];
    // What the cell file extends is in that text.
    let is_base = |path: &Path| opened.source.bases().iter().any(|base| base.path == path);
    for file in opened.cell.files.iter().filter(|file| !is_base(&file.path)) {
        let stays = file.path.components().all(|part| matches!(part, Component::Normal(_)));
        if !stays {
            return Err(Failure::unusable_with_help(
                format!("{} is outside the folder of the cell file", file.path.display()),
                "put it beside the cell file or below, and name it from there",
            ));
        }
        let bytes = std::fs::read(folder.join(&file.path))
            .map_err(|e| Failure::unusable(format!("cannot read {}: {e}", file.path.display())))?;
        let parts: Vec<_> = file.path.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        added.push((format!("{EXTRA_FOLDER}/{}", parts.join("/")), bytes));
    }
    write(&named, &out, &added).map_err(|e| Failure::unusable(format!("cannot write {}: {e}", out.display())))?;
    output::result(&format!("{}\n", out.display()));
    output::note(&format!(
        "   Packed {} files into a copy of {}. Next: fmi-hazard scan {}",
        added.len(),
        named.display(),
        out.display()
    ));
    Ok(NO_HAZARD)
}

/// Copies the archive and adds files; what it had under their names is replaced.
fn write(from: &Path, to: &Path, added: &[(String, Vec<u8>)]) -> Result<(), Box<dyn std::error::Error>> {
    let mut archive = ZipArchive::new(BufReader::new(File::open(from)?))?;
    // Whole or not at all, and never onto what is being read.
    let folder = to.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let temporary = tempfile::NamedTempFile::new_in(folder)?;
    let mut copy = ZipWriter::new(BufWriter::new(temporary));
    let names: BTreeSet<&str> = added.iter().map(|(name, _)| name.as_str()).collect();
    for index in 0..archive.len() {
        let entry = archive.by_index_raw(index)?;
        if !names.contains(entry.name()?.as_ref()) {
            copy.raw_copy_file(entry)?;
        }
    }
    for (name, bytes) in added {
        copy.start_file(name.as_str(), SimpleFileOptions::default())?;
        copy.write_all(bytes)?;
    }
    let written = copy.finish()?.into_inner().map_err(std::io::IntoInnerError::into_error)?;
    // As files that are made otherwise: readable by who may read what it is a copy of.
    written.as_file().set_permissions(std::fs::metadata(from)?.permissions())?;
    written.persist(to)?;
    Ok(())
}
