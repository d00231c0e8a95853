use super::term_sums::LocalState;
use super::terms::{LOCAL, Local, LocalMatrix, State, Term, Weights};

/// Force changes of laws with kinks within a step, without those that a linear law has.
///
/// R = Δf − K Δq − D Δv between the ends, with the derivatives K and D at the end where they explain less, and f − ½(f₀ + f₁) in the
/// middle. A stop that acts at one end only has its whole force there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LawChanges {
    /// Numbers of the terms, in ascending order.
    pub terms: Vec<usize>,
    /// Forces R between the ends and in the middle, by coordinate.
    pub forces: [Vec<f64>; 2],
}

/// Work of a force change below this part of that of a linear law is negligible: the law is smooth within the step.
const NEGLIGIBLE: f64 = 0.1;

/// Returns the changes of terms, by their numbers, in a step; `None` if all laws are nearly linear there.
pub(super) fn law_changes<'a>(
    terms: impl Iterator<Item = (usize, &'a dyn Term)>,
    [from, middle, to]: [&State; 3],
) -> Option<LawChanges> {
    let zeros = vec![0.0; from.q.len()];
    let mut changes = LawChanges { terms: Vec::new(), forces: [zeros.clone(), zeros] };
    let (mut gathered, mut storage) = ([const { LocalState::EMPTY }; 3], vec![0.0; LOCAL * (LOCAL + 1) / 2]);
    for (number, term) in terms.filter(|(_, term)| term.has_kinks()) {
        let [a, b, c] = &mut gathered;
        let ends = [a.gather(from, term), c.gather(to, term)];
        let Some(own) = changes_of(term, ends, &b.gather(middle, term), &mut storage) else { continue };
        for (sum, own) in changes.forces.iter_mut().zip(own) {
            term.coordinates().iter().zip(own).for_each(|(&i, force)| sum[i] += force);
        }
        changes.terms.push(number);
    }
    (!changes.terms.is_empty()).then_some(changes)
}

type Forces = [f64; LOCAL];

/// Returns the changes of a term; `None` if its law is nearly linear in the step. `storage` is that of a matrix.
fn changes_of(
    term: &dyn Term,
    ends: [Local<'_>; 2],
    middle: &Local<'_>,
    storage: &mut [f64],
) -> Option<[Forces; 2]> {
    let n = term.coordinates().len();
    let [before, after] = &ends;
    let (mut moved, mut sped_up) = ([0.0; LOCAL], [0.0; LOCAL]);
    for i in 0..n {
        (moved[i], sped_up[i]) = (after.q[i] - before.q[i], after.v[i] - before.v[i]);
    }
    let h = after.t - before.t;
    let dot = |x: &Forces, y: &Forces| (0..n).map(|i| x[i] * y[i]).sum::<f64>();
    let work = |force: &Forces| dot(force, &moved).abs() + h * dot(force, &sped_up).abs();
    let [start, between, end] = [before, middle, after].map(|at| forces(term, at));
    let linear = [before, after].map(|at| linear_change(term, at, [&moved, &sped_up], storage));
    let linear = if work(&linear[0]) <= work(&linear[1]) { linear[0] } else { linear[1] };
    let (mut change, mut bend) = ([0.0; LOCAL], [0.0; LOCAL]);
    for i in 0..n {
        change[i] = end[i] - start[i] - linear[i];
        bend[i] = between[i] - 0.5 * (start[i] + end[i]);
    }
    let changes = [change, bend];
    changes.iter().any(|change| work(change) > NEGLIGIBLE * work(&linear)).then_some(changes)
}

fn forces(term: &dyn Term, at: &Local<'_>) -> Forces {
    let mut r = [0.0; LOCAL];
    term.residual(at, &mut r[..at.q.len() + term.multipliers().len()]);
    r
}

/// Returns K Δq + D Δv.
fn linear_change(term: &dyn Term, at: &Local<'_>, changes: [&Forces; 2], storage: &mut [f64]) -> Forces {
    let (n, mut sum) = (at.q.len(), [0.0; LOCAL]);
    for (w, x) in [Weights::STIFFNESS, Weights::DAMPING].into_iter().zip(changes) {
        let mut matrix = LocalMatrix::zero(n + term.multipliers().len(), storage);
        term.tangent(at, w, &mut matrix);
        for i in 0..n {
            sum[i] += (0..n).map(|j| matrix.get(i.max(j), i.min(j)) * x[j]).sum::<f64>();
        }
    }
    sum
}
