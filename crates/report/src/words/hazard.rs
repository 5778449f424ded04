//! What the page says of a hazard.

use serde::Serialize;

use crate::hazard::Class;
use fmi_hazard_record::figures::{grouped, plural};
use fmi_hazard_record::hazard::{Hazard, SensorState, Through};
use fmi_hazard_record::headline::confirmed_words;
use fmi_hazard_record::judged::{LimitKind, NONE_ALLOWED, measure_cell};
use fmi_hazard_record::operated::OperatedControl;

/// Of one hazard.
#[derive(Serialize)]
pub(super) struct HazardWords {
    /// What the robot does to whom: "tool hits the hand".
    deed: String,
    /// How bad it is, and after what time.
    way: String,
    /// Its row in the table: ratio, force with the robot's own speed, with that of approach, limit, what is broken, speed, the speed below
    /// which it is safe, time, how often it was found, which sensors report, whether it is confirmed.
    row: [String; 11],
    /// What happens.
    what: String,
    /// Where the person looks, and how far they bend.
    person: String,
    /// Where and when its sequence begins, where that is not where the scan did.
    #[serde(skip_serializing_if = "Option::is_none")]
    begins: Option<String>,
    /// Both forces, where one of them decides, and the number of that.
    #[serde(skip_serializing_if = "Option::is_none")]
    forces: Option<([String; 2], usize)>,
    /// That they are far apart.
    #[serde(skip_serializing_if = "Option::is_none")]
    apart: Option<String>,
    /// What is broken by another criterion, and what the force would be.
    #[serde(skip_serializing_if = "Option::is_none")]
    broken: Option<[String; 3]>,
    /// The formula with its numbers.
    computed: String,
    /// Planes that the arm went past.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    through: Vec<String>,
    /// What the sensors say then.
    sensors: String,
    /// How often and when it was found.
    found: String,
    /// Its shortest sequence.
    shortest: String,
    /// What comes at last, in a word.
    event: &'static str,
    /// That the link came to rest.
    rests: String,
    /// Controls that are worked on the way, in order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    worked: Vec<String>,
}

impl HazardWords {
    pub(super) fn of(hazard: &Hazard) -> Self {
        let by_force = hazard.class.beside_force().is_none();
        let apart = hazard.class == Class::Separation;
        Self {
            deed: deed(hazard),
            way: format!("{:.2}x after {:.2} s", hazard.ratio, hazard.time_s),
            row: row(hazard),
            what: hazard.meeting_words(),
            person: person(hazard),
            begins: hazard.begins.map(|begins| format!("{}; times count from then", begins.words())),
            forces: by_force.then(|| (hazard.both_forces(), usize::from(hazard.is_by_approach()))),
            apart: hazard.apart_words(),
            broken: (!by_force).then(|| broken(hazard)),
            computed: computed(hazard),
            through: hazard.through.iter().map(Through::words).collect(),
            sensors: sensors(hazard),
            found: found(hazard),
            shortest: shortest(hazard),
            event: if apart { "too near" } else { "contact" },
            rests: format!("{} stands still", hazard.robot_link),
            worked: hazard.worked.iter().map(OperatedControl::words).collect(),
        }
    }
}

/// What the robot does to the part of the body: "clamps the hand against table".
fn deed(hazard: &Hazard) -> String {
    let of = hazard.person.as_ref().map_or_else(String::new, |person| format!(" of {person}"));
    let hit = format!("{}{of}", hazard.struck_words());
    let does = match hazard.class {
        Class::Clamping => {
            let against = hazard.clamping().map_or_else(String::new, |by| format!(" against {}", by.against));
            format!("clamps the {hit}{against}")
        }
        Class::Pressure => format!("presses the {hit}"),
        Class::MovingContact => format!("touches the {hit} while it moves"),
        Class::Separation => format!("is too near the {hit}"),
        Class::Force | Class::HeadContact => format!("hits the {hit}"),
    };
    format!("{} {does}", hazard.robot_link)
}

