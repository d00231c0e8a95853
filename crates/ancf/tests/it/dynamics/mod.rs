//! Time integration: order, step control, initial conditions, Newton methods, rigid bodies.

mod adaptive;
mod adaptive_laws;
mod convergence;
mod dissipation;
mod energy;
mod energy_momentum;
mod initial_conditions;
mod newton_methods;
mod pendulum;
mod pulses;
mod restarts;
mod rigid_bodies;
mod schemes;
mod stiff_starts;
mod unresolved;
