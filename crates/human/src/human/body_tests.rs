//! Tests of the body: its heights against the survey, its bends by hand.

use super::*;
use crate::human::BendFraction as Fraction;
use crate::standards::anthropometry;

fn body(sex: Sex, percentile: Percentile) -> Body {
    Body::new(&Anthropometry { sex, percentile, ..Anthropometry::default() }).unwrap()
}

fn upright(body: &Body) -> PlacedBody {
    body.placed(Vec3::ZERO, 0.0, Posture::Upright, Fraction::FULL)
}

fn top(capsule: &Capsule) -> f64 {
    capsule.a.z.max(capsule.b.z) + capsule.radius
}

fn bottom(capsule: &Capsule) -> f64 {
    capsule.a.z.min(capsule.b.z) - capsule.radius
}

/// The capsules against the surveyed heights of six persons; each measure scales with stature here, and is the
/// percentile of its own there.
#[test]
fn heights_agree_with_the_survey() {
    for (sex, percentile) in anthropometry::ALL {
        let surveyed = measures(sex, percentile);
        let placed = upright(&body(sex, percentile));
        let check = |what: &str, height: f64, expected: f64, tolerance: f64| {
            assert!((height - expected).abs() < tolerance, "{sex:?} {percentile:?} {what}: {height}, {expected}");
        };
        // 1 cm, which is 0.6 % of stature, at every size.
        check("head", top(placed.capsule(BodyPart::Head)), surveyed.stature_m, 0.0061 * surveyed.stature_m);
        // A median man's joint is 40 mm below the acromion and 20 mm inside it.
        let scale = surveyed.stature_m / 1.755;
        let shoulder = placed.shoulder(Side::Left).translation;
        check("shoulder", shoulder.z, surveyed.acromial_height_m - 0.04 * scale, 0.015);
        check("shoulder", shoulder.y, 0.5 * surveyed.biacromial_breadth_m - 0.02 * scale, 0.016);
        // Legs are the part that scales least with stature: exact for the man who was measured, else to 3 cm.
        let tolerance = if (sex, percentile) == (Sex::Man, Percentile::P50) { 0.002 } else { 0.03 };
        check("knee", placed.capsule(BodyPart::LeftShank).b.z, surveyed.knee_height_m, tolerance);
        // The pivot of the bend lies between the surveyed trochanterion and the hip joint of Drillis and Contini
        // (0.530 of stature); the two differ by up to 5 cm.
        let hip = placed.world_from_trunk().translation.z;
        assert!(
            (surveyed.trochanterion_height_m - 0.01..0.530 * surveyed.stature_m).contains(&hip),
            "{sex:?} {percentile:?} hip: {hip}"
        );
        let neck = placed.capsule(BodyPart::Neck);
        assert!(bottom(neck) < surveyed.cervicale_height_m && surveyed.cervicale_height_m < top(neck));
        for side in [BodyPart::LeftShank, BodyPart::RightShank] {
            check("foot", bottom(placed.capsule(side)), 0.0, 1e-12);
        }
    }
}

/// No gap in the body: every part overlaps a neighbour, from head to foot.
#[test]
fn parts_hang_together() {
    for (sex, percentile) in anthropometry::ALL {
        let placed = upright(&body(sex, percentile));
        let column = [
            BodyPart::Head,
            BodyPart::Neck,
            BodyPart::UpperChest,
            BodyPart::LowerChest,
            BodyPart::Abdomen,
            BodyPart::Pelvis,
            BodyPart::RightThigh,
            BodyPart::RightShank,
        ];
        for pair in column.windows(2) {
            let (above, below) = (placed.capsule(pair[0]), placed.capsule(pair[1]));
            assert!(bottom(above) < top(below), "{sex:?} {percentile:?}: gap between {pair:?}");
        }
    }
}

