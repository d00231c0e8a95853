//! Stability of the equilibria of statics and paths. Unstable equilibria become warnings.

use ancf_solver::eigen::{ComplexMode, nonconservative_modes, skew_ratio};
use ancf_solver::equations::{EquationsOfMotion, State};
use ancf_solver::newton::Interrupt;

use super::stability::{directions, instability};
use crate::assembly::Assembly;
use crate::errors::short;
use crate::units::Scales;

/// Stability of the equilibria so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct EquilibriumStability {
    /// Number of equilibria, and the load factor of the last one.
    count: usize,
    load: f64,
    /// Unstable parts in the order of the analysis.
    parts: Vec<UnstablePart>,
    /// True if the last equilibrium is unstable.
    is_unstable: bool,
    /// True if the stability of the last equilibrium is unknown.
    is_unknown: bool,
}

/// Consecutive unstable equilibria.
#[derive(Clone, Debug)]
struct UnstablePart {
    /// Load factors of the last stable and the first unstable equilibrium.
    between: [f64; 2],
    /// Numbers of the first and the last equilibrium, and the load factor of the last one.
    first: usize,
    last: usize,
    to: f64,
    /// Largest number of unstable directions.
    most: usize,
}

impl EquilibriumStability {
    /// Adds an equilibrium with its number of unstable directions.
    pub(crate) fn add(&mut self, load: f64, unstable: Option<usize>) {
        self.count += 1;
        self.is_unknown = unstable.is_none();
        match unstable {
            None => self.is_unstable = false,
            Some(0) => self.is_unstable = false,
            Some(most) => {
                let (count, between) = (self.count, [self.load, load]);
                let new = UnstablePart { between, first: count, last: count, to: load, most };
                match self.parts.last_mut().filter(|_| self.is_unstable) {
                    Some(part) => (part.last, part.to, part.most) = (count, load, part.most.max(most)),
                    None => self.parts.push(new),
                }
                self.is_unstable = true;
            }
        }
        self.load = load;
    }

    /// Warnings after the last equilibrium `s` of statics or of a path.
    pub(crate) fn warnings(&self, assembly: &Assembly, s: &State, scales: Scales, path: bool) -> Vec<String> {
        let mut warnings: Vec<String> = self.parts.iter().map(|part| part.text(path)).collect();
        if let (true, Some(part)) = (self.is_unstable, self.parts.last()) {
            let found = instability(assembly, s);
            let place = found.map_or_else(String::new, |found| {
                format!(", most at {}", assembly.name_in(found.at, scales.length))
            });
            let count = found.map_or(part.most, |found| found.count);
            let advice = if path {
                "a small imperfection or side load leads to the branch that a structure takes"
            } else {
                "`unstable = \"leave\"`, a small imperfection or a side load leads to a stable equilibrium"
            };
            let consequence = if assembly.system.skew_damping(s).is_empty() {
                "no structure stays in it"
            } else {
                "no structure stays in it unless Coriolis forces stabilise it (modes with `about = \"equilibrium\"` and `damped = true`)"
            };
            warnings.push(format!(
                "the last equilibrium, at load factor {}, is unstable in {}{place} (buckling or snap-through): {consequence}; {advice}",
                short(self.load),
                directions(count)
            ));
        }
        let unknown = || {
            format!("the stability of the equilibrium at load factor {} was not determined", short(self.load))
        };
        let is_stable = !self.is_unstable && !self.is_unknown;
        match without_potential(assembly, s, scales, is_stable) {
            Some(Ok(text)) => warnings.extend(text),
            None if !self.is_unknown => {}
            Some(Err(())) | None => warnings.push(unknown()),
        }
        warnings
    }
}

/// Number of modes that are examined for flutter.
const MODES: usize = 8;
/// Growth rate, relative to the circular frequency, up to which the damping of any structure suppresses flutter. Without
/// damping a round cantilever flutters under the smallest torque (Nicolai 1928).
const DAMPED: f64 = 0.01;

/// Examines the modes of a state under loads without a potential: `None` if there are none, else the warning of an
/// unstable mode, or an error if the modes were not found.
///
/// `is_stable`: the symmetric part of the stiffness is positive definite. A small skew part then causes no growth above the limit:
/// sin ½φ ≈ ½ |Im ω²|/Re ω².
fn without_potential(
    assembly: &Assembly,
    s: &State,
    scales: Scales,
    is_stable: bool,
) -> Option<Result<Option<String>, ()>> {
    let complete = assembly.system.with_active_terms(s);
    let system = complete.as_ref().map_or(&assembly.system, |(system, _)| system);
    if system.skew_stiffness(s).is_empty() {
        return None;
    }
    match skew_ratio(system, system.matrix(), s) {
        Ok(0.0) => return None,
        Ok(ratio) if is_stable && ratio < DAMPED => return Some(Ok(None)),
        _ => {}
    }
    let Ok(modes) = nonconservative_modes(system, system.matrix(), s, MODES, &Interrupt::default()) else {
        return Some(Err(()));
    };
    let is_significant = |mode: &&ComplexMode| {
        let size = mode.omega_squared.norm().sqrt();
        mode.is_unstable() && mode.frequency_and_growth()[1] > DAMPED * size
    };
    let mut unstable = modes.iter().filter(is_significant);
    Some(Ok(unstable.next().map(|mode| {
        let [frequency, growth] = mode.frequency_and_growth().map(|x| x / scales.time);
        let kind = if mode.omega_squared.im == 0.0 {
            "diverges".to_owned()
        } else {
            format!("flutters at the frequency {}", short(frequency))
        };
        format!(
            "the last equilibrium, at load factor {}, is unstable under its loads without a potential: it {kind}, with the \
             growth rate {}; modes with `about = \"equilibrium\"` have the details",
            short(s.load),
            short(growth)
        )
    })))
}

impl UnstablePart {
    fn text(&self, path: bool) -> String {
        let Self { between: [stable, unstable], first, last, to, most } = self;
        let [stable, unstable, to] = [stable, unstable, to].map(|load| short(*load));
        let (what, directions) = (if path { "path" } else { "equilibrium" }, directions(*most));
        let points = if path { format!(" (points {first} to {last})") } else { String::new() };
        format!(
            "the {what} lost its stability between the load factors {stable} and {unstable}: it is unstable in up to \
             {directions} up to load factor {to}{points}"
        )
    }
}
