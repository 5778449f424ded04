//! The safe FMI layer against a real binary: states belong to their instance, and a fatal error ends all calls.
//!
//! On its own in this file, because it looks at the memory of its process.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "suite/common/mod.rs"]
#[allow(dead_code, reason = "this program uses little of it")]
mod common;
use fmi_hazard_sample as sample;

use common::test_fmus;
use fmi_hazard::fmi::{Error, Fmu, Instance, Slave, Status, Stepping};

fn slave(name: &str) -> (Fmu, Slave) {
    let fmu = Fmu::open(&test_fmus().join(name)).unwrap();
    let slave = fmu.load().unwrap();
    (fmu, slave)
}

fn started(fmu: &Fmu, slave: &Slave, kind: i32, step: i32) -> Instance<Stepping> {
    let reference = |name: &str| fmu.description().variable(name).unwrap().value_reference;
    let mut instance = slave.instantiate("test").unwrap();
    instance.set_integer(&[reference("fault.kind"), reference("fault.step")], &[kind, step]).unwrap();
    instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap()
}

fn q(fmu: &Fmu, instance: &mut Instance<Stepping>) -> f64 {
    let mut value = [f64::NAN];
    instance.get_real(&[fmu.description().variable("q").unwrap().value_reference], &mut value).unwrap();
    value[0]
}

#[test]
fn a_state_restores_and_may_outlive_its_instance() {
    let (fmu, slave) = slave("faulty.fmu");
    let mut instance = started(&fmu, &slave, 0, 0);
    instance.do_step(0.0, 0.02).unwrap();
    let (state, before) = (instance.save().unwrap(), q(&fmu, &mut instance));
    instance.do_step(0.02, 0.02).unwrap();
    assert!(q(&fmu, &mut instance) > before);
    instance.restore(&state).unwrap();
    assert_eq!(q(&fmu, &mut instance).to_bits(), before.to_bits());
    let bytes = instance.serialize(&state).unwrap();
    drop(instance);
    drop(state);
    let mut other = started(&fmu, &slave, 0, 0);
    let state = other.deserialize(&bytes).unwrap();
    other.restore(&state).unwrap();
    assert_eq!(q(&fmu, &mut other).to_bits(), before.to_bits());
}

#[test]
fn a_state_of_another_instance_is_an_error_and_not_a_crash() {
    let (fmu, slave) = slave("faulty.fmu");
    let (mut a, mut b) = (started(&fmu, &slave, 0, 0), started(&fmu, &slave, 0, 0));
    let state = a.save().unwrap();
    assert!(matches!(b.restore(&state), Err(Error::ForeignState)));
    assert!(matches!(b.serialize(&state), Err(Error::ForeignState)));
    a.restore(&state).unwrap();
}

#[test]
fn a_dropped_state_gives_its_handle_back_for_reuse() {
    let (fmu, slave) = slave("faulty.fmu");
    let mut instance = started(&fmu, &slave, 0, 0);
    let resident = || {
        let text = std::fs::read_to_string("/proc/self/statm").unwrap();
        text.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap() * 4096
    };
    for _ in 0..1000 {
        drop(instance.save().unwrap());
    }
    let before = resident();
    for _ in 0..1_000_000 {
        drop(instance.save().unwrap());
    }
    // A million states of some hundred bytes would be above 64 MiB.
    assert!(resident() < before + (16 << 20), "{} -> {}", before, resident());
}

#[test]
fn failures_name_the_function_the_time_and_the_last_log_lines() {
    let (fmu, slave) = slave("faulty.fmu");
    let mut instance = started(&fmu, &slave, 2, 1);
    instance.do_step(0.0, 0.02).unwrap();
    let Err(Error::Call(failure)) = instance.do_step(0.02, 0.02) else { panic!("an error was expected") };
    assert_eq!((failure.function, failure.status, failure.time_s), ("fmi2DoStep", Status::Error, Some(0.02)));
    assert!(!failure.log.is_empty());
    let mut instance = started(&fmu, &slave, 3, 1);
    instance.do_step(0.0, 0.02).unwrap();
    let Err(Error::Call(failure)) = instance.do_step(0.02, 0.02) else { panic!("a discard was expected") };
    assert_eq!((failure.status, failure.last_successful_s), (Status::Discard, Some(0.02)));
}

#[test]
fn after_a_fatal_error_nothing_is_called_any_more() {
    let (fmu, slave) = slave("faulty.fmu");
    let mut bystander = started(&fmu, &slave, 0, 0);
    let mut instance = started(&fmu, &slave, 4, 0);
    assert!(instance.do_step(0.0, 0.02).unwrap_err().is_fatal());
    assert!(matches!(instance.do_step(0.0, 0.02), Err(Error::AfterFatal)));
    assert!(matches!(bystander.do_step(0.0, 0.02), Err(Error::AfterFatal)));
    assert!(matches!(slave.instantiate("another"), Err(Error::AfterFatal)));
}

#[test]
fn an_fmu_without_states_says_so() {
    let (fmu, slave) = slave("faulty-nostate.fmu");
    assert!(!slave.capabilities().can_get_and_set_state);
    let mut instance = started(&fmu, &slave, 0, 0);
    assert!(instance.save().is_err());
    instance.do_step(0.0, 0.02).unwrap();
}
