//! Builds the example FMUs into the build folder.
//!
//! The library of the example FMUs is compiled once, by the compiler of this build and with no dependencies, and
//! packed under each model's name. Equal sources and an equal compiler give equal bytes, wherever the checkout lies. The
//! FMU that does harm on purpose is written in C and packed alike.
#![allow(clippy::print_stdout, reason = "this is how a build script talks to cargo")]

use std::error::Error;
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use zip::write::SimpleFileOptions;

// The tables of variables, the same source the library is made of.
#[path = "models/interface/mod.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod interface;
use interface::variables::Interface;

/// Folder for project files within an FMU (FMI 2.0.4, section 2.3: reverse domain notation).
const EXTRA: &str = "extra/io.github.fmi-hazard";

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=models");
    println!("cargo:rerun-if-changed=hostile");
    println!("cargo:rerun-if-changed=scenarios");

    let binary = compressed(&fs::read(compile_library(&root, &out)?)?)?;
    let fmus = out.join("fmus");
    fs::create_dir_all(&fmus)?;
    let scenarios = root.join("scenarios");
    for model in interface::all() {
        write_both(&fmus, &model, &binary, &cell_files(&scenarios.join(&model.name))?)?;
    }
    if env::var_os("CARGO_CFG_UNIX").is_some() {
        let hostile = compressed(&fs::read(compile_hostile(&root, &out)?)?)?;
        write_both(&fmus, &interface::hostile::interface(), &hostile, &[])?;
    }
    let types = Contents {
        identifier: interface::types3::IDENTIFIER.to_owned(),
        description: interface::types3::xml3(&env::var("CARGO_PKG_VERSION")?),
        documentation: format!("<!DOCTYPE html>\n<title>types3</title>\n<p>{}.</p>\n", interface::types3::DESCRIPTION),
        platform: platform3()?,
    };
    fs::write(fmus.join(format!("{}.fmu", interface::types3::NAME)), pack(&types, &binary, &[])?)?;
    let mut examples = String::from("static EXAMPLES: &[Example] = &[\n");
    let stations = (interface::coupled::STATIONS, interface::coupled::STATIONS_ABOUT);
    let cells = interface::WORKCELLS.iter().map(|spec| (spec.name, spec.description));
    let (parts, of_stations) = (interface::coupled::all(), interface::coupled::stations());
    for (cell, description) in cells.chain([stations]) {
        let whole = interface::WORKCELLS.iter().filter(|spec| spec.name == cell).map(|spec| spec.name.to_owned());
        let parts = parts.iter().chain(&of_stations).map(|part| part.name.clone());
        let parts = parts.filter(|part| part.strip_prefix(cell).is_some_and(|rest| rest.starts_with('-')));
        let names: Vec<String> = whole.chain(parts).collect();
        let names = names.iter().cloned().chain(names.iter().map(|name| format!("{name}-fmi3")));
        writeln!(examples, "    Example {{\n        name: {cell:?},\n        summary: {description:?},")?;
        writeln!(examples, "        fmus: &[")?;
        for name in names {
            let file = format!("{name}.fmu");
            writeln!(examples, "            ({file:?}, include_bytes!({:?})),", utf8(&fmus.join(&file))?)?;
        }
        writeln!(examples, "        ],\n        files: &[")?;
        for (name, file) in &cell_files(&scenarios.join(cell))? {
            writeln!(examples, "            ({name:?}, include_bytes!({:?})),", utf8(file)?)?;
        }
        writeln!(examples, "        ],\n    }},")?;
    }
    examples.push_str("];\n");
    fs::write(out.join("examples.rs"), examples)?;
    println!("cargo:rustc-env=TEST_FMUS={}", utf8(&fmus)?);
    Ok(())
}

