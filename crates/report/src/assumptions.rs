//! What every report rests on beside its obligations: the model of the person, of contacts and of the FMU, as far as its settings have
//! them so.

use serde_json::Value;

/// In sentences, for the settings of a scan as they stand in `scan.json`.
#[must_use]
pub(crate) fn assumptions(settings: &Value) -> Vec<String> {
    let also: Vec<&str> = settings["also"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let holds = !settings["held_m"].is_null();
    vec![
        walks(settings, &also, holds),
        arms(settings),
        "The force is that of ISO/TS 15066 A.3: F = v sqrt(mu k), with the absolute speed of the robot point, as in the paper: \
         conservative where the robot moves away. The body region's mass and spring constant are those of its table A.3, the \
         robot's mass is half its moving mass and the payload."
            .to_owned(),
        limits(&settings["criteria"]).to_owned(),
        shapes(holds),
        "Obstacles stop the person as a whole, and arms do not reach through them; they are boxes as given in the cell file, or in \
         its meshes. Those that follow the FMU stand as it has them."
            .to_owned(),
        "Where an arm reaches through a light curtain or a door, or lets go of a two-hand control, that is reported as long \
         before the contact as the hand needs at 2.0 m/s (ISO 13855), rounded up to whole steps; the replay and the input trace \
         show the robot as it is then. Doors are open at once, and closed again behind the person."
            .to_owned(),
        "The FMU is taken as it is: what it does not model (wear, faults of the safety system, other operating modes) is not \
         examined. No hazard found is never a proof of safety of the real workplace."
            .to_owned(),
    ]
}

fn walks(settings: &Value, also: &[&str], holds: bool) -> String {
    let how = match settings["strategy"].as_str() {
        Some(fmi_hazard_record::reachability::REACHABILITY) => "on any way, turns, bends and reaches at any moment",
        _ => "turns, bends and reaches in actions of the length given above; an action takes effect at once",
    };
    let runs = also.contains(&"run");
    let mut not = vec!["climbs"];
    if !runs {
        not.insert(0, "runs");
    }
    if !holds {
        not.push("carries something");
    }
    let last = not.pop().unwrap_or_default();
    let not = if not.is_empty() { last.to_owned() } else { format!("{} or {last}", not.join(", ")) };
    let faster = if runs { "A person who is faster than the settings say" } else { "A person who is faster" };
    format!("The person walks at 1.6 m/s (ISO 13855), {how}. {faster}, {not} is not in the model.")
}

fn arms(settings: &Value) -> String {
    let speed = match settings["arm_speed_m_s"].as_f64() {
        Some(speed) => format!(" that hands can have reached at {speed} m/s"),
        None => String::new(),
    };
    format!(
        "Arms are not animated: at every instant all arm poses within the joint limits{speed} are searched for one that touches \
         the robot and is free of obstacles; a contact that lasts only while the arm is moved by less than the reach tolerance \
         may be missed."
    )
}

fn limits(criteria: &Value) -> &'static str {
    if criteria["clamping"].is_object() {
        "Limits of hits are those for transient contact. Where a part of the body is held by an obstacle, the quasi-static limits \
         apply, which are lower."
    } else {
        "Limits are those for transient contact. Clamping does not count in this scan: where the person can be clamped, the \
         quasi-static limits apply, which are lower (clamping under [criteria] in the cell file)."
    }
}

fn shapes(holds: bool) -> String {
    let tools = if holds { "" } else { ", tools in the hand" };
    format!(
        "Robot links and the body are simplified shapes (capsules, convex hulls, meshes) as given in the cell file; hair, \
         clothes{tools} and sharp edges are not in the model."
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// What a scan looks at is not told as left out.
    #[test]
    fn they_are_those_of_the_scan() {
        let plain = assumptions(&json!({ "strategy": "auto" })).join(" ");
        for words in ["runs, climbs or carries something", "Clamping does not count", "tools in the hand"] {
            assert!(plain.contains(words), "{words}");
        }
        let criteria = json!({ "clamping": { "travel_after_contact_m": 0.0 } });
        let settings =
            json!({ "strategy": "auto", "also": ["run"], "held_m": 0.3, "criteria": criteria, "arm_speed_m_s": 2.0 });
        let rich = assumptions(&settings).join(" ");
        for words in ["runs,", "carries", "Clamping does not", "tools in the hand"] {
            assert!(!rich.contains(words), "{words}");
        }
        assert!(rich.contains("at 2 m/s are searched") && rich.contains("quasi-static limits apply"));
        assert!(assumptions(&json!({ "strategy": "anywhere" }))[0].contains("on any way"));
    }
}