fn row(hazard: &Hazard) -> [String; 11] {
    let newtons = |force_n: f64| format!("{force_n:.0} N");
    let figures = (hazard.deciding_force_n(), hazard.deciding_limit_n(), hazard.speed_m_s);
    [
        format!("{:.2}x", hazard.ratio),
        newtons(hazard.force_n),
        newtons(hazard.directed_force_n),
        if hazard.class == Class::HeadContact { NONE_ALLOWED.to_owned() } else { newtons(hazard.limit_n) },
        measure_cell(hazard.class, hazard.judged.as_ref(), figures),
        format!("{:.2} m/s", hazard.speed_m_s),
        hazard.safe_words(),
        format!("{:.2} s", hazard.time_s),
        hazard.sequences.as_ref().map_or_else(|| grouped(&hazard.times_found.to_string()), |number| grouped(number)),
        reporting(&hazard.sensors),
        confirmed_words(hazard.confirmed).to_owned(),
    ]
}

/// Sensors that report the person, and for how long they have.
fn reporting(sensors: &[SensorState]) -> String {
    let one = |sensor: &SensorState| match sensor.since_s {
        Some(since_s) => format!("{} {since_s:.2} s", sensor.name),
        None => sensor.name.clone(),
    };
    let all: Vec<String> = sensors.iter().filter(|sensor| sensor.person_detected).map(one).collect();
    if all.is_empty() { "none".to_owned() } else { all.join(", ") }
}

fn person(hazard: &Hazard) -> String {
    let bend = match hazard.bend_fraction {
        all if all >= 1.0 => String::new(),
        part => format!(", bent as far as obstacles leave it ({:.0} %)", 100.0 * part),
    };
    format!("looking towards {:.0} degrees{bend}", hazard.person_heading_deg.rem_euclid(360.0))
}

/// How bad it is, by what figures, and what the transient force would be.
fn broken(hazard: &Hazard) -> [String; 3] {
    let [worst, figures] = hazard.measured().worst_first();
    let beside = match hazard.class {
        Class::Separation => String::new(),
        _ => format!(
            "On somebody who can give way: {:.0} N, {:.2}x the limit.",
            hazard.force_n,
            hazard.force_n / hazard.limit_n
        ),
    };
    [worst, figures, beside]
}

/// The formula with its numbers, and what they mean.
fn computed(hazard: &Hazard) -> String {
    let mut said: Vec<String> = hazard.other_criteria().into_iter().flat_map(|(_, paragraphs)| paragraphs).collect();
    if said.is_empty() {
        said = vec![hazard.force_formula(), hazard.safe_speed_words()];
    }
    // A formula ends without a full stop.
    let sentence = |text: String| if text.ends_with(['.', ')']) { text } else { text + "." };
    said.into_iter().map(sentence).collect::<Vec<_>>().join(" ")
}

/// What they report, and for how long they have.
fn sensors(hazard: &Hazard) -> String {
    let reports = hazard.reports_words();
    let one = |sensor: &SensorState| {
        let since = sensor.since_s.map_or_else(String::new, |since_s| format!(" for {since_s:.2} s"));
        sensor.words(reports) + &since
    };
    let all: Vec<String> = hazard.sensors.iter().map(one).collect();
    if all.is_empty() { "no sensor".to_owned() } else { all.join(", ") }
}

fn found(hazard: &Hazard) -> String {
    let times = match &hazard.sequences {
        Some(number) => format!("{} sequence{}", grouped(number), if number == "1" { "" } else { "s" }),
        None => plural(usize::try_from(hazard.times_found).unwrap_or(usize::MAX), "time"),
    };
    let first = match hazard.first_iteration {
        0 => String::new(),
        number => format!("; first in iteration {number}"),
    };
    format!("{times}; earliest contact at {:.2} s{first}", hazard.earliest_time_s)
}

fn shortest(hazard: &Hazard) -> String {
    let shortest = &hazard.shortest;
    if shortest.actions == hazard.actions {
        return "the same sequence".to_owned();
    }
    let is_force = hazard.class.beside_force().is_none()
        || hazard.judged.as_ref().is_some_and(|judged| judged.limit == LimitKind::Force);
    let force = if is_force { format!(", {:.0} N", shortest.force_n) } else { String::new() };
    format!(
        "{:.2}x{force} at {:.2} s; confirmed: {}",
        shortest.ratio,
        shortest.time_s,
        confirmed_words(shortest.confirmed)
    )
}
