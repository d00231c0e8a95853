//! Time integration.

mod adaptive;
mod convergence;
mod initial_conditions;
mod newton_methods;
mod pendulum;
mod rigid_bodies;
mod schemes;
