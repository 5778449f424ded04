//! Limits and forces of table A.2 and A.3 as the page prints them, which speed decides, and what is unsafe.

/// A body region as scan.json calls it.
pub type Region = &'static str;

pub const FACE: Region = "face";
pub const SKULL: Region = "skull_forehead";
pub const THROAT: Region = "neck_front";

/// A robot point that is no faster stands, m/s.
const STANDS: f64 = 1e-3;

/// Which speed decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Criterion {
    Absolute,
    Approach,
}

/// Of a robot point that touches the person, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Speeds {
    /// Its own, whatever the person does.
    pub own: f64,
    /// That at which it and the person come towards each other, which counts unless it stands.
    pub towards: f64,
}

impl Speeds {
    pub fn approach(self) -> f64 {
        if self.own > STANDS { self.towards } else { 0.0 }
    }

    pub fn decides(self, criterion: Criterion) -> f64 {
        match criterion {
            Criterion::Absolute => self.own,
            Criterion::Approach => self.approach(),
        }
    }

    /// Where the velocity of the robot is another by so much: at most, or at least with a minus. What decides grows with
    /// both, so this bounds it, too.
    pub fn changed(self, by: f64) -> Self {
        Self { own: self.own + by, towards: self.towards + by }
    }
}

/// Of one contact, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// With the robot's own speed.
    pub own: f64,
    /// With the speed of approach.
    pub approach: f64,
    /// The one of the two that decides.
    pub decides: f64,
    pub limit: f64,
}

impl Forces {
    pub fn new(region: Region, m_r: f64, speeds: Speeds, criterion: Criterion) -> Self {
        let of = |v: f64| force(region, m_r, v).0;
        let (decides, limit) = force(region, m_r, speeds.decides(criterion));
        Self { own: of(speeds.own), approach: of(speeds.approach()), decides, limit }
    }

    pub fn ratio(&self) -> f64 {
        self.decides / self.limit
    }
}

/// Effective mass, kg; spring constant, N/m; limit for transient contact, N.
fn figures(region: Region) -> (f64, f64, f64) {
    match region {
        SKULL => (4.4, 150e3, 130.0),
        FACE => (4.4, 75e3, 65.0),
        THROAT => (1.2, 50e3, 145.0),
        "neck" => (1.2, 50e3, 290.0),
        "back_shoulders" => (40.0, 35e3, 420.0),
        "chest" => (40.0, 25e3, 280.0),
        "abdomen" => (40.0, 10e3, 220.0),
        "pelvis" => (40.0, 25e3, 360.0),
        "upper_arm" => (3.0, 30e3, 300.0),
        "lower_arm" => (2.0, 40e3, 320.0),
        "hand" => (0.6, 75e3, 270.0),
        "thigh" => (75.0, 50e3, 440.0),
        "lower_leg" => (75.0, 60e3, 250.0),
        other => panic!("no region: {other}"),
    }
}

/// The potential collision force, N, and its limit; m_R in kg, v in m/s.
pub fn force(region: Region, m_r: f64, v: f64) -> (f64, f64) {
    let (m_h, k, limit) = figures(region);
    let mu = 1.0 / (1.0 / m_h + 1.0 / m_r);
    (v * (mu * k).sqrt(), limit)
}

/// The speed at which the force is the limit, m/s.
pub fn safe_speed(region: Region, m_r: f64) -> f64 {
    let (at_one, limit) = force(region, m_r, 1.0);
    limit / at_one
}

/// The class of an unsafe contact. A robot that moves must not touch the head, even where it draws back.
pub fn class(region: Region, m_r: f64, speeds: Speeds, criterion: Criterion) -> Option<&'static str> {
    let (f, limit) = force(region, m_r, speeds.decides(criterion));
    let no_limit = [SKULL, FACE, THROAT].contains(&region);
    if f > limit {
        Some("force")
    } else if no_limit && speeds.own > STANDS {
        Some("head_contact")
    } else {
        None
    }
}
