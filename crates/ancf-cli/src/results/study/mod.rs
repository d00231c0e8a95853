//! Results of a study: page with figures and tables.

mod figures;
mod live;
mod page;

pub use live::LiveStudy;
pub use page::study_page;