/// Compiles the library of all models and returns where it is.
fn compile_library(root: &Path, out: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let library = out.join("fmi_hazard_fmus.bin");
    let mut command = Command::new(env::var_os("RUSTC").ok_or("cargo did not say which compiler to use")?);
    command
        .args(["--crate-name", "fmi_hazard_fmus", "--crate-type", "cdylib", "--edition", "2024"])
        .args(["-C", "opt-level=3", "-C", "codegen-units=1", "-C", "strip=symbols", "-C", "metadata=fmi-hazard-fmus"])
        .args(["--target", &env::var("TARGET")?])
        .arg("--remap-path-prefix")
        .arg(format!("{}=fmi-hazard", utf8(root)?))
        .args(["--remap-path-prefix", "models=fmus/src"])
        .arg("-o")
        .arg(&library)
        .arg("models/lib.rs")
        .current_dir(root);
    if let Some(linker) = env::var_os("RUSTC_LINKER") {
        let mut option = std::ffi::OsString::from("linker=");
        option.push(linker);
        command.arg("-C").arg(option);
    }
    let output = command.output()?;
    if !output.status.success() {
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(format!("the library of the example FMUs does not compile:\n{message}").into());
    }
    Ok(library)
}

/// Compiles the library of the FMU that does harm on purpose and returns where it is.
fn compile_hostile(root: &Path, out: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let library = out.join("fmi_hazard_hostile.bin");
    let mut sources = Vec::new();
    for entry in fs::read_dir(root.join("hostile"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "c") {
            sources.push(Path::new("hostile").join(path.file_name().ok_or("a source without a name")?));
        }
    }
    sources.sort();
    // The same on every machine with this compiler: no optimisation levels of the profile, nothing that holds a path.
    let mut command = cc::Build::new().opt_level(1).debug(false).try_get_compiler()?.to_command();
    command.args([
        "-std=c11",
        "-fPIC",
        "-shared",
        "-fvisibility=hidden",
        "-ffp-contract=off",
        "-g0",
        "-Wall",
        "-Wextra",
    ]);
    let output = command.arg("-o").arg(&library).args(sources).args(["-lm", "-lpthread"]).current_dir(root).output()?;
    let message = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("the library of the hostile FMU does not compile:\n{message}").into());
    }
    for line in message.lines() {
        println!("cargo:warning={line}");
    }
    Ok(library)
}

/// The cell files of a scenario by name; none if there is no `cell.toml`.
fn cell_files(folder: &Path) -> Result<Vec<(String, PathBuf)>, Box<dyn Error>> {
    let mut files = Vec::new();
    if !folder.join("cell.toml").exists() {
        return Ok(files);
    }
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str()).ok_or("a file name is not UTF-8")?.to_owned();
        let extension = path.extension().and_then(|extension| extension.to_str());
        if path.is_file() && extension.is_some_and(|extension| ["toml", "md", "svg"].contains(&extension)) {
            files.push((name, path));
        }
    }
    files.sort();
    Ok(files)
}

/// How every entry of every FMU is written: one time, one permission.
fn options() -> SimpleFileOptions {
    SimpleFileOptions::default()
        .compression_method(zip::CompressionMethod::Deflated)
        .last_modified_time(zip::DateTime::default())
        .unix_permissions(0o644)
}

/// The library as the only entry of an archive, from which it is copied without compressing it again.
fn compressed(library: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    archive.start_file("library", options())?;
    archive.write_all(library)?;
    Ok(archive.finish()?.into_inner())
}

/// Packs a model for FMI 2.0 and for FMI 3.0.
fn write_both(
    fmus: &Path,
    model: &Interface,
    binary: &[u8],
    cell_files: &[(String, PathBuf)],
) -> Result<(), Box<dyn Error>> {
    let version = env::var("CARGO_PKG_VERSION")?;
    let two = Contents::new(model, interface::description::xml(model, &version), platform2()?)?;
    fs::write(fmus.join(format!("{}.fmu", model.name)), pack(&two, binary, cell_files)?)?;
    let three = Contents::new(model, interface::description3::xml3(model, &version), platform3()?)?;
    fs::write(fmus.join(format!("{}-fmi3.fmu", model.name)), pack(&three, binary, cell_files)?)?;
    Ok(())
}

