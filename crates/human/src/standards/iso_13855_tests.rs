//! Separation distances against worked examples that makers of safety devices publish, and each rule where it changes.

use super::iso_13855::Edition::{Of2010, Of2024};
use super::iso_13855::{
    Detection, Edition, Opening, Required, along, beam_heights, door, heights_for_reaching_over, mat, over,
    reaching_over_m, through, two_hand, under,
};

fn fine(resolution_mm: f64) -> Detection {
    Detection { resolution_m: Some(resolution_mm / 1000.0), beams: None }
}

const fn beams(beams: u32) -> Detection {
    Detection { resolution_m: None, beams: Some(beams) }
}

/// S, mm, of something that is known.
fn s_mm(required: &Required) -> f64 {
    assert!(required.not_known.is_empty(), "{required:?}");
    required.separation.s_m() * 1000.0
}

/// The least that S can be, mm, of something that is not known.
fn least_mm(required: &Required) -> f64 {
    assert!(!required.not_known.is_empty(), "{required:?}");
    required.separation.s_m() * 1000.0
}

#[track_caller]
fn is(found_mm: f64, expected_mm: f64) {
    assert!((found_mm - expected_mm).abs() < 1e-6, "{found_mm} mm instead of {expected_mm} mm");
}

/// Makers round up to whole millimetres.
#[track_caller]
fn is_rounded_up(found_mm: f64, printed_mm: f64) {
    is((found_mm - 1e-6).ceil(), printed_mm);
}

/// Leuze electronic, SOLID-4 connecting and operating instructions, 6.1.1: point of operation, 150 + 25 + 20 ms, 20 mm.
#[test]
fn published_leuze_solid_4_point_of_operation() {
    is(s_mm(&through(Of2010, 0.150 + 0.025 + 0.020, 0.0, &fine(20.0))), 438.0);
}

/// Leuze electronic, SOLID-2 connecting and operating instructions, 5.1.1: 150 + 49 + 20 ms, 20 mm.
#[test]
fn published_leuze_solid_2_danger_point() {
    is(s_mm(&through(Of2010, 0.150 + 0.049 + 0.020, 0.0, &fine(20.0))), 486.0);
}

/// Leuze electronic, MLC 510 and MLC 530 operating instructions, 6.1.2: feeding a press, 190 + 22 ms, 20 mm.
#[test]
fn published_leuze_mlc_press() {
    is(s_mm(&through(Of2010, 0.190 + 0.022, 0.0, &fine(20.0))), 472.0);
}

/// Leuze electronic, MLC 520 EX operating instructions, 6.1.2: access to a robot, 250 + 14 ms, 40 mm. With 2000 mm/s it is more than
/// 500 mm, so it is taken anew. Before that the manual has a curtain of 90 mm with C = 850 mm: that is the least here, because
/// wenglor has 1200 mm above 70 mm.
#[test]
fn published_leuze_mlc_access_to_a_robot() {
    is_rounded_up(s_mm(&through(Of2010, 0.250 + 0.014, 0.0, &fine(40.0))), 631.0);
    is_rounded_up(least_mm(&through(Of2010, 0.250 + 0.006, 0.0, &fine(90.0))), 1260.0);
}

/// Leuze electronic, MLC 510 operating instructions, 6.1.3: a horizontal light curtain on the floor, 40 mm, 140 + 13 + 10 ms, then
/// 140 + 14 + 10 ms.
#[test]
fn published_leuze_mlc_horizontal() {
    is_rounded_up(s_mm(&along(Of2010, 0.163, 0.0, 0.0, Some(0.040))), 1461.0);
    is_rounded_up(s_mm(&along(Of2010, 0.164, 0.0, 0.0, Some(0.040))), 1463.0);
}

/// SICK, deTem4 Core operating instructions, 4.3.1: multiple light beams, 290 + 20 ms.
#[test]
fn published_sick_detem4_beams() {
    for count in 2..=4 {
        is(s_mm(&through(Of2010, 0.290 + 0.020, 0.0, &beams(count))), 1346.0);
    }
}

