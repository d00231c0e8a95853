use ancf_solver::eigen::LoadDirection;
use ancf_solver::equations::{EquationsOfMotion, State};
use ancf_solver::newton::Interrupt;
use ancf_solver::statics::Stability;
use nalgebra::DMatrix;
use toml::Value;

use super::critical_factors::CriticalFactors;
use super::differences::{Derivatives, DifferencePair, extrapolated, has_kink};
use super::equilibrium::AccurateEquilibrium;
use super::error::GradientError;
use super::frequencies::Frequencies;
use super::gradient_table::Gradients;
use super::parameter::{ModelNumber, Parameter};
use super::varied_models::VariedModels;
use crate::assembly::Assembly;
use crate::errors::{ModelError, ModelErrors};
use crate::failure::{RunFailure, require_support, unloaded};
use crate::initial::EquilibriumSearch;
use crate::model::{About, Analysis, Model, Statics};
use crate::results::{AngleRates, Column, LOAD, Rows, columns};
use crate::simulate::{NO_CRITICAL_LOAD, Outcome, Simulation, outcome};
use crate::units::Scales;

/// Computes the derivatives of the results of a model with respect to its numbers.
///
/// The results are the columns of the last equilibrium of statics, the frequencies of undamped modes, or critical load factors. The
/// equations of the equilibrium r(x, p) = 0 are differentiated: K dx/dp = −∂r/∂p with the stiffness K. For an eigenvalue θ of
/// A x = θ B x, dθ/dp = xᵀ (dA/dp − θ dB/dp) x / xᵀ B x, where A and B also change with the equilibrium. Terms are differentiated with
/// respect to p by extrapolated differences between assembled models; no solution is repeated. The derivatives are those of the
/// discrete equations. Equal eigenvalues have derivatives for one parameter at a time only, which is a warning.
///
/// Source: Choi & Kim (2005), direct differentiation; Ridders (1982), extrapolation; Ojalvo (1988), equal eigenvalues.
///
/// # Errors
/// If the model or a parameter is not valid, the analysis has no gradients or fails, or a force has a kink in the equilibrium.
///
/// ```
/// use ancf::{Model, Parameter, gradients};
///
/// let model = Model::parse(
///     r#"
///     materials.steel = { density = 7850.0, young = 2.1e11 }
///     sections.rod = { kind = "rectangle", width = 0.02, height = 0.01 }
///
///     [[bodies]]
///     kind = "beam"
///     name = "beam"
///     from = [0, 0, 0]
///     to = [1, 0, 0]
///     elements = 4
///     section = "rod"
///     material = "steel"
///
///     [[joints]]
///     kind = "clamp"
///     name = "root"
///     a = { body = "beam", at = "start" }
///
///     [analysis]
///     kind = "modes"
///     count = 1
///     "#,
/// )?;
/// let found = gradients(&model, &[Parameter::new("materials.steel.young")], &Default::default())?;
/// // The frequency is proportional to the root of the stiffness.
/// let relative = found.derivatives[(0, 0)] / found.values[0] * 2.1e11;
/// assert!((relative - 0.5).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gradients(
    model: &Model,
    parameters: &[Parameter],
    interrupt: &Interrupt,
) -> Result<Gradients, GradientError> {
    let data = data_of(model)?;
    let numbers = parameters.iter().map(|parameter| ModelNumber::new(&data, parameter));
    let (numbers, errors): (Vec<_>, Vec<_>) = numbers.partition(Result::is_ok);
    let errors: Vec<ModelError> = errors.into_iter().filter_map(Result::err).collect();
    if !errors.is_empty() {
        return Err(ModelErrors(errors).into());
    }
    let numbers: Vec<ModelNumber> = numbers.into_iter().flatten().collect();
    let simulation = Simulation::new(model)?.with_interrupt(interrupt.clone());
    let differentiation = Differentiation { simulation: &simulation, data: &data, numbers: &numbers };
    match &simulation.scaled.analysis {
        Analysis::Statics(settings) => differentiation.statics(settings),
        Analysis::Modes(settings) => differentiation.frequencies(settings.about, settings.count as usize),
        Analysis::Buckling(settings) => {
            differentiation.critical_factors(settings.count as usize, settings.sense.into())
        }
        Analysis::Dynamics(_) | Analysis::Path(_) => Err(no_gradients(model)),
    }
}

