//! Closed curves: elevation, and fine tuning before anything closes the result again.
//!
//! The file wraps: it gives the full knot vector of degree `p` over `k / m` (for the cubics each knot twice), and
//! repeats the first controls at the end. A periodic space of the library takes one period of knots from the seam,
//! here `0 .. (m - 1) / m`, and unrolls them to the left so far that `t_p` is the last copy of the seam; its
//! coefficient `i` has its support from `t_i`. So
//!
//! - quadratics over simple knots: `t_0 = -2 / m`, as in the file; coefficient `i` is vertex `i`;
//! - cubics over double knots: `t_0 = t_1 = -1 / m`, as in the file, which stops one knot short of the unrolled
//!   ones; coefficient `i` is control `i`, and control `2 m + i` is coefficient `i` again;
//! - linear over simple knots: `t_0 = -1 / m`, so coefficient `i` is the value at `i / m`, where the curve meets the
//!   middle of leg `i`: the `a[i]` of the file.
//!
//! Over `f64` knots unrolled over the seam carry a rounding of the period, so only numbers are compared.

use crate::check::{check_row, for_each, largest, row};
use crate::data::{Case, Field, cases};
use nalgebra::SVector;
use symspline::{Curve, Error, Function, Q, Result, Scalar, Scale, SplineSpace};

/// The bound over `f64`, in units of epsilon times the largest coordinate.
const FACTOR: f64 = 4.0;

type Rows<T> = Vec<Vec<T>>;

/// The space of `degree` over the simple knots `0, 1 / m, ...` of period 1.
pub fn ring<T: Field>(degree: usize, m: usize) -> Result<SplineSpace<T>> {
    SplineSpace::periodic(degree, (0..m as i64).map(|k| T::of(&Q::frac(k, m as i64))), T::one())
}

/// The closed quadratic of the polygon.
pub fn closed_quadratic<T: Field>(case: Case) -> Result<Curve<T, 2>> {
    let polygon: Vec<SVector<T, 2>> = case.get("polygon").points();
    Curve::new(ring(2, polygon.len())?, polygon)
}

/// The first `count` coefficients of the unrolled space.
pub fn unrolled<T: Field>(curve: &Curve<T, 2>, count: usize) -> Rows<T> {
    (0..count).map(|i| row(curve.coeffs()[curve.space().slot(i)].clone())).collect()
}

/// Checks `found` over `f64` against the rows the file has under `key`.
fn check_floats(case: Case, found: &Rows<f64>, key: &str, size: f64) {
    let expected: Rows<Q> = case.get(key).rows();
    assert_eq!(found.len(), expected.len(), "{} {key}", case.id());
    for (k, (x, q)) in found.iter().zip(&expected).enumerate() {
        check_row(&format!("{} {key}[{k}]", case.id()), x, q, size, FACTOR);
    }
}

fn size_of(case: Case, key: &str) -> f64 {
    largest(case.get(key).rows::<Q>().iter().flatten())
}

/// Degree, knots and controls after raising the degree.
fn elevation(case: Case) -> Result<()> {
    let id = case.id();
    let (quadratic, rounded) = (closed_quadratic::<Q>(case)?, closed_quadratic::<f64>(case)?);
    let (cubic, rounded_cubic) = (quadratic.elevated(1)?, rounded.elevated(1)?);
    let (u, u_hat): (Vec<Q>, Vec<Q>) = (case.get("U").numbers(), case.get("U_hat").numbers());
    assert_eq!(quadratic.space().knots()[..], u, "{id} U");
    assert_eq!(cubic.space().knots()[..u_hat.len()], u_hat, "{id} U_hat");
    assert_eq!(cubic.space().knots().len(), u_hat.len() + 1, "{id} U_hat");
    assert_eq!((cubic.degree(), cubic.space().is_periodic()), (3, true), "{id}");
    assert_eq!(unrolled(&cubic, cubic.space().dim()), case.get("Q").rows::<Q>(), "{id} Q");
    let [p, q] = ["P_wrapped", "Q_wrapped"].map(|key| case.get(key).list().len());
    assert_eq!(unrolled(&quadratic, p), case.get("P_wrapped").rows::<Q>(), "{id} P_wrapped");
    assert_eq!(unrolled(&cubic, q), case.get("Q_wrapped").rows::<Q>(), "{id} Q_wrapped");
    check_floats(case, &unrolled(&rounded_cubic, q), "Q_wrapped", size_of(case, "Q_wrapped"));
    Ok(())
}