/// wenglor, SG4 operating instructions, sample calculations: 5.7 + 20 ms, with one beam out of order 47 mm, and 30 mm.
#[test]
fn published_wenglor_sg4() {
    is(s_mm(&through(Of2010, 0.0257, 0.0, &fine(47.0))), 891.12);
    is(s_mm(&through(Of2010, 0.0257, 0.0, &fine(30.0))), 179.4);
}

/// Schmersal in OEM Update, April 2012, "Pressure Mat Safety Distances": 117.5 + 70 ms, at floor level.
#[test]
fn published_schmersal_mat() {
    is(s_mm(&mat(Of2010, 0.1175 + 0.070, 0.0, 0.0)), 1500.0);
}

/// Rockwell Automation, safety products catalogue, safety mats: 35 + 485 ms, mats from 2032 mm on.
#[test]
fn published_rockwell_mat() {
    is(s_mm(&mat(Of2010, 0.035 + 0.485, 0.0, 0.0)), 2032.0);
}

/// Omron, safety handbook, 6.1.2: a two-hand control, 60 ms.
#[test]
fn published_omron_two_hand_control() {
    is(s_mm(&two_hand(Of2010, 0.060, 0.0)), 346.0);
}

/// GT Engineering, guide to EN ISO 13855 (new edition): 550 mm for two-hand controls, 1200 mm for fields at any height. By hand with
/// 0.3 s: 480 mm + 550 mm and 480 mm + 1200 mm; of 2010, 0.5 m high, 480 mm + 1000 mm.
#[test]
fn editions_differ_in_two_hand_controls_and_fields() {
    is(s_mm(&two_hand(Of2024, 0.3, 0.0)), 1030.0);
    is(s_mm(&along(Of2024, 0.3, 0.0, 0.15, Some(0.05))), 1680.0);
    is(s_mm(&along(Of2024, 0.3, 0.1, 0.15, Some(0.05))), 1780.0);
    is(s_mm(&along(Of2010, 0.3, 0.0, 0.2, Some(0.05))), 480.0 + 1120.0);
    is(s_mm(&mat(Of2010, 0.3, 0.0, 0.25)), 480.0 + 1100.0);
    is(s_mm(&mat(Of2024, 0.3, 0.0, 0.25)), 480.0 + 1200.0);
}

/// The distances for hands go down to 100 mm and up to 500 mm; beyond, those for walking begin at 500 mm.
#[test]
fn a_fine_curtain_has_least_distances() {
    for edition in [Of2010, Of2024] {
        let at = |t_s: f64, d: f64| s_mm(&through(edition, t_s, 0.0, &fine(d)));
        is(at(0.02, 14.0), 100.0);
        is(at(0.05, 14.0), 100.0);
        is(at(0.06, 14.0), 120.0);
        // Finer than 14 mm takes nothing off.
        is(at(0.06, 5.0), 120.0);
        is(at(0.25, 14.0), 500.0);
        // 2000 mm/s would be 502 mm, 1600 mm/s 401.6 mm.
        is(at(0.251, 14.0), 500.0);
        is(at(0.3125, 14.0), 500.0);
        is(at(0.32, 14.0), 512.0);
        // A supplement comes on top of the least distance.
        is(s_mm(&through(edition, 0.02, 0.03, &fine(14.0))), 130.0);
    }
}

#[test]
fn resolutions_where_the_rule_changes() {
    let at = |edition: Edition, d: f64| through(edition, 0.45, 0.0, &fine(d));
    is(s_mm(&at(Of2010, 30.0)), 848.0);
    is(s_mm(&at(Of2010, 40.0)), 720.0 + 208.0);
    is(s_mm(&at(Of2010, 40.1)), 720.0 + 850.0);
    is(s_mm(&at(Of2010, 70.0)), 720.0 + 850.0);
    is(least_mm(&at(Of2010, 70.1)), 720.0 + 850.0);
    is(s_mm(&at(Of2024, 40.0)), 720.0 + 208.0);
    is(least_mm(&at(Of2024, 40.1)), 720.0 + 48.0);
    is(least_mm(&at(Of2024, 55.0)), 720.0 + 48.0);
    is(least_mm(&at(Of2024, 55.1)), 720.0 + 850.0);
    let unknown = Detection::default();
    is(least_mm(&through(Of2010, 0.45, 0.0, &unknown)), 720.0);
    is(least_mm(&through(Of2024, 0.1, 0.0, &unknown)), 200.0);
}

