//! What measures the speed of `ancf`: a table of rows beside their goals, and counts of instructions for comparison.
//!
//! ```text
//! model -> plant -> subject -> table          time of the processor per element, beside goals, peers and the machine's best
//!                      |  \--> benches/rows   the same by criterion, to compare before and after
//!                      \--> instructions      counts of fixed work, which no other load of the machine disturbs
//! ```
//!
//! All goes through the public interface of the library, so that it holds whatever is inside.

pub mod clock;
pub mod counts;
pub mod instructions;
pub mod kernels;
pub mod least;
pub mod machine;
pub mod measure;
pub mod model;
pub mod motion;
pub mod process;
pub mod report;
pub mod row;
pub mod subject;
pub mod table;
