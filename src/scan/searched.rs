//! What a search gives besides its groups, and how the parts of one come together.

use super::execution::Doubt;
use super::exhaustive::ExhaustiveResult;
use super::options::Method;
use crate::host::{FmuUsage, PlantError};
use crate::obligations::{Need, Point};
use crate::record::certificate::Certificate;
use crate::record::model::FaultRecord;
use crate::search::residual::Figures;
use crate::sim::Coverage;
use crate::sim::motion::Motion;

/// Name of [`Method::Auto`].
pub(super) const AUTO: &str = "auto";

/// What a search gives besides its groups.
pub(super) struct Searched {
    pub name: &'static str,
    pub iterations: u64,
    pub interrupted: bool,
    /// The quick part did not try all its sequences, because it was told to stop.
    pub quick_cut: bool,
    pub broken: Option<PlantError>,
    pub certificate: Option<Certificate>,
    /// What the search left open of what an answer needs, and why.
    pub gaps: Vec<(Need, Point)>,
    /// From random sequences, if the number of iterations was the one fixed beforehand.
    pub figures: Option<Figures>,
    pub coverage: Coverage,
    pub motion: Motion,
    pub faults: Vec<FaultRecord>,
    pub fmu_steps: u64,
    pub fmu_states: usize,
    pub effort: FmuUsage,
    /// Why it is not to be relied on.
    pub doubt: Option<Doubt>,
    pub notes: Vec<String>,
}

impl Searched {
    /// Stopped before anything was looked at.
    pub(super) fn nothing(method: Method, sensors: usize) -> Self {
        let name = match method {
            Method::Strategy(name) => name.build().name(),
            Method::Exhaustive(_) => "exhaustive",
            Method::Auto(..) => AUTO,
        };
        Self {
            name,
            iterations: 0,
            interrupted: true,
            quick_cut: true,
            broken: None,
            certificate: None,
            gaps: Vec::new(),
            figures: None,
            coverage: Coverage::new(sensors),
            motion: Motion::default(),
            faults: Vec::new(),
            fmu_steps: 0,
            fmu_states: 0,
            effort: FmuUsage::default(),
            doubt: None,
            notes: Vec::new(),
        }
    }

    /// Whether every sequence was looked at, and what the search itself needs is there.
    pub(super) fn has_all(&self) -> bool {
        self.certificate.is_some() && self.gaps.is_empty()
    }

    /// Whether sequence after sequence is worth trying beside a complete search that came to this.
    pub(super) fn needs_quick(&self) -> bool {
        !self.has_all() && !self.interrupted && self.broken.is_none() && self.doubt.is_none()
    }

    /// The second part of a search whose first part was `quick`, which alone met the hazards `only_quick`.
    pub(super) fn after(self, quick: Self, only_quick: &[String]) -> Self {
        let mut coverage = quick.coverage;
        coverage.merge(&self.coverage);
        let mut motion = quick.motion;
        motion.merge(&self.motion);
        let mut gaps = Vec::new();
        if self.has_all() && !only_quick.is_empty() {
            let why = format!(
                "the quick search met hazards that the complete one did not ({}): this is an error of this tool, please \
                 report it with the cell",
                only_quick.join(", ")
            );
            gaps.push((Need::Searched, Point::open(why)));
        }
        gaps.extend(self.gaps);
        let mut faults = quick.faults;
        faults.extend(self.faults);
        Self {
            name: AUTO,
            iterations: quick.iterations,
            figures: quick.figures,
            coverage,
            motion,
            faults,
            fmu_steps: quick.fmu_steps + self.fmu_steps,
            fmu_states: quick.fmu_states.max(self.fmu_states),
            effort: quick.effort.and(self.effort),
            gaps,
            interrupted: self.interrupted || quick.interrupted,
            quick_cut: quick.quick_cut,
            broken: self.broken.or(quick.broken),
            ..self
        }
    }

    pub(super) fn all(census: ExhaustiveResult) -> Self {
        let ExhaustiveResult {
            certificate,
            gaps,
            coverage,
            motion,
            fmu_steps,
            fmu_states,
            effort,
            faults,
            interrupted,
            broken,
            doubt,
        } = census;
        Self {
            name: "exhaustive",
            iterations: 0,
            interrupted,
            quick_cut: false,
            broken,
            certificate,
            gaps,
            figures: None,
            coverage,
            motion,
            faults,
            fmu_steps,
            fmu_states,
            effort,
            doubt,
            notes: Vec::new(),
        }
    }
}