/// Leuze, safety at work, 3.7, and Datalogic, general catalogue: a single beam has C = 1200 mm.
#[test]
fn single_beams_and_their_heights() {
    is(s_mm(&through(Of2010, 0.1, 0.0, &beams(1))), 160.0 + 1200.0);
    is(least_mm(&through(Of2024, 0.1, 0.0, &beams(3))), 160.0 + 850.0);
    for (count, low_m, high_m, stands) in [
        (1, 0.75, 0.75, true),
        (1, 0.8, 0.8, false),
        (2, 0.4, 0.9, true),
        (2, 0.41, 0.9, false),
        (3, 0.3, 1.1, true),
        (3, 0.3, 1.0, false),
        (4, 0.3, 1.2, true),
        (4, 0.4, 1.2, false),
        (7, 0.5, 0.6, true),
    ] {
        assert_eq!(beam_heights(count, [low_m, high_m]).is_none(), stands, "{count} {low_m} {high_m}");
    }
}

#[test]
fn fields_too_low_for_their_resolution_or_high_enough_to_creep_under_are_not_known() {
    // H >= 15 (70 - 50) = 300 mm, which is not above 300 mm.
    is(s_mm(&along(Of2010, 0.1, 0.0, 0.3, Some(0.07))), 160.0 + 1080.0);
    is(least_mm(&along(Of2010, 0.1, 0.0, 0.29, Some(0.07))), 160.0 + 1084.0);
    is(least_mm(&along(Of2010, 0.1, 0.0, 0.31, Some(0.07))), 160.0 + 1076.0);
    // In 2024 people creep under from 200 mm on.
    is(s_mm(&along(Of2024, 0.1, 0.0, 0.2, Some(0.063))), 160.0 + 1200.0);
    is(least_mm(&along(Of2024, 0.1, 0.0, 0.21, Some(0.063))), 160.0 + 1200.0);
    // 1200 - 0.4 x 875 = 850.
    is(least_mm(&along(Of2010, 0.1, 0.0, 0.875, Some(0.05))), 160.0 + 850.0);
    is(least_mm(&along(Of2010, 0.1, 0.0, 1.0, Some(0.05))), 160.0 + 850.0);
    let unknown = along(Of2010, 0.1, 0.0, 0.2, None);
    is(least_mm(&unknown), 160.0 + 1120.0);
    // 200 / 15 + 50 = 63.3.
    assert!(unknown.not_known[0].contains("63 mm or finer"), "{unknown:?}");
}

/// Leuze, multiple light beams: above 300 mm they can be crept under; GT Engineering, new edition: above 200 mm.
#[test]
fn what_is_below_a_curtain() {
    assert!(under(Of2010, 0.3, &fine(30.0)).is_none() && under(Of2010, 0.31, &fine(30.0)).is_some());
    assert!(under(Of2010, 0.4, &beams(2)).is_none() && under(Of2010, 0.41, &beams(2)).is_some());
    assert!(under(Of2010, 0.4, &beams(3)).is_some() && under(Of2010, 0.75, &beams(1)).is_none());
    // Nothing that does not fit between its beams fits below it; more is not known.
    assert!(under(Of2024, 0.03, &fine(30.0)).is_none());
    assert!(under(Of2024, 0.031, &fine(30.0)).unwrap().contains("D_DU"));
    assert!(under(Of2024, 0.21, &fine(30.0)).unwrap().contains("unseen"));
    assert!(under(Of2024, 0.01, &Detection::default()).is_some());
}

