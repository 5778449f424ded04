//! Checks of the obstacles in a cell file: boxes, and mesh files as boxes that lie inside their parts.
//!
//! A box that is too large hides hazards, one that is too small makes false ones: so nothing is filled that a mesh does not
//! fill, and what is lost is told.

use std::path::Path;

use super::checker::{Checker, pose};
use super::described::upright;
use super::format::{CellFile, ObstacleTable, PoseTable, StaticMeshTable, UpAxis};
use crate::cell::CellError;
use crate::cell::foreign::mesh::{Mesh, ending};
use crate::cell::foreign::{gltf, mesh};
use crate::cell::workcell::{Control, Obstacle};
use crate::fmi;
use crate::geometry::boxes::{self, TooMany};
use crate::geometry::roll_pitch_yaw;
use crate::geometry::surface::{Flaw, Surface, Triangles};
use crate::geometry::{Cuboid, Vec3};
use crate::human::ControlKind;
use path_clean::clean;

type Result<T> = std::result::Result<T, Box<CellError>>;

/// Longest edge of the cells that a body is filled with, unless told otherwise, m.
const RESOLUTION_M: f64 = 0.05;

/// Most triangles of a file, and boxes that it becomes.
const MOST_TRIANGLES: usize = 500_000;
const MOST_BOXES: usize = 2000;

/// A part that is filled less than this is named.
const WELL_FILLED: f64 = 0.9;

/// Parts of a file that are named one by one in warnings.
const MOST_NAMED: usize = 10;

/// What became of a mesh.
#[derive(Default)]
struct Filled {
    boxes: Vec<Cuboid>,
    /// Volume of all closed parts, and of the boxes in them, m³.
    volume: f64,
    filled: f64,
    /// What is to be said of single parts.
    told: Vec<String>,
}

