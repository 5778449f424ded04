//! States, faults and modes of an instance, without the C interface.

use super::*;
use crate::interface::workcell::interface;
use crate::interface::{WORKCELLS, coupled, faulty, gantry, safety_fence};

fn fence() -> Interface {
    interface(&safety_fence::SPEC, Variant::Faithful).0
}

/// All models that save their states.
fn models() -> Vec<Interface> {
    let cells = WORKCELLS.into_iter().map(|spec| interface(spec, Variant::Faithful).0);
    cells
        .chain(coupled::all().into_iter().take(2))
        .chain(coupled::stations().into_iter().take(1))
        .chain([faulty::interface(Variant::Faithful), gantry::interface()])
        .collect()
}

fn stepping(interface: &Interface, integers: &[(usize, i32)]) -> Component {
    let mut component = Component::new(&interface.guid()).unwrap();
    for &(place, value) in integers {
        component.set(u32::try_from(place).unwrap(), Value::Integer(value)).unwrap();
    }
    start(&mut component);
    component
}

fn start(component: &mut Component) {
    component.setup(0.0).unwrap();
    component.enter_initialization().unwrap();
    component.exit_initialization().unwrap();
}

/// Outputs over `steps` steps of 20 ms with inputs that change.
fn future(component: &mut Component, steps: u32) -> Vec<Value> {
    let mut values = Vec::new();
    let first = component.tick / 20;
    for k in 0..u64::from(steps) {
        for place in 0..component.interface.variables.len() {
            let variable = &component.interface.variables[place];
            if variable.causality == Causality::Input && matches!(variable.kind.start(), Value::Boolean(_)) {
                let value = Value::Boolean((first + k + place as u64) % 7 < 4);
                component.set(u32::try_from(place).unwrap(), value).unwrap();
            }
        }
        component.step((first + k) as f64 * 0.02, 0.02).unwrap();
        for place in 0..component.interface.variables.len() {
            if component.interface.variables[place].causality == Causality::Output {
                values.push(component.get(u32::try_from(place).unwrap()).unwrap());
            }
        }
    }
    values
}

#[test]
fn a_restored_state_has_the_same_future() {
    for interface in models() {
        let mut component = stepping(&interface, &[]);
        future(&mut component, 13);
        let early = component.save().unwrap();
        future(&mut component, 5);
        let late = component.save().unwrap();
        let expected = future(&mut component, 60);
        component.restore(&early).unwrap();
        future(&mut component, 2);
        component.restore(&late).unwrap();
        assert_eq!(future(&mut component, 60), expected, "{}", interface.name);
    }
}

#[test]
fn bytes_carry_a_state_to_another_instance() {
    for interface in models() {
        let mut component = stepping(&interface, &[]);
        future(&mut component, 17);
        let saved = component.save().unwrap();
        let bytes = component.serialize(&saved).unwrap();
        let expected = future(&mut component, 60);
        let mut other = Component::new(&interface.guid()).unwrap();
        let read = other.deserialize(&bytes).unwrap();
        assert_eq!(other.serialize(&read).unwrap(), bytes);
        other.restore(&read).unwrap();
        assert_eq!(future(&mut other, 60), expected, "{}", interface.name);
        assert!(other.deserialize(&bytes[..bytes.len() - 1]).is_err(), "cut short");
        assert!(other.deserialize(&[&bytes[..], &[0]].concat()).is_err(), "too long");
    }
}

#[test]
fn reset_brings_back_the_start_values() {
    let mut component = stepping(&fence(), &[]);
    let expected = future(&mut component, 60);
    component.reset().unwrap();
    start(&mut component);
    assert_eq!(future(&mut component, 60), expected);
}

#[test]
fn any_step_size_leads_to_the_same_place() {
    let reference = u32::try_from(fence().place("robot.q[1]").unwrap()).unwrap();
    let mut whole = stepping(&fence(), &[]);
    whole.step(0.0, 1.234).unwrap();
    let mut parts = stepping(&fence(), &[]);
    let mut time = 0.0;
    for size in [0.000_4, 0.01, 0.333_3, 0.2, 0.000_2, 0.690_1] {
        parts.step(time, size).unwrap();
        time += size;
    }
    assert_eq!(parts.get(reference), whole.get(reference));
}

#[test]
fn a_step_that_does_not_continue_is_an_error() {
    let mut component = stepping(&fence(), &[]);
    component.step(0.0, 0.02).unwrap();
    assert!(component.step(0.0, 0.02).is_err());
    assert!(component.step(0.02, f64::NAN).is_err());
    assert!(component.step(0.02, -0.01).is_err());
}

