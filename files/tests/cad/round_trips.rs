//! What is written is read as the same value, bit by bit.

use crate::plane;
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Q, SplineSpace};
use symspline_dynamic::{
    AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Over, Value,
};
use symspline_files::{Entry, Format, from_bytes, to_bytes};

const SURFACES: [Format; 2] = [Format::Step, Format::Iges];
const CURVES: [Format; 3] = [Format::Dxf, Format::Step, Format::Iges];

/// Numbers of all sizes whose products with weights are in range.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        -10.0..10.0,
        (-1.0..1.0, -100..100_i32).prop_map(|(x, e): (f64, i32)| x * 10_f64.powi(e))
    ]
}

/// Spaces of degree 1 and more: clamped, unclamped and periodic, with knots of several copies, also at the seam.
fn space() -> impl Strategy<Value = SplineSpace<f64>> {
    let steps = vec((1e-3..10.0, 1..3_usize), 1..6);
    (1..6_usize, 0..3, -1e3..1e3, steps).prop_filter_map("too many copies", |(p, kind, start, steps)| {
        let mut t = start;
        let mut knots = Vec::new();
        for (step, copies) in &steps {
            knots.extend(std::iter::repeat_n(t, *copies.min(&p)));
            t += step;
        }
        match kind {
            0 => SplineSpace::clamped(p, [knots.clone(), vec![t]].concat()),
            1 => SplineSpace::periodic_up_to(p, knots, t),
            _ => SplineSpace::new(
                p,
                (0..=p).map(|i| start - (p + 1 - i) as f64).chain(knots).chain((0..=p).map(|i| t + i as f64)),
            ),
        }
        .ok()
    })
}

fn floats(count: usize) -> impl Strategy<Value = Coords> {
    vec(number(), count).prop_map(Over::Float)
}

fn weights(count: usize) -> impl Strategy<Value = Coords> {
    vec(prop_oneof![Just(1.0), 1e-3..1e3], count).prop_map(Over::Float)
}

fn curve() -> impl Strategy<Value = Value> {
    (space(), 2..=3_usize, any::<bool>()).prop_flat_map(|(space, dim, rational)| {
        let count = space.dim();
        (floats(dim * count), weights(count)).prop_map(move |(points, weights)| {
            let space = AnySpace::from(space.clone());
            match rational {
                true => AnyRational::new(space, dim, points, weights).unwrap().into(),
                false => AnySpline::new(space, dim, points).unwrap().into(),
            }
        })
    })
}

fn surface() -> impl Strategy<Value = Value> {
    (space(), space(), any::<bool>()).prop_flat_map(|(u, v, rational)| {
        let count = u.dim() * v.dim();
        (floats(3 * count), weights(count)).prop_map(move |(points, weights)| {
            let (u, v) = (AnySpace::from(u.clone()), AnySpace::from(v.clone()));
            match rational {
                true => AnyRationalSurface::new(u, v, 3, points, weights).unwrap().into(),
                false => AnySurface::new(u, v, 3, points).unwrap().into(),
            }
        })
    })
}

fn name() -> impl Strategy<Value = Option<String>> {
    proptest::option::of("[ -~]{1,90}")
}

/// Bits, so that zeros with either sign differ. What STEP holds of a curve in the plane is in space.
fn bits(entries: &[Entry]) -> String {
    format!("{entries:?}")
}