/// Data of a model whose numbers can be changed.
fn data_of(model: &Model) -> Result<Value, GradientError> {
    let unsupported = |path: &str, found: &str, expected: &str| {
        Err(ModelErrors(vec![ModelError::new(path, found, expected)]).into())
    };
    if model.is_extended() {
        return unsupported(
            "",
            "a part of a kind of the program's own",
            "joints, loads and sections of model files",
        );
    }
    if !model.contacts.is_empty() {
        return unsupported(
            "contacts",
            "contacts",
            "a model without contacts, for which there are gradients",
        );
    }
    let is_damped = matches!(&model.analysis, Analysis::Modes(settings) if settings.damped);
    if is_damped || matches!(&model.analysis, Analysis::Dynamics(_) | Analysis::Path(_)) {
        return Err(no_gradients(model));
    }
    let data = Value::try_from(model)
        .map_err(|error| ModelErrors(vec![ModelError::new("", error.to_string(), "a model")]))?;
    // The data lack functions that the program supplies.
    Model::from_value(&data)?.check_supplies()?;
    Ok(data)
}

fn no_gradients(model: &Model) -> GradientError {
    let found = match &model.analysis {
        Analysis::Dynamics(_) => "dynamics",
        Analysis::Path(_) => "a path",
        _ => "damped modes",
    };
    let expected = "statics, modes or buckling, for which there are gradients";
    ModelErrors(vec![ModelError::new("analysis", found, expected)]).into()
}

/// Derivatives with respect to a number, with their errors; `None` at a kink.
type Found = Result<Option<Vec<[f64; 2]>>, GradientError>;

/// Warning of an unstable equilibrium.
const UNSTABLE: &str = "the equilibrium is unstable: the structure would leave it";

/// Sizes of the changes of a number, relative to the largest.
const REDUCTIONS: [f64; 3] = [1.0, 1.0 / 64.0, 1.0 / 4096.0];

/// Analysis of a model whose results are differentiated with respect to numbers.
struct Differentiation<'a> {
    simulation: &'a Simulation,
    data: &'a Value,
    numbers: &'a [ModelNumber],
}

