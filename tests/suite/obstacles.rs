//! Static geometry from mesh files: where its boxes are, that nothing is filled that the mesh does not fill, and that a
//! cell has the hazards that it has with boxes given by hand.

use std::path::Path;

use crate::common::{assert_same_hazards, examples, fmi_hazard, scan_json, write};
use fmi_hazard::cell::error::Source;
use fmi_hazard::cell::file::validate::validate;
use fmi_hazard::cell::workcell::Workcell;
use fmi_hazard::geometry::{Cuboid, Vec3};
use fmi_hazard_sample::meshes;

/// The cell with these tables of obstacles.
fn cell(folder: &Path, obstacles: &str) -> Result<Workcell, String> {
    let text = format!(
        "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[human]\nstart = {{ xy_m = [0, -2], heading_deg = 90 }}\n[[robot]]\nname = \
         \"r\"\npayload_kg = 1\nmoving_mass_kg = 20\n[[robot.joint]]\nname = \"j\"\naxis = [0, 0, 1]\nangle = {{ variable = \
         \"q\" }}\n[[robot.link]]\nname = \"l\"\njoint = \"j\"\ncapsule = {{ from_m = [0, 0, 0], to_m = [0, 0, 1], radius_m \
         = 0.1 }}\n{obstacles}"
    );
    let told = |e: Box<fmi_hazard::cell::CellError>| format!("{}: {e}: {:?}", e.line().unwrap(), e.help);
    validate(&Source::new("cell.toml", &text).in_folder(folder)).map_err(told)
}

fn obstacle(mesh: &str) -> String {
    format!("[[obstacle]]\nname = \"thing\"\nmesh = {{ {mesh} }}\n")
}

/// The corners of a box, in a fixed order.
fn corners(cuboid: &Cuboid) -> Vec<Vec3> {
    let corner = |n: usize| {
        let sign = Vec3::from_array([0, 1, 2].map(|axis| if n >> axis & 1 == 0 { -1.0 } else { 1.0 }));
        cuboid.centre + cuboid.rotation * (cuboid.half * sign)
    };
    let mut corners: Vec<Vec3> = (0..8).map(corner).collect();
    let key = |v: &Vec3| v.to_array().map(|c| (c * 1e4).round());
    let by = |a: &[f64; 3], b: &[f64; 3]| a.partial_cmp(b).unwrap();
    corners.sort_by(|a, b| by(&key(a), &key(b)));
    corners
}

#[track_caller]
fn same_box(found: &Cuboid, expected: &Cuboid) {
    for (a, b) in corners(found).iter().zip(corners(expected)) {
        assert!((*a - b).length() < 2e-6, "{found:?} {expected:?}");
    }
}

const OBSTACLE_BY_HAND: &str =
    "[[obstacle]]\nname = \"by hand\"\ncentre_m = [1, -2, 0.7]\nsize_m = [1.2, 0.02, 1.4]\nrpy_deg = [0, 0, 30]\n";

#[test]
fn a_box_comes_out_of_every_format_where_it_is() {
    let dir = tempfile::TempDir::new().unwrap();
    let (points, triangles) = meshes::cuboid([-0.6, -0.01, -0.7], [0.6, 0.01, 0.7]);
    let millimetres: Vec<[f64; 3]> = points.iter().map(|p| p.map(|v| v * 1e3)).collect();
    // glTF has y up: (x, y, z) here is (x, z, -y) there.
    let upright: Vec<[f64; 3]> = points.iter().map(|[x, y, z]| [*x, *z, -*y]).collect();
    let (sin, cos) = libm::sincos(15f64.to_radians());
    let node = format!("\"translation\":[1,0.7,2],\"rotation\":[0,{sin},0,{cos}]");
    std::fs::write(dir.path().join("a.glb"), meshes::glb(&upright, &triangles, &node)).unwrap();
    // The same as a matrix, columns one after the other; mirrored in x, which changes nothing about this box.
    let (s, c) = libm::sincos(30f64.to_radians());
    let matrix = format!("\"matrix\":[{},0,{},0, 0,1,0,0, {s},0,{c},0, 1,0.7,2,1]", -c, s);
    std::fs::write(dir.path().join("b.glb"), meshes::glb(&upright, &triangles, &matrix)).unwrap();
    write(dir.path(), "a.stl", &meshes::stl(&millimetres, &triangles));
    let mut obj = String::new();
    for [x, y, z] in &upright {
        obj += &format!("v {x} {y} {z}\n");
    }
    for [a, b, c] in &triangles {
        obj += &format!("f {} {} {}\n", a + 1, b + 1, c + 1);
    }
    write(dir.path(), "a.obj", &obj);
    for mesh in [
        "file = \"a.glb\"",
        "file = \"b.glb\"",
        "file = \"a.glb\", up = \"y\", metres_per_unit = 1",
        "file = \"a.stl\", metres_per_unit = 0.001, at = { xyz_m = [1, -2, 0.7], rpy_deg = [0, 0, 30] }",
        "file = \"a.obj\", metres_per_unit = 1, up = \"y\", at = { xyz_m = [1, -2, 0.7], rpy_deg = [0, 0, 30] }",
    ] {
        let cell = cell(dir.path(), &format!("{}{OBSTACLE_BY_HAND}", obstacle(mesh))).unwrap();
        let [first, second] = cell.obstacles.as_slice() else { panic!("{mesh}: {:?}", cell.obstacles) };
        let (name, found, expected) = (&first.name, &first.cuboid, &second.cuboid);
        assert_eq!(name, "thing");
        same_box(found, expected);
        assert_eq!((first.table, second.table), (None, Some(1)));
        assert_eq!(cell.files.len(), 1);
        assert_eq!(cell.warnings.len(), 1, "{:?}", cell.warnings);
        assert!(
            cell.warnings[0].contains("1 parts and is taken as 1 boxes, which fill 100.0 %"),
            "{:?}",
            cell.warnings
        );
    }
}

