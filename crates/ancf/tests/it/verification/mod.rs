//! Verification: the element, the joints and the schemes against published and independently computed numbers.
//!
//! Files are named after their source. Where a number comes from is said beside it.

mod balance;
mod chrono_3243;
mod eigenvalues;
mod kim;
mod large_deflections;
mod linear_beam;