fn comes_back(entries: &[Entry], formats: &[Format]) -> Result<(), TestCaseError> {
    for format in formats {
        let again = from_bytes(&to_bytes(entries, *format).unwrap(), *format).unwrap();
        prop_assert_eq!(bits(&again), bits(entries), "{:?}", format);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn curves_come_back(values in vec((name(), curve()), 0..4)) {
        let entries: Vec<Entry> = values.into_iter().map(|(name, value)| Entry { name, value }).collect();
        // A name that would be read as another is refused in DXF.
        let ambiguous = |entry: &Entry| entry.name.as_ref().is_some_and(|name| name.contains("\\U+"));
        prop_assume!(!entries.iter().any(ambiguous));
        comes_back(&entries, &[Format::Dxf, Format::Iges])?;
        let in_space: Vec<Entry> = entries.into_iter().filter(|entry| entry.value.dim() == 3).collect();
        comes_back(&in_space, &[Format::Step])?;
    }

    #[test]
    fn surfaces_come_back(values in vec((name(), surface()), 1..3)) {
        let entries: Vec<Entry> = values.into_iter().map(|(name, value)| Entry { name, value }).collect();
        comes_back(&entries, &SURFACES)?;
    }

    /// Their control points are products over weights, rounded again: the same for polynomials alone.
    #[test]
    fn exact_values_that_are_floats_come_back_as_these(value in curve()) {
        let exact = value.to_exact().unwrap();
        for format in CURVES {
            let again = from_bytes(&to_bytes(&[exact.clone().into()], format).unwrap(), format).unwrap();
            let same = again[0].value == value || (format == Format::Step && value.dim() == 2);
            prop_assert!(same || matches!(value, Value::Rational(_)), "{:?}", again);
        }
    }

    /// Formats without a word for periodic spaces bring all others back.
    #[test]
    fn open_curves_and_surfaces_come_back_from_obj_and_geomdl(curve in curve(), surface in surface()) {
        for value in [curve, surface] {
            if is_open(&value) {
                comes_back(&[value.clone().into()], &[Format::Obj])?;
                comes_back(&[Entry::named("a \"name\" é\n", value)], &[Format::Geomdl])?;
            }
        }
    }
}

fn is_open(value: &Value) -> bool {
    let spaces = match value {
        Value::Spline(s) => s.spaces(),
        Value::Rational(s) => s.spaces(),
        Value::Surface(s) => s.spaces(),
        Value::RationalSurface(s) => s.spaces(),
        other => panic!("{other}"),
    };
    spaces.iter().all(|space| matches!(space, Over::Float(space) if !space.is_periodic()))
}

/// CAD systems ask whether a spline is closed: where its ends meet, in the direction where they do.
#[test]
fn splines_whose_ends_meet_are_called_closed() {
    let line = || SplineSpace::clamped(1, [0.0, 1.0, 2.0]).unwrap();
    let told = |value: Value, format| String::from_utf8(to_bytes(&[value.into()], format).unwrap()).unwrap();
    for (last, step, iges) in [
        (0.0, ".UNSPECIFIED.,.T.,.U.", "126,2,1,1,1,1,0,"),
        (0.5, ".UNSPECIFIED.,.F.,.U.", "126,2,1,1,0,1,0,"),
    ] {
        let triangle = plane(line(), &[0.0, 0.0, 1.0, 1.0, last, 0.0]);
        assert!(
            told(triangle.clone(), Format::Step).contains(step)
                && told(triangle, Format::Iges).contains(iges)
        );
    }
    // In v the last column is the first.
    let tube: Vec<f64> = [0.0, 1.0].iter().flat_map(|z| [0.0, 0.0, *z, 1.0, 0.0, *z, 0.0, 0.0, *z]).collect();
    let u = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let tube = Value::from(AnySurface::new(u.into(), line().into(), 3, Over::Float(tube)).unwrap());
    assert!(told(tube.clone(), Format::Step).contains(".UNSPECIFIED.,.F.,.T.,.U."));
    assert!(told(tube, Format::Iges).contains("128,1,2,1,1,0,1,1,0,0,"));
}

#[test]
fn fractions_are_rounded_to_the_nearest_floats() {
    let space = SplineSpace::bezier(1, Q::from(0), Q::from(1)).unwrap();
    let third = "1/3".parse::<Q>().unwrap();
    let points = [Q::from(0), Q::from(1), third, Q::from(2)].to_vec();
    let value = Value::from(AnySpline::new(space.into(), 2, Over::Exact(points)).unwrap());
    let rounded = plane(SplineSpace::bezier(1, 0.0, 1.0).unwrap(), &[0.0, 1.0, 1.0 / 3.0, 2.0]);
    for format in CURVES.into_iter().chain([Format::Obj, Format::Geomdl]) {
        let [exact, rounded] =
            [&value, &rounded].map(|value| to_bytes(&[value.clone().into()], format).unwrap());
        assert_eq!(exact, rounded);
    }
}