#[test]
fn parts_are_boxes_filled_hollow_or_left_out_and_told() {
    let dir = tempfile::TempDir::new().unwrap();
    let (mut points, mut triangles) = meshes::cuboid([0.0; 3], [1.0; 3]);
    let mut add = |(more, of): (Vec<[f64; 3]>, Vec<[u32; 3]>), keep: std::ops::Range<usize>, turned: bool| {
        let before = u32::try_from(points.len()).unwrap();
        points.extend(more);
        let turn = |[a, b, c]: [u32; 3]| if turned { [a, c, b] } else { [a, b, c] };
        triangles.extend(of[keep].iter().map(|t| turn(*t).map(|corner| corner + before)));
    };
    // A hollow in the first; one without a side; one that is inside out; one thinner than a cell and slanted.
    add(meshes::cuboid([0.2; 3], [0.8; 3]), 0..12, true);
    add(meshes::cuboid([2.0, 0.0, 0.0], [2.5, 0.5, 0.5]), 2..12, false);
    add(meshes::cuboid([4.0, 0.0, 0.0], [4.5, 0.5, 0.5]), 0..12, true);
    let wedge = [[6.0, 0.0], [6.01, 0.0], [7.01, 1.0], [7.0, 1.0]];
    let bent = [[8.0, 0.0], [8.01, 0.0], [8.51, 0.5], [8.01, 1.0], [8.0, 1.0], [8.5, 0.5]];
    add(meshes::prism(&wedge, &[[0, 1, 2], [0, 2, 3]], 0.5), 0..12, false);
    add(meshes::prism(&bent, &[[0, 1, 2], [0, 2, 5], [5, 2, 3], [5, 3, 4]], 0.5), 0..20, false);
    write(dir.path(), "all.stl", &meshes::stl(&points, &triangles));
    let cell = cell(dir.path(), &obstacle("file = \"all.stl\", metres_per_unit = 1")).unwrap();
    let inside = |x: f64, y: f64, z: f64| {
        let at = Vec3::new(x, y, z);
        cell.obstacles
            .iter()
            .map(|o| &o.cuboid)
            .any(|c| (c.rotation.inverse() * (at - c.centre)).abs().cmple(c.half).all())
    };
    assert!(inside(0.1, 0.5, 0.5) && !inside(0.5, 0.5, 0.5) && inside(4.2, 0.2, 0.2) && !inside(2.2, 0.2, 0.2));
    let names: Vec<&str> = cell.obstacles.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names[..3], ["thing", "thing/2", "thing/3"]);
    let told = cell.warnings.join("\n");
    assert!(told.contains("all.stl has 6 parts"), "{told}");
    assert!(
        told.contains("part 3 (0.50 x 0.50 x 0.50 m at 2.25, 0.25, 0.25) is left out: its surface is open at 4"),
        "{told}"
    );
    assert!(told.contains("part 6") && told.contains("no cell of 0.05 m fits into it; give it as a box"), "{told}");
    assert!(!told.contains("part 4") && !told.contains("part 1 "), "{told}");
}

