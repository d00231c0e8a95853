//! Conversion of models to other units.

mod choice_rule;
mod couplings;
mod model;
