//! Variants of a cell, by `extends`: each means what the whole cell written out means, mistakes are told where they stand,
//! and a file that is extended counts as part of the cell.

use std::path::Path;

use crate::common::{examples, fmi_hazard, json, scan_json, write};
use crate::sample;

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The flawed cell of the example, as what the repaired one has otherwise.
const FLAWED: &str = r#"extends = "../fixed.toml"
name = "again"
search = { actions = 6 }

[[obstacle]]
name = "fence right"
centre_m = [1, 1, 1]
size_m = [0.02, 2, 2]

[[obstacle]]
name = "fence left"
centre_m = [-1, 1, 1]
size_m = [0.02, 2, 2]

[[sensor]]
name = "mat"
zone = { polygon_m = [[-1, -1.2], [1, -1.2], [1, 2], [-1, 2]] }

[human]
start = { xy_m = [-0.74, -1.36] }
"#;

fn with_variants() -> tempfile::TempDir {
    let dir = examples();
    let cell = dir.path().join("sensor-mat");
    std::fs::create_dir(cell.join("variants")).unwrap();
    write(&cell, "variants/flawed.toml", FLAWED);
    dir
}

fn scan(dir: &Path, cell: &str, out: &str) -> (Option<i32>, String) {
    let (code, _, said) = ran(dir, &["scan", "--no-advice", cell, "--strategy", "exhaustive", "--out", out]);
    (code, said)
}

