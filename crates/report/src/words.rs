//! Every sentence and name that the page shows, by id: made here and in what this calls, and only drawn by the viewer.
//!
//! - [`hazard`], [`cause`]: what is said of one
//! - [`searched`]: what the search covered
//! - [`subject`]: settings and self-test

mod cause;
mod hazard;
mod searched;
mod subject;

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use self::cause::CauseWords;
use self::hazard::HazardWords;
use self::searched::Part;
use super::basis::TO_ACCEPT;
use super::does::acts;
use super::terminal::limits_words;
use crate::hazard::Class;
use crate::human::Action;
use crate::standards::BodyRegion;
use fmi_hazard_record::cause::{Cause, capitalised};
use fmi_hazard_record::certificate::{Certificate, Residual};
use fmi_hazard_record::coverage::Coverage;
use fmi_hazard_record::forces::both_forces_note;
use fmi_hazard_record::formula::REPORTS;
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::judged::{NO_CONTACT, NONE_ALLOWED};
use fmi_hazard_record::model::{Headline, Settings, Spent};
use fmu_self_test::SelfTest;

/// A scan, as far as sentences are made of it.
#[derive(Deserialize)]
struct Told {
    #[serde(default)]
    headline: Headline,
    settings: Settings,
    #[serde(default)]
    causes: Vec<Cause>,
    hazards: Vec<Hazard>,
    certificate: Option<Certificate>,
    residual: Option<Residual>,
    coverage: Coverage,
    spent: Spent,
    faults: Vec<serde::de::IgnoredAny>,
    self_test: SelfTest,
    standard_edition: String,
    tables: Vec<ToldTable>,
    /// Names of all sensors, in the order of the coverage.
    #[serde(skip)]
    sensors: Vec<String>,
}

#[derive(Deserialize)]
struct ToldTable {
    verified: bool,
}

/// A term and what is said of it.
type Row = (String, String);

/// What the page says.
#[derive(Serialize)]
pub(crate) struct Words {
    /// What a hazard is here, and what the report is not.
    hazard_is: String,
    /// Where there is no hazard.
    nothing_found: &'static str,
    /// Whom sensors report and who acts.
    people: People,
    /// Actions by their names.
    actions: BTreeMap<String, String>,
    /// Regions of the body by their ids.
    regions: BTreeMap<&'static str, &'static str>,
    /// By id.
    hazards: BTreeMap<String, HazardWords>,
    /// By id.
    causes: BTreeMap<String, CauseWords>,
    /// Of a region that no moving robot may touch, before its ratio.
    not_allowed: &'static str,
    /// Under the table of hazards.
    table_notes: Vec<String>,
    /// Of arms in replays.
    arm: &'static str,
    /// How hazards are confirmed.
    confirmed: &'static str,
    /// What the search covered.
    searched: Vec<Part>,
    /// Before the lines that accept what was tried out.
    to_accept: &'static str,
    /// How it was searched.
    settings: Vec<Row>,
    /// What the FMU's states are worth.
    self_test: Vec<Row>,
    /// Where the limits are from.
    limits: String,
    /// Commands, to which an id is added, and when to give them.
    commands: Commands,
}

/// Of one person, or of two.
#[derive(Serialize)]
struct People {
    /// Who acts, before what they do; nothing where names say it.
    who: &'static str,
    /// The same as a heading.
    heading: &'static str,
    /// What a sensor does that reports somebody.
    reports: &'static str,
    /// What several do.
    report: &'static str,
    /// Where none does.
    unseen: &'static str,
    /// What a sensor does when it begins to.
    begins: &'static str,
}

/// One person.
const ALONE: People = People {
    who: "the person",
    heading: "the person",
    reports: REPORTS[0],
    report: "report the person",
    unseen: "no sensor reports the person",
    begins: "reports",
};

/// Two people, whose names stand before what they do.
const BOTH: People = People {
    who: "",
    heading: "both people",
    reports: REPORTS[1],
    report: "report somebody",
    unseen: "no sensor reports anybody",
    begins: "reports",
};

