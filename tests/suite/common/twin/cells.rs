//! The cells that are looked at: examples with another start, and small ones around the gantry FMU.

use std::path::{Path, PathBuf};

/// An example with these texts replaced, written beside its FMU.
pub fn example(dir: &Path, name: &str, changes: &[(&str, &str)]) -> PathBuf {
    let mut text = std::fs::read_to_string(dir.join(name).join("cell.toml")).expect("an example");
    for (old, new) in changes {
        assert!(text.contains(old), "{name} has no {old}");
        text = text.replace(old, new);
    }
    let file = dir.join(name).join("twice.toml");
    std::fs::write(&file, text).expect("a file can be written");
    file
}

/// A cell with the gantry: two slides along x, the second on the first.
pub struct Gantry {
    /// Where both slides begin.
    pub base: [f64; 3],
    /// Stroke, speed and phase of each slide.
    pub slides: [[f64; 3]; 2],
    /// Name, slide (1 or 2), centre, half length along x, radius.
    pub links: &'static [(&'static str, u8, [f64; 3], f64, f64)],
    /// Moving mass, kg; there is no payload.
    pub mass: f64,
    /// Further tables: obstacles, sensors.
    pub tables: &'static str,
    /// Further parameters.
    pub parameters: &'static str,
    pub start: [f64; 2],
    pub begins: f64,
    pub actions: u32,
    /// Whether the speed of approach decides.
    pub approach: bool,
    /// How far what is held reaches beyond the finger tips; 0 for nothing.
    pub held: f64,
}

impl Gantry {
    pub fn write(&self, dir: &Path) -> PathBuf {
        std::fs::copy(crate::common::test_fmus().join("gantry.fmu"), dir.join("gantry.fmu")).expect("a copy");
        let file = dir.join("cell.toml");
        std::fs::write(&file, self.text()).expect("a file can be written");
        file
    }

    fn text(&self) -> String {
        let Self { base, slides, links, mass, tables, parameters, start, begins, actions, approach, held } = self;
        let held = if *held > 0.0 { format!("held_m = {held:?}\n") } else { String::new() };
        let criterion = if *approach { "[criteria]\ntransient_force = \"approach\"\n" } else { "" };
        let [mut joints, mut shapes, mut motion] = [const { String::new() }; 3];
        for (i, [stroke, speed, phase]) in (1..).zip(slides) {
            joints += &format!(
                "[[robot.joint]]\nname = \"slide_{i}\"\naxis = [1, 0, 0]\nposition = {{ variable = \"axis.position[{i}]\" }}\n\
                 speed = {{ variable = \"axis.velocity[{i}]\" }}\n"
            );
            motion += &format!(
                "\"axis.stroke[{i}]\" = {stroke:?}\n\"axis.speed[{i}]\" = {speed:?}\n\"axis.phase0[{i}]\" = {phase:?}\n"
            );
        }
        for (name, slide, [x, y, z], half, radius) in *links {
            shapes += &format!(
                "[[robot.link]]\nname = \"{name}\"\njoint = \"slide_{slide}\"\n\
                 capsule = {{ from_m = [{:?}, {y:?}, {z:?}], to_m = [{:?}, {y:?}, {z:?}], radius_m = {radius:?} }}\n",
                x - half,
                x + half
            );
        }
        format!(
            "schema = 1\nname = \"gantry\"\nfmu = \"gantry.fmu\"\n[time]\nstep_s = 0.02\n[[robot]]\nname = \"gantry\"\n\
             base = {{ xyz_m = {base:?} }}\nmoving_mass_kg = {mass:?}\npayload_kg = 0\nphase = \"ctrl.leg\"\n{joints}{shapes}{tables}\n\
             [parameters]\n{motion}{parameters}\n[inputs]\n\"plc.reset\" = false\n\
             [human]\nstart = {{ xy_m = {start:?}, heading_deg = 90 }}\nbegins_s = [{begins:?}]\n{held}[search]\nactions = {actions}\n{criterion}"
        )
    }
}

/// Nobody gets past it; arms and trunk pass over it.
const LOW_WALL: &str = "[[obstacle]]\nname = \"low wall\"\ncentre_m = [0, 0, 0.4]\nsize_m = [6, 0.02, 0.8]\n";

