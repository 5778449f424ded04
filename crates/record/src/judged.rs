//! How a hazard was judged where another criterion counts than the transient force: what it breaks, by how much, and against what.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::standards::BodyRegion;
use fmi_hazard_criteria::contact::{Against, Contact};
use fmi_hazard_criteria::criterion::Class;

/// Whether the part of the body can give way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactKind {
    /// It can.
    Transient,
    /// It cannot: something holds it.
    QuasiStatic,
    /// There is no contact.
    None,
}

impl ContactKind {
    /// As in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Transient => "transient",
            Self::QuasiStatic => "quasi_static",
            Self::None => "none",
        }
    }
}

impl LimitKind {
    /// As in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Pressure => "pressure",
            Self::Motion => "motion",
            Self::Distance => "distance",
        }
    }
}

/// What the limit is one of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LimitKind {
    /// A force.
    Force,
    /// A pressure.
    Pressure,
    /// The speed of the robot's point.
    Motion,
    /// A distance.
    Distance,
}

/// How a hazard was judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Judged {
    /// All criteria that it breaks, the worst first.
    pub breaks: Vec<Class>,
    /// Whether the part of the body can give way, in what it breaks worst.
    pub contact: ContactKind,
    /// What the limit is one of that it breaks worst.
    pub limit: LimitKind,
    /// What holds the part of the body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clamping: Option<Clamping>,
    /// The pressure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<Pressure>,
    /// How near the robot is, and should not be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub separation: Option<Separation>,
}

/// What holds a part of the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Clamping {
    /// What does not give way: the floor, an obstacle, a link.
    pub against: String,
    /// Width of the gap, m.
    pub gap_m: f64,
    /// How far the robot goes on after the contact, as far as that counts, m.
    pub travel_m: f64,
    /// How fast the gap closes, m/s.
    pub closing_m_s: f64,
    /// Force on the part, N.
    pub force_n: f64,
    /// Quasi-static limit, N.
    pub limit_n: f64,
    /// Point of the robot from which the gap is measured, m.
    pub at_m: [f64; 3],
    /// Unit vector from there towards what does not give way.
    pub toward: [f64; 3],
    /// Number of the obstacle that it is, if it is one.
    #[serde(skip)]
    obstacle: Option<usize>,
}

/// A pressure and its limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Pressure {
    /// The pressure, N/cm2.
    pub n_cm2: f64,
    /// The limit, N/cm2.
    pub limit_n_cm2: f64,
    /// Whether it is that of a part that cannot give way.
    pub clamped: bool,
}

/// How near a robot is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Separation {
    /// Distance from the person, arms left out, m.
    pub distance_m: f64,
    /// Protective separation distance, m; none if the robot does not stop at all.
    pub required_m: Option<f64>,
    /// How long the robot goes on if it is stopped at that instant, s; none if it does not stand within the time that is waited.
    pub stops_after_s: Option<f64>,
    /// How far the link gets in that time at most, m.
    pub travel_m: f64,
}

impl Judged {
    /// That of a contact; nothing where only the transient force counts.
    #[must_use]
    pub(crate) fn of(contact: &Contact, class: Class, links: &[String]) -> Option<Self> {
        let beside = contact.clamp.is_some() || contact.pressure.is_some() || contact.apart.is_some();
        if !beside && class.beside_force().is_none() {
            return None;
        }
        let held = class == Class::Clamping;
        let pressure =
            contact.pressure.map(|p| Pressure { n_cm2: p.n_cm2, limit_n_cm2: p.limit_n_cm2, clamped: p.clamped });
        let by_pressure = |p: &Pressure| p.clamped && p.n_cm2 / p.limit_n_cm2 >= contact.ratio();
        let limit = match class {
            Class::Clamping if pressure.as_ref().is_some_and(by_pressure) => LimitKind::Pressure,
            Class::Force | Class::Clamping => LimitKind::Force,
            Class::Pressure => LimitKind::Pressure,
            Class::HeadContact | Class::MovingContact => LimitKind::Motion,
            Class::Separation => LimitKind::Distance,
        };
        Some(Self {
            breaks: contact.breaks(),
            contact: match class {
                Class::Separation => ContactKind::None,
                _ if held => ContactKind::QuasiStatic,
                _ => ContactKind::Transient,
            },
            limit,
            clamping: contact.clamp.map(|clamp| Clamping {
                against: match clamp.against {
                    Against::Floor => "the floor".to_owned(),
                    Against::Obstacle(number) => format!("obstacle {number}"),
                    Against::Link(link) => links[link].clone(),
                },
                gap_m: clamp.gap_m,
                travel_m: clamp.travel_m,
                closing_m_s: clamp.closing_m_s,
                force_n: clamp.force_n,
                limit_n: clamp.limit_n,
                at_m: clamp.at.to_array(),
                toward: clamp.toward.to_array(),
                obstacle: match clamp.against {
                    Against::Obstacle(number) => Some(number),
                    Against::Floor | Against::Link(_) => None,
                },
            }),
            pressure,
            separation: contact.apart.map(|apart| Separation {
                distance_m: contact.distance_m,
                required_m: apart.required_m.is_finite().then_some(apart.required_m),
                stops_after_s: apart.stops_after_s.is_finite().then_some(apart.stops_after_s),
                travel_m: apart.travel_m,
            }),
        })
    }

