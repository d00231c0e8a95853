use crate::model::Model;
use crate::units::{ScaleChoice, Scales};

impl Model {
    /// Converts the model to other units. The result is a model in its own units, without a choice of scales.
    ///
    /// Tolerances of absolute convergence criteria are not converted, because they refer to the units of the solver.
    #[must_use]
    pub fn scaled(&self, scales: &Scales) -> Self {
        let couplings = self.scaled_couplings(scales);
        Self { units: None, couplings, scales: ScaleChoice::None, ..self.clone().scaled_keys(scales) }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};

    use toml::Value;

    use super::*;

    /// Model files of the tests. Together they state every key.
    fn models() -> Vec<(PathBuf, Model)> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/good");
        let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let models = paths.filter(|path| path.extension().is_some_and(|end| end == "toml"));
        models.map(|path| (path.clone(), Model::read(&path).unwrap())).collect()
    }

    /// Model without the keys that conversion removes.
    fn bare(model: Model) -> Model {
        Model { units: None, scales: ScaleChoice::None, ..model }
    }

    /// Largest relative difference of corresponding numbers.
    fn difference(a: &Value, b: &Value) -> f64 {
        match (a, b) {
            (Value::Float(a), Value::Float(b)) if a == b => 0.0,
            (Value::Float(a), Value::Float(b)) => (a - b).abs() / a.abs().max(b.abs()),
            (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
                a.iter().zip(b).map(|(a, b)| difference(a, b)).fold(0.0, f64::max)
            }
            (Value::Table(a), Value::Table(b)) if a.keys().eq(b.keys()) => {
                a.values().zip(b.values()).map(|(a, b)| difference(a, b)).fold(0.0, f64::max)
            }
            _ if a == b => 0.0,
            _ => f64::INFINITY,
        }
    }

    #[test]
    fn powers_of_two_are_undone_exactly() {
        let scales = Scales { length: 8.0, time: 0.25, force: 1024.0 };
        for (path, model) in models() {
            let scaled = model.scaled(&scales);
            assert_ne!(scaled, bare(model.clone()), "{}", path.display());
            assert_eq!(scaled.scaled(&scales.inverse()), bare(model), "{}", path.display());
        }
    }

    #[test]
    fn other_scales_are_undone_within_rounding() {
        let scales = Scales { length: 0.3, time: 7.1, force: 1e3 };
        for (path, model) in models() {
            let back = model.scaled(&scales).scaled(&scales.inverse());
            let [back, own] = [back, bare(model)].map(|model| Value::try_from(&model).unwrap());
            let difference = difference(&back, &own);
            assert!(difference < 1e-14, "{}: {difference}", path.display());
        }
    }

    #[test]
    fn factors_of_couplings_have_the_unit_of_the_joint() {
        let scales = Scales { length: 2.0, time: 1.0, force: 1.0 };
        let mut seen = [false; 2];
        for (_, model) in models() {
            let scaled = model.scaled(&scales);
            let parts = |model: &Model| {
                model.couplings.iter().flat_map(|coupling| coupling.joints.clone()).collect::<Vec<_>>()
            };
            for (own, scaled) in parts(&model).iter().zip(parts(&scaled)) {
                let ratio = scaled.factor / own.factor;
                assert!(ratio == 1.0 || ratio == 2.0, "{ratio}");
                seen[usize::from(ratio == 2.0)] = true;
            }
        }
        assert_eq!(seen, [true; 2]);
    }
}
