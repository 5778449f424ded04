//! A hazard explained: what happens in plain words, the force with its formula, numbers and sources, the safe speed, and
//! what came of changes of the cell.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use super::does::moves;
use crate::human::{Action, Who};
use crate::standards::iso_ts_15066 as limits;
use crate::standards::provenance::Table;
use crate::standards::tables::tables;
use fmi_hazard_record::advice::{self, RiskReduction};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::STANDARD_EDITION;
use fmi_hazard_record::operated::OperatedControl;
use fmi_hazard_record::paragraph::{wrapped, wrapped_under};
use fmi_hazard_record::people::SecondRecord;

/// Everything that is told about a hazard.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Explanation {
    /// The hazard.
    pub hazard: Hazard,
    /// Where the person starts, floor plan, m, and looks, degrees from +x towards +y.
    pub start: ([f64; 2], f64),
    /// A second person, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub second: Option<SecondRecord>,
    /// When the person starts, s after the FMU.
    pub begins_s: f64,
    /// Duration of an action, s.
    pub action_s: f64,
    /// What the sensors report on the way.
    pub sensors: Vec<Reports>,
    /// How far the person stands outside the zones of sensors that do not report anybody.
    pub outside: Vec<Outside>,
    /// The robot that hits.
    pub robot: Robot,
    /// What was tried against it; empty if nothing was.
    pub remedies: Vec<RiskReduction>,
}

/// What a sensor reports on the way.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Reports {
    /// Its name.
    pub name: String,
    /// Times at which it begins and ends to report the person, s; it begins with "clear".
    pub changes_s: Vec<f64>,
}

/// A person outside a zone.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Outside {
    /// The sensor.
    pub name: String,
    /// From the middle between the feet to the zone's edge, m.
    pub distance_m: f64,
}

/// The robot that hits.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Robot {
    /// Its name.
    pub name: String,
    /// Mass of its moving parts, kg.
    pub moving_mass_kg: f64,
    /// Where that is said.
    pub mass_from: String,
}

/// Tables whose figures are in the formula.
const BEHIND: [&str; 3] = ["iso_ts_15066_force_limits", "iso_ts_15066_springs_and_masses", "iso_ts_15066_formulas"];

impl Explanation {
    /// For people: what came of changes.
    #[must_use]
    pub fn render_changes(&self) -> String {
        let told = self.look_at_controls() + &advice::render(&self.remedies);
        if self.hazard.begins.is_none() || self.remedies.is_empty() {
            return told;
        }
        let only = "Changes were held against walks from where this hazard begins, and against what is known of the scan's other \
                    hazards: look at the changed cell from anywhere again.";
        told + &wrapped(only, "   ")
    }

    /// What to look at first where a control is worked on the way: no change of a safeguard or of a parameter stands for it.
    fn look_at_controls(&self) -> String {
        let mut names: Vec<&str> = Vec::new();
        for working in &self.hazard.worked {
            if !names.contains(&working.control.name.as_str()) {
                names.push(&working.control.name);
            }
        }
        if names.is_empty() {
            return String::new();
        }
        let text = format!(
            "This way leads over {}. Look there first: out of reach from inside, in view of all of the cell, or without effect while \
             somebody is inside. Other changes below were held against the times of this scan only: a robot that starts more slowly \
             may merely come later.",
            names.join(" and ")
        );
        format!("\n Controls\n{}", wrapped(&text, "   "))
    }

    /// For people: all but the changes.
    #[must_use]
    pub fn render_hazard(&self) -> String {
        let hazard = &self.hazard;
        let mut out = format!(
            "{}  {} <- {}  {:.2}x{}\n\n What happens\n",
            hazard.id,
            hazard.body_region,
            hazard.robot_link,
            hazard.ratio,
            if hazard.body_region.permits_no_contact() && hazard.class.beside_force().is_none() {
                " (contact there is not allowed at all)"
            } else {
                ""
            }
        );
        let mut say = |text: &str| out += &wrapped(text, "   ");
        let ([x, y], heading) = self.start;
        let when = if self.begins_s > 0.0 { format!(" {:.2} s after the FMU,", self.begins_s) } else { String::new() };
        let person = self.second.as_ref().map_or("The person", |second| &second.names[0]);
        let begins = format!("starts{when} at ({x:.2}, {y:.2}) m, looking towards {heading:.0} degrees");
        match &self.second {
            None => say(&format!("{person} {begins}, and then")),
            Some(SecondRecord { names, xy_m: [x, y], heading_deg, .. }) => say(&format!(
                "{person} {begins}, {} at ({x:.2}, {y:.2}) m, looking towards {heading_deg:.0} degrees, and then",
                names[1]
            )),
        }
        let names = self.second.as_ref().map(|second| &second.names);
        for (from, line) in steps(&hazard.actions, &hazard.worked, names, self.action_s) {
            say(&format!("{from:5.2} s  {line}"));
        }
        for sensor in &self.sensors {
            let whom = if self.second.is_some() { "somebody" } else { "the person" };
            say(&format!("{} {}.", sensor.name, sensor.words(whom)));
        }
        say(&hazard.meeting_words());
        for outside in &self.outside {
            say(&format!("That is {:.2} m outside the zone of {}.", outside.distance_m, outside.name));
        }
        for through in &hazard.through {
            say(&through.words());
        }
        let other = hazard.other_criteria();
        for (title, paragraphs) in &other {
            let _ = writeln!(out, "\n {title}");
            paragraphs.iter().for_each(|text| out += &wrapped(text, "   "));
        }
        if other.is_empty() {
            self.force(&mut out);
        }
        out
    }