impl Checker<'_> {
    /// All boxes of a cell that has these controls, and planes or none; for each obstacle of the file, what it follows.
    pub(super) fn obstacles(
        &self,
        file: &CellFile,
        (controls, planes): (&[Control], bool),
        follows: &[Option<usize>],
    ) -> Vec<Obstacle> {
        let each = file.obstacles.iter().enumerate().map(|(number, table)| {
            let opened_by = self.opened_by(table, controls, planes)?;
            let boxes = match self.form(table)? {
                Some(mesh) => self.boxes_of(table, mesh)?.into_iter().map(|cuboid| (cuboid, None)).collect(),
                None => vec![(self.given(table)?, Some(number))],
            };
            Ok((table.name.get_ref(), boxes, (opened_by, follows.get(number).copied().flatten())))
        });
        let mut all = Vec::new();
        for (name, boxes, (opened_by, follows)) in self.problems.keep_all(each) {
            for (number, (cuboid, table)) in boxes.into_iter().enumerate() {
                let name = if number == 0 { name.clone() } else { format!("{name}/{}", number + 1) };
                all.push(Obstacle { name, cuboid, table, opened_by, follows });
            }
        }
        all
    }

    /// The control that opens the leaf of a door; none for what always stands there.
    fn opened_by(&self, table: &ObstacleTable, controls: &[Control], planes: bool) -> Result<Option<usize>> {
        let Some(opened_by) = &table.opened_by else { return Ok(None) };
        let (name, control, span) = (table.name.get_ref(), opened_by.get_ref(), opened_by.span());
        let number = controls.iter().position(|known| known.name == *control);
        self.that(number.is_some(), span.clone(), || {
            let help = format!("add [[control]] with name = \"{control}\" and kind = \"toggled\"");
            (format!("obstacle `{name}` is opened by `{control}`, which is no control"), help)
        })?;
        let toggled = number.is_some_and(|number| controls[number].kind == ControlKind::Toggled);
        self.that(toggled, span.clone(), || {
            let help = format!("give control `{control}` kind = \"toggled\": it opens the door, and then closes it");
            (format!("obstacle `{name}` is opened by `{control}`, which does not stay as it was put"), help)
        })?;
        self.that(!planes, span, || {
            let help =
                "leave opened_by out, for a leaf that stays closed; or leave the obstacle out, and the sensor tells";
            let message =
                format!("obstacle `{name}` opens, in a cell with a light curtain, a door sensor or a two-hand control");
            (message, help.to_owned())
        })?;
        Ok(number)
    }

    /// The mesh of an obstacle; none if it is a box.
    fn form<'t>(&self, table: &'t ObstacleTable) -> Result<Option<&'t StaticMeshTable>> {
        let (name, span) = (table.name.get_ref(), table.name.span());
        let given = [table.centre_m.is_some(), table.size_m.is_some()];
        let help = "a box is centre_m and size_m, a file is mesh = { file = \"...\" }";
        self.that(table.mesh.is_some() || given == [true; 2], span.clone(), || {
            (format!("obstacle `{name}` needs centre_m and size_m, or a mesh"), help.to_owned())
        })?;
        self.that(table.mesh.is_none() || given == [false; 2], span.clone(), || {
            (format!("obstacle `{name}` is a box and a mesh"), format!("remove one of the two: {help}"))
        })?;
        self.that(table.mesh.is_none() || table.rpy_deg.is_none(), span.clone(), || {
            let help = "write it as at = { rpy_deg = [...] } in the mesh".to_owned();
            (format!("rpy_deg of obstacle `{name}` is for boxes"), help)
        })?;
        self.that(table.mesh.is_some() || table.resolution_m.is_none(), span, || {
            (format!("resolution_m of obstacle `{name}` is for meshes"), "remove it".to_owned())
        })?;
        Ok(table.mesh.as_ref())
    }

    fn given(&self, o: &ObstacleTable) -> Result<Cuboid> {
        let (name, span) = (o.name.get_ref(), o.size_m.as_ref().map_or(o.name.span(), toml::Spanned::span));
        let size = o.size_m.as_ref().map_or([0.0; 3], |size| *size.get_ref());
        for edge in size {
            self.positive(edge, &span, &format!("each edge of obstacle `{name}`"))?;
        }
        let centre = o.centre_m.unwrap_or_default();
        self.finite(&centre, &span, &format!("the centre of obstacle `{name}`"))?;
        self.of_a_workshop(&[size, centre].concat(), &span, &format!("obstacle `{name}`"))?;
        let rotation = roll_pitch_yaw(o.rpy_deg.unwrap_or_default().map(f64::to_radians));
        Ok(Cuboid { centre: Vec3::from_array(centre), half: Vec3::from_array(size) * 0.5, rotation })
    }

    fn boxes_of(&self, table: &ObstacleTable, mesh: &StaticMeshTable) -> Result<Vec<Cuboid>> {
        let (name, span) = (table.name.get_ref(), mesh.file.span());
        let resolution = table.resolution_m.as_ref().map_or(RESOLUTION_M, |told| *told.get_ref());
        let place = table.resolution_m.as_ref().map_or(span.clone(), toml::Spanned::span);
        self.that((0.01..=0.2).contains(&resolution), place.clone(), || {
            (
                format!("resolution_m of obstacle `{name}` is {}", fmi::number(resolution)),
                "use 0.01 to 0.2 m".to_owned(),
            )
        })?;
        let PoseTable { xyz_m, rpy_deg } = mesh.at;
        self.finite(&[xyz_m, rpy_deg].concat(), &span, &format!("where obstacle `{name}` is"))?;
        let parts = self.parts(mesh)?;
        let triangles: usize = parts.iter().map(|(_, part)| part.triangles.len()).sum();
        self.that(triangles <= MOST_TRIANGLES, span.clone(), || {
            let message = format!("the mesh has {triangles} triangles; up to {MOST_TRIANGLES} are read");
            (message, "make it coarser, or export what a person can touch alone".to_owned())
        })?;
        let count = parts.len();
        let corners = parts.iter().flat_map(|(_, part)| part.points.iter().flat_map(|point| point.to_array()));
        self.of_a_workshop(&corners.collect::<Vec<_>>(), &span, &format!("the mesh of obstacle `{name}`"))?;
        let filled = filled(parts, resolution).map_err(|TooMany| {
            let message = format!("the mesh takes more than {MOST_BOXES} boxes, or too many cells, at {resolution} m");
            let help = "a larger resolution_m; or export what a person can touch alone, and without roundings";
            self.source.error(place, "here", message, Some(help.to_owned()))
        })?;
        self.tell(name, &mesh.file, count, &filled);
        self.that(!filled.boxes.is_empty(), span, || {
            let why = filled.told.first().cloned().unwrap_or_else(|| "it has no triangles".to_owned());
            let help = "give the obstacle as boxes: centre_m and size_m; or close its surfaces in CAD".to_owned();
            (format!("nothing of the mesh can be taken: {why}"), help)
        })?;
        Ok(filled.boxes)
    }

    /// What became of a file, and of parts of it.
    fn tell(&self, name: &str, file: &toml::Spanned<String>, parts: usize, filled: &Filled) {
        let mut warnings = self.warnings.borrow_mut();
        let share = match filled.volume > 0.0 {
            true => format!(", which fill {:.1} % of its volume", 100.0 * filled.filled / filled.volume),
            false => String::new(),
        };
        let (boxes, file) = (filled.boxes.len(), file.get_ref());
        warnings.push(format!("obstacle `{name}`: {file} has {parts} parts and is taken as {boxes} boxes{share}"));
        let told = filled.told.iter().take(MOST_NAMED);
        warnings.extend(told.map(|told| format!("obstacle `{name}`: {told}")));
        if let Some(more @ 1..) = filled.told.len().checked_sub(MOST_NAMED) {
            warnings.push(format!("obstacle `{name}`: the same holds for {more} more of its parts"));
        }
    }

    /// Parts of a mesh file in the world, m, with what they are called.
    fn parts(&self, table: &StaticMeshTable) -> Result<Vec<(String, Triangles)>> {
        let span = table.file.span();
        let path = clean(table.file.get_ref());
        let is_gltf = ["gltf", "glb"].contains(&ending(&path).as_str());
        let metres_per_unit = match table.metres_per_unit {
            Some(told) => told,
            None if is_gltf => 1.0,
            None => {
                let message = format!("{} does not say its unit", path.display());
                let help = "add metres_per_unit: 0.001 for a file in millimetres".to_owned();
                return Err(self.source.error(span, "of this file", message, Some(help)));
            }
        };
        self.positive(metres_per_unit, &span, "metres_per_unit")?;
        let up = table.up.unwrap_or(if is_gltf { UpAxis::Y } else { UpAxis::Z });
        let read = self.meshes(&path, is_gltf).map_err(|message| {
            let help = "the path is relative to the cell file; STL, OBJ, glTF and GLB are read".to_owned();
            self.source.error(span.clone(), "named here", message, Some(help))
        })?;
        let place = pose(&table.at);
        let mut parts = Vec::new();
        for (name, mesh) in read {
            let merged = Triangles::merged(&mesh.points, &mesh.triangles);
            for part in boxes::parts(&merged) {
                let name = if name.is_empty() { String::new() } else { format!(" of {name}") };
                let part = part.mapped(|point| place * upright(point, metres_per_unit, up));
                parts.push((format!("part {}{name}", parts.len() + 1), part));
            }
        }
        let far =
            |part: &Triangles| part.points.iter().any(|point| !point.is_finite() || point.abs().max_element() > 1e4);
        self.that(parts.iter().all(|(_, part)| !far(part)), span, || {
            let help = "look at metres_per_unit: 0.001 for a file in millimetres".to_owned();
            ("the mesh is more than 10 km away".to_owned(), help)
        })?;
        Ok(parts)
    }

    fn meshes(&self, path: &Path, is_gltf: bool) -> std::result::Result<Vec<(String, Mesh)>, String> {
        let read = |path: &Path| {
            let bytes = self.files.read(self.source.folder(), path);
            bytes.map_err(|error| format!("cannot read {}: {error}", path.display()))
        };
        let bytes = read(path)?;
        let named = |error: String| format!("{}: {error}", path.display());
        if !is_gltf {
            return Ok(vec![(String::new(), mesh::read(path, &bytes).map_err(named)?)]);
        }
        let beside = |uri: &str| Ok(read(&clean(path.with_file_name(uri)))?.to_vec());
        gltf::read(&bytes, &beside).map_err(named)
    }
}

