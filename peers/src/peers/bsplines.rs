//! bsplines: knots go from 0 to 1, so parameters are scaled, and derivatives back.

use crate::candidates::{CurvePoints, Operator, Operator2, Operators, Parts};
use crate::data::{CurveData, Point};
use crate::measure::Column;
use bsplines::{ControlPoints, Curve, DataPoints, KnotMethod, Knots, ParameterMethod, Points};
use nalgebra::{DMatrix, DVector};

const COLUMN: Column = Column::Bsplines;
const INSIDE: &str = "the parameter is in the domain";

/// A curve, the end of the domain it stands for, and the factor of its values.
#[derive(Clone)]
pub struct Scaled {
    curve: Curve,
    end: f64,
    factor: f64,
}

fn matrix(points: &[Point]) -> DMatrix<f64> {
    DMatrix::from_fn(3, points.len(), |axis, i| points[i][axis])
}

fn point(vector: &DVector<f64>, factor: f64) -> Point {
    [0, 1, 2].map(|axis| factor * vector[axis])
}

impl Scaled {
    fn new(data: &CurveData) -> Self {
        let end = data.end();
        let knots = DVector::from_iterator(data.knots.len(), data.knots.iter().map(|t| t / end));
        let knots = Knots::new(data.degree, knots).expect("knots are in order");
        let curve = Curve::new(knots, ControlPoints::new(matrix(&data.points))).expect("the data are valid");
        Self { curve, end, factor: 1.0 }
    }
}

impl CurvePoints for Scaled {
    const COLUMN: Column = COLUMN;
    type Point = Point;

    fn of(data: &CurveData) -> Self {
        Self::new(data)
    }

    fn at(&self, x: f64) -> Point {
        point(&self.curve.evaluate(x / self.end).expect(INSIDE), 1.0)
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn derivatives(&self, x: f64) -> [Point; 3] {
        let (u, r) = (x / self.end, 1.0 / self.end);
        let value = |k: usize| self.curve.evaluate_derivative(u, k).expect(INSIDE);
        [point(&value(0), 1.0), point(&value(1), r), point(&value(2), r * r)]
    }
}

pub struct Bsplines;

impl Operators for Bsplines {
    const COLUMN: Column = COLUMN;
    type Curve = Scaled;
    type Pieces = ();

    fn curve(data: &CurveData) -> Scaled {
        Scaled::new(data)
    }

    fn parts(f: &Scaled) -> Parts {
        let knots = f.curve.knots().vector().iter().map(|t| t * f.end).collect();
        let columns = f.curve.control_points().matrix().column_iter();
        let points = columns.map(|c| [0, 1, 2].map(|axis| f.factor * c[axis])).collect();
        Parts { degree: f.curve.degree(), knots, points }
    }

    fn joined((): &()) -> Parts {
        unreachable!("not offered")
    }

    const REFINE: Operator2<Scaled, [f64]> = Some(|f, knots| {
        let mut fine = f.clone();
        for t in knots {
            fine.curve.insert_knot(t / f.end).expect("the knot is inside");
        }
        fine
    });
    const DERIVE: Operator<Scaled> = Some(|f| {
        let curve = f.curve.derivative_curve(1).expect("the degree is 3");
        Scaled { curve, end: f.end, factor: f.factor / f.end }
    });
    const INTERPOLATE: Operator<[Point], Scaled> = Some(|points| {
        let data = DataPoints::new(matrix(points));
        let (parameters, knots) = (ParameterMethod::ChordLength, KnotMethod::Averaging);
        let curve = Curve::interpolate_with(&data, 3, parameters, knots).expect("points differ");
        Scaled { curve, end: 1.0, factor: 1.0 }
    });
}
