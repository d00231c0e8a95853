use std::hint::black_box;

use ancf::mechanics::batches::term_batches;
use ancf::mechanics::bodies::BeamMesh;
use ancf::solver::equations::{
    Batch, LANES, LOCAL, Lanes, Local, LocalLanes, LocalMatrix, State, Term, Weights,
};

/// Elements of a mesh with their gathered coordinates in a state: batches of elements, and terms without a batch.
pub struct ElementKernels {
    batches: Vec<GatheredBatch>,
    single: Vec<GatheredTerm>,
    count: usize,
}

struct GatheredTerm {
    term: Box<dyn Term>,
    /// q, v, a.
    at: [Vec<f64>; 3],
}

struct GatheredBatch {
    batch: Box<dyn Batch>,
    /// q, v, a.
    at: [Vec<Lanes>; 3],
}

impl std::fmt::Debug for ElementKernels {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (batches, single) = (self.batches.len(), self.single.len());
        f.debug_struct("ElementKernels").field("batches", &batches).field("single", &single).finish()
    }
}

impl ElementKernels {
    /// Gathers the coordinates of the elements of a mesh in a state.
    pub fn new(mesh: &BeamMesh, s: &State) -> Self {
        let terms = mesh.terms();
        let count = terms.len();
        let mut batched = vec![false; count];
        let gathered = |(own, batch): (Vec<usize>, Box<dyn Batch>)| {
            own.iter().for_each(|&term| batched[term] = true);
            let own: Vec<&dyn Term> = own.iter().map(|&term| &*terms[term]).collect();
            GatheredBatch { at: [&s.q, &s.v, &s.a].map(|x| lanes(&own, x)), batch }
        };
        let batches = term_batches(&terms).into_iter().map(gathered).collect();
        let single = terms.into_iter().zip(batched).filter(|(_, batched)| !batched).map(|(term, _)| {
            let of = |x: &[f64]| term.coordinates().iter().map(|&c| x[c]).collect();
            GatheredTerm { at: [of(&s.q), of(&s.v), of(&s.a)], term }
        });
        Self { batches, single: single.collect(), count }
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Evaluates the residual of each element: elastic and inertial forces minus weight.
    pub fn residual(&self) {
        let mut rows = [Lanes::default(); LOCAL];
        for GatheredBatch { batch, at } in &self.batches {
            let rows = &mut rows[..at[0].len()];
            rows.fill(Lanes::default());
            batch.residual(&local_lanes(at), rows);
            black_box(rows);
        }
        let mut rows = [0.0; LOCAL];
        for GatheredTerm { term, at } in &self.single {
            let rows = &mut rows[..at[0].len()];
            rows.fill(0.0);
            term.residual(&local(at), rows);
            black_box(rows);
        }
    }

    /// Evaluates the tangent of each element.
    pub fn tangent(&self, w: Weights) {
        if let Some(size) = self.batches.iter().map(|batch| batch.at[0].len()).max() {
            let mut lower = vec![Lanes::default(); size * (size + 1) / 2];
            for GatheredBatch { batch, at } in &self.batches {
                let n = at[0].len();
                let lower = &mut lower[..n * (n + 1) / 2];
                batch.tangent(&local_lanes(at), w, lower);
                black_box(lower);
            }
        }
        let mut storage = [0.0; LOCAL * (LOCAL + 1) / 2];
        for GatheredTerm { term, at } in &self.single {
            let mut block = LocalMatrix::zero(at[0].len(), &mut storage);
            term.tangent(&local(at), w, &mut block);
            black_box(block.lower());
        }
    }
}

/// Coordinates of terms, each term in a lane. Surplus lanes repeat the last term.
fn lanes(terms: &[&dyn Term], x: &[f64]) -> Vec<Lanes> {
    let of = |i: usize| {
        Lanes(std::array::from_fn::<_, LANES, _>(|l| x[terms[l.min(terms.len() - 1)].coordinates()[i]]))
    };
    (0..terms[0].coordinates().len()).map(of).collect()
}

fn local_lanes([q, v, a]: &[Vec<Lanes>; 3]) -> LocalLanes<'_> {
    LocalLanes { q, v, a, lambda: &[], load: 1.0 }
}

fn local([q, v, a]: &[Vec<f64>; 3]) -> Local<'_> {
    Local { q, v, a, lambda: &[], t: 0.0, load: 1.0 }
}
