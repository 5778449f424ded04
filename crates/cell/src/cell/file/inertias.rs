//! Checks of how a robot's mass is spread, as joints or a URDF tell, and of where it carries its payload.

use std::collections::BTreeMap;

use super::checker::Checker;
use super::format::{InertiaTable, JointTable, RobotTable};
use crate::cell::CellError;
use crate::cell::workcell::{Driven, Link};
use crate::fmi::number;
use crate::geometry::inertia::{Drive, Inertia, Masses};
use crate::geometry::{Pose, Vec3};

/// What shapes may be attached to: the index of the joint or frame, and where they are in its frame.
pub(super) type Places = BTreeMap<String, (usize, Pose)>;

/// How the mass of what a joint moves is spread.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Spread {
    /// So.
    Given(Inertia),
    /// It is not known, for these reasons; and whether part of it is told.
    Unknown(Vec<String>, bool),
}

impl Checker<'_> {
    /// The inertia of a joint's table, if it is one that a body has.
    pub(super) fn inertia(&self, joint: &JointTable) -> Result<Option<Inertia>, Box<CellError>> {
        let Some(table) = &joint.inertia else { return Ok(None) };
        let (span, name) = (table.span(), joint.name.get_ref());
        let InertiaTable { mass_kg, centre_m, moments_kg_m2, products_kg_m2 } = *table.get_ref();
        self.positive(mass_kg, &span, &format!("the mass that joint `{name}` moves"))?;
        let all: Vec<f64> = [centre_m, moments_kg_m2, products_kg_m2].concat();
        self.finite(&all, &span, &format!("the inertia of joint `{name}`"))?;
        let inertia = Inertia::new(mass_kg, Vec3::from_array(centre_m), moments_kg_m2, products_kg_m2);
        self.that(inertia.is_semidefinite(), span.clone(), || {
            let message = format!("by the inertia of joint `{name}`, turning it about some axis gives energy away");
            (message, "check moments and products, and the signs of the latter: xy is -sum(m x y)".to_owned())
        })?;
        self.that(inertia.is_of_a_body(), span, || {
            let [x, y, z] = moments_kg_m2.map(number);
            let message = format!("no body has moments of inertia like those of joint `{name}`: {x}, {y} and {z} kg m^2");
            let help = "about its main axes none is greater than both others together; they are about the centre of mass, \
                        not about the joint";
            (message, help.to_owned())
        })?;
        Ok(Some(inertia))
    }

    /// What a joint of the cell file says.
    pub(super) fn spread(&self, joint: &JointTable) -> Spread {
        match self.problems.keep(self.inertia(joint)).flatten() {
            Some(inertia) => Spread::Given(inertia),
            None => Spread::Unknown(vec![format!("joint `{}` has no `inertia`", joint.name.get_ref())], false),
        }
    }

    /// The masses of a robot whose joints move what `spread` says, if that is known of all of them. If of some only, that is
    /// worth a warning.
    pub(super) fn masses(&self, robot: &RobotTable, spread: Vec<Spread>, driven: &[Driven]) -> Option<Masses> {
        let told = |spread: &Spread| matches!(spread, Spread::Given(_) | Spread::Unknown(_, true));
        let any = spread.iter().any(told);
        let (mut bodies, mut missing) = (Vec::new(), Vec::new());
        for spread in spread {
            match spread {
                Spread::Given(inertia) => bodies.push(inertia),
                Spread::Unknown(reasons, _) => missing.extend(reasons),
            }
        }
        let warn = |text: String| self.warnings.borrow_mut().push(format!("robot `{}`: {text}", robot.name));
        if !missing.is_empty() {
            if any {
                let what = "how heavy it is where it hits is not told, because that needs all inertias";
                warn(format!("{what}, and {}", missing.join(", ")));
            }
            return None;
        }
        // Of a robot whose poses the FMU gives there is nothing to know.
        if bodies.is_empty() {
            return None;
        }
        let sum: f64 = bodies.iter().map(|body| body.mass_kg).sum();
        if let Some(told) = robot.moving_mass_kg.as_ref().map(|mass| *mass.get_ref())
            && (sum - told).abs() > 0.1 * told
        {
            warn(format!(
                "its inertias are those of {sum:.1} kg, its moving mass is {told:.1} kg: one of both is wrong"
            ));
        }
        let held = |named: usize| robot.joints[named].held_deg.is_some() || robot.joints[named].held_m.is_some();
        let drive = |driven: &Driven| {
            (!held(driven.named)).then_some(Drive { coordinate: driven.named, factor: driven.factor })
        };
        Some(Masses { bodies, drives: driven.iter().map(drive).collect() })
    }

    /// The joint that carries the payload, and where that is in its frame.
    pub(super) fn payload_at(
        &self,
        robot: &RobotTable,
        places: &Places,
        links: &[Link],
    ) -> Result<(usize, Vec3), Box<CellError>> {
        let Some(at) = &robot.payload_at else {
            let last = links.last().map(|link| (link.joint, link.shape.bounding_sphere().0));
            return Ok(last.unwrap_or_default());
        };
        let span = at.joint.span();
        self.that(robot.frames.is_empty(), span.clone(), || {
            let message = "how heavy a robot is where it hits is known of robots with joints only".to_owned();
            (message, "remove `payload_at`".to_owned())
        })?;
        self.finite(&at.centre_m, &span, "where the payload is")?;
        let (joint, joint_from_place): (usize, Pose) = self.carrier(&at.joint, places)?;
        Ok((joint, joint_from_place.transform_point(Vec3::from_array(at.centre_m))))
    }
}
