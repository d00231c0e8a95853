use super::read::read_document;
use super::sequence::AnalysisSequence;
use super::valid_model::ValidModel;
use crate::errors::ModelErrors;
use crate::schema::Document;

/// Content of a model file: a single analysis or several.
#[derive(Clone, Debug)]
pub enum ModelFile {
    /// Model with a single analysis.
    Single(Box<ValidModel>),
    /// Models of a list of analyses.
    Sequence(AnalysisSequence),
}

impl ModelFile {
    /// Reads the text of a model file.
    ///
    /// # Errors
    /// All errors of the model or of the models of all analyses, in the order of the text.
    pub fn parse(text: &str) -> Result<Self, ModelErrors> {
        let mut document = Document::parse(text);
        match AnalysisSequence::of_document(&mut document, text)? {
            Some(sequence) => Ok(Self::Sequence(sequence)),
            None => Ok(Self::Single(Box::new(ValidModel(read_document(document, text)?)))),
        }
    }
}
