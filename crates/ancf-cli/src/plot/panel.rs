/// Curves that share their axes.
#[derive(Debug)]
pub struct Panel {
    /// What stands at the horizontal axis.
    pub x: String,
    /// Whether there is nothing between points, as between modes.
    pub is_discrete: bool,
    /// The unit of the vertical axis; empty if there is none.
    pub unit: String,
    pub curves: Vec<Curve>,
}

/// A curve through points.
#[derive(Debug)]
pub struct Curve {
    pub name: String,
    pub x: Vec<f64>,
    pub y: Vec<f64>,
}

impl Curve {
    /// Its pieces: it breaks where a number is none.
    pub fn pieces(&self) -> Vec<Vec<[f64; 2]>> {
        let points: Vec<[f64; 2]> = self.x.iter().zip(&self.y).map(|(&x, &y)| [x, y]).collect();
        let is_finite = |point: &[f64; 2]| point.iter().all(|number| number.is_finite());
        let pieces = points.split(|point| !is_finite(point));
        pieces.filter(|piece| !piece.is_empty()).map(<[_]>::to_vec).collect()
    }
}

impl Panel {
    /// Whether there is anything to be seen.
    pub fn has_points(&self) -> bool {
        self.curves.iter().any(|curve| !curve.pieces().is_empty())
    }

    /// Names of all curves, with the unit.
    pub fn label(&self) -> String {
        let names: Vec<&str> = self.curves.iter().map(|curve| curve.name.as_str()).collect();
        self.with_unit(&names.join(", "))
    }

    /// A text with the unit behind it.
    pub fn with_unit(&self, text: &str) -> String {
        if self.unit.is_empty() { text.to_owned() } else { format!("{text} ({})", self.unit) }
    }

    /// Least and largest number of all points: of x, of y.
    pub fn ranges(&self) -> [[f64; 2]; 2] {
        let points = || self.curves.iter().flat_map(Curve::pieces).flatten();
        [0, 1].map(|axis| {
            let wider = |[lo, hi]: [f64; 2], point: [f64; 2]| [lo.min(point[axis]), hi.max(point[axis])];
            points().fold([f64::INFINITY, f64::NEG_INFINITY], wider)
        })
    }
}