#[test]
fn a_fence_from_a_file_has_the_hazards_of_the_fence_given_by_hand_and_travels_with_the_fmu() {
    let dir = examples();
    let folder = dir.path().join("safety-fence");
    let mut table: toml::Table = std::fs::read_to_string(folder.join("cell.toml")).unwrap().parse().unwrap();
    std::fs::create_dir(folder.join("cad")).unwrap();
    for (number, obstacle) in table["obstacle"].as_array_mut().unwrap().iter_mut().enumerate() {
        let obstacle = obstacle.as_table_mut().unwrap();
        let numbers = |value: toml::Value| -> Vec<f64> {
            let list = value.as_array().unwrap().clone();
            list.iter().map(|v| v.as_float().or(v.as_integer().map(|i| i as f64)).unwrap()).collect()
        };
        let (centre, size) =
            (numbers(obstacle.remove("centre_m").unwrap()), numbers(obstacle.remove("size_m").unwrap()));
        assert!(obstacle.remove("rpy_deg").is_none());
        let ends = |sign: f64| [0, 1, 2].map(|axis| centre[axis] + 0.5 * sign * size[axis]);
        let (points, triangles) = meshes::cuboid(ends(-1.0), ends(1.0));
        // With y up, and the binary part in a file of its own, which is named as in a link.
        let points: Vec<[f64; 3]> = points.iter().map(|[x, y, z]| [*x, *z, -*y]).collect();
        let glb = meshes::glb(&points, &triangles, "");
        let json = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
        let text = String::from_utf8(glb[20..20 + json].to_vec()).unwrap();
        let uri = format!("\"buffers\":[{{\"uri\":\"the%20fence{number}.bin\",");
        write(&folder, &format!("cad/fence{number}.gltf"), &text.replace("\"buffers\":[{", &uri));
        std::fs::write(folder.join(format!("cad/the fence{number}.bin")), &glb[28 + json..]).unwrap();
        let mesh: toml::Table = format!("file = \"cad/fence{number}.gltf\"").parse().unwrap();
        obstacle.insert("mesh".to_owned(), mesh.into());
    }
    write(&folder, "by-file.toml", &toml::to_string(&table).unwrap());
    let scan = |cell: &str, out: &str| {
        let arguments = ["scan", "--no-advice", cell, "--out", out, "--iterations", "30", "--strategy", "mcts-dpw"];
        fmi_hazard(&folder).args(arguments).assert().code(1);
        scan_json(&folder.join(out))
    };
    fmi_hazard(&folder).args(["pack", "by-file.toml", "--out", "packed.fmu"]).assert().code(0);
    let scans = [scan("cell.toml", "hand"), scan("by-file.toml", "file"), scan("packed.fmu", "packed")];
    let files = scans[1]["subject"]["files"].as_array().unwrap();
    let paths: Vec<&str> = files.iter().map(|file| file["path"].as_str().unwrap()).collect();
    assert_eq!(paths[..2], ["cad/fence0.gltf", "cad/the fence0.bin"]);
    assert_eq!(scans[1]["subject"]["files"], scans[2]["subject"]["files"]);
    assert!(!scans[0]["hazards"].as_array().unwrap().is_empty());
    scans[1..].iter().for_each(|other| assert_same_hazards(&scans[0], other));
}

#[test]
fn damaged_files_are_refused_and_never_panic() {
    let dir = tempfile::TempDir::new().unwrap();
    let (points, triangles) = meshes::cuboid([0.0; 3], [1.0; 3]);
    let good = meshes::glb(&points, &triangles, "");
    let text = obstacle("file = \"a.glb\"");
    let with = |bytes: &[u8]| {
        std::fs::write(dir.path().join("a.glb"), bytes).unwrap();
        cell(dir.path(), &text)
    };
    assert!(with(&good).is_ok());
    let mut refused = 0;
    for at in 0..good.len() {
        for value in [0, 0x20, 0x39, 0xff, good[at] ^ 1] {
            let mut bytes = good.clone();
            bytes[at] = value;
            refused += usize::from(with(&bytes).is_err());
        }
        refused += usize::from(with(&good[..at]).is_err());
    }
    assert!(refused > good.len(), "{refused}");
    let changed = |from: &str, to: &str| {
        let json = u32::from_le_bytes([good[12], good[13], good[14], good[15]]) as usize;
        let text = String::from_utf8(good[20..20 + json].to_vec()).unwrap();
        assert!(text.contains(from));
        let mut bytes = good.clone();
        let text = text.replace(from, to);
        let text = format!("{text:<width$}", width = text.len().next_multiple_of(4));
        bytes.splice(20..20 + json, text.bytes());
        bytes[12..16].copy_from_slice(&u32::try_from(text.len()).unwrap().to_le_bytes());
        let length = u32::try_from(bytes.len()).unwrap();
        bytes[8..12].copy_from_slice(&length.to_le_bytes());
        with(&bytes).unwrap_err()
    };
    for (from, to, words) in [
        ("\"mode\":4", "\"mode\":5", "`thing` has TriangleStrip; only triangles are read"),
        ("\"mode\":4", "\"mode\":1", "`thing` has Lines; only triangles are read"),
        ("{\"asset\"", "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\"", "without compression"),
        ("\"count\":36", "\"count\":360", "its data end too early"),
        ("\"componentType\":5126", "\"componentType\":5123", "not three 32-bit"),
        ("\"buffers\":[{", "\"buffers\":[{\"uri\":\"no.bin\",", "cannot read no.bin"),
        ("\"buffers\":[{", "\"buffers\":[{\"uri\":\"https://a.b/c.bin\",", "which is not fetched"),
        ("\"mesh\":0", "\"mesh\":0,\"children\":[0]", "is in the scene twice"),
        (
            "\"type\":\"VEC3\"",
            "\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":0,\"componentType\":5125},\
             \"values\":{\"bufferView\":1}}",
            "sparse accessors are not read",
        ),
    ] {
        let told = changed(from, to);
        assert!(told.contains(words) && told.starts_with("20: "), "{told}");
    }
}