/// Some cells of the table by hand, and what is between its rows and columns: the one that asks for more.
#[test]
fn reaching_over_by_the_table() {
    let at = |a: f64, b: f64| reaching_over_m([a, a], b).map(|m| (m * 1000.0).round());
    assert_eq!(at(1.0, 1.4), Some(700.0));
    assert_eq!(at(1.6, 1.1), Some(1100.0));
    assert_eq!(at(1.2, 1.3), Some(850.0));
    assert_eq!(at(2.2, 1.8), Some(550.0));
    assert_eq!(at(0.2, 0.9), Some(600.0));
    // Between 1000 mm (700) and 1200 mm (800), and between 1400 mm and 1600 mm of the edge.
    assert_eq!(at(1.1, 1.4), Some(800.0));
    assert_eq!(at(1.1, 1.5), Some(800.0));
    // Between 2400 and 2500 mm it falls again.
    assert_eq!(at(2.45, 1.8), Some(400.0));
    assert_eq!(at(2.55, 0.9), Some(400.0));
    assert_eq!((at(2.7, 0.9), at(1.0, 2.7), at(1.0, 0.89)), (Some(0.0), Some(0.0), None));
    // The whole height of a robot: the greatest of it.
    assert_eq!(reaching_over_m([0.5, 2.3], 1.8), Some(0.55));
    assert_eq!(reaching_over_m([0.5, 1.4], 1.8), Some(0.0));
    let heights: Vec<[f64; 2]> = heights_for_reaching_over().collect();
    assert!(heights.len() == 14 && heights[0] == [2.5, 2.6] && heights[13] == [0.0, 0.2]);
    // A higher edge never asks for more.
    for [low_m, high_m] in heights {
        let c: Vec<f64> = (9..28).map(|b| reaching_over_m([low_m, high_m], f64::from(b) / 10.0).unwrap()).collect();
        assert!(c.windows(2).all(|pair| pair[0] >= pair[1]), "{low_m}: {c:?}");
    }
}

#[test]
fn reaching_over_is_never_passed_where_it_is_not_known() {
    let at = |edition, edge_m| over(edition, 0.45, 0.0, &fine(30.0), ([1.4, 1.6], edge_m));
    // 1600 mm/s x 0.45 s + 450 mm.
    is(s_mm(&at(Of2010, 1.8).unwrap()), 1170.0);
    assert!(at(Of2010, 2.0).is_none());
    is(least_mm(&at(Of2010, 0.8).unwrap()), 720.0);
    is(least_mm(&at(Of2024, 1.8).unwrap()), 720.0);
    assert!(at(Of2024, 2.7).is_none() && at(Of2024, 2.69).is_some());
    // A hand over a low edge: 2000 mm/s x 0.05 s + 100 mm; with beams a person.
    let hand = over(Of2010, 0.05, 0.0, &fine(30.0), ([2.4, 2.4], 2.4)).unwrap();
    is(s_mm(&hand), 200.0);
    let person = over(Of2010, 0.05, 0.0, &beams(3), ([2.4, 2.4], 2.4)).unwrap();
    is(s_mm(&person), 180.0);
}

/// ABB, product manual of its door switches: S = K T + C with 1600 mm/s; T may be less by the time that the guard takes to open.
#[test]
fn doors() {
    let at =
        |gap_mm: Option<f64>, time_s| door(Of2010, 0.5, 0.0, &Opening { gap_m: gap_mm.map(|mm| mm / 1000.0), time_s });
    is(least_mm(&at(None, 0.0)), 800.0);
    is(s_mm(&at(Some(4.0), 0.0)), 802.0);
    is(s_mm(&at(Some(10.0), 0.0)), 880.0);
    is(s_mm(&at(Some(25.0), 0.0)), 800.0 + 850.0);
    is(least_mm(&at(Some(121.0), 0.0)), 800.0 + 850.0);
    is(s_mm(&at(Some(4.0), 0.2)), 480.0 + 2.0);
    is(s_mm(&at(Some(4.0), 0.7)), 2.0);
}
