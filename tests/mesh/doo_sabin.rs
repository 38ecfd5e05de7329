//! Doo-Sabin surfaces, and their conversion to Catmull-Clark surfaces.

use crate::nets::{Net, intervals, net, sorted, sums};
use crate::strategies::cases;
use proptest::prelude::*;
use symspline::{Boundary, DooSabin, Q, Result, Scalar, SplineSpace, Surface};

/// The knots `t_1 .. t_{m+1}` between which the vertices have their intervals, with one more at each end, which does not matter.
fn around(knots: Vec<Q>) -> Vec<Q> {
    let (first, last) = (knots[0].clone() - Q::int(1), knots[knots.len() - 1].clone() + Q::int(1));
    std::iter::once(first).chain(knots).chain([last]).collect()
}

/// Each interval cut in two.
fn halves(intervals: &[Q]) -> Vec<Q> {
    let half = |d: &Q| d.clone() / Q::int(2);
    intervals.iter().flat_map(|d| [half(d), half(d)]).collect()
}

/// The knots after two steps.
fn twice_refined_space(d: &[Q]) -> Result<SplineSpace<Q>> {
    let once = halves(d);
    let twice = halves(&once[1..once.len() - 1]);
    SplineSpace::new(2, sums(&twice).into_iter().map(|t| t + &once[0]))
}

fn quadratic(net: &Net, du: &[Q], dv: &[Q]) -> Result<Surface<Q, 2>> {
    let [u, v] = [du, dv].map(|d| SplineSpace::new(2, around(sums(d))));
    Surface::new(u?, v?, net.points.clone())
}

/// The knots of the refined spline: with all midpoints, without the outermost knots.
fn refined_space(d: &[Q]) -> Result<SplineSpace<Q>> {
    SplineSpace::new(2, sums(&halves(d)))
}

/// The knots of the elevated spline: all inner ones twice, and clamped ends.
fn elevated_space(d: &[Q]) -> Result<SplineSpace<Q>> {
    let mut knots = sums(d);
    let last = knots.len() - 1;
    knots[0] = knots[1].clone();
    knots[last] = knots[last - 1].clone();
    let twice = |(k, t): (usize, &Q)| vec![t.clone(); if k == 0 || k == last { 1 } else { 2 }];
    SplineSpace::new(3, around(knots.iter().enumerate().flat_map(twice).collect()))
}

/// The intervals with those at the ends replaced by 0: the ends of a clamped spline.
fn clamped(count: usize) -> Vec<Q> {
    (0..count).map(|k| Q::int(i64::from(k > 0 && k + 1 < count))).collect()
}

/// Nets with knot intervals.
fn net_over_intervals() -> impl Strategy<Value = (Net, [Vec<Q>; 2])> {
    net(3, 5).prop_flat_map(|net| {
        let [m, n] = net.size;
        (Just(net), [intervals(m).boxed(), intervals(n).boxed()])
    })
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn regular_parts_are_biquadratic_splines((net, [du, dv]) in net_over_intervals()) {
        let mesh = net.mesh()?;
        let d = net.at_vertices(mesh.topology(), &du, &dv);
        let surface = DooSabin::with_intervals(mesh, d, Boundary::Open)?;
        let spline = quadratic(&net, &du, &dv)?;
        let fine = spline.embedded(&refined_space(&du)?, &refined_space(&dv)?)?;
        prop_assert_eq!(sorted(fine.coeffs()), sorted(surface.refined(1)?.mesh().points()));
        // The new knot intervals are right if another step is. A knot now occurs three times at most.
        if du.iter().chain(&dv).all(|d| *d > Q::int(0)) {
            let finer = fine.embedded(&twice_refined_space(&du)?, &twice_refined_space(&dv)?)?;
            prop_assert_eq!(sorted(finer.coeffs()), sorted(surface.refined(2)?.mesh().points()));
        }
        let elevated = spline.embedded(&elevated_space(&du)?, &elevated_space(&dv)?)?;
        let converted = surface.converted()?;
        prop_assert_eq!(sorted(elevated.coeffs()), sorted(converted.mesh().points()));
        // Where four patches meet lies the limit of a face.
        let (us, vs) = (sums(&du), sums(&dv));
        let [m, n] = net.size;
        let values = spline.eval_grid(&us[1..m], &vs[1..n])?;
        prop_assert_eq!(surface.limit_points()?, values);
    }

    #[test]
    fn smooth_boundaries_of_grids_are_clamped_ends(net in net(3, 5)) {
        let [du, dv] = net.size.map(clamped);
        let surface = DooSabin::new(net.mesh()?, Boundary::Smooth);
        let spline = quadratic(&net, &du, &dv)?;
        let fine = spline.embedded(&refined_space(&du)?, &refined_space(&dv)?)?;
        prop_assert_eq!(sorted(fine.coeffs()), sorted(surface.refined(1)?.mesh().points()));
        let elevated = spline.embedded(&elevated_space(&du)?, &elevated_space(&dv)?)?;
        prop_assert_eq!(sorted(elevated.coeffs()), sorted(surface.converted()?.mesh().points()));
        let (us, vs) = (sums(&du), sums(&dv));
        let [m, n] = net.size;
        prop_assert_eq!(surface.limit_points()?, spline.eval_grid(&us[1..m], &vs[1..n])?);
        let corners = DooSabin::new(net.mesh()?, Boundary::Corners);
        prop_assert!(corners.refined(2)?.mesh() == surface.refined(2)?.mesh());
    }

    #[test]
    fn equal_intervals_change_nothing(net in net(2, 5), open in any::<bool>(), d in 1_i64..9) {
        let mesh = net.mesh()?;
        let boundary = if open { Boundary::Open } else { Boundary::Smooth };
        let d = vec![[Q::int(d), Q::int(d)]; mesh.topology().edge_count()];
        let even = DooSabin::new(mesh.clone(), boundary);
        let surface = DooSabin::with_intervals(mesh, d, boundary)?;
        prop_assert!(surface.refined(2)?.mesh() == even.refined(2)?.mesh());
        prop_assert!(surface.converted()?.mesh() == even.converted()?.mesh());
    }
}