/// Parts as boxes.
fn filled(parts: Vec<(String, Triangles)>, resolution: f64) -> std::result::Result<Filled, TooMany> {
    let mut all = Filled::default();
    let mut closed: Vec<(String, Triangles)> = Vec::new();
    for (name, part) in parts {
        match (boxes::as_box(&part), part.closed()) {
            (Some(cuboid), Err(_)) => all.boxes.push(cuboid),
            (_, Ok(())) => closed.push((name, part)),
            (None, Err(flaw)) => all.told.push(left_out(&name, &part, flaw)),
        }
    }
    for (name, part) in outwards(closed) {
        let volume = part.volume();
        all.volume += volume;
        if let Some(cuboid) = boxes::as_box(&part) {
            all.boxes.push(cuboid);
            all.filled += volume;
            continue;
        }
        let at = place(&part);
        let Ok(surface) = Surface::new(part) else { continue };
        let most = MOST_BOXES.saturating_sub(all.boxes.len());
        let (cuboids, filled) = boxes::inside(&surface, resolution, most)?;
        all.filled += filled;
        if cuboids.is_empty() {
            all.told.push(format!(
                "{name} ({at}) is left out: no cell of {resolution} m fits into it; give it as a box, or take a finer \
                 resolution_m"
            ));
        } else if filled < WELL_FILLED * volume {
            all.told.push(format!(
                "{name} ({at}) is filled to {:.0} %: a finer resolution_m fills more of it; what is not filled may let a \
                 person through",
                100.0 * filled / volume
            ));
        }
        all.boxes.extend(cuboids);
    }
    if all.boxes.len() > MOST_BOXES { Err(TooMany) } else { Ok(all) }
}