/// A slow link deep in the trunk, and a faster one just at the thighs: too fast for thighs, not for arms.
pub fn slow_and_fast_at_the_body() -> Gantry {
    Gantry {
        base: [-0.5, 0.0, 0.0],
        slides: [[2.0, 0.2, 0.0], [2.0, 0.3, 0.0]],
        links: &[("slow", 1, [0.3, 0.0, 1.1], 0.6, 0.15), ("fast", 2, [0.3, 0.06, 0.7], 0.3, 0.08)],
        mass: 200.0,
        tables: "",
        parameters: "",
        start: [0.0, -0.5],
        begins: 0.0,
        actions: 2,
        approach: false,
        held: 0.0,
    }
}

/// Two links so low that no hand gets there, in front of a wall that stops who walks. The fast one is too fast for legs: it
/// comes towards those on its way, and draws back from others. The slow one is not, but who walks into it is too fast.
pub fn comes_and_draws_back() -> Gantry {
    Gantry {
        base: [-0.15, 0.0, 0.15],
        slides: [[2.0, 0.1, 0.0], [2.0, 0.4, 0.0]],
        links: &[("slow", 1, [0.5, -0.45, 0.0], 0.0, 0.08), ("fast", 2, [0.0, 0.0, 0.0], 0.0, 0.08)],
        mass: 20.0,
        tables: "[[obstacle]]\nname = \"low wall\"\ncentre_m = [0, 0.1, 0.4]\nsize_m = [6, 0.02, 0.8]\n",
        parameters: "",
        start: [0.0, -0.5],
        begins: 0.0,
        actions: 3,
        approach: false,
        held: 0.0,
    }
}

/// A link at 1.2 m/s: a hand bears it, no other part of an arm does.
pub fn too_fast_for_limbs() -> Gantry {
    Gantry {
        base: [-0.9, 0.0, 0.0],
        slides: [[3.0, 1.2, 0.0], [0.0, 0.0, 0.0]],
        links: &[("tool", 1, [0.0, 0.45, 1.05], 0.0, 0.08)],
        mass: 200.0,
        tables: LOW_WALL,
        parameters: "",
        start: [0.0, -0.5],
        begins: 0.0,
        actions: 2,
        approach: false,
        held: 0.0,
    }
}

/// The same, twice as fast, where no hand reaches, but a rod that it holds.
pub fn within_reach_of_a_rod() -> Gantry {
    let links = &[("tool", 1, [0.0, 0.97, 1.05], 0.0, 0.08)];
    let slides = [[3.0, 2.4, 0.0], [0.0, 0.0, 0.0]];
    Gantry { links, slides, held: 0.3, ..too_fast_for_limbs() }
}

/// The same where hands reach well, and of the limbs only the last of the forearm, beside the wrist.
pub fn too_fast_for_the_end_of_a_forearm() -> Gantry {
    let links = &[("tool", 1, [0.0, 0.7, 1.05], 0.0, 0.08)];
    Gantry { base: [-1.2, 0.0, 0.0], slides: [[3.0, 1.25, 0.0], [0.0, 0.0, 0.0]], links, ..too_fast_for_limbs() }
}

/// A slow tube, and in it a link at 1.6 m/s, which a hand does not bear: the tube is always deeper in the hand.
pub fn fast_within_slow() -> Gantry {
    Gantry {
        base: [-0.9, 0.0, 0.0],
        slides: [[2.0, 0.2, 0.0], [3.0, 1.4, 0.2]],
        links: &[("tube", 1, [0.8, 0.5, 1.1], 1.6, 0.15), ("tool", 2, [0.0, 0.5, 1.1], 0.0, 0.04)],
        mass: 200.0,
        tables: LOW_WALL,
        parameters: "",
        start: [0.0, -0.5],
        begins: 0.0,
        actions: 2,
        approach: false,
        held: 0.0,
    }
}

const CURTAIN: &str = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\n\
     zone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }\nvariable = \"plc.curtain_clear\"\nactive = false\n";
const DOOR: &str = "[[sensor]]\nname = \"door\"\nkind = \"interlocked_door\"\n\
     zone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }\nvariable = \"plc.door_clear\"\nactive = false\n";
