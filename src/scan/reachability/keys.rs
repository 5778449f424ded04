//! The keys of a cell file that say what is around the robots and who is there, and what a scan from anywhere
//! does with each: taken apart without `..`, so that a new key does not compile before that is said here. What a cell is made of
//! them is taken apart in `fields`.

use crate::cell::file::format::{
    CellFile, ControlTable, CriteriaTable, DetectionZoneTable, EvaluatedTable, HumanTable, ObstacleTable, People,
    SecondTable, SensorTable, StartAreaTable, StartTable,
};

/// All of them.
pub(super) fn keys(file: &CellFile) {
    let CellFile {
        // Which file and FMU it is, and where values go.
        schema: _,
        name: _,
        extends: _,
        remove: _,
        fmu: _,
        units: _,
        connections: _,
        parameters: _,
        inputs: _,
        // Taken apart as the cell has them.
        time: _,
        robots: _,
        pose: _,
        search: _,
        accepts: _,
        // Of what is made of a result.
        fail_on: _,
        explain: _,
        obstacles,
        sensors,
        controls,
        human,
        criteria,
    } = file;
    obstacles.iter().for_each(obstacle);
    sensors.iter().for_each(sensor);
    controls.iter().for_each(control);
    let People { first, second } = human;
    person(first);
    second.iter().for_each(second_person);
    // All but the transient force are told to be left out.
    let CriteriaTable { transient_force: _, clamping: _, pressure: _, moving_contact: _, separation: _ } = criteria;
}

/// In the way as it stands; doors are taken to be open, and what follows the FMU is refused.
fn obstacle(
    ObstacleTable {
        name: _,
        centre_m: _,
        size_m: _,
        rpy_deg: _,
        mesh: _,
        resolution_m: _,
        opened_by: _,
        stands_while: _,
        moves_with: _,
    }: &ObstacleTable,
) {
}

fn sensor(table: &SensorTable) {
    let SensorTable {
        name: _,
        // What people do unseen by one is asked in `fields`.
        kind: _,
        zone,
        variable: _,
        active: _,
        delay_ms: _,
        // Held in every history; people are seen as without it.
        latched: _,
        values: _,
        // Refused.
        counts_while: _,
        evaluated,
        // A curtain that is too coarse for hands is told.
        resolution_mm: _,
        beams: _,
        // For the distance alone: the search has doors open at once.
        opening_mm: _,
        opening_ms: _,
        supplement_mm: _,
    } = table;
    if let Some(zone) = zone {
        // Nobody is low.
        let DetectionZoneTable { polygon_m: _, line_m: _, height_m: _, heights_m: _ } = zone.get_ref();
    }
    if let Some(evaluated) = evaluated {
        // Refused.
        let EvaluatedTable { variable: _, active: _ } = evaluated.get_ref();
    }
}

/// Worked at any moment, so often at most as is told; one that works at times only is refused.
fn control(
    ControlTable {
        name: _,
        variable: _,
        by: _,
        kind: _,
        at_m: _,
        to_m: _,
        within_m: _,
        for_ms: _,
        released: _,
        pressed: _,
        works_while: _,
    }: &ControlTable,
) {
}

fn person(table: &HumanTable) {
    let HumanTable {
        name: _,
        // People come from anywhere, at any time; starts say from which side of planes.
        start,
        other_starts,
        start_areas,
        begins_s: _,
        // The floor that is looked at.
        from: _,
        floor_m: _,
        start_region_m: _,
        // Looked at as it is.
        sex: _,
        percentile: _,
        bend_forward_deg: _,
        bend_lateral_deg: _,
        held_m: _,
        radii_m: _,
        // Hands are anywhere at once, which is more.
        arm_speed_m_s: _,
        // Told to be left out.
        also: _,
        run_m_s: _,
    } = table;
    for StartTable { xy_m: _, heading_deg: _ } in start.iter().chain(other_starts).map(toml::Spanned::get_ref) {}
    for StartAreaTable { polygon_m: _, spacing_m: _, heading_deg: _ } in start_areas.iter().map(toml::Spanned::get_ref)
    {
    }
}

/// Refused.
fn second_person(
    SecondTable {
        name: _,
        start: _,
        sex: _,
        percentile: _,
        bend_forward_deg: _,
        bend_lateral_deg: _,
        also: _,
        held_m: _,
        run_m_s: _,
        radii_m: _,
    }: &SecondTable,
) {
}
