use ancf_mechanics::shells::SectionField;

use super::shell_fields::{FieldDefect, FieldError, FieldPoint, GivenFields, ShellFields};

/// Place of a shell with a weight: element, (ξ, η) in it, and the weight of the area dξ dη.
pub(crate) type FieldPlace = (usize, [f64; 2], f64);

/// Smallest, mean and largest thickness of a shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ThicknessRange {
    pub(crate) least: f64,
    /// Mean over the area.
    pub(crate) mean: f64,
    pub(crate) largest: f64,
}

/// Shell whose section may vary over the surface.
pub(crate) trait FieldShell {
    /// Fields as given.
    fn given(&self) -> GivenFields<'_>;

    /// Points of the surface by element and (ξ, η) in it.
    fn field_points(&self) -> Box<dyn Fn(usize, [f64; 2]) -> FieldPoint + Send + Sync>;

    /// Places of all elements at which sections are evaluated; none for an invalid surface.
    fn field_places(&self) -> Box<dyn Iterator<Item = FieldPlace> + '_>;

    /// Description of a point of an element.
    fn describe_point(&self, element: usize, point: &FieldPoint) -> String;

    /// Places by which the range of the thickness is evaluated.
    fn range_places(&self) -> Box<dyn Iterator<Item = FieldPlace> + '_> {
        self.field_places()
    }

    /// True if all points have the same section.
    fn is_uniform(&self) -> bool {
        self.given().are_uniform()
    }

    /// True if the thickness is a field.
    fn has_varying_thickness(&self) -> bool {
        self.given().thickness.uniform().is_none()
    }

    /// Fields for evaluation.
    ///
    /// # Errors
    /// If a formula has a syntax error.
    fn fields(&self) -> Result<ShellFields, FieldError> {
        self.given().compile()
    }

    /// Range of the thickness; not a number without places or for invalid formulas.
    fn thickness_range(&self) -> ThicknessRange {
        if let Some(h) = self.given().thickness.uniform() {
            return ThicknessRange { least: h, mean: h, largest: h };
        }
        let none = ThicknessRange { least: f64::NAN, mean: f64::NAN, largest: f64::NAN };
        let Ok(fields) = self.fields() else { return none };
        let (points, mut least, mut largest) = (self.field_points(), f64::INFINITY, 0.0_f64);
        let (mut volume, mut area) = (0.0, 0.0);
        for (element, at, weight) in self.range_places() {
            let point = points(element, at);
            let (h, own) = (fields.at(&point).thickness, weight * point.normal.norm());
            (least, largest) = (least.min(h), largest.max(h));
            (volume, area) = (volume + own * h, area + own);
        }
        if area > 0.0 { ThicknessRange { least, mean: volume / area, largest } } else { none }
    }

    /// First defect of the fields of a valid surface, with the description of its place.
    fn field_defect(&self) -> Option<(FieldDefect, String)> {
        let (fields, points) = (self.fields().ok()?, self.field_points());
        self.field_places().find_map(|(element, at, _)| {
            let point = points(element, at);
            Some((fields.at(&point).defect(&point)?, self.describe_point(element, &point)))
        })
    }

    /// Sections relative to that of a thickness; `None` if all points have the same section.
    ///
    /// # Panics
    /// If a formula has a syntax error, which checks of the model exclude.
    fn section_field(&self, thickness: f64) -> Option<SectionField> {
        if self.is_uniform() {
            return None;
        }
        let fields = self.fields().expect("the formulas of a checked model have no syntax errors");
        let points = self.field_points();
        Some(SectionField::new(move |element, at| fields.at(&points(element, at)).section(thickness)))
    }
}