const DOOR_AND_CURTAIN: &str = "[[sensor]]\nname = \"door\"\nkind = \"interlocked_door\"\n\
     zone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }\nvariable = \"plc.door_clear\"\nactive = false\n\
     [[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\n\
     zone = { line_m = [[-3, 0.25], [3, 0.25]], heights_m = [0, 2.6] }\nvariable = \"plc.curtain_clear\"\nactive = false\n";

/// A tool at 2 m/s along x that passes in front of the entrance after 0.5 s, behind a plane.
const fn behind_a_plane(tables: &'static str, parameters: &'static str) -> Gantry {
    Gantry {
        base: [-2.2, 0.0, 0.0],
        slides: [[4.4, 2.0, 0.55], [0.0, 0.0, 0.0]],
        links: &[("tool", 1, [0.0, 0.95, 1.1], 0.0, 0.1)],
        mass: 120.0,
        tables,
        parameters,
        start: [0.0, -0.5],
        begins: 0.0,
        actions: 3,
        approach: false,
        held: 0.0,
    }
}

/// The curtain is muted for so long that the person has passed it; then it is in force again.
pub const fn palletiser() -> Gantry {
    const PARAMETERS: &str = "\"plc.latched\" = true\n\"muting.from_ms\" = 0\n\"muting.to_ms\" = 380\n\
         \"plc.reaction_ms\" = 20\n\"plc.ramp_ms\" = 100\n";
    let slides = [[4.4, 2.0, 0.0], [0.0, 0.0, 0.0]];
    Gantry { base: [-1.1, 0.0, 0.0], slides, start: [0.0, -0.35], ..behind_a_plane(CURTAIN, PARAMETERS) }
}

/// A curtain that the FMU evaluates itself, from where the person is; it is told of arms, and of who bends into it. Its stop is not
/// latched: who is through it meets the tool again.
pub const fn curtain_inside() -> Gantry {
    const EVALUATED: &str = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\n\
         zone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }\nvariable = \"plc.curtain_clear\"\nactive = false\n\
         evaluated = { variable = \"curtain.interrupted\", active = true }\n[pose]\ny = \"person.y\"\n";
    const PARAMETERS: &str = "\"plc.latched\" = false\n\"plc.reaction_ms\" = 20\n\"plc.ramp_ms\" = 100\n\
         \"curtain.own_depth\" = 0.137\n";
    Gantry { start: [0.0, -0.35], ..behind_a_plane(EVALUATED, PARAMETERS) }
}

/// The stop ends when the door is clear again, behind the person.
pub const fn door_that_does_not_latch() -> Gantry {
    Gantry {
        start: [0.0, -0.35],
        ..behind_a_plane(DOOR, "\"plc.latched\" = false\n\"plc.reaction_ms\" = 20\n\"plc.ramp_ms\" = 100\n")
    }
}

/// A tool behind a door whose stop comes late, soon out of reach; nobody's body gets as far in one action, hands do that
/// begin at once.
pub const fn behind_a_door(parameters: &'static str) -> Gantry {
    let cell = behind_a_plane(DOOR, parameters);
    let links = &[("tool", 1, [0.0, 0.3, 1.0], 0.0, 0.1)];
    let slides = [[2.0, 2.0, 0.0], [0.0, 0.0, 0.0]];
    Gantry { base: [-0.2, 0.0, 0.0], slides, links, start: [0.0, -0.9], actions: 1, ..cell }
}

/// A curtain 0.25 m behind a door, and a stop that comes late.
pub const fn curtain_behind_a_door() -> Gantry {
    Gantry {
        base: [-1.57, 0.0, 0.0],
        slides: [[3.2, 3.0, 0.03], [0.0, 0.0, 0.0]],
        links: &[("tool", 1, [0.0, 0.45, 1.1], 0.0, 0.08)],
        start: [0.0, -0.3],
        actions: 2,
        ..behind_a_plane(DOOR_AND_CURTAIN, "\"plc.latched\" = true\n\"plc.reaction_ms\" = 200\n\"plc.ramp_ms\" = 200\n")
    }
}