#[test]
fn left_is_left() {
    let body = body(Sex::Man, Percentile::P50);
    let placed = upright(&body);
    assert!(placed.shoulder(Side::Left).translation.y > 0.0);
    assert!(placed.capsule(BodyPart::LeftThigh).a.y > 0.0);
    // Looking along +y, the left is towards -x; bent to the left, the head goes there.
    let turned = body.placed(Vec3::ZERO, std::f64::consts::FRAC_PI_2, Posture::Left, Fraction::FULL);
    assert!(turned.shoulder(Side::Left).translation.x < turned.shoulder(Side::Right).translation.x);
    let head = turned.capsule(BodyPart::Head).a;
    assert!((head.x + 0.72 * 0.5).abs() < 1e-12 && head.y.abs() < 1e-12, "{head}");
}

/// By hand: 45 degrees forward moves the head centre by 0.72 sin 45 and leaves it 0.72 cos 45 above the pivot; the
/// shoulders likewise with 0.48; legs and pelvis stay.
#[test]
fn forward_bend_by_hand() {
    let body = body(Sex::Man, Percentile::P50);
    let at = Vec3::new(2.0, -1.0, 0.0);
    let placed = body.placed(at, 0.0, Posture::Forward, Fraction::FULL);
    let half = 0.5_f64.sqrt();
    let close = |a: Vec3, b: Vec3| assert!((a - b).length() < 1e-12, "{a} is not {b}");
    close(placed.capsule(BodyPart::Head).a, at + Vec3::new(0.72 * half, 0.0, 0.92 + 0.72 * half));
    let shoulder = placed.shoulder(Side::Right);
    close(shoulder.translation, at + Vec3::new(0.48 * half, -0.19, 0.92 + 0.48 * half));
    // Axes of the trunk: up tilts forward, forward tilts down, left stays.
    close(shoulder.rotation * Vec3::Z, Vec3::new(half, 0.0, half));
    close(shoulder.rotation * Vec3::X, Vec3::new(half, 0.0, -half));
    close(shoulder.rotation * Vec3::Y, Vec3::Y);
    let standing = body.placed(at, 0.0, Posture::Upright, Fraction::FULL);
    for (bent, straight) in placed.parts().iter().zip(standing.parts()).filter(|(part, _)| !part.0.is_trunk()) {
        assert_eq!(bent, straight);
    }
    // Half of the bend is 22.5 degrees.
    let half_way = body.placed(at, 0.0, Posture::Forward, Fraction::new(8).unwrap());
    let sine = 22.5_f64.to_radians();
    close(
        half_way.capsule(BodyPart::Head).a,
        at + Vec3::new(0.72 * libm::sin(sine), 0.0, 0.92 + 0.72 * libm::cos(sine)),
    );
}

/// Forward 45 and left 30: the lean reaches as far forward as the plain bend, its upward share is cos 45 cos 30,
/// and the lowest point of a median man's head is 1.26 m above the floor (published with the cells).
#[test]
fn diagonal_bend_by_hand() {
    let body = body(Sex::Man, Percentile::P50);
    for (posture, sign) in [(Posture::ForwardLeft, 1.0), (Posture::ForwardRight, -1.0)] {
        let placed = body.placed(Vec3::ZERO, 0.0, posture, Fraction::FULL);
        let head = placed.capsule(BodyPart::Head);
        let half = 0.5_f64.sqrt();
        let expected = Vec3::new(half, sign * half * 0.5, half * 0.75_f64.sqrt());
        assert!((head.a - Vec3::new(0.0, 0.0, 0.92) - 0.72 * expected).length() < 1e-12, "{}", head.a);
        assert!((bottom(head) - 1.26).abs() < 0.005, "{}", bottom(head));
    }
}

#[test]
fn a_bend_that_is_no_angle_is_refused() {
    for degrees in [-1.0, 90.1, f64::NAN, f64::INFINITY] {
        let forward = Anthropometry { bend_forward_deg: degrees, ..Anthropometry::default() };
        let lateral = Anthropometry { bend_lateral_deg: degrees, ..Anthropometry::default() };
        for (parameters, named) in [(forward, "bend_forward_deg"), (lateral, "bend_lateral_deg")] {
            let error = Body::new(&parameters).unwrap_err();
            assert!(error.to_string().contains(named), "{error}");
        }
    }
}

