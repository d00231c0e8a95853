//! The elements of a mesh alone: their share of the equations, gathered beforehand and scattered nowhere.

use std::hint::black_box;

use ancf::mechanics::BeamMesh;
use ancf::system::{Batch, LANES, LOCAL, Lanes, Local, LocalLanes, LocalMatrix, State, Term, Weights};

/// The elements of a mesh with their unknowns in a state: batches where there are some, else terms one by one.
pub struct Kernels {
    batches: Vec<Several>,
    alone: Vec<One>,
    count: usize,
}

struct One {
    term: Box<dyn Term>,
    /// q, v, a.
    at: [Vec<f64>; 3],
}

struct Several {
    batch: Box<dyn Batch>,
    /// q, v, a.
    at: [Vec<Lanes>; 3],
}

impl std::fmt::Debug for Kernels {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (batches, alone) = (self.batches.len(), self.alone.len());
        f.debug_struct("Kernels").field("batches", &batches).field("alone", &alone).finish()
    }
}

impl Kernels {
    /// The elements of a mesh in a state.
    pub fn new(mesh: &BeamMesh, s: &State) -> Self {
        let terms = mesh.terms();
        let count = terms.len();
        let mut batched = vec![false; count];
        let several = |(first, batch): (usize, Box<dyn Batch>)| {
            let own = first..first + batch.count();
            batched[own.clone()].fill(true);
            Several { at: [&s.q, &s.v, &s.a].map(|x| lanes(&terms[own.clone()], x)), batch }
        };
        let batches = mesh.batches().into_iter().map(several).collect();
        let alone = terms.into_iter().zip(batched).filter(|(_, batched)| !batched).map(|(term, _)| {
            let of = |x: &[f64]| term.coordinates().iter().map(|&c| x[c]).collect();
            One { at: [of(&s.q), of(&s.v), of(&s.a)], term }
        });
        Self { batches, alone: alone.collect(), count }
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The residual of each: elastic and inertial force, less weight.
    pub fn residual(&self) {
        let mut rows = [Lanes::default(); LOCAL];
        for Several { batch, at } in &self.batches {
            let rows = &mut rows[..at[0].len()];
            rows.fill(Lanes::default());
            batch.residual(&side_by_side(at), rows);
            black_box(rows);
        }
        let mut rows = [0.0; LOCAL];
        for One { term, at } in &self.alone {
            let rows = &mut rows[..at[0].len()];
            rows.fill(0.0);
            term.residual(&single(at), rows);
            black_box(rows);
        }
    }

    /// The tangent of each.
    pub fn tangent(&self, w: Weights) {
        if let Some(size) = self.batches.iter().map(|several| several.at[0].len()).max() {
            let mut lower = vec![Lanes::default(); size * (size + 1) / 2];
            for Several { batch, at } in &self.batches {
                let n = at[0].len();
                let lower = &mut lower[..n * (n + 1) / 2];
                batch.tangent(&side_by_side(at), w, lower);
                black_box(lower);
            }
        }
        let mut storage = [0.0; LOCAL * (LOCAL + 1) / 2];
        for One { term, at } in &self.alone {
            let mut block = LocalMatrix::zero(at[0].len(), &mut storage);
            term.tangent(&single(at), w, &mut block);
            black_box(block.lower());
        }
    }
}

/// A coordinate of each term in a lane; lanes beyond repeat the last term.
fn lanes(terms: &[Box<dyn Term>], x: &[f64]) -> Vec<Lanes> {
    let of = |i: usize| {
        Lanes(std::array::from_fn::<_, LANES, _>(|l| x[terms[l.min(terms.len() - 1)].coordinates()[i]]))
    };
    (0..terms[0].coordinates().len()).map(of).collect()
}

fn side_by_side([q, v, a]: &[Vec<Lanes>; 3]) -> LocalLanes<'_> {
    LocalLanes { q, v, a, load: 1.0 }
}

fn single([q, v, a]: &[Vec<f64>; 3]) -> Local<'_> {
    Local { q, v, a, lambda: &[], t: 0.0, load: 1.0 }
}
