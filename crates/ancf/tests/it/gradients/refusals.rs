use ancf::{Parameter, gradients};

use super::column;
use crate::common::models::parse;

fn message(text: &str, path: &str) -> String {
    gradients(&parse(text), &[Parameter::new(path)], &Default::default()).unwrap_err().to_string()
}

const SECTION: (&str, &str) = ("cable", "{ kind = \"circle\", diameter = 0.02 }");

/// Paths that are no continuous numbers, and analyses without gradients, are errors that state the path and what is expected.
#[test]
fn rejected_parameters() {
    let text = column(1, 2, SECTION, "[analysis]\nkind = \"modes\"\ncount = 1\n");
    assert!(message(&text, "bodies.b1.elements").contains("the integer 2"));
    assert!(message(&text, "bodies.b1.material").contains("no number"));
    assert!(message(&text, "materials.m2.young").contains("m2"));
    assert!(message(&text, "analysis.count").contains("analysis"));
    assert!(message(&text, "gravity[2]").contains("0, to which changes have no proportion"));
    let sized = Parameter { path: "gravity[2]".into(), size: Some(0.1) };
    assert!(gradients(&parse(&text), &[sized], &Default::default()).is_ok());
    let tiny = Parameter { path: "materials.m1.young".into(), size: Some(1e-300) };
    let error = gradients(&parse(&text), &[tiny], &Default::default()).unwrap_err();
    assert!(error.to_string().contains("which the number does not resolve"), "{error}");
    // A gap in a joint is no change of the structure, and a number at its limit changes less.
    let joined = column(2, 2, SECTION, "[analysis]\nkind = \"modes\"\ncount = 1\n");
    for size in [None, Some(1e-9)] {
        let end = Parameter { path: "bodies.b1.to[0]".into(), size };
        let error = gradients(&parse(&joined), &[end], &Default::default()).unwrap_err().to_string();
        assert!(error.contains("joints[1]") && error.contains("for its derivative"), "{error}");
    }
    let limit = joined.replace("young = 2.1e11", "young = 2.1e11, poisson = 0.4999");
    assert!(gradients(&parse(&limit), &["materials.m1.poisson".into()], &Default::default()).is_ok());
    let motion = column(1, 2, SECTION, "[analysis]\nkind = \"dynamics\"\nduration = 1.0\nstep = 0.1\n");
    assert!(message(&motion, "materials.m1.young").contains("statics, modes or buckling"));
}

/// A block on a spring with a stop that begins at its equilibrium: the force has a kink there, and none beside it.
#[test]
fn kinks_of_forces() {
    let text = |stop: f64| {
        format!(
            r#"
            gravity = [0, 0, -10.0]
            [[bodies]]
            kind = "mass"
            name = "block"
            mass = 2.0
            center = [0, 0, 0]
            [[joints]]
            kind = "spring"
            name = "spring"
            a = {{ body = "block", at = "center" }}
            b = {{ point = [0, 0, 1.0] }}
            tension = {{ kind = "expression", text = "1000*x + 3000*max(x - {stop:?}, 0)" }}
            [[joints]]
            kind = "point_on_line"
            name = "guide"
            a = {{ body = "block", at = "center" }}
            axis = [0, 0, 1]
            [[probes]]
            name = "block"
            on = {{ body = "block", at = "center" }}
            [analysis]
            kind = "statics"
            "#
        )
    };
    assert!(message(&text(0.02), "bodies.block.mass").contains("a stiffness has a kink there"));
    for (stop, stiffness) in [(0.021, 1000.0), (0.019, 4000.0)] {
        let found = super::gradients_of(&text(stop), &["bodies.block.mass"]);
        let derivative = super::derivative(&found, "block.z", "bodies.block.mass");
        crate::common::assertions::assert_relative("z", derivative, -10.0 / stiffness, 1e-6);
    }
    // The stop begins at the undeformed state, about which the block vibrates.
    let modes = text(0.0).replace("\"statics\"", "\"modes\"\n            count = 1");
    assert!(message(&modes, "bodies.block.mass").contains("not differentiable"));
}
