//! Results of a study: page with figures and tables.

mod figures;
mod page;

pub use page::study_page;
