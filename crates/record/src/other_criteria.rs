//! What is broken other than the transient force, explained: formula, numbers, and what would remove it.

use crate::hazard::Hazard;
use crate::judged::{Clamping, LimitKind, Pressure, Separation};
use crate::model::STANDARD_EDITION;
use crate::standards::iso_13854::least_gap_m;
use crate::standards::iso_ts_15066::spring_constant_n_m;
use fmi_hazard_criteria::criterion::Class;

/// A title, and what is said under it, a paragraph each.
pub(crate) type Block = (String, Vec<String>);

impl Hazard {
    /// What is broken, where that is not the transient force; nothing where it is.
    #[must_use]
    pub fn other_criteria(&self) -> Vec<Block> {
        let Some(judged) = &self.judged else { return Vec::new() };
        match (self.class, &judged.clamping, &judged.pressure, &judged.separation) {
            (Class::Clamping, Some(clamping), Some(pressure), _) if judged.limit == LimitKind::Pressure => {
                vec![self.clamped(clamping), self.pressed(pressure)]
            }
            (Class::Clamping, Some(clamping), ..) => vec![self.clamped(clamping)],
            (Class::Pressure, _, Some(pressure), _) => vec![self.pressed(pressure)],
            (Class::Separation, _, _, Some(separation)) => vec![self.apart(separation)],
            (Class::MovingContact, ..) => vec![self.touched()],
            _ => Vec::new(),
        }
    }

    fn touched(&self) -> Block {
        let text = format!(
            "In this cell no robot that moves may be touched (moving_contact in the cell file); this one moves at {:.2} m/s \
             there. For information, the transient force would be {:.0} N, {:.2} times its limit of {:.0} N. What would \
             remove it: a robot that stands before anybody gets there.",
            self.speed_m_s,
            self.force_n,
            self.force_n / self.limit_n,
            self.limit_n
        );
        ("Contact".to_owned(), vec![text])
    }

    fn clamped(&self, clamping: &Clamping) -> Block {
        let (region, link) = (self.body_region, &self.robot_link);
        let (least, travel) = (1000.0 * least_gap_m(region), 1000.0 * clamping.travel_m);
        let on = if travel > 0.0 {
            format!(", and {travel:.0} mm that the link goes on after the contact")
        } else {
            String::new()
        };
        let bears = if region.permits_no_contact() {
            "What cannot recoil bears no more here than what can, and"
        } else {
            "A part that cannot recoil bears half of the transient limit, and"
        };
        let k = spring_constant_n_m(region) / 1000.0;
        let safe = clamping.closing_m_s * clamping.limit_n / clamping.force_n;
        let between = format!(
            "The {} is between the robot's {link} and {}, which does not give way: {:.0} mm of room at ({:.2}, {:.2}, {:.2}) m, and it \
             closes at {:.2} m/s. ISO 13854 asks for {least:.0} mm{on}. {bears} the whole mass of the robot is behind the stroke.",
            region.words(),
            clamping.against,
            1000.0 * clamping.gap_m,
            clamping.at_m[0],
            clamping.at_m[1],
            clamping.at_m[2],
            clamping.closing_m_s,
        );
        let formula = format!(
            "F = c sqrt(m_R k) = {:.3} m/s x sqrt({:.2} kg x {k:.0} kN/m) = {:.0} N; quasi-static limit {:.0} N; {:.2}x",
            clamping.closing_m_s,
            self.effective_mass_kg,
            clamping.force_n,
            clamping.limit_n,
            clamping.force_n / clamping.limit_n,
        );
        let remedy = format!(
            "What would remove it: at least {:.0} mm of room between {link} and {} wherever people reach, or no faster than {safe:.2} m/s \
             towards it where there is less.",
            least + travel,
            clamping.against
        );
        (format!("Clamping, after {STANDARD_EDITION} and ISO 13854"), vec![between, formula, remedy])
    }

    fn pressed(&self, pressure: &Pressure) -> Block {
        let kind = if pressure.clamped { "quasi-static" } else { "transient" };
        let text = format!(
            "{:.0} N/cm2 on the {}, by what the cell file says of how small the {} touches; {kind} limit {:.0} N/cm2; {:.2}x. What \
             would remove it: a rounder or larger surface, padding, or less speed.",
            pressure.n_cm2,
            self.body_region.words(),
            self.robot_link,
            pressure.limit_n_cm2,
            pressure.n_cm2 / pressure.limit_n_cm2
        );
        (format!("Pressure, after {STANDARD_EDITION}, Table A.2"), vec![text])
    }

    fn apart(&self, separation: &Separation) -> Block {
        let who = self.person.as_deref().unwrap_or("The person");
        let words = match (separation.required_m, separation.stops_after_s) {
            (Some(required), Some(stops)) => format!(
                "{who} is {:.3} m from the robot's {}, which moves at {:.2} m/s. Stopped now it stands after {stops:.2} s and gets up to \
                 {:.3} m farther, as the FMU shows. With what the cell file says of approach, intrusion and uncertainty the protective \
                 separation distance is {required:.3} m: {:.0} mm are missing.",
                separation.distance_m,
                self.robot_link,
                self.speed_m_s,
                separation.travel_m,
                1000.0 * (required - separation.distance_m)
            ),
            _ => format!(
                "{who} is {:.3} m from the robot's {}, which moves at {:.2} m/s and does not stop when it is told to: it still moved \
                 after 5 s.",
                separation.distance_m, self.robot_link, self.speed_m_s
            ),
        };
        let remedy =
            "What would remove it: a sensor that reports people that much earlier, a shorter stop, or a slower robot.";
        ("Separation, after ISO/TS 15066, 5.5.4".to_owned(), vec![words, remedy.to_owned()])
    }
}