#[test]
fn each_fault_does_what_it_says() {
    let fault = |kind: i32| {
        let settings = [(faulty::vr::FAULT_KIND, kind), (faulty::vr::FAULT_STEP, 2)];
        let mut component = stepping(&faulty::interface(Variant::Faithful), &settings);
        future(&mut component, 2);
        component
    };
    let q = |component: &mut Component| match component.get(u32::try_from(faulty::vr::Q).unwrap()) {
        Ok(Value::Real(q)) => q,
        other => panic!("{other:?}"),
    };
    for (kind, severity, mode) in
        [(2, Severity::Error, Mode::Failed), (3, Severity::Discard, Mode::Stepping), (4, Severity::Fatal, Mode::Dead)]
    {
        let mut component = fault(kind);
        assert_eq!(component.step(0.04, 0.02).unwrap_err().severity, severity);
        assert_eq!(component.mode(), mode);
    }
    for kind in [1, 9] {
        let mut component = fault(kind);
        assert!(q(&mut component).is_finite());
        component.step(0.04, 0.02).unwrap();
        assert_eq!(q(&mut component).is_nan(), kind == 1);
        assert_eq!(q(&mut component).is_infinite(), kind == 9);
    }
    let (mut one, mut two) = (fault(5), fault(5));
    assert_eq!(q(&mut one), q(&mut two));
    assert_ne!(future(&mut one, 1), future(&mut two, 1));

    let mut sharing = fault(7);
    let first = sharing.save().unwrap();
    sharing.restore(&first).unwrap();
    assert_eq!(sharing.tick, 40, "one round trip looks well");
    future(&mut sharing, 3);
    sharing.save().unwrap();
    sharing.restore(&first).unwrap();
    assert_eq!(sharing.tick, 100, "the second state has overwritten the first");

    let mut stubborn = fault(8);
    let before = q(&mut stubborn);
    stubborn.reset().unwrap();
    start(&mut stubborn);
    assert_eq!(q(&mut stubborn), before);
    let mut honest = fault(0);
    honest.reset().unwrap();
    start(&mut honest);
    assert_eq!(q(&mut honest), 0.0);
}

/// An instance with a fault in its third step, which starts at 0.04 s; the importer can do what FMI 3.0 allows.
fn fault3(kind: i32, importer: Importer) -> Component {
    let mut component = Component::new(&faulty::interface(Variant::Faithful).guid()).unwrap();
    component.serve(importer).unwrap();
    for (place, value) in [(faulty::vr::FAULT_KIND, kind), (faulty::vr::FAULT_STEP, 2)] {
        component.set(u32::try_from(place).unwrap(), Value::Integer(value)).unwrap();
    }
    start(&mut component);
    if importer.uses_events {
        component.update_discrete().unwrap();
        component.enter_step().unwrap();
    }
    future(&mut component, 2);
    component
}

const ABLE: Importer = Importer { uses_events: true, allows_early_return: true };

#[test]
fn an_early_return_stops_halfway_and_the_rest_follows() {
    let plain = StepEnd { event: false, terminate: false, early: false, time: 0.06 };
    let mut honest = fault3(0, ABLE);
    assert_eq!(honest.step(0.04, 0.02), Ok(plain));
    let mut early = fault3(10, ABLE);
    assert_eq!(early.step(0.04, 0.02), Ok(StepEnd { early: true, time: 0.05, ..plain }));
    assert_eq!(early.tick, 50);
    assert!(early.step(0.06, 0.02).is_err(), "not there yet");
    assert_eq!(early.step(0.05, 0.06 - 0.05), Ok(plain));
    assert_eq!(future(&mut early, 5)[..], future(&mut honest, 5)[..]);
    assert_eq!(fault3(10, Importer::default()).step(0.04, 0.02), Ok(plain), "not allowed, so not done");
}

#[test]
fn a_model_that_ends_the_simulation_takes_no_further_step() {
    let mut component = fault3(11, ABLE);
    let before = component.save().unwrap();
    let end = component.step(0.04, 0.02).unwrap();
    assert!(end.terminate && !end.early);
    assert_eq!((end.time, component.mode()), (0.06, Mode::Ended));
    assert!(component.step(0.06, 0.02).is_err());
    component.get(0).unwrap();
    component.restore(&before).unwrap();
    assert_eq!(component.mode(), Mode::Stepping);
    component.step(0.04, 0.02).unwrap();
    component.terminate().unwrap();
}

#[test]
fn an_event_has_the_same_effect_in_event_mode_and_without() {
    let mut without = fault3(12, Importer::default());
    assert!(!without.step(0.04, 0.02).unwrap().event);
    let mut with = fault3(12, ABLE);
    assert!(with.step(0.04, 0.02).unwrap().event);
    let mut forgetful = fault3(12, ABLE);
    forgetful.step(0.04, 0.02).unwrap();
    with.enter_event().unwrap();
    assert!(with.step(0.06, 0.02).is_err(), "not in event mode");
    let waiting = with.save().unwrap();
    with.update_discrete().unwrap();
    with.restore(&waiting).unwrap();
    with.update_discrete().unwrap();
    with.enter_step().unwrap();
    let expected = future(&mut without, 30);
    assert_eq!(future(&mut with, 30), expected);
    assert_ne!(future(&mut forgetful, 30), expected, "only an event that was handled has an effect");
    assert!(without.enter_event().is_err(), "this importer has no event mode");
}