#[test]
fn a_variant_is_the_cell_written_out() {
    if !sample::is_turn(5, 12) {
        return;
    }
    let dir = with_variants();
    let dir = dir.path();
    let flawed = std::fs::read_to_string(dir.join("sensor-mat/cell.toml")).unwrap() + "\n[search]\nactions = 6\n";
    write(dir, "sensor-mat/whole.toml", &flawed);
    let (code, said) = scan(dir, "sensor-mat/variants/flawed.toml", "variant");
    assert_eq!(code, Some(1), "{said}");
    assert_eq!(scan(dir, "sensor-mat/whole.toml", "whole").0, Some(1));
    let [variant, whole] = ["variant", "whole"].map(|out| scan_json(&dir.join(out)));
    assert_eq!(variant["hazards"], whole["hazards"]);
    assert!(!variant["hazards"].as_array().unwrap().is_empty());
    assert_eq!(variant["certificate"]["sequences"], whole["certificate"]["sequences"]);
    assert_eq!(variant["certificate"]["states"], whole["certificate"]["states"]);
    // The repaired file is part of it.
    assert_eq!(variant["subject"]["files"][0]["path"], "../fixed.toml");
    let (_, told, _) = ran(dir, &["compare", "variant", "whole", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_str(&told).unwrap();
    // Values that differ are told one by one, laid together: the name alone.
    let words = told.to_string();
    assert!(words.contains("cell file, name") && !words.contains("cell file, obstacle"), "{words}");
    // Findings are shown at the line that names the link, which is in the other file.
    let sarif = json(&dir.join("variant/hazards.sarif"));
    let place = &sarif["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "sensor-mat/fixed.toml");
    let line = usize::try_from(place["region"]["startLine"].as_u64().unwrap()).unwrap();
    let fixed = std::fs::read_to_string(dir.join("sensor-mat/fixed.toml")).unwrap();
    assert!(fixed.lines().nth(line - 1).unwrap().starts_with("joint = "), "{line}");
    // What explains it turns the whole cell.
    let id = variant["hazards"][0]["id"].as_str().unwrap();
    let arguments = ["explain", "variant", id, "--from", "start", "--quick", "--iterations", "2", "--format", "json"];
    let (code, text, said) = ran(dir, &arguments);
    assert_eq!(code, Some(0), "{said}");
    let explained: serde_json::Value = serde_json::from_str(&text).unwrap();
    let remedies = explained["remedies"].as_array().unwrap();
    assert!(remedies.iter().any(|r| r["change"].as_str().unwrap().starts_with("zone of mat")), "{explained}");
    // And so does a copy that carries its cell.
    let arguments = ["pack", "sensor-mat/variants/flawed.toml", "--out", "alone.fmu"];
    assert_eq!(ran(dir, &arguments).0, Some(0));
    assert_eq!(scan(dir, "alone.fmu", "alone").0, Some(1));
    assert_eq!(scan_json(&dir.join("alone"))["hazards"], whole["hazards"]);
    // The extended file changes.
    let changed = fixed.replace("moving_mass_kg = 34.1", "moving_mass_kg = 44.1");
    write(dir, "sensor-mat/fixed.toml", &changed);
    let (_, _, said) = ran(dir, &["replay", "variant", id]);
    assert!(said.contains("a cell file that it extends") && said.contains("has changed"), "{said}");
}

/// The place and the message of every problem of a variant.
fn problems(dir: &Path, text: &str) -> Vec<(String, u64, String)> {
    write(dir, "sensor-mat/variants/wrong.toml", text);
    let (code, told, said) = ran(dir, &["check", "sensor-mat/variants/wrong.toml", "--no-run", "--format", "json"]);
    assert_eq!(code, Some(2), "{said}");
    let told: serde_json::Value = serde_json::from_str(&told).unwrap();
    let one = |problem: &serde_json::Value| {
        let text = |key: &str| problem[key].as_str().unwrap().to_owned();
        (text("file"), problem["line"].as_u64().unwrap(), format!("{} ({})", text("message"), problem["help"]))
    };
    told["problems"].as_array().unwrap().iter().map(one).collect()
}

#[test]
fn mistakes_are_told_in_the_file_in_which_they_stand() {
    let dir = with_variants();
    let dir = dir.path();
    let own = "sensor-mat/variants/wrong.toml";
    let base = |number: u32| format!("sensor-mat/variants/../broken-{number}.toml");
    let fixed = std::fs::read_to_string(dir.join("sensor-mat/fixed.toml")).unwrap();
    let line = |text: &str, what: &str| text.lines().position(|line| line.contains(what)).unwrap() as u64 + 1;
    let top = "extends = \"../fixed.toml\"\nname = \"wrong\"\n";
    let alone = |text: &str| match problems(dir, text).as_slice() {
        [one] => one.clone(),
        several => panic!("{several:#?}"),
    };
    // In the variant: a type, an unknown key, a name that the FMU does not have.
    let (file, at, _) = alone(&format!("{top}[human]\npercentile = \"many\"\n"));
    assert_eq!((file.as_str(), at), (own, 4));
    let (file, at, message) = alone(&format!("{top}\n[human]\npercentil = 5\n"));
    assert_eq!((file.as_str(), at), (own, 5));
    assert!(message.contains("did you mean `percentile`"), "{message}");
    let (file, at, _) = alone(&format!("{top}[[sensor]]\nname = \"mat\"\nvariable = \"plc.mat_cleer\"\n"));
    assert_eq!((file.as_str(), at), (own, 5));
    // The same in what it extends, and both at once.
    let broken = fixed.replace("axis = [1, 0, 0]", "axis = [0, 0, 0]").replace("kind = \"mat\"", "kind = \"matt\"");
    write(dir, "sensor-mat/broken-1.toml", &broken);
    let both = problems(dir, "extends = \"../broken-1.toml\"\nname = \"wrong\"\n[human]\npercentile = 6\n");
    let places: Vec<(&str, u64)> = both.iter().map(|(file, line, _)| (file.as_str(), *line)).collect();
    let base_1 = base(1);
    assert_eq!(places[0], (own, 4), "{both:?}");
    assert!(places.contains(&(base_1.as_str(), line(&broken, "kind = \"matt\""))), "{both:?}");
    assert!(places.contains(&(base_1.as_str(), line(&broken, "axis = [0, 0, 0]"))), "{both:?}");
    assert_eq!(both.len(), 4, "{both:?}");
    // No TOML there; a TODO there.
    write(dir, "sensor-mat/broken-2.toml", &fixed.replace("moving_mass_kg = 34.1", "moving_mass_kg = = 34.1"));
    let (file, at, _) = alone("extends = \"../broken-2.toml\"\nname = \"wrong\"\n");
    assert_eq!((file, at), (base(2), line(&fixed, "moving_mass_kg")));
    write(dir, "sensor-mat/broken-3.toml", &format!("{fixed}# TODO more\n"));
    let (file, at, _) = alone("extends = \"../broken-3.toml\"\nname = \"wrong\"\n");
    assert_eq!((file, at), (base(3), fixed.lines().count() as u64 + 1));
    // People see the file's name and the line.
    write(dir, own, "extends = \"../broken-1.toml\"\nname = \"wrong\"\n");
    let (_, _, said) = ran(dir, &["check", own]);
    assert!(said.contains(&format!("broken-1.toml:{}:", line(&broken, "kind = \"matt\""))), "{said}");
}

#[test]
fn what_cannot_be_extended_says_why() {
    let dir = with_variants();
    let dir = dir.path();
    let told = |text: &str, file: &str, line: u64, words: &str| {
        let told = problems(dir, text);
        let found = told.iter().any(|(f, l, m)| f.ends_with(file) && *l == line && m.contains(words));
        assert!(found && told.len() == 1, "{words}: {told:#?}");
    };
    told("name = \"x\"\nextends = \"../none.toml\"\n", "wrong.toml", 2, "cannot read");
    told("name = \"x\"\nextends = \"wrong.toml\"\n", "wrong.toml", 2, "extended by itself");
    write(dir, "sensor-mat/round.toml", "extends = \"variants/wrong.toml\"\n");
    told("name = \"x\"\nextends = \"../round.toml\"\n", "round.toml", 1, "extended by itself");
    for number in 1..10 {
        write(dir, &format!("sensor-mat/c{number}.toml"), &format!("extends = \"c{}.toml\"\n", number + 1));
    }
    told("name = \"x\"\nextends = \"../c1.toml\"\n", "c8.toml", 1, "more than 8");
    told("extends = \"../fixed.toml\"\n", "wrong.toml", 1, "no name of its own");
    told("extends = \"../fixed.toml\"\nname = \"sensor-mat-fixed\"\n", "wrong.toml", 2, "as what it extends");
    let top = "extends = \"../fixed.toml\"\nname = \"x\"\n";
    told(&format!("{top}remove = {{ sensor = [\"matt\"] }}\n"), "wrong.toml", 3, "did you mean `mat`");
    told(&format!("{top}remove = {{ inputs = [\"plc.rest\"] }}\n"), "wrong.toml", 3, "did you mean `plc.reset`");
    told(&format!("{top}remove = {{ connection = [\"x\"] }}\n"), "wrong.toml", 3, "could be removed");
    told(
        &format!(
            "{top}[[robot]]\nname = \"new\"\nremove = {{ link = [\"x\"] }}\nmoving_mass_kg = 1\npayload_kg = 1\n\
                   joint = [{{ name = \"j\", axis = [0, 0, 1], held_deg = 0 }}]\n\
                   link = [{{ name = \"l\", joint = \"j\", capsule = {{ from_m = [0, 0, 0], to_m = [0, 0, 1], \
                   radius_m = 0.1 }} }}]\n"
        ),
        "wrong.toml",
        5,
        "nothing that this could be removed from",
    );
    // Inside an FMU nothing is beside it.
    let own = "extra/io.github.fmi-hazard/cell.toml";
    let fmu = std::fs::read(dir.join("sensor-mat/sensor-mat.fmu")).unwrap();
    let mut before = zip::ZipArchive::new(std::io::Cursor::new(fmu)).unwrap();
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for entry in 0..before.len() {
        let entry = before.by_index_raw(entry).unwrap();
        if entry.name().unwrap() != own {
            archive.raw_copy_file(entry).unwrap();
        }
    }
    archive.start_file(own, zip::write::SimpleFileOptions::default()).unwrap();
    std::io::Write::write_all(&mut archive, FLAWED.as_bytes()).unwrap();
    std::fs::write(dir.join("inside.fmu"), archive.finish().unwrap().into_inner()).unwrap();
    let (code, _, said) = ran(dir, &["check", "inside.fmu"]);
    assert_eq!(code, Some(2));
    assert!(said.contains("inside an FMU cannot extend another") && said.contains("fmi-hazard pack"), "{said}");
}

/// The tables of a variant, laid over what it extends.
fn laid(dir: &Path, text: &str) -> toml::Table {
    let path = write(dir, "variants/laid.toml", text);
    let (_, whole) = fmi_hazard::cell::find::whole_text(&path).unwrap();
    whole.parse().unwrap()
}

fn names<'a>(table: &'a toml::Table, list: &str) -> Vec<&'a str> {
    table[list].as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect()
}

#[test]
fn tables_are_laid_by_key_and_entries_by_name() {
    let dir = with_variants();
    let dir = dir.path().join("sensor-mat");
    write(
        &dir,
        "base.toml",
        r#"schema = 1
           name = "base"
           fmu = "a.fmu"
           parameters = { a = 1, b = 2 }
           [[obstacle]]
           name = "box"
           centre_m = [0, 0, 0]
           size_m = [1, 1, 1]
           rpy_deg = [0, 0, 30]
           [[obstacle]]
           name = "mesh"
           mesh = { file = "m.stl", metres_per_unit = 0.001 }
           [[obstacle]]
           name = "gone"
           [[sensor]]
           name = "mat"
           kind = "mat"
           delay_ms = 20
           zone = { polygon_m = [[0, 0], [1, 0], [0, 1]] }
           [[robot]]
           name = "arm"
           urdf = "geometry/arm.urdf"
           packages = { p = "/opt/p", q = "packages/q" }
           payload_kg = 3
           [[robot.joint]]
           name = "j1"
           angle = { variable = "q1", sign = -1 }
           speed = { variable = "v1" }
           [[robot.joint]]
           name = "j2"
           angle = { variable = "q2" }
           [[robot.link]]
           name = "tool"
           joint = "j2"
           capsule = { radius_m = 1 }
           [[robot.link]]
           name = "tool"
           joint = "j2"
           capsule = { radius_m = 2 }
           [[robot.link]]
           name = "hose"
           joint = "j2"
        "#,
    );
    let all = laid(
        &dir,
        r#"extends = "../base.toml"
           name = "variant"
           remove = { obstacle = ["gone"], parameters = ["a"] }
           parameters = { b = 3, c = 4 }
           [[obstacle]]
           name = "new"
           [[obstacle]]
           name = "box"
           mesh = { file = "own.stl", metres_per_unit = 1 }
           [[obstacle]]
           name = "mesh"
           centre_m = [0, 0, 0]
           size_m = [1, 1, 1]
           [[sensor]]
           name = "mat"
           kind = "light_curtain"
           zone = { line_m = [[0, 0], [1, 0]], heights_m = [0, 1] }
           [[robot]]
           name = "arm"
           remove = { link = ["hose"] }
           payload = { variable = "m" }
           [[robot.joint]]
           name = "j2"
           held_deg = 0
           [[robot.joint]]
           name = "j1"
           angle = { variable = "other" }
           [[robot.link]]
           name = "tool"
           joint = "j1"
        "#,
    );
    assert!(all.get("extends").is_none() && all.get("remove").is_none());
    assert_eq!((all["name"].as_str(), all["schema"].as_integer()), (Some("variant"), Some(1)));
    assert_eq!(all["parameters"].to_string(), "{ b = 3, c = 4 }");
    // In the order of the base, new ones behind.
    assert_eq!(names(&all, "obstacle"), ["box", "mesh", "new"]);
    let [of_box, of_mesh] = [0, 1].map(|n| all["obstacle"][n].as_table().unwrap());
    assert!(of_box.get("centre_m").is_none() && of_box.get("rpy_deg").is_none());
    assert_eq!(of_box["mesh"]["file"].as_str(), Some("own.stl"));
    assert!(of_mesh.get("mesh").is_none());
    // Another kind of sensor has neither the zone nor the response time of the one before.
    let zone = all["sensor"][0]["zone"].as_table().unwrap();
    assert!(zone.get("polygon_m").is_none() && all["sensor"][0].get("delay_ms").is_none());
    // Files are where they were for the file that names them.
    assert_eq!(all["fmu"].as_str(), Some("../a.fmu"));
    let arm = all["robot"][0].as_table().unwrap();
    assert_eq!(arm["urdf"].as_str(), Some("../geometry/arm.urdf"));
    assert_eq!(arm["packages"].to_string(), "{ p = \"/opt/p\", q = \"../packages/q\" }");
    assert!(arm.get("payload_kg").is_none() && arm.get("remove").is_none());
    assert_eq!(names(arm, "joint"), ["j1", "j2"]);
    // By key: the sign stays with another variable.
    assert_eq!(arm["joint"][0]["angle"].to_string(), "{ sign = -1, variable = \"other\" }");
    assert!(arm["joint"][0].get("speed").is_some() && arm["joint"][1].get("angle").is_none());
    // Several shapes of a name go together.
    assert_eq!(names(arm, "link"), ["tool"]);
    assert!(arm["link"][0].get("capsule").is_none());
    // An entry that is removed and written again is as written; a chain goes through all files.
    std::fs::create_dir_all(dir.join("variants/deeper")).unwrap();
    write(
        &dir,
        "variants/deeper/middle.toml",
        "extends = \"../../base.toml\"\nunit = [{ name = \"u\", fmu = \"u.fmu\" }]\n",
    );
    let again = laid(
        &dir,
        r#"extends = "deeper/middle.toml"
           remove = { sensor = ["mat"] }
           sensor = [{ name = "mat", kind = "mat" }]
        "#,
    );
    assert_eq!(again["sensor"][0].to_string(), "{ kind = \"mat\", name = \"mat\" }");
    assert!(again.get("fmu").is_none());
    assert_eq!(again["unit"][0]["fmu"].as_str(), Some("deeper/u.fmu"));
    assert_eq!(again["robot"][0]["urdf"].as_str(), Some("../geometry/arm.urdf"));
}

#[test]
fn scans_go_on_only_while_what_is_extended_is_the_same() {
    let dir = with_variants();
    let dir = dir.path();
    assert!(FLAWED.contains("actions = 6"));
    let several = FLAWED
        .replace("[human]", "[human]\nbegins_s = [0, 0.4]")
        .replace("actions = 6", if sample::is_whole() { "actions = 6" } else { "actions = 3" });
    write(dir, "sensor-mat/variants/several.toml", &several);
    let arguments =
        ["scan", "--no-advice", "sensor-mat/variants/several.toml", "--strategy", "exhaustive", "--out", "o"];
    let (code, _, said) = ran(dir, &arguments);
    let codes: &[i32] = if sample::is_whole() { &[1] } else { &[0, 1, 4] };
    assert!(code.is_some_and(|code| codes.contains(&code)), "{said}");
    let table = json(&dir.join("o/beginnings.json"));
    assert_eq!(table["files"][0]["path"], "../fixed.toml");
    // As if it had been interrupted after the first: that is known, until the extended file changes.
    let mut half = table.clone();
    half["beginnings"].as_array_mut().unwrap().truncate(1);
    let command = serde_json::json!({ "arguments": &arguments[1..], "folder": ".." });
    let resume = || {
        write(dir, "o/beginnings.json", &half.to_string());
        write(dir, "o/resume.json", &command.to_string());
        let (_, _, said) = ran(dir, &["scan", "--resume", "o"]);
        said.matches("Begins").count()
    };
    assert_eq!(resume(), 1);
    let fixed = std::fs::read_to_string(dir.join("sensor-mat/fixed.toml")).unwrap();
    write(dir, "sensor-mat/fixed.toml", &fixed.replace("moving_mass_kg = 34.1", "moving_mass_kg = 44.1"));
    assert_eq!(resume(), 2);
}

/// The cell files among the examples of a page of the book.
fn on_page(page: &str) -> Vec<String> {
    let text =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src/howto").join(page)).unwrap();
    let blocks = text.split("```toml").skip(1).map(|block| block.split("```").next().unwrap());
    blocks.map(|block| block.split_once('\n').unwrap().1.to_owned()).collect()
}

#[test]
fn examples_of_the_book_are_as_it_says() {
    if !sample::is_turn(3, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let checked = |cell: &str| {
        let (code, told, said) = ran(dir, &["check", cell]);
        assert_eq!(code, Some(0), "{cell}: {told}{said}");
        told
    };
    let pages = on_page("variants.md");
    write(dir, "sensor-mat/half-mat.toml", &pages[0]);
    assert!(checked("sensor-mat/half-mat.toml").contains("  extends   sensor-mat/fixed.toml\n"));
    write(dir, "sensor-mat/open.toml", &pages[1]);
    checked("sensor-mat/open.toml");
    let cell = |example: &str| std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
    let ranges = on_page("changes.md");
    write(dir, "head-collision/ranges.toml", &(cell("head-collision") + &ranges[0]));
    checked("head-collision/ranges.toml");
    let areas = on_page("beginnings.md");
    let area = areas.iter().find(|text| text.contains("start_area")).unwrap();
    let without = cell("safety-fence").replace("[human]\nstart = { xy_m = [1.05, -1.7], heading_deg = 90 }\n", "");
    write(dir, "safety-fence/area.toml", &(without + area));
    let told = checked("safety-fence/area.toml");
    let promised = "  person    starts at 27 places of an area, 0.4 m apart, 3 headings each; 1 more is left out: an obstacle is there\n            81 beginnings\n";
    assert!(told.contains(promised), "{told}");
}
