//! Behaviours of an FMU whose stop restarts by itself, or is latched: whatever is reported to it, it does what they say.

use std::ops::ControlFlow;

use crate::common::write;
use crate::restarts::{WATCHES, cell, folder};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::search::Rng;
use fmi_hazard::search::behaviours::walks::{Style, Walked, walk};
use fmi_hazard::search::behaviours::{Ended, Extent, any, find};
use fmi_hazard::sim::anywhere::held::HeldReadings;
use fmi_hazard::sim::anywhere::told::seen;

/// Latched, the slide of a gantry has some thousand behaviours for all time; where it restarts, within some steps, one for each moment at
/// which it was stopped and freed, and more. Walks of each style show nothing else. What restarts is looked at as far as walks go.
#[test]
fn an_fmu_does_what_its_behaviours_say() {
    for (fmu, latched_by, steps, ended) in [
        ("gantry.fmu", "PLC", usize::MAX, Ended::Closed),
        ("gantry-fmi3.fmu", "nobody", 60, Ended::Steps),
        ("gantry.fmu", "host", usize::MAX, Ended::Closed),
    ] {
        let dir = folder(fmu);
        let prepared = prepare(&write(dir.path(), "cell.toml", &cell(WATCHES[0], latched_by)), None).unwrap();
        let readings = [vec![false], vec![true]];
        let people = vec![seen(&prepared.cell, ([0.0, -1.1], 0.0)); 2];
        let parts = (&*prepared.cell, &*prepared.binding);
        let mut machine = HeldReadings::new(
            prepared.plant(StateChoice::Auto),
            parts,
            (readings.into_iter().map(|one| vec![one]).collect(), any(2)),
            people,
        );
        let extent = Extent { held: 30, steps, most: 50_000 };
        let found = find(&mut machine, extent, &mut |_| ControlFlow::Continue(())).unwrap();
        assert_eq!(found.ended, ended, "{fmu} {latched_by}: {} behaviours", found.len());
        assert!(found.len() > 500, "{}", found.len());
        let mut rng = Rng::new(3);
        for style in Style::ALL {
            let walked = walk(&mut machine, &found, &style.drawn(&mut rng, &any(2), extent.held, 400)).unwrap();
            assert!(
                matches!(walked, Walked::Alike(alike) if alike >= steps.min(400)),
                "{latched_by} {style:?}: {walked:?}"
            );
        }
    }
}