/// Closed parts turned outwards, hollows joined to what they are in: a part that is inside out is a hollow if it is inside
/// of another.
fn outwards(closed: Vec<(String, Triangles)>) -> Vec<(String, Triangles)> {
    let (inside_out, mut bodies): (Vec<_>, Vec<_>) = closed.into_iter().partition(|(_, part)| part.volume() < 0.0);
    if inside_out.is_empty() {
        return bodies;
    }
    let surfaces: Vec<Option<Surface>> = bodies.iter().map(|(_, part)| Surface::new(part.clone()).ok()).collect();
    for (name, part) in inside_out {
        let holds = |surface: &Option<Surface>| {
            let first = part.points.first();
            surface.as_ref().zip(first).is_some_and(|(surface, point)| surface.holds(*point))
        };
        match surfaces.iter().position(holds) {
            Some(body) => bodies[body].1.add(&part),
            None => bodies.push((name, part.turned())),
        }
    }
    bodies
}

fn left_out(name: &str, part: &Triangles, flaw: Flaw) -> String {
    let why = match flaw {
        Flaw::Open(edges) => format!("its surface is open at {edges} edges"),
        Flaw::Turned(edges) => format!("its surface is turned inside out in parts, at {edges} edges"),
        Flaw::Flat => "it holds no volume".to_owned(),
    };
    format!("{name} ({}) is left out: {why}; give it as a box, or close it in CAD", place(part))
}

/// Size and middle of a part, for messages.
fn place(part: &Triangles) -> String {
    let low = part.points.iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = part.points.iter().copied().reduce(Vec3::max).unwrap_or_default();
    let (size, middle) = (high - low, (low + high) * 0.5);
    let [x, y, z] = middle.to_array();
    format!("{:.2} x {:.2} x {:.2} m at {x:.2}, {y:.2}, {z:.2}", size.x, size.y, size.z)
}
