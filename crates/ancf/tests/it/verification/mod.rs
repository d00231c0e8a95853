//! Verification against published and independently computed numbers.
//!
//! Files are named after their source or subject. Each number has its source beside it.

mod balance;
mod chrono_3243;
mod eigenvalues;
mod kim;
mod large_deflections;
mod linear_beam;