/// What is in an FMU besides the library and the cell files.
struct Contents {
    identifier: String,
    description: String,
    documentation: String,
    /// Folder of the binary, and how shared libraries end.
    platform: (&'static str, &'static str),
}

impl Contents {
    fn new(
        model: &Interface,
        description: String,
        platform: (&'static str, &'static str),
    ) -> Result<Self, Box<dyn Error>> {
        let identifier = model.identifier.clone();
        Ok(Self { identifier, description, documentation: documentation(model)?, platform })
    }
}

/// The bytes of one FMU: entries sorted by name.
fn pack(contents: &Contents, binary: &[u8], cell_files: &[(String, PathBuf)]) -> Result<Vec<u8>, Box<dyn Error>> {
    let (platform, extension) = contents.platform;
    let library = format!("binaries/{platform}/{}.{extension}", contents.identifier);
    let mut entries: Vec<(String, Option<Vec<u8>>)> = vec![
        ("modelDescription.xml".to_owned(), Some(contents.description.clone().into_bytes())),
        (library, None),
        ("documentation/index.html".to_owned(), Some(contents.documentation.clone().into_bytes())),
    ];
    for (name, path) in cell_files {
        entries.push((format!("{EXTRA}/{name}"), Some(fs::read(path)?)));
    }
    entries.sort();
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        match bytes {
            Some(bytes) => {
                archive.start_file(name, options())?;
                archive.write_all(&bytes)?;
            }
            None => archive.raw_copy_file_rename(zip::ZipArchive::new(Cursor::new(binary))?.by_index(0)?, name)?,
        }
    }
    Ok(archive.finish()?.into_inner())
}

/// FMI 2.0's name of the target's folder, and how shared libraries end there.
fn platform2() -> Result<(&'static str, &'static str), Box<dyn Error>> {
    let (system, processor) = (env::var("CARGO_CFG_TARGET_OS")?, env::var("CARGO_CFG_TARGET_ARCH")?);
    match (system.as_str(), processor.as_str()) {
        ("linux", "x86_64") => Ok(("linux64", "so")),
        ("linux", "aarch64") => Ok(("aarch64-linux", "so")),
        ("macos", "x86_64" | "aarch64") => Ok(("darwin64", "dylib")),
        ("windows", "x86_64") => Ok(("win64", "dll")),
        _ => Err(format!("FMI 2.0 has no folder name for {system} on {processor}").into()),
    }
}

/// FMI 3.0's name of the target's folder (`<architecture>-<system>`), and how shared libraries end there.
fn platform3() -> Result<(&'static str, &'static str), Box<dyn Error>> {
    let (system, processor) = (env::var("CARGO_CFG_TARGET_OS")?, env::var("CARGO_CFG_TARGET_ARCH")?);
    match (system.as_str(), processor.as_str()) {
        ("linux", "x86_64") => Ok(("x86_64-linux", "so")),
        ("linux", "aarch64") => Ok(("aarch64-linux", "so")),
        ("macos", "x86_64") => Ok(("x86_64-darwin", "dylib")),
        ("macos", "aarch64") => Ok(("aarch64-darwin", "dylib")),
        ("windows", "x86_64") => Ok(("x86_64-windows", "dll")),
        _ => Err(format!("no folder name for {system} on {processor}").into()),
    }
}

/// A short page with the table of variables.
fn documentation(model: &Interface) -> Result<String, Box<dyn Error>> {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{0}</title>\n<h1>{0}</h1>\n<p>{1}.</p>\n\
         <table>\n<tr><th>variable<th>role<th>meaning\n",
        model.name, model.description
    );
    for variable in &model.variables {
        let role = format!("{:?}", variable.causality).to_lowercase();
        writeln!(page, "<tr><td>{}<td>{role}<td>{}", variable.name, variable.description)?;
    }
    page.push_str("</table>\n</html>\n");
    Ok(page)
}

fn utf8(path: &Path) -> Result<&str, Box<dyn Error>> {
    Ok(path.to_str().ok_or_else(|| format!("the path {} is not UTF-8", path.display()))?)
}
