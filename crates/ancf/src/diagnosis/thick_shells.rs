use crate::errors::short;
use crate::model::{Body, Model, Shell};

/// Thickness, relative to the longer side, above which the neglected transverse shear changes the deflection of a supported plate by
/// more than about 1 %.
const THICK: f64 = 0.05;

/// Describes shells that are too thick for the theory of Kirchhoff and Love, one sentence each.
///
/// A hinged square plate of a tenth of its side deflects by 5 % more with transverse shear than without (Navier's solutions of both
/// theories), and a clamped one by a multiple of this.
pub(crate) fn thickness_warnings(model: &Model) -> Vec<String> {
    let shells =
        model.bodies.iter().filter_map(|body| if let Body::Shell(shell) = body { Some(shell) } else { None });
    let warning = |shell: &Shell| {
        let [_, u, v, _] = shell.map([0.5, 0.5]);
        let ratio = shell.thickness / u.norm().max(v.norm());
        (ratio > THICK).then(|| {
            format!(
                "shell `{}`: its thickness is {} of its longer side; transverse shear, which thin shells neglect, is not negligible",
                shell.name,
                short(ratio)
            )
        })
    };
    shells.filter_map(warning).collect()
}
