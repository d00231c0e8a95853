//! Linear static displacements.

use ancf::assembly::Assembly;
use ancf::solver::equations::{EquationsOfMotion, State, Weights};
use ancf::solver::factor::Factor;

/// Returns the linear static state under the loads of an assembly and additional generalised forces.
pub(crate) fn linear(assembly: &Assembly, forces: &[(usize, f64)]) -> State {
    let (system, mut state) = (&assembly.system, assembly.rest());
    let (mut matrix, mut x) = (system.matrix(), vec![0.0; system.coordinates() + system.multipliers()]);
    system.residual(&state, &mut x);
    x.iter_mut().for_each(|x| *x = -*x);
    for &(coordinate, force) in forces {
        x[coordinate] += force;
    }
    system.tangent(&state, Weights::STIFFNESS, &mut matrix);
    let mut factor = Factor::new(matrix.pattern()).unwrap();
    factor.factorise(&matrix).unwrap();
    factor.solve(&matrix, &mut x).unwrap();
    state.add(&x, Weights::STIFFNESS);
    state
}