/// What to do with an id, in the folder with the results.
#[derive(Serialize)]
struct Commands {
    explain: [&'static str; 2],
    replay: [&'static str; 2],
    report: [&'static str; 2],
}

const COMMANDS: Commands = Commands {
    explain: ["Changes are tried out by:", "fmi-hazard explain . "],
    replay: ["In the folder with this report:", "fmi-hazard replay scan.json "],
    report: [
        "This report carries the replays of the worst ways only. To get this one, in the folder with the report:",
        "fmi-hazard report . --hazard ",
    ],
};

impl Words {
    /// Of a scan as it stands in `scan.json`, and the names of the cell's sensors.
    ///
    /// # Errors
    /// When it is none.
    pub(crate) fn of(scan: &Value, sensors: &[String]) -> serde_json::Result<Self> {
        let told = Told { sensors: sensors.to_vec(), ..Told::deserialize(scan)? };
        let Told { settings, causes, hazards, .. } = &told;
        let people = if settings.second.is_some() { BOTH } else { ALONE };
        let by_id: BTreeMap<&str, &Hazard> = hazards.iter().map(|hazard| (hazard.id.as_str(), hazard)).collect();
        Ok(Self {
            hazard_is: hazard_is(settings),
            nothing_found: "None was found. The next section tells what that is worth.",
            actions: actions(hazards, settings),
            regions: BodyRegion::ALL.into_iter().map(|region| (region.id(), region.words())).collect(),
            hazards: hazards.iter().map(|hazard| (hazard.id.clone(), HazardWords::of(hazard))).collect(),
            causes: causes
                .iter()
                .map(|cause| (cause.id.clone(), CauseWords::of(cause, by_id.get(cause.worst.as_str()).copied())))
                .collect(),
            not_allowed: NO_CONTACT,
            table_notes: table_notes(hazards, settings),
            arm: "An arm pose is searched at every instant; the one shown is that at the contact.",
            confirmed: "by a fresh instance without any restore",
            searched: searched::parts(&told),
            to_accept: TO_ACCEPT,
            settings: subject::settings(&scan["settings"], settings),
            self_test: subject::self_test(&told.self_test),
            limits: {
                let verified = told.tables.iter().filter(|table| table.verified).count();
                limits_words(&told.standard_edition, told.tables.len(), verified) + "."
            },
            commands: COMMANDS,
            people,
        })
    }
}

fn hazard_is(settings: &Settings) -> String {
    let harm = match settings.criteria {
        Some(_) => "harmed by what this cell counts as unsafe",
        None => "hit harder than ISO/TS 15066 allows",
    };
    format!(
        "A hazard is a way, found in the model, for a person to be {harm}. The report helps an assessment; it does not show \
         that the cell is safe."
    )
}

/// Each action of the hazards once.
fn actions(hazards: &[Hazard], settings: &Settings) -> BTreeMap<String, String> {
    let names = settings.second.as_ref().map(|second| &second.names);
    let all = hazards.iter().flat_map(|hazard| hazard.actions.iter().chain(&hazard.shortest.actions));
    let all: BTreeSet<Action> = all.copied().collect();
    all.into_iter().map(|action| (action.to_string(), acts(action, names, &settings.controls))).collect()
}

/// Under the table of hazards.
fn table_notes(hazards: &[Hazard], settings: &Settings) -> Vec<String> {
    let mut notes = vec![both_forces_note(settings.speed_criterion)];
    if hazards.iter().any(|hazard| hazard.class == Class::HeadContact) {
        notes.push(format!(
            "“{}”: a moving robot may not touch head or throat at all; the ratio is that to the force limit and may be \
             below 1.",
            capitalised(NONE_ALLOWED)
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmi_hazard_record::fixtures::{cause, hazard, report};

    fn words(hazard: Hazard) -> Value {
        let cause = cause("C-1", &[&hazard.id]);
        let scan = serde_json::to_value(report(vec![hazard], vec![cause])).unwrap();
        serde_json::to_value(Words::of(&scan, &[]).unwrap()).unwrap()
    }

    #[test]
    fn a_hazard_and_its_cause_are_told() {
        let words = words(hazard("H-1", 1.5));
        let told = &words["hazards"]["H-1"];
        assert_eq!((&told["deed"], &told["way"]), (&"gripper hits the hand".into(), &"1.50x after 0.20 s".into()));
        assert_eq!(
            told["row"],
            serde_json::json!([
                "1.50x",
                "150 N",
                "150 N",
                "100 N",
                "150 N / 100 N",
                "0.50 m/s",
                "0.40 m/s",
                "0.20 s",
                "1",
                "none",
                "yes"
            ])
        );
        assert!(told["forces"][1] == 0 && told["apart"].is_null() && told["broken"].is_null(), "{told}");
        assert!(
            told["computed"].as_str().unwrap().ends_with("Safe below 0.40 m/s at this point: 80 % of the speed there.")
        );
        let cause = &words["causes"]["C-1"];
        assert_eq!(cause["severity"], serde_json::json!(["1.50x the limit", "150 N, limit 100 N"]));
        assert_eq!((&cause["ways"], &cause["earliest"]), (&"1 way, confirmed".into(), &"from 0.20 s on".into()));
        assert_eq!(words["actions"], serde_json::json!({ "stop/upright": "stands, upright" }));
        assert_eq!(words["table_notes"].as_array().unwrap().len(), 1);
        let parts: Vec<&str> = words["searched"].as_array().unwrap().iter().filter_map(|p| p["id"].as_str()).collect();
        assert_eq!(parts, ["certificate", "seen", "faults"]);
    }

    #[test]
    fn a_head_that_is_touched_slowly_is_not_told_as_harmless() {
        let mut hazard = hazard("H-1", 0.6);
        (hazard.class, hazard.body_region) = (Class::HeadContact, BodyRegion::Face);
        let words = words(hazard);
        let row = &words["hazards"]["H-1"]["row"];
        assert_eq!((&row[3], &row[6]), (&"none allowed".into(), &"none".into()));
        assert!(words["hazards"]["H-1"]["computed"].as_str().unwrap().contains("No speed is safe"));
        assert_eq!(words["table_notes"].as_array().unwrap().len(), 2);
        assert_eq!(fmi_hazard_record::judged::ratio_words(BodyRegion::Face, 0.6), "no contact allowed (0.60x)");
    }
}
