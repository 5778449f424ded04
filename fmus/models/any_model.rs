//! The choice of the model that runs.

use std::sync::OnceLock;

use crate::bytes::Reader;
use crate::cells::coupled::{Controller, Kinematics, Plc, StationsPlc};
use crate::cells::faulty::Faulty;
use crate::cells::gantry::Gantry;
use crate::cells::guarded::Guarded;
use crate::cells::liar::Liar;
use crate::cells::workcell::Workcell;
use crate::interface;
use crate::interface::variables::{Interface, Variant};
use crate::model::{Model, Special};

/// The running model. As an enum it stays a plain value, so that saving and restoring are copies.
#[derive(Debug, Clone, Copy)]
pub enum AnyModel {
    /// A workcell.
    Workcell(Workcell),
    /// A safety controller to be coupled.
    Plc(Plc),
    /// One with two stations.
    StationsPlc(StationsPlc),
    /// A robot controller to be coupled.
    Controller(Controller),
    /// Kinematics to be coupled.
    Kinematics(Kinematics),
    /// The model that misbehaves on demand.
    Faulty(Faulty),
    /// Two slides with a stop of many kinds.
    Gantry(Gantry),
    /// The model whose states lie on demand.
    Liar(Liar),
    /// The model with all that can be set wrongly.
    Guarded(Guarded),
}

/// All interfaces, built once.
fn interfaces() -> &'static [Interface] {
    static ALL: OnceLock<Vec<Interface>> = OnceLock::new();
    ALL.get_or_init(interface::all)
}

/// The interface with this GUID. Only of those whose name it holds the whole GUID is made: each takes the text of a whole table.
pub fn interface_of(guid: &str) -> Option<&'static Interface> {
    static GUIDS: OnceLock<Vec<OnceLock<String>>> = OnceLock::new();
    let guids = GUIDS.get_or_init(|| interfaces().iter().map(|_| OnceLock::new()).collect());
    let named = interfaces().iter().zip(guids).filter(|(interface, _)| guid.ends_with(&interface.end_of_guid()));
    named.into_iter().find(|(interface, known)| known.get_or_init(|| interface.guid()) == guid).map(|(found, _)| found)
}

impl AnyModel {
    /// A new instance with all start values; None if no model has this identifier.
    pub fn new(identifier: &str) -> Option<Self> {
        match identifier {
            "faulty" | "faulty_nostate" => Some(AnyModel::Faulty(Faulty::new())),
            "gantry" => Some(AnyModel::Gantry(Gantry::new())),
            "liar" => Some(AnyModel::Liar(Liar::new())),
            "guarded" => Some(AnyModel::Guarded(Guarded::new())),
            "sensor_mat_plc" => Some(AnyModel::Plc(Plc::new())),
            "two_operators_plc" => Some(AnyModel::StationsPlc(StationsPlc::new())),
            "sensor_mat_controller" | "two_operators_controller" => Some(AnyModel::Controller(Controller::new())),
            "sensor_mat_kinematics" | "two_operators_kinematics" => Some(AnyModel::Kinematics(Kinematics::new())),
            _ => Workcell::new(identifier).map(AnyModel::Workcell),
        }
    }

    /// The model behind the trait.
    pub fn get(&self) -> &dyn Model {
        match self {
            AnyModel::Workcell(model) => model,
            AnyModel::Plc(model) => model,
            AnyModel::StationsPlc(model) => model,
            AnyModel::Controller(model) => model,
            AnyModel::Kinematics(model) => model,
            AnyModel::Faulty(model) => model,
            AnyModel::Gantry(model) => model,
            AnyModel::Liar(model) => model,
            AnyModel::Guarded(model) => model,
        }
    }

    /// The model behind the trait.
    pub fn get_mut(&mut self) -> &mut dyn Model {
        match self {
            AnyModel::Workcell(model) => model,
            AnyModel::Plc(model) => model,
            AnyModel::StationsPlc(model) => model,
            AnyModel::Controller(model) => model,
            AnyModel::Kinematics(model) => model,
            AnyModel::Faulty(model) => model,
            AnyModel::Gantry(model) => model,
            AnyModel::Liar(model) => model,
            AnyModel::Guarded(model) => model,
        }
    }

    /// Back to a saved state, as faithfully as the variant does it.
    pub fn restore(&mut self, saved: &Self, variant: Variant) {
        match (self, saved) {
            (AnyModel::Faulty(model), AnyModel::Faulty(saved)) => model.restore(saved),
            (AnyModel::Liar(model), AnyModel::Liar(saved)) => model.restore(saved),
            (AnyModel::Workcell(model), AnyModel::Workcell(saved)) if variant == Variant::ForgetsLatch => {
                *model = saved.forgetting_latches(model);
            }
            (model, saved) => *model = *saved,
        }
    }

    /// Back to the start values, unless the variant does not.
    pub fn reset(&mut self, variant: Variant) {
        if variant == Variant::IdleReset {
            return;
        }
        match self {
            AnyModel::Workcell(model) => *model = model.fresh(),
            AnyModel::Plc(model) => *model = Plc::new(),
            AnyModel::StationsPlc(model) => *model = StationsPlc::new(),
            AnyModel::Controller(model) => *model = Controller::new(),
            AnyModel::Kinematics(model) => *model = Kinematics::new(),
            AnyModel::Faulty(model) => model.reset(),
            AnyModel::Gantry(model) => *model = Gantry::new(),
            AnyModel::Liar(model) => *model = Liar::new(),
            AnyModel::Guarded(model) => *model = Guarded::new(),
        }
    }

    /// Whether saved states are to share one buffer (a fault that importers must notice).
    pub fn shares_saved_states(&self) -> bool {
        matches!(self, AnyModel::Faulty(model) if model.shares_saved_states())
    }

    /// What the next step has in store.
    pub fn special(&self) -> Special {
        if let AnyModel::Faulty(model) = self { model.special() } else { Special::None }
    }

    /// Lets an event that is waiting take effect.
    pub fn handle_event(&mut self) {
        if let AnyModel::Faulty(model) = self {
            model.handle_event();
        }
    }

    /// The next event that is known beforehand, ms.
    pub fn announced(&self) -> Option<u64> {
        if let AnyModel::Faulty(model) = self { model.announced() } else { None }
    }

    /// Whether it handles such an event by itself, where no event mode is used.
    pub fn handles_announced(&self) -> bool {
        matches!(self, AnyModel::Faulty(model) if model.handles_announced())
    }

    /// Reads a model of the same kind from bytes.
    pub fn read(&self, input: &mut Reader) -> Option<Self> {
        match self {
            AnyModel::Workcell(model) => model.read(input).map(AnyModel::Workcell),
            AnyModel::Plc(_) => Plc::read(input).map(AnyModel::Plc),
            AnyModel::StationsPlc(_) => StationsPlc::read(input).map(AnyModel::StationsPlc),
            AnyModel::Controller(_) => Controller::read(input).map(AnyModel::Controller),
            AnyModel::Kinematics(_) => Kinematics::read(input).map(AnyModel::Kinematics),
            AnyModel::Faulty(_) => Faulty::read(input).map(AnyModel::Faulty),
            AnyModel::Gantry(_) => Gantry::read(input).map(AnyModel::Gantry),
            AnyModel::Liar(_) => Liar::read(input).map(AnyModel::Liar),
            AnyModel::Guarded(_) => Guarded::read(input).map(AnyModel::Guarded),
        }
    }
}