/// The open fine tuned curve over the file's wrapped double knots: the library clamps it, the file does not.
fn tuned_controls<T: Field>(case: Case) -> Result<Rows<T>> {
    let curve = closed_quadratic::<T>(case)?;
    let m = curve.space().dim();
    let alpha = Function::new(ring(1, m)?, case.get("a").numbers())?;
    let tuned = curve.fine_tuned(Scale::Signed(&alpha))?;
    assert!(tuned.space().is_clamped(), "{}", case.id());
    // Each of -1/m, 0, ..., 1, 1 + 1/m twice.
    let m = m as i64;
    let doubled = (-1..=m + 1).flat_map(|k| [k, k]).map(|k| T::of(&Q::frac(k, m)));
    let controls = tuned.embedded(&SplineSpace::new(3, doubled)?)?.into_coeffs();
    Ok(controls.into_iter().map(row).collect())
}

/// The differences of neighbours.
fn legs<T: Field>(controls: &Rows<T>) -> Rows<T> {
    let difference = |(p, q): (&T, &T)| q.clone() - p;
    controls.windows(2).map(|pair| pair[0].iter().zip(&pair[1]).map(difference).collect()).collect()
}

/// Controls, legs and drift of the result that nothing closes.
fn tuning(case: Case) -> Result<()> {
    let id = case.id();
    let (exact, rounded) = (tuned_controls::<Q>(case)?, tuned_controls::<f64>(case)?);
    let m = case.get("polygon").list().len();
    assert_eq!(exact, case.get("Q").rows::<Q>(), "{id} Q (found on the left)");
    // The last leg repeats the first.
    assert_eq!(legs(&exact)[..2 * m], case.get("legs").rows::<Q>(), "{id} legs");
    assert_eq!(legs(&exact)[2 * m], legs(&exact)[0], "{id} legs are periodic");
    let drift = |controls: &Rows<Q>| legs(&vec![controls[0].clone(), controls[2 * m].clone()]).remove(0);
    assert_eq!(drift(&exact), case.get("drift").numbers::<Q>(), "{id} drift");
    let size = size_of(case, "Q");
    check_floats(case, &rounded, "Q", size);
    check_floats(case, &legs(&rounded)[..2 * m].to_vec(), "legs", size);
    Ok(())
}

#[test]
fn closed_quadratic_to_cubic() {
    for_each("closed_quadratic_to_cubic", 2, elevation);
}

#[test]
fn closed_fine_tune_open() {
    for_each("closed_fine_tune_open", 2, tuning);
}

/// The drift between the ends is a mean that does not vanish, so there is no periodic antiderivative.
#[test]
fn the_unclosed_result_has_no_periodic_form() {
    for case in cases("closed_fine_tune_open") {
        let curve = closed_quadratic::<Q>(case).unwrap();
        let alpha = Function::new(ring(1, curve.space().dim()).unwrap(), case.get("a").numbers()).unwrap();
        let error = curve.derivative().unwrap().times(&alpha).unwrap().antiderivative().unwrap_err();
        let drift: Vec<String> = case.get("drift").numbers::<Q>().iter().map(Q::to_string).collect();
        assert_eq!(error, Error::NonZeroMean { integral: drift.join(", ") }, "{}", case.id());
    }
}