    /// The same with the names of obstacles.
    pub(crate) fn name_obstacles(&mut self, name: impl Fn(usize) -> String) {
        if let Some(Clamping { against, obstacle: Some(number), .. }) = &mut self.clamping {
            *against = name(*number);
        }
    }
}

/// What is broken, and by how much, in parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measure {
    /// What was measured: "270 N".
    is: String,
    /// How bad that is: "2.00x the limit"; nothing if that says it.
    beyond: String,
    /// The limit, if there is a figure: "135 N".
    limit: Option<String>,
    /// What stands between the first two.
    stop: &'static str,
}

impl Measure {
    /// Of force, limit, ratio and speed.
    #[must_use]
    pub(crate) fn of(
        class: Class,
        judged: Option<&Judged>,
        (force_n, limit_n, ratio, speed_m_s): (f64, f64, f64, f64),
    ) -> Self {
        let pressure = judged.and_then(|judged| judged.pressure);
        let separation = judged.and_then(|judged| judged.separation);
        let by_pressure = judged.is_some_and(|judged| judged.limit == LimitKind::Pressure);
        let over = |is: String, limit: String| Self {
            is,
            beyond: format!("{ratio:.2}x the limit"),
            limit: Some(limit),
            stop: ", ",
        };
        let never = |is: String| Self {
            is,
            beyond: "a moving robot may not touch it at all".to_owned(),
            limit: None,
            stop: "; ",
        };
        let plain = |is: String, beyond: String| Self { is, beyond, limit: None, stop: ", " };
        match (class, pressure, separation) {
            (Class::Clamping | Class::Pressure, Some(p), _) if by_pressure => {
                over(format!("{:.0} N/cm2", p.n_cm2), format!("{:.0} N/cm2", p.limit_n_cm2))
            }
            (Class::Force | Class::Pressure, ..) => over(format!("{force_n:.0} N"), format!("{limit_n:.0} N")),
            (Class::Clamping, ..) => {
                over(format!("{force_n:.0} N"), format!("{limit_n:.0} N for what cannot give way"))
            }
            (Class::HeadContact, ..) => never(format!("{force_n:.0} N")),
            (Class::MovingContact, ..) => never(format!("touched at {speed_m_s:.2} m/s")),
            (Class::Separation, _, Some(s)) => match s.required_m {
                Some(required) => plain(
                    format!("{:.2} m away", s.distance_m),
                    format!("{:.2} m less than {required:.2} m", required - s.distance_m),
                ),
                None => plain(format!("{:.2} m away from a robot that does not stop", s.distance_m), String::new()),
            },
            (Class::Separation, ..) => plain("too near".to_owned(), String::new()),
        }
    }

    /// In few words: "270 N, 2.00x the limit of 135 N".
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let Self { is, beyond, limit, stop } = self;
        match limit {
            _ if beyond.is_empty() => is.clone(),
            Some(limit) => format!("{is}{stop}{beyond} of {limit}"),
            None => format!("{is}{stop}{beyond}"),
        }
    }

    /// How bad it is, and the figures of that: "2.00x the limit", "270 N, limit 135 N".
    #[must_use]
    pub fn worst_first(self) -> [String; 2] {
        let Self { is, beyond, limit, stop: _ } = self;
        match limit {
            _ if beyond.is_empty() => [is, String::new()],
            Some(limit) => [beyond, format!("{is}, limit {limit}")],
            None => [beyond, is],
        }
    }
}

/// Of a region that no moving robot may touch.
pub const NO_CONTACT: &str = "no contact allowed";

/// A ratio for a region; below 1 it would read as harmless where no contact is allowed.
#[must_use]
pub fn ratio_words(region: BodyRegion, ratio: f64) -> String {
    match ratio < 1.0 && region.permits_no_contact() {
        true => format!("{NO_CONTACT} ({ratio:.2}x)"),
        false => format!("{ratio:.2}x"),
    }
}

/// The limit of contacts that a moving robot may not have at all.
pub const NONE_ALLOWED: &str = "none allowed";

/// What is broken for a narrow column: measure and limit.
#[must_use]
pub fn measure_cell(class: Class, judged: Option<&Judged>, (force_n, limit_n, speed_m_s): (f64, f64, f64)) -> String {
    let by_pressure = judged.is_some_and(|judged| judged.limit == LimitKind::Pressure);
    match (class, judged.and_then(|j| j.pressure), judged.and_then(|j| j.separation)) {
        (Class::Clamping | Class::Pressure, Some(p), _) if by_pressure => {
            format!("{:.0} / {:.0} N/cm2", p.n_cm2, p.limit_n_cm2)
        }
        (Class::Clamping, ..) => format!("{force_n:.0} N / {limit_n:.0} N clamped"),
        (Class::Force | Class::Pressure, ..) => format!("{force_n:.0} N / {limit_n:.0} N"),
        (Class::HeadContact, ..) => format!("{force_n:.0} N / {NONE_ALLOWED}"),
        (Class::MovingContact, ..) => format!("{speed_m_s:.2} m/s / {NONE_ALLOWED}"),
        (Class::Separation, _, Some(s)) => match s.required_m {
            Some(required) => format!("{:.2} m / {required:.2} m", s.distance_m),
            None => format!("{:.2} m / does not stop", s.distance_m),
        },
        (Class::Separation, ..) => "too near".to_owned(),
    }
}
