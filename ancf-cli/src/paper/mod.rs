//! Every table and figure of Kim et al. (2017).

pub mod cases;
pub mod conditioning;
pub mod machine;
pub mod published;
pub mod rigid;
pub mod study;
