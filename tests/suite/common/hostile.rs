//! FMUs that do harm on purpose: the packed `hostile` FMU with a file that says what it shall do.
//!
//! ```ignore
//! Hostile::v2().what("segfault").at("step", 12).write(dir);
//! Hostile::v3().what("signal-handlers").at("load", 1).what("hang").at("step", 3).write(dir);
//! ```
//!
//! `fmus/hostile/README.md` lists behaviours and calls. Steps are counted from 0 in each run, all other calls from 1 in
//! each process.

use std::fmt::Write as _;
use std::io::{Cursor, Read as _, Write as _};
use std::path::{Path, PathBuf};

use zip::write::SimpleFileOptions;

use super::{faulty_cell, test_fmus, write};
use crate::sample;

/// Name of the FMU that [`Hostile::write`] writes.
pub const FMU: &str = "x.fmu";
/// Name of its cell file.
pub const CELL: &str = "x.toml";

/// A hostile FMU in the making; an honest one until [`Hostile::what`].
#[derive(Clone, Debug)]
pub struct Hostile {
    third: bool,
    behaviour: String,
    attributes: Vec<(&'static str, String)>,
    slides: bool,
}

impl Hostile {
    /// Of FMI 2.0.
    pub fn v2() -> Self {
        Self { third: false, behaviour: String::new(), attributes: Vec::new(), slides: false }
    }

    /// Of FMI 3.0.
    pub fn v3() -> Self {
        Self { third: true, ..Self::v2() }
    }

    /// One of each version.
    pub fn both() -> [Self; 2] {
        [Self::v2(), Self::v3()]
    }

    /// Of one version, the case of the next number of the other, and in another run of the tests the other way round; of both where all
    /// cases are looked at.
    pub fn by_turns(case: usize) -> impl Iterator<Item = Self> {
        let both = Self::both().into_iter().enumerate();
        both.filter(move |(version, _)| sample::takes(version + case, 2)).map(|(_, one)| one)
    }

    /// Begins another behaviour; the next calls are about it.
    pub fn what(self, behaviour: &str) -> Self {
        self.line("what", behaviour)
    }

    /// In which call, and in the how manieth; without this in step 0, and always for what is no single deed.
    pub fn at(self, call: &str, count: u32) -> Self {
        self.line("where", call).line("at", count)
    }

    /// In the how manieth step in a row with `stop`. A self-test has at most five, so 6 and more meet a search only.
    pub fn when_stopped(self, count: u32) -> Self {
        self.at("step", count).line("when", "stop")
    }

    /// Bytes, seconds or milliseconds, as the behaviour needs.
    pub fn size(self, size: i64) -> Self {
        self.line("size", size)
    }

    /// A file.
    pub fn path(self, path: &Path) -> Self {
        self.line("path", path.display())
    }

    /// A port of this machine.
    pub fn port(self, port: u16) -> Self {
        self.line("port", port)
    }

    fn line(mut self, key: &str, value: impl std::fmt::Display) -> Self {
        let _ = writeln!(self.behaviour, "{key} = {value}");
        self
    }

    /// Says in modelDescription.xml whether states can be saved.
    pub fn saves(self, yes: bool) -> Self {
        let name = if self.third { "canGetAndSetFMUState" } else { "canGetAndSetFMUstate" };
        self.attribute(name, yes)
    }

    /// Says in modelDescription.xml whether states can be serialised.
    pub fn serializes(self, yes: bool) -> Self {
        let name = if self.third { "canSerializeFMUState" } else { "canSerializeFMUstate" };
        self.attribute(name, yes)
    }

    /// Says in modelDescription.xml how long it is to be run, s.
    pub fn stop_time(mut self, seconds: &str) -> Self {
        self.attributes.push(("stopTime", seconds.to_owned()));
        self
    }

    /// Says in modelDescription.xml that its joint is a slide: m and m/s.
    pub fn slides(self) -> Self {
        Self { slides: true, ..self }
    }

    /// Says in modelDescription.xml whether there can be one instance in a process only.
    pub fn once_per_process(self, yes: bool) -> Self {
        self.attribute("canBeInstantiatedOnlyOncePerProcess", yes)
    }

    fn attribute(mut self, name: &'static str, value: bool) -> Self {
        self.attributes.push((name, value.to_string()));
        self
    }

    /// Writes [`FMU`] and [`CELL`], a cell of it, into a folder; the path of the FMU.
    pub fn write(&self, dir: &Path) -> PathBuf {
        let cell = faulty_cell(FMU, 0, 0).replace("[parameters]\n\"fault.kind\" = 0\n\"fault.step\" = 0\n", "");
        assert!(!cell.contains("fault."), "the FMU has no such parameters");
        write(dir, CELL, &cell);
        let path = dir.join(FMU);
        std::fs::write(&path, self.bytes()).expect("a file can be written");
        path
    }

    /// The FMU's bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let name = if self.third { "hostile-fmi3.fmu" } else { "hostile.fmu" };
        let honest = std::fs::read(test_fmus().join(name)).expect("the build script made it");
        let mut from = zip::ZipArchive::new(Cursor::new(honest)).expect("an archive");
        let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for place in 0..from.len() {
            let mut entry = from.by_index(place).expect("an entry");
            let name = entry.name().expect("UTF-8").into_owned();
            if name == "modelDescription.xml" {
                let mut text = String::new();
                entry.read_to_string(&mut text).expect("UTF-8");
                to.start_file(name, SimpleFileOptions::default()).expect("an entry");
                to.write_all(self.changed(text).as_bytes()).expect("an entry");
            } else {
                to.raw_copy_file(entry).expect("an entry");
            }
        }
        if !self.behaviour.is_empty() {
            to.start_file("resources/behaviour", SimpleFileOptions::default()).expect("an entry");
            to.write_all(self.behaviour.as_bytes()).expect("an entry");
        }
        to.finish().expect("an archive").into_inner()
    }

    /// modelDescription.xml with the attributes changed.
    fn changed(&self, mut text: String) -> String {
        for (name, value) in &self.attributes {
            let key = format!(" {name}=\"");
            let start = text.find(&key).expect("the attribute is there") + key.len();
            let length = text[start..].find('"').expect("the value ends");
            text.replace_range(start..start + length, value);
        }
        if self.slides {
            text =
                text.replace("\"rad\"", "\"m\"").replace("\"rad/s\"", "\"m/s\"").replace("BaseUnit rad", "BaseUnit m");
        }
        text
    }
}
