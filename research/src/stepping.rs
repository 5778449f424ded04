//! One action after the other, as somebody else chooses them: what other searches (a learning agent, a sampler) need of a cell. They see
//! what a person beside the cell could see and measure, and are told what the scan's own searches are told: reward, end, hazards.

use std::collections::BTreeMap;

use serde::Serialize;

use fmi_hazard::hazard::{Finding, Identity};
use fmi_hazard::host::{Hosted, PlantError};
use fmi_hazard::human::Action;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::Prepared;
use fmi_hazard::search::{End, Environment as _, Step};
use fmi_hazard::sim::{Instant, Simulation, Snapshot};
use fmi_hazard::standards::BodyRegion;

/// Most states that are kept at a time.
pub(crate) const MOST_SAVED: usize = 100_000;

/// What an environment is.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Description {
    /// Name of the cell.
    pub cell: String,
    /// Names of the actions, by their number.
    pub actions: Vec<String>,
    /// Longest episode, in actions.
    pub horizon: u32,
    /// Length of an action, s.
    pub action_s: f64,
    /// Names of the sensors.
    pub sensors: Vec<String>,
    /// Names of the robots' links.
    pub links: Vec<String>,
}

/// What there is to see at one instant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Observation {
    /// Actions taken so far.
    pub actions: usize,
    /// Where the person stands, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where they look: cosine and sine of the angle from +x towards +y.
    pub heading: [f64; 2],
    /// Whether each sensor reports them.
    pub sensors: Vec<bool>,
    /// Middle of each link, world, m.
    pub links_m: Vec<[f64; 3]>,
    /// Upper bound on the speed of each, m/s.
    pub speeds_m_s: Vec<f64>,
}

/// An unsafe contact.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Met {
    /// Id of the hazard, as in a scan.
    pub id: String,
    /// What is hit.
    pub body_region: BodyRegion,
    /// By which link.
    pub robot_link: String,
    /// Force over limit.
    pub ratio: f64,
    /// When, s after the start of the sequence.
    pub time_s: f64,
    /// The sequence.
    pub actions: Vec<Action>,
}

/// What an action led to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Taken {
    /// What there is to see then; nothing where the FMU could not finish the action.
    pub observation: Option<Observation>,
    /// The reward of the paper: 0 on the way and for an unsafe contact, less at an end without one, by how near it came.
    pub reward: f64,
    /// Why the episode is over: `unsafe`, `horizon` or `not_evaluated`; nothing if it is not.
    pub end: Option<&'static str>,
    /// The unsafe contact that ends it.
    pub hazard: Option<Met>,
}

/// Why something cannot be done.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SteppingError {
    /// What was asked for makes no sense.
    #[error("{0}")]
    Asked(String),
    /// The FMU failed.
    #[error("the FMU failed: {0}")]
    Failed(#[from] PlantError),
}

/// A cell that is stepped.
pub(crate) struct Stepping {
    simulation: Simulation<Hosted>,
    description: Description,
    /// How many actions were taken, and whether the episode is over.
    taken: usize,
    is_over: bool,
    saved: BTreeMap<u64, (Snapshot, usize, bool)>,
    next: u64,
}

impl Stepping {
    /// A cell at its start.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub(crate) fn new(prepared: &Prepared, state: StateChoice) -> Result<Self, PlantError> {
        let cell = &prepared.cell;
        let description = Description {
            cell: cell.name.clone(),
            actions: cell.repertoire.all().map(|action| action.to_string()).collect(),
            horizon: cell.search.actions,
            action_s: fmi_hazard::human::action::ACTION_S,
            sensors: cell.sensors.iter().map(|sensor| sensor.name.clone()).collect(),
            links: cell.links.iter().map(|link| link.name.clone()).collect(),
        };
        let simulation = prepared.simulation(state, false)?;
        Ok(Self { simulation, description, taken: 0, is_over: false, saved: BTreeMap::new(), next: 0 })
    }

    /// What it is.
    #[must_use]
    pub(crate) const fn description(&self) -> &Description {
        &self.description
    }

    /// Goes to the start.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn reset(&mut self) -> Result<Observation, SteppingError> {
        self.simulation.reset()?;
        (self.taken, self.is_over) = (0, false);
        self.observe()
    }

    /// Takes an action.
    ///
    /// # Errors
    /// When there is no such action, the episode is over, or the FMU fails.
    pub(crate) fn step(&mut self, action: usize) -> Result<Taken, SteppingError> {
        let actions = self.description.actions.len();
        if action >= actions {
            return Err(SteppingError::Asked(format!(
                "there is no action {action}: they go from 0 to {}",
                actions - 1
            )));
        }
        if self.is_over {
            return Err(SteppingError::Asked("the episode is over: reset, or restore a state".to_owned()));
        }
        let Step { reward, end } = self.simulation.step(action)?;
        self.taken += 1;
        self.is_over = end.is_some();
        let links = &self.description.links;
        let hazard = self.simulation.take_findings().last().map(|finding| met(finding, links));
        let observation = if end == Some(End::NotEvaluated) { None } else { Some(self.observe()?) };
        let end = end.map(|end| match end {
            End::Unsafe => "unsafe",
            End::Horizon => "horizon",
            End::NotEvaluated => "not_evaluated",
        });
        Ok(Taken { observation, reward, end, hazard })
    }

    /// Keeps the present state; its number.
    ///
    /// # Errors
    /// When too many are kept.
    pub(crate) fn save(&mut self) -> Result<u64, SteppingError> {
        if self.saved.len() >= MOST_SAVED {
            return Err(SteppingError::Asked(format!("{MOST_SAVED} states are kept already: forget some")));
        }
        self.next += 1;
        self.saved.insert(self.next, (self.simulation.save(), self.taken, self.is_over));
        Ok(self.next)
    }

    /// Comes back to a kept state.
    ///
    /// # Errors
    /// When there is none with this number, or the FMU fails.
    pub(crate) fn restore(&mut self, number: u64) -> Result<Observation, SteppingError> {
        let unknown = || SteppingError::Asked(format!("no state {number} is kept"));
        let (snapshot, taken, is_over) = self.saved.get(&number).ok_or_else(unknown)?;
        self.simulation.restore(snapshot)?;
        (self.taken, self.is_over) = (*taken, *is_over);
        self.observe()
    }

    /// Keeps a state no more.
    pub(crate) fn forget(&mut self, number: u64) {
        self.saved.remove(&number);
    }

    fn observe(&mut self) -> Result<Observation, SteppingError> {
        let Instant { position, readings, frame, .. } = self.simulation.now()?;
        let (sin, cos) = libm::sincos(self.simulation.heading_rad());
        Ok(Observation {
            actions: self.taken,
            xy_m: [position.x, position.y],
            heading: [cos, sin],
            sensors: readings,
            links_m: frame.links.iter().map(|link| link.bounding_sphere().0.to_array()).collect(),
            speeds_m_s: frame.speed_bounds.clone(),
        })
    }
}

fn met(finding: &Finding, links: &[String]) -> Met {
    Met {
        id: Identity::of(finding, links).id(),
        body_region: finding.contact.region,
        robot_link: links[finding.contact.link].clone(),
        ratio: finding.contact.ratio(),
        time_s: finding.time_s,
        actions: finding.actions.clone(),
    }
}