impl Differentiation<'_> {
    fn scales(&self) -> Scales {
        self.simulation.scales()
    }

    /// Differentiates the columns of the last equilibrium.
    fn statics(&self, settings: &Statics) -> Result<Gradients, GradientError> {
        let mut equilibrium = self.equilibrium(settings)?;
        let scales = self.scales();
        let row = |assembly: &Assembly, s: &State| row(assembly, s, scales);
        let values = row(&self.simulation.assembly, &equilibrium.state);
        let columns = columns(&self.simulation.assembly, LOAD, &[]);
        // Columns of errors are not known.
        let is_result: Vec<bool> =
            columns.iter().zip(&values).map(|(column, x)| column.name != LOAD && x.is_finite()).collect();
        let kept = |all: Vec<f64>| -> Vec<f64> {
            all.into_iter().zip(&is_result).filter(|(_, is_result)| **is_result).map(|(x, _)| x).collect()
        };
        let of_results = columns.into_iter().zip(&is_result).filter(|(_, is_result)| **is_result);
        let results = of_results.zip(kept(values)).map(|((column, _), value)| (column, value));
        let mut found = self.begin(results);
        let stability = Stability::new(&self.simulation.assembly.system, &equilibrium.state);
        if stability.is_some_and(|stability| stability.unstable > 0) {
            found.warnings.push(UNSTABLE.to_owned());
        }
        self.each(&mut found, |models| {
            let Some(change) = equilibrium.change(models)? else { return Ok(None) };
            let (_, Derivatives { values, errors, .. }) =
                equilibrium.derivatives(models, &change, |assembly, s| kept(row(assembly, s)));
            Ok(Some(values.into_iter().zip(errors).map(|(value, error)| [value, error]).collect()))
        })?;
        Ok(found)
    }

    /// Differentiates frequencies.
    fn frequencies(&self, about: About, count: usize) -> Result<Gradients, GradientError> {
        let assembly = &self.simulation.assembly;
        let (state, mut equilibrium) = match about {
            About::Reference => (unloaded(assembly), None),
            About::Equilibrium => {
                let found = self.equilibrium(&Statics::default())?;
                (found.state.clone(), Some(found))
            }
        };
        let modes = Frequencies::new(assembly, &state, count, &self.simulation.interrupt);
        let modes = modes.map_err(|failure| self.failure(failure))?;
        let rate = self.scales().time.recip();
        let values = modes.values().into_iter().map(|frequency| frequency * rate);
        let names = modes.names().into_iter().map(|name| Column::new(name, None));
        let mut found = self.begin(names.zip(values));
        if modes.unstable > 0 {
            found
                .warnings
                .push(format!("{} of the modes are unstable and have no frequency", modes.unstable));
        }
        let squares = |assembly: &Assembly, s: &State| modes.squares(assembly, s);
        let (centre, rounding) = (squares(assembly, &state), rounding_of(modes.sizes()));
        self.each(&mut found, |models| {
            let (pairs, forms) = match &mut equilibrium {
                Some(equilibrium) => {
                    let Some(change) = equilibrium.change(models)? else { return Ok(None) };
                    equilibrium.derivatives(models, &change, squares)
                }
                None => {
                    let pairs = unloaded_pairs(models, squares);
                    let forms = extrapolated(&pairs);
                    (pairs, forms)
                }
            };
            if has_kink(&pairs, &centre, &rounding) {
                return Ok(None);
            }
            Ok(Some(modes.derivatives(&forms).into_iter().map(|pair| pair.map(|x| x * rate)).collect()))
        })?;
        found.warn_of_equal(modes.groups.equal());
        found.truncate(modes.groups.requested);
        Ok(found)
    }

    /// Differentiates critical load factors.
    fn critical_factors(&self, count: usize, sense: LoadDirection) -> Result<Gradients, GradientError> {
        let assembly = &self.simulation.assembly;
        let state = unloaded(assembly);
        let supported = require_support(assembly, &state, self.scales());
        let factors = supported.and_then(|()| {
            CriticalFactors::new(assembly, &state, (count, sense), &self.simulation.interrupt)
        });
        let factors = factors.map_err(|failure| self.failure(failure))?;
        let names = factors.names().into_iter().map(|name| Column::new(name, None));
        let mut found = self.begin(names.zip(factors.values().iter().copied()));
        if factors.values().is_empty() {
            found.warnings.push(NO_CRITICAL_LOAD.to_owned());
        }
        let (centre, rounding) = (factors.squares(assembly, &state), rounding_of(factors.sizes()));
        self.each(&mut found, |models| {
            let pairs = unloaded_pairs(models, |assembly, s| factors.squares(assembly, s));
            let forms = extrapolated(&pairs);
            Ok((!has_kink(&pairs, &centre, &rounding)).then(|| factors.derivatives(&forms)))
        })?;
        found.warn_of_equal(factors.groups.equal());
        found.truncate(factors.groups.requested);
        Ok(found)
    }

    /// Computes the equilibrium of the model.
    fn equilibrium(&self, settings: &Statics) -> Result<AccurateEquilibrium<'_>, GradientError> {
        let Simulation { scaled: model, assembly, interrupt, .. } = self.simulation;
        let search =
            EquilibriumSearch { model, scales: self.scales(), assembly, settings, interrupt, given: None };
        let state = search.run(&mut |_, _| ()).map_err(|failure| self.failure(failure))?;
        AccurateEquilibrium::new(assembly, state)
    }

    fn begin(&self, results: impl Iterator<Item = (Column, f64)>) -> Gradients {
        let (columns, values): (Vec<Column>, Vec<f64>) = results.unzip();
        let zeros = DMatrix::zeros(columns.len(), self.numbers.len());
        let (quantities, dimensions) =
            columns.into_iter().map(|column| (column.name, column.dimension)).unzip();
        Gradients {
            quantities,
            values,
            dimensions,
            parameters: self.numbers.iter().map(|number| number.path.clone()).collect(),
            parameter_values: self.numbers.iter().map(|number| number.value).collect(),
            derivatives: zeros.clone(),
            errors: zeros,
            warnings: self.simulation.warnings.clone(),
        }
    }

    /// Computes the derivatives with respect to each number, with their errors.
    ///
    /// Where forces have kinks near the state, or derivatives are not accurate, the numbers are changed less.
    fn each(
        &self,
        found: &mut Gradients,
        mut of: impl FnMut(&VariedModels) -> Found,
    ) -> Result<(), GradientError> {
        let given = (&self.scales(), &self.simulation.assembly);
        for (column, number) in self.numbers.iter().enumerate() {
            number.require_freedom(self.data)?;
            let (mut is_known, mut invalid) = (false, None);
            for reduction in REDUCTIONS {
                if self.simulation.interrupt.is_set() {
                    return Err(GradientError::Interrupted);
                }
                let models = match VariedModels::new(self.data, &number.reduced(reduction), given) {
                    Ok(models) => models,
                    Err(GradientError::Model(errors)) if number.is_out_of_range(&errors) => {
                        invalid = Some(GradientError::Model(errors));
                        continue;
                    }
                    Err(error) => return Err(error),
                };
                let Some(derivatives) = of(&models)? else { continue };
                found.improve(column, &derivatives, is_known);
                is_known = true;
                if found.inaccurate(column).is_none() {
                    break;
                }
            }
            if !is_known {
                let path = &number.path;
                let kink = || {
                    GradientError::failed(format!(
                        "there is no derivative with respect to `{path}`: a force or a stiffness has a kink there"
                    ))
                };
                return Err(invalid.unwrap_or_else(kink));
            }
            let inaccurate = found.inaccurate(column);
            found.warnings.extend(inaccurate);
        }
        Ok(())
    }

    /// Failure of the analysis as an error.
    fn failure(&self, failure: RunFailure) -> GradientError {
        let Simulation { scaled, assembly, .. } = self.simulation;
        match outcome(Err(failure), scaled, assembly, self.scales()) {
            Outcome::Failed { reason, at, .. } => GradientError::Failed { reason, at },
            Outcome::Finished | Outcome::Stopped => GradientError::Interrupted,
        }
    }
}

/// Columns of an equilibrium.
fn row(assembly: &Assembly, s: &State, scales: Scales) -> Vec<f64> {
    let mut rows = Rows::new(assembly, scales, LOAD, &[]);
    rows.count_turns(s.load, s, AngleRates::Differences);
    rows.fill(assembly, s, s.load, &[], assembly.system.energy(s), None).to_vec()
}

/// Evaluates functions of the equations at the unloaded state, in which the joints of an assembled model are closed.
fn unloaded_pairs(
    models: &VariedModels,
    mut of: impl FnMut(&Assembly, &State) -> Vec<f64>,
) -> Vec<DifferencePair> {
    models.pairs(|assembly, _| of(assembly, &unloaded(assembly)))
}

/// Rounding error of a square of an eigenvector, relative to its parts.
const ROUNDING: f64 = 1e-9;

/// Bounds the rounding errors of squares of eigenvectors by the sizes of their parts.
fn rounding_of(mut sizes: Vec<f64>) -> Vec<f64> {
    sizes.iter_mut().for_each(|size| *size *= ROUNDING);
    sizes
}
