//! Laws of forces along one coordinate, by formulas and by functions of programs.

mod contact_law;
mod force_law;
mod friction_curve;
mod law_expression;
mod resistance;
mod state_law;
mod stops;

pub use contact_law::ContactLaw;
pub use force_law::{ForceLaw, LawNumber, LawState, LawValue, UserForceLaw};
pub use friction_curve::FrictionCurve;
pub use law_expression::{LawExpression, LawVariables, is_law_name};
pub use resistance::{LawUnits, Resistance};
pub use state_law::{LawStateVariable, StateLaw, StateLawError};
pub use stops::Stops;
