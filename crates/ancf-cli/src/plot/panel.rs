//! Curves with common axes.

/// Curves with common axes.
#[derive(Debug)]
pub struct PlotPanel {
    /// Label of the horizontal axis.
    pub x: String,
    /// True for points without lines between them, as for modes.
    pub is_discrete: bool,
    /// Unit of the vertical axis, may be empty.
    pub unit: String,
    /// Curves.
    pub curves: Vec<PanelCurve>,
}

/// Curve through points.
#[derive(Debug)]
pub struct PanelCurve {
    /// Name of the column.
    pub name: String,
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

impl PanelCurve {
    /// Returns the pieces between points that are not finite.
    pub fn pieces(&self) -> Vec<Vec<[f64; 2]>> {
        let points: Vec<[f64; 2]> = self.x.iter().zip(&self.y).map(|(&x, &y)| [x, y]).collect();
        let is_finite = |point: &[f64; 2]| point.iter().all(|number| number.is_finite());
        let pieces = points.split(|point| !is_finite(point));
        pieces.filter(|piece| !piece.is_empty()).map(<[_]>::to_vec).collect()
    }
}

impl PlotPanel {
    /// True if there are finite points.
    pub fn has_points(&self) -> bool {
        self.curves.iter().any(|curve| !curve.pieces().is_empty())
    }

    /// Returns the names of all curves with the unit.
    pub fn label(&self) -> String {
        let names: Vec<&str> = self.curves.iter().map(|curve| curve.name.as_str()).collect();
        self.with_unit(&names.join(", "))
    }

    /// Appends the unit to a text.
    pub fn with_unit(&self, text: &str) -> String {
        if self.unit.is_empty() { text.to_owned() } else { format!("{text} ({})", self.unit) }
    }

    /// Returns the smallest and largest values of x and of y.
    pub fn ranges(&self) -> [[f64; 2]; 2] {
        let points = || self.curves.iter().flat_map(PanelCurve::pieces).flatten();
        [0, 1].map(|axis| {
            let wider = |[lo, hi]: [f64; 2], point: [f64; 2]| [lo.min(point[axis]), hi.max(point[axis])];
            points().fold([f64::INFINITY, f64::NEG_INFINITY], wider)
        })
    }
}