    fn force(&self, out: &mut String) {
        let hazard = &self.hazard;
        let region = hazard.body_region;
        let (m_r, m_h) = (hazard.effective_mass_kg, limits::effective_mass_kg(region));
        let (mu, k) = (limits::reduced_mass(m_h, m_r), limits::spring_constant_n_m(region));
        let quasi_static = limits::quasi_static_limit_n(region);
        let factor = hazard.limit_n / quasi_static;
        let half = 0.5 * self.robot.moving_mass_kg;
        let by_approach = hazard.is_by_approach();
        let speed = if by_approach { hazard.approach_m_s } else { hazard.speed_m_s };
        let _ = writeln!(out, "\n Force, after {STANDARD_EDITION}");
        let _ = writeln!(out, "   {}   limit {:.0} N   {:.2}x", hazard.force_formula(), hazard.limit_n, hazard.ratio);
        let rows = [
            (
                "v",
                format!("{speed:.3} m/s"),
                if by_approach {
                    format!(
                        "speed of approach, the person's walking included, as the cell file asks; with the robot's own speed, \
                         {:.3} m/s, it would be {:.0} N",
                        hazard.speed_m_s, hazard.force_n
                    )
                } else {
                    format!(
                        "absolute speed of the robot's point, from the FMU; with the speed of approach alone, {:.3} m/s, it \
                         would be {:.0} N",
                        hazard.approach_m_s, hazard.directed_force_n
                    )
                },
            ),
            (
                "m_R",
                format!("{m_r:.2} kg"),
                format!(
                    "effective mass of {} (A.4): half of M = {:.2} kg ({}) and {:.2} kg of tool and workpiece",
                    self.robot.name,
                    self.robot.moving_mass_kg,
                    self.robot.mass_from,
                    m_r - half
                ),
            ),
            ("m_H", format!("{m_h:.2} kg"), format!("effective mass of the {} (Table A.3)", region.words())),
            ("mu", format!("{mu:.3} kg"), "reduced mass, 1 / (1/m_H + 1/m_R) (A.3)".to_owned()),
            ("k", format!("{:.0} kN/m", k / 1000.0), format!("spring constant of the {} (Table A.3)", region.words())),
            (
                "limit",
                format!("{:.0} N", hazard.limit_n),
                if region.permits_no_contact() {
                    format!(
                        "quasi-static, {quasi_static:.0} N (Table A.2); for ranking only: contact with a moving robot is \
                         not allowed there (A.3.2, 5.5.5)"
                    )
                } else {
                    format!("transient: {factor:.0} x {quasi_static:.0} N (Tables A.2 and A.4)")
                },
            ),
        ];
        for (symbol, value, what) in rows {
            *out += &wrapped_under(&format!("   {symbol:<6}{value:<11}"), &what);
        }
        if let Some(text) = hazard.reflected_mass_kg.map(|kg| reflected(kg, m_r)) {
            *out += &wrapped_under("   ", &text);
        }
        for Table { title, source, verified, .. } in tables().filter(|table| BEHIND.contains(&table.id)) {
            let state = if verified { "verified" } else { "not yet verified against the purchased standard" };
            *out += &wrapped_under("   from  ", &format!("{title}: {source}; {state}"));
        }
        let _ = writeln!(out, "\n {}", hazard.safe_speed_words());
    }
}

/// What the robot weighs at a contact by inertias and pose, beside the mass that decides.
fn reflected(reflected_kg: f64, effective_kg: f64) -> String {
    let decides = format!("M/2 + payload, which decides, is {effective_kg:.0} kg");
    if reflected_kg.is_finite() {
        let kg = if reflected_kg < 9.5 { format!("{reflected_kg:.1}") } else { format!("{reflected_kg:.0}") };
        return format!(
            "By the links' inertias and the pose the robot weighs {kg} kg at this point in this direction; {decides}."
        );
    }
    format!("By the links' joints the robot cannot give way at this point in this direction in this pose; {decides}.")
}

impl Reports {
    /// For people; a sensor does not tell which of two it reports.
    fn words(&self, whom: &str) -> String {
        if self.changes_s.is_empty() {
            return "reports nobody on the way".to_owned();
        }
        let word = |(number, time): (usize, &f64)| match number % 2 {
            0 => format!("reports {whom} from {time:.2} s"),
            _ => format!("nobody from {time:.2} s"),
        };
        self.changes_s.iter().enumerate().map(word).collect::<Vec<_>>().join(", ")
    }
}

/// Equal actions together, with the time at which they begin.
fn steps(
    actions: &[Action],
    worked: &[OperatedControl],
    names: Option<&[String; 2]>,
    action_s: f64,
) -> Vec<(f64, String)> {
    let turns = |action: &Action| Who::ALL.into_iter().any(|who| action.of(who).walk().turn_eighths() != 0);
    let mut steps: Vec<(usize, usize, Action)> = Vec::new();
    for (number, action) in actions.iter().enumerate() {
        match steps.last_mut() {
            // A turn is made once each time, and what is worked is told each time.
            Some((_, times, last)) if last == action && action.presses().is_none() && !turns(action) => *times += 1,
            _ => steps.push((number, 1, *action)),
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "a few actions")]
    let told = |(first, times, action): (usize, usize, Action)| {
        let (from, lasts) = (first as f64 * action_s, times as f64 * action_s);
        let meanwhile = worked.iter().filter(|working| (working.at_s - from).abs() < 0.5 * action_s);
        let meanwhile: String = meanwhile.map(|working| format!("; {}", working.words())).collect();
        (from, format!("{}, for {lasts:.1} s{meanwhile}", moves(action, names)))
    };
    steps.into_iter().map(told).collect()
}
