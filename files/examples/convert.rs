//! Converts a file: `convert IN OUT`; or prints the values of its curves and surfaces on 17 parameters a direction: `convert IN`.

use std::path::Path;
use symspline_dynamic::{Coords, Number, Over, Value};
use symspline_files::{read, write};

const STEPS: u32 = 16;

/// Equal steps from one end to the other.
fn steps(ends: &(Number, Number)) -> Coords {
    let (Over::Float(a), Over::Float(b)) = ends else { return Coords::Float(Vec::new()) };
    let at = |i: u32| if i == STEPS { *b } else { a + (b - a) * f64::from(i) / f64::from(STEPS) };
    Coords::Float((0..=STEPS).map(at).collect())
}

fn ends(space: &symspline_dynamic::AnySpace) -> (Number, Number) {
    match space {
        Over::Float(s) => (Over::Float(*s.domain().0), Over::Float(*s.domain().1)),
        Over::Exact(s) => (Over::Float(s.domain().0.to_f64()), Over::Float(s.domain().1.to_f64())),
    }
}

#[expect(clippy::print_stdout, reason = "this is what the example is for")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let entries = read(Path::new(paths.first().ok_or("a file is missing")?))?;
    if let Some(out) = paths.get(1) {
        return Ok(write(Path::new(out), &entries)?);
    }
    for entry in entries {
        let values = match &entry.value {
            Value::Spline(s) => s.eval(&steps(&s.domain()))?,
            Value::Rational(s) => s.eval(&steps(&s.domain()))?,
            Value::Surface(s) => s.eval_grid(&steps(&ends(&s.spaces()[0])), &steps(&ends(&s.spaces()[1])))?,
            Value::RationalSurface(s) => {
                s.eval_grid(&steps(&ends(&s.spaces()[0])), &steps(&ends(&s.spaces()[1])))?
            }
            other => return Err(format!("{other} has no parameters").into()),
        };
        let Coords::Float(all) = values.to_float()? else { unreachable!("it was rounded to floats") };
        println!("{} {all:?}", entry.value.dim());
    }
    Ok(())
}