#[test]
fn parameters_are_read_with_defaults_and_without_typing_errors() {
    let short: Anthropometry = serde_json::from_str(r#"{"sex": "woman", "percentile": 5}"#).unwrap();
    let expected = Anthropometry { sex: Sex::Woman, percentile: Percentile::P5, ..Anthropometry::default() };
    assert_eq!(short, expected);
    assert!(serde_json::from_str::<Anthropometry>(r#"{"bend_foward_deg": 30}"#).is_err());
    assert!(serde_json::from_str::<Anthropometry>(r#"{"percentile": 99}"#).is_err());
}

#[test]
fn radii_may_be_those_of_somebody_else() {
    let radii_m = Radii { head: Some(0.15), thigh: Some(0.11), shank: Some(0.07), ..Radii::default() };
    let other = Body::new(&Anthropometry { radii_m, ..Anthropometry::default() }).unwrap();
    let median = body(Sex::Man, Percentile::P50);
    // As they are given, whatever the stature.
    let tall = Body::new(&Anthropometry { radii_m, percentile: Percentile::P95, ..Anthropometry::default() }).unwrap();
    assert!((upright(&tall).capsule(BodyPart::Head).radius - 0.15).abs() < 1e-12);
    let (ours, theirs) = (upright(&median), upright(&other));
    for (part, capsule) in theirs.parts() {
        let expected = match part {
            BodyPart::Head => 0.15,
            BodyPart::LeftThigh | BodyPart::RightThigh => 0.11,
            BodyPart::LeftShank | BodyPart::RightShank => 0.07,
            _ => ours.capsule(*part).radius,
        };
        assert!((capsule.radius - expected).abs() < 1e-12, "{part:?}");
    }
    assert!(bottom(theirs.capsule(BodyPart::LeftShank)).abs() < 1e-12);
    assert!((top(theirs.capsule(BodyPart::LeftShank)) - top(ours.capsule(BodyPart::LeftShank)) - 0.015).abs() < 1e-3);
    // Nothing of it is beyond the sphere that leaves out what cannot be touched, however it bends.
    let huge = Radii { upper_chest: Some(0.4), pelvis: Some(0.4), head: Some(0.4), ..Radii::default() };
    for radii_m in [radii_m, huge] {
        let body = Body::new(&Anthropometry { radii_m, ..Anthropometry::default() }).unwrap();
        for posture in Posture::USUAL {
            let placed = body.placed(Vec3::ZERO, 0.3, posture, Fraction::FULL);
            let far =
                placed.parts().iter().map(|(_, c)| (c.a - Vec3::Z).length().max((c.b - Vec3::Z).length()) + c.radius);
            assert!(far.fold(0.0, f64::max) <= body.reach_from_one_metre(0.0, &[]) + 1e-12, "{posture:?}");
        }
    }
    for metres in [0.0, 0.5, f64::NAN] {
        let radii_m = Radii { neck: Some(metres), ..Radii::default() };
        let error = Body::new(&Anthropometry { radii_m, ..Anthropometry::default() }).unwrap_err();
        assert!(error.to_string().contains("`neck`"), "{error}");
    }
}

/// Heights and lengths of the low postures of the median man, by hand: thigh 0.43 m and shank 0.435 m, head 0.72 m up the trunk and
/// 0.105 m thick. Limbs keep their lengths, nothing is below the floor, and no part comes apart on the way down.
#[test]
fn low_postures_are_as_low_as_they_say() {
    let median = body(Sex::Man, Percentile::P50);
    let cos = |degrees: f64| libm::cos(degrees.to_radians());
    let crouching = 0.055 + 0.435 * cos(35.0) + 0.43 * cos(95.0);
    for (posture, height_m) in [
        (Posture::Kneeling, 0.055 + 0.43 + 0.72 + 0.105),
        (Posture::Crouching, crouching + 0.72 * cos(60.0) + 0.105),
        // The pelvis and the head are as high, nearly: 0.055 + 0.43 + 0.03 + 0.14 and 0.055 + 0.43 + 0.72 cos 85 + 0.105.
        (Posture::Crawling, 0.055 + 0.43 + 0.40 * cos(85.0) + 0.13),
    ] {
        let height = median.height_m(posture);
        assert!((height - height_m).abs() < 0.006, "{posture:?}: {height} m, by hand {height_m} m");
        for (sex, percentile) in anthropometry::ALL {
            let body = body(sex, percentile);
            assert!((body.height_m(posture) / body.stature_m() - height / median.stature_m()).abs() < 1e-12);
            let reach = body.reach_from_one_metre(0.85, &Posture::LOW);
            for fraction in Fraction::ALL {
                let placed = body.placed(Vec3::new(0.3, -2.0, 0.0), 1.0, posture, fraction);
                let upright = upright(&body);
                for ((part, now), (_, before)) in placed.parts().iter().zip(upright.parts()) {
                    assert!(((now.a - now.b).length() - (before.a - before.b).length()).abs() < 1e-12, "{part:?}");
                    // A thigh is 25 mm thicker at the knee than the shank on which it kneels.
                    assert!(bottom(now) > -0.0251 * body.scale(), "{posture:?} {part:?} {fraction:?}");
                    let far = |end: Vec3| (end - Vec3::new(0.3, -2.0, 1.0)).length() + now.radius;
                    assert!(far(now.a).max(far(now.b)) <= reach + 1e-12);
                }
                let shoulder = placed.shoulder(Side::Left).translation;
                assert!((shoulder - Vec3::new(0.3, -2.0, 1.0)).length() + 0.85 <= reach + 1e-12);
                for (thigh, shank) in
                    [(BodyPart::LeftThigh, BodyPart::LeftShank), (BodyPart::RightThigh, BodyPart::RightShank)]
                {
                    let (thigh, shank) = (placed.capsule(thigh), placed.capsule(shank));
                    assert!((thigh.a - shank.b).length() < 1e-12, "{posture:?} {fraction:?}: the knee");
                    // From the upper end of the thigh to the middle of the pelvis, as upright.
                    let pelvis = |placed: &PlacedBody, thigh: &Capsule| {
                        let pelvis = placed.capsule(BodyPart::Pelvis);
                        ((pelvis.a + pelvis.b) * 0.5 - thigh.b).length()
                    };
                    assert!(
                        pelvis(&placed, thigh)
                            < pelvis(&upright, upright.capsule(BodyPart::LeftThigh)) + 0.05 * body.scale()
                    );
                }
            }
        }
        // As high upright as ever.
        assert_eq!(
            median.placed(Vec3::ZERO, 0.0, posture, Fraction::UPRIGHT).world_from_trunk(),
            upright(&median).world_from_trunk()
        );
    }
}

/// Who kneels is on the floor with knees and toes, who crawls with the hands too, who crouches with the feet; half way down, with the feet.
#[test]
fn what_touches_the_floor() {
    let median = body(Sex::Man, Percentile::P50);
    let on =
        |posture, fraction| median.on_floor(Vec3::new(1.0, 2.0, 0.0), std::f64::consts::FRAC_PI_2, posture, fraction);
    let at = |points: &[Vec3]| points.iter().map(|p| [p.x, p.y, p.z].map(|v| (v * 1e3).round())).collect::<Vec<_>>();
    let standing = on(Posture::Forward, Fraction::FULL);
    assert_eq!((at(&standing.feet), standing.besides), (vec![[910.0, 2000.0, 0.0], [1090.0, 2000.0, 0.0]], None));
    assert_eq!(at(&on(Posture::Crouching, Fraction::FULL).feet), at(&standing.feet));
    let kneeling = on(Posture::Kneeling, Fraction::FULL);
    assert_eq!(at(&kneeling.feet), at(&standing.feet));
    let toes = [[910.0, 1565.0, 0.0], [1090.0, 1565.0, 0.0]];
    assert_eq!(at(&kneeling.besides.unwrap()), [toes, toes].concat());
    let crawling = on(Posture::Crawling, Fraction::FULL);
    assert_eq!(at(&crawling.feet), [[910.0, 1750.0, 0.0], [1090.0, 1750.0, 0.0]]);
    assert_eq!(at(&crawling.besides.unwrap())[2..], [[810.0, 2228.0, 0.0], [1190.0, 2228.0, 0.0]]);
    assert_eq!(on(Posture::Crawling, Fraction::new(8).unwrap()).besides, None);
}
