//! Initial states by their origin.

use ancf_solver::equations::State;
use ancf_solver::newton::Interrupt;
use ancf_solver::statics::Equilibrium;

use super::equilibrium_search::EquilibriumSearch;
use super::given_state::GivenState;
use super::initial_state::InitialState;
use super::report::InitialReport;
use super::start_state::StartState;
use super::turn_counter::TurnCounter;
use crate::assembly::Assembly;
use crate::diagnosis::projection_warning;
use crate::failure::{EquilibriumStability, RunFailure};
use crate::model::{IndexedModel, Model, Origin, TimeMode};
use crate::results::Rows;
use crate::units::Scales;

impl InitialState {
    /// Computes the initial state of a model in solver units, and counts the turns of joint angles up to it.
    ///
    /// # Errors
    /// If there is no equilibrium.
    pub(crate) fn new(
        (model, scales): (&Model, Scales),
        assembly: &Assembly,
        (interrupt, given): (&Interrupt, Option<&StartState>),
        rows: &mut Rows,
    ) -> Result<Self, RunFailure> {
        match (given, &model.initial.from) {
            (Some(given), _) => {
                rows.start_turns(&given.angles);
                given.initial_state((model, scales), assembly)
            }
            (None, Origin::Undeformed) => Ok(Self::undeformed(model, assembly)),
            (None, Origin::Equilibrium) => Self::equilibrium((model, scales), assembly, interrupt, rows)
                .map_err(|failure| RunFailure::Start(Box::new(failure))),
            (None, Origin::Folder(folder)) => Err(RunFailure::NoState(folder.clone())),
        }
    }

    /// Equilibrium with the velocities of the model.
    fn equilibrium(
        (model, scales): (&Model, Scales),
        motion: &Assembly,
        interrupt: &Interrupt,
        rows: &mut Rows,
    ) -> Result<Self, RunFailure> {
        let frozen = IndexedModel::new(model).assembled(TimeMode::AtStart);
        let assembly = &frozen.expect("gaps that were closed for the motion are closed for its equilibrium");
        let settings = &model.initial.statics.settings();
        let (mut stability, mut turns) =
            (EquilibriumStability::default(), TurnCounter::new(&assembly.system, &assembly.rest(), rows)?);
        let [mut increments, mut iterations] = [0, 0];
        let mut unstable = None;
        let mut each = |s: &State, found: Option<&Equilibrium>| {
            turns.count(rows, s);
            let Some(found) = found else { return };
            stability.add(s.load, found.unstable);
            (increments, iterations) = (increments + 1, iterations + u64::from(found.iterations));
            unstable = found.unstable;
        };
        let search = EquilibriumSearch { model, scales, assembly, settings, interrupt, given: None };
        let found = search.run(&mut each)?;
        rows.restart_turns();
        let warnings = stability.warnings(assembly, &found, scales, false).into_iter();
        let warnings = warnings.map(|warning| format!("equilibrium at the start: {warning}"));
        // Motions have further coordinates for the states of force laws.
        let has_states = motion.joints.iter().any(|joint| !joint.states.is_empty());
        let found = if has_states { transferred(assembly, motion, scales, &found) } else { found };
        let state = motion.with_motions(found, model);
        let warnings = warnings.chain(motion.projection(&state).and_then(projection_warning)).collect();
        Ok(Self {
            state,
            report: Some(InitialReport::Equilibrium { increments, iterations, unstable }),
            warnings,
        })
    }
}

/// State of an assembly of a model as state of another assembly of the model.
fn transferred(from: &Assembly, to: &Assembly, scales: Scales, state: &State) -> State {
    let given = GivenState::new(from, scales, state, String::new());
    given.state(to, scales).expect("assemblies of a model have the same bodies and joints")
}