#[test]
fn an_event_halfway_is_left_to_an_importer_that_allows_an_early_return() {
    let plain = StepEnd { event: false, terminate: false, early: false, time: 0.06 };
    let mut without = fault3(16, Importer::default());
    assert_eq!(without.step(0.04, 0.02), Ok(plain));
    let mut with = fault3(16, ABLE);
    assert_eq!(with.step(0.04, 0.02), Ok(StepEnd { event: true, early: true, time: 0.05, ..plain }));
    with.enter_event().unwrap();
    with.update_discrete().unwrap();
    with.enter_step().unwrap();
    assert_eq!(with.step(0.05, 0.06 - 0.05), Ok(plain));
    let mut dropped = fault3(16, Importer { allows_early_return: true, ..Importer::default() });
    assert_eq!(dropped.step(0.04, 0.02), Ok(StepEnd { early: true, time: 0.05, ..plain }));
    dropped.step(0.05, 0.06 - 0.05).unwrap();
    let expected = future(&mut without, 30);
    assert_eq!(future(&mut with, 30), expected);
    assert_ne!(future(&mut dropped, 30), expected, "nobody brought it through its event");
}

/// It is 50 ms after the beginning, announced in event mode only, and handled alone without, but by fault 20.
#[test]
fn an_announced_event_is_handled_where_it_is_announced_for_or_alone() {
    let mut with = fault3(18, ABLE);
    with.enter_event().unwrap();
    assert_eq!(with.update_discrete(), Ok(Some(0.05)));
    with.enter_step().unwrap();
    assert!(!with.step(0.04, 0.01).unwrap().event, "it was announced");
    with.enter_event().unwrap();
    assert_eq!(with.update_discrete(), Ok(None));
    with.enter_step().unwrap();
    with.step(0.05, 0.06 - 0.05).unwrap();
    let [mut alone, mut lost, mut honest] = [18, 20, 0].map(|kind| fault3(kind, Importer::default()));
    for component in [&mut alone, &mut lost, &mut honest] {
        component.step(0.04, 0.02).unwrap();
    }
    let expected = future(&mut alone, 30);
    assert_eq!(future(&mut with, 30), expected);
    let dropped = future(&mut lost, 30);
    assert_eq!(dropped, future(&mut honest, 30));
    assert_ne!(dropped, expected);
    // That of fault 19 is found by a step that ends there only.
    let [mut missed, mut found] = [fault3(19, Importer::default()), fault3(19, Importer::default())];
    missed.step(0.04, 0.02).unwrap();
    found.step(0.04, 0.01).unwrap();
    found.step(0.05, 0.06 - 0.05).unwrap();
    assert_eq!((future(&mut missed, 30), future(&mut found, 30)), (dropped, expected));
}

#[test]
fn a_lying_step_is_made_in_full() {
    let mut component = fault3(13, ABLE);
    let end = component.step(0.04, 0.02).unwrap();
    assert_eq!((end.early, end.time, component.tick), (false, 0.05, 60));
}

#[test]
fn modes_of_fmi_3_are_kept_apart_and_saved() {
    let mut cell = Component::new(&fence().guid()).unwrap();
    assert!(cell.serve(ABLE).is_err(), "the cells have no event mode");
    let mut component = Component::new(&faulty::interface(Variant::Faithful).guid()).unwrap();
    component.enter_configuration().unwrap();
    assert!(component.enter_initialization().is_err());
    assert!(component.set(4, Value::Real(0.5)).is_err());
    let saved = component.save().unwrap();
    component.exit_configuration().unwrap();
    let read = component.deserialize(&component.serialize(&saved).unwrap()).unwrap();
    component.restore(&read).unwrap();
    assert_eq!(component.mode(), Mode::Configuring);
}

#[test]
fn without_state_functions_every_one_of_them_refuses() {
    let mut component = stepping(&faulty::interface(Variant::NoState), &[]);
    assert!(component.save().is_err());
    assert!(component.deserialize(b"").is_err());
    let saved = stepping(&faulty::interface(Variant::Faithful), &[]).save().unwrap();
    assert!(component.restore(&saved).is_err());
    assert!(component.serialize(&saved).is_err());
}

#[test]
fn what_may_not_be_set_is_refused() {
    let mut component = stepping(&fence(), &[]);
    let reference = |place: usize| u32::try_from(place).unwrap();
    assert!(component.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(0.4)).is_err(), "fixed by now");
    component.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(0.3)).unwrap();
    assert!(component.set(reference(fence().place("robot.q[1]").unwrap()), Value::Real(0.0)).is_err(), "an output");
    assert!(component.set(reference(fence().place("plc.reset").unwrap()), Value::Real(1.0)).is_err(), "wrong type");
    assert!(component.set(99, Value::Real(1.0)).is_err(), "unknown");
    assert!(component.get(99).is_err(), "unknown");
    let mut early = Component::new(&fence().guid()).unwrap();
    assert!(
        early.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(f64::NAN)).is_err(),
        "not a number"
    );
    assert!(early.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(9.0)).is_err(), "out of range");
    assert!(Component::new("{other}").is_err());
}
