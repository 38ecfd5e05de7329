//! Laws of skins: sections and tangents are met exactly, whatever spaces they come in.

use crate::strategies::{ANY, CLAMPED, Kind, OPEN, RING, cases, coeffs, curve, number, point, surface};
use nalgebra::{SMatrix, SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{
    Coeff, Curve, Error, Function, NurbsSurface, Q, Rational, Scalar, Skin, SkinError, Spline, SplineSpace,
    Surface, arc,
};

/// Sections whose union stays small.
const SECTION: Kind = ANY.of_degree(0, 3).few(2);

type Sections = Vec<Curve<Q, 2>>;

fn sections(kind: Kind) -> impl Strategy<Value = Sections> {
    vec(curve::<2>(kind), 2..=4)
}

/// Ascending parameters.
fn parameters() -> impl Strategy<Value = Vec<Q>> {
    (number(), vec((1_i64..9, 1_i64..5), 5)).prop_map(|(start, gaps)| {
        let mut all = vec![start];
        for (n, d) in gaps {
            all.push(all[all.len() - 1].clone() + Q::frac(n, d));
        }
        all
    })
}

/// A skin at some of the parameters.
fn open(sections: &Sections, parameters: &[Q]) -> symspline::Result<Skin<Q, SVector<Q, 2>>> {
    Skin::through(sections)?.with_parameters(&parameters[..sections.len()])
}

/// That the surface is each section at its parameter, as it was given.
fn check_met(
    surface: &Surface<Q, 2>,
    skin: &Skin<Q, SVector<Q, 2>>,
    given: &Sections,
) -> Result<(), TestCaseError> {
    let (a, b) = given[0].domain();
    prop_assert_eq!(surface.u().domain(), (a, b));
    for ((v, section), given) in skin.parameters().iter().zip(skin.sections()).zip(given) {
        let met = surface.isocurve(V, v)?;
        prop_assert!(met.same_function(section)?);
        prop_assert!(met.same_function(&given.reparametrised(a, b)?)?);
    }
    Ok(())
}

fn slopes(surface: &Surface<Q, 2>, v: &Q) -> symspline::Result<Curve<Q, 2>> {
    surface.contracted(V, |rows| rows.derivative_at(v, 1))
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn sections_are_met(given in sections(SECTION), v in parameters(), degree in 0_usize..4) {
        let skin = open(&given, &v)?;
        prop_assert!(skin.sections().iter().all(|s| s.space() == skin.sections()[0].space()));
        let rings = given.iter().all(|s| s.space().is_periodic());
        let surface = match skin.surface(degree) {
            Err(error) => {
                prop_assert!(given.len() <= degree);
                let expected = SkinError::TooFewSections { expected: degree + 1, found: given.len() };
                prop_assert_eq!(error, expected.into());
                return Ok(());
            }
            surface => surface?,
        };
        prop_assert!(given.len() > degree);
        prop_assert_eq!(surface.u().is_periodic(), rings);
        prop_assert_eq!((surface.v().degree(), surface.v().dim()), (degree, given.len()));
        check_met(&surface, &skin, &given)?;
    }

    #[test]
    fn tangents_are_met(
        given in sections(SECTION),
        v in parameters(),
        tangents in (curve::<2>(SECTION), curve::<2>(SECTION)),
        (start, end) in (any::<bool>(), any::<bool>()),
        degree in 1_usize..4,
    ) {
        let mut skin = open(&given, &v)?;
        if start {
            skin = skin.start_tangents(&tangents.0)?;
        }
        if end {
            skin = skin.end_tangents(&tangents.1)?;
        }
        let data = given.len() + usize::from(start) + usize::from(end);
        let surface = match skin.surface(degree) {
            Err(Error::DegreeTooLow { degree: 1, needed: 2 }) => {
                prop_assert!(degree == 1 && (start || end));
                return Ok(());
            }
            Err(Error::Skin(SkinError::TooFewSections { .. })) => {
                prop_assert!(data <= degree);
                return Ok(());
            }
            surface => surface?,
        };
        check_met(&surface, &skin, &given)?;
        let (a, b) = given[0].domain();
        let across = surface.v().domain();
        for (asked, wanted, v) in [(start, &tangents.0, across.0), (end, &tangents.1, across.1)] {
            prop_assert!(!asked || slopes(&surface, v)?.same_function(&wanted.reparametrised(a, b)?)?);
        }
    }

    #[test]
    fn closed_skins_come_round(given in sections(SECTION), v in parameters(), degree in 0_usize..4) {
        let skin = Skin::closed_through(&given)?.with_parameters(&v[..=given.len()])?;
        let surface = skin.surface(degree)?;
        prop_assert!(surface.v().is_periodic() && surface.v().dim() == given.len());
        prop_assert_eq!(surface.v().breaks()[1..].iter().map(|(_, m)| *m).max(), Some(1));
        let ((a, b), last) = (surface.v().domain(), &v[given.len()]);
        prop_assert_eq!(b.clone() - a, last.clone() - &v[0]);
        check_met(&surface, &skin, &given)?;
    }

    #[test]
    fn rings_make_tubes_and_tori(given in sections(RING.of_degree(1, 3).few(2)), v in parameters()) {
        let skin = Skin::closed_through(&given)?.with_parameters(&v[..=given.len()])?;
        for degree in [2, 3] {
            let torus = skin.surface(degree)?;
            prop_assert!(torus.u().is_periodic() && torus.v().is_periodic());
            check_met(&torus, &skin, &given)?;
        }
        let tube = Skin::through(&given)?.surface(1)?;
        prop_assert!(tube.u().is_periodic() && !tube.v().is_periodic());
    }

    #[test]
    fn one_section_over_and_over_stays(c in curve::<2>(SECTION), v in parameters(), degree in 0_usize..4, closed in any::<bool>()) {
        let given = vec![c.clone(); 4];
        let skin = if closed { Skin::closed_through(&given)?.with_parameters(&v[..5])? } else { open(&given, &v)? };
        let surface = skin.surface(degree)?;
        prop_assert_eq!(surface.u(), c.space());
        prop_assert!(surface.rows().zip(c.coeffs()).all(|(row, point)| row.iter().all(|p| p == point)));
    }

    #[test]
    fn affine_maps_of_sections_map_the_skin(
        given in sections(SECTION),
        tangents in curve::<2>(SECTION),
        v in parameters(),
        m in vec(number(), 4),
        by in point::<2>(),
    ) {
        let m = SMatrix::<Q, 2, 2>::from_iterator(m);
        let linear = |p: &SVector<Q, 2>| {
            SVector::<Q, 2>::from_fn(|i, _| m[(i, 0)].clone() * &p[0] + m[(i, 1)].clone() * &p[1])
        };
        let moved = |c: &Curve<Q, 2>, by: &SVector<Q, 2>| {
            let points = c.coeffs().iter().map(|p| linear(p).plus_scaled(&Q::int(1), by)).collect();
            Curve::new(c.space().clone(), points)
        };
        let skin = open(&given, &v)?.start_tangents(&tangents)?.surface(2)?;
        let images = given.iter().map(|c| moved(c, &by)).collect::<symspline::Result<Sections>>()?;
        let image = open(&images, &v)?.start_tangents(&moved(&tangents, &SVector::zeros())?)?.surface(2)?;
        prop_assert_eq!(skin.u(), image.u());
        for (p, q) in skin.coeffs().iter().zip(image.coeffs()) {
            prop_assert_eq!(linear(p).plus_scaled(&Q::int(1), &by), q.clone());
        }
    }

    #[test]
    fn the_isocurves_of_a_surface_give_it_back(s in surface::<2>(SECTION, CLAMPED.of_degree(0, 3).smooth(1).few(2))) {
        prop_assume!(s.v().dim() > 1);
        let nodes = s.v().greville();
        let isocurves = nodes.iter().map(|v| s.isocurve(V, v)).collect::<symspline::Result<Sections>>()?;
        let skin = Skin::through(&isocurves)?.with_parameters(&nodes)?;
        prop_assert_eq!(skin.surface_in(s.v())?, s);
    }

    #[test]
    fn so_do_isocurves_and_end_tangents(s in surface::<2>(SECTION, CLAMPED.of_degree(3, 3).smooth(2).few(2))) {
        // Values at the breaks and slopes at the ends: the complete cubic.
        let breaks: Vec<Q> = s.v().breaks().into_iter().map(|(t, _)| t).collect();
        prop_assume!(s.v().dim() == breaks.len() + 2);
        let isocurves = breaks.iter().map(|v| s.isocurve(V, v)).collect::<symspline::Result<Sections>>()?;
        let (a, b) = s.v().domain();
        let skin = Skin::through(&isocurves)?.with_parameters(&breaks)?;
        let skin = skin.start_tangents(&slopes(&s, a)?)?.end_tangents(&slopes(&s, b)?)?;
        prop_assert_eq!(skin.surface_in(s.v())?, s);
    }

    #[test]
    fn a_skin_goes_on_where_its_neighbours_end(
        s in surface::<2>(OPEN.of_degree(0, 3).few(1), OPEN.of_degree(1, 3).smooth(1).few(1)),
        middle in curve::<2>(SECTION),
        v in parameters(),
        factor in (1_i64..5, 1_i64..5),
    ) {
        let (factor, exactly) = (Q::frac(factor.0, factor.1), Q::int(0));
        let (a, b) = s.v().domain();
        let given = vec![s.isocurve(V, b)?, middle, s.isocurve(V, a)?];
        let skin = open(&given, &v)?.continuing(&s, &factor, &exactly)?.continued_by(&s, &factor, &exactly)?;
        let surface = skin.surface(3)?;
        check_met(&surface, &skin, &given)?;
        for (here, there) in [(surface.v().domain().0, b), (surface.v().domain().1, a)] {
            prop_assert!(slopes(&surface, here)?.same_function(&slopes(&s, there)?.scaled(&factor)?)?);
        }
        // A neighbour elsewhere is no neighbour.
        let off = s.translated(&vector![Q::int(1), Q::int(0)])?;
        let far = open(&given, &v)?.continuing(&off, &factor, &Q::frac(1, 2)).unwrap_err();
        let elsewhere = matches!(far, Error::Skin(SkinError::EdgeElsewhere { .. }));
        prop_assert!(elsewhere, "{}", far);
        prop_assert!(open(&given, &v)?.continuing(&off, &factor, &Q::int(1)).is_ok());
    }

    #[test]
    fn lengths_do_not_depend_on_place_and_size(
        z in vec(0.1_f64..3.0, 4), points in coeffs(point::<2>().boxed()), by in -5.0_f64..5.0, closed in any::<bool>()
    ) {
        let space = SplineSpace::clamped(2, [0.0, 0.5, 1.0])?;
        let plane: Vec<_> = points[..4].iter().map(|p| p.map(|x| x.to_f64())).collect();
        let mut sections = Vec::new();
        let mut height = 0.0;
        for z in z {
            height += z;
            let lifted = plane.iter().map(|p| vector![p[0] + z, p[1] * z, height]).collect();
            sections.push(Curve::<f64, 3>::new(space.clone(), lifted)?);
        }
        let skin = |sections: &[Curve<f64, 3>]| {
            if closed { Skin::closed_through(sections) } else { Skin::through(sections) }
        };
        let moved: Vec<Curve<f64, 3>> = sections
            .iter()
            .map(|s| s.scaled(&8.0).and_then(|s| s.translated(&vector![by, -by, by])))
            .collect::<symspline::Result<_>>()?;
        for (one, two) in [
            (skin(&sections)?.by_chord_length()?, skin(&moved)?.by_chord_length()?),
            (skin(&sections)?.centripetal()?, skin(&moved)?.centripetal()?),
        ] {
            let (v, w) = (one.parameters(), two.parameters());
            prop_assert!(v[0] == 0.0 && v[v.len() - 1] == 1.0 && v.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(v.iter().zip(w).all(|(v, w)| (v - w).abs() < 1e-6));
            let surface = one.surface(3)?;
            for (v, section) in v.iter().zip(one.sections()) {
                let met = surface.isocurve(V, v)?;
                let bound = 1e-12 * section.size_bound()?.max(1.0);
                prop_assert!(met.coeffs().iter().zip(section.coeffs()).all(|(p, q)| (p - q).norm() <= bound));
            }
        }
    }
}

#[test]
fn parameters_are_means_over_the_rows() -> symspline::Result<()> {
    let line =
        |a: [f64; 2], b: [f64; 2]| Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![a.into(), b.into()]);
    // One row moves by 1 and 3, the other by 4 and 4: shares 1/4 and 1/2. A row that stands still does not count.
    let moving =
        [line([0.0, 0.0], [9.0, 0.0])?, line([0.0, 1.0], [9.0, 4.0])?, line([0.0, 4.0], [9.0, 8.0])?];
    assert_eq!(Skin::through(&moving)?.by_chord_length()?.parameters(), [0.0, 0.375, 1.0]);
    let pole = [line([0.0, 0.0], [9.0, 0.0])?, line([0.0, 1.0], [9.0, 0.0])?, line([0.0, 5.0], [9.0, 0.0])?];
    assert_eq!(Skin::through(&pole)?.by_chord_length()?.parameters(), [0.0, 0.2, 1.0]);
    assert_eq!(Skin::through(&pole)?.centripetal()?.parameters(), [0.0, 1.0 / 3.0, 1.0]);
    assert_eq!(Skin::closed_through(&pole)?.by_chord_length()?.parameters(), [0.0, 0.1, 0.5, 1.0]);
    Ok(())
}

#[test]
fn rational_sections_are_met_as_weighted_ones() -> symspline::Result<()> {
    // Two quarter circles of different size and a point between them: a cone of revolution is its own skin.
    let quarter = |r: f64, z: f64| -> symspline::Result<_> {
        let flat = arc(&vector![0.0, 0.0], &vector![r, 0.0], &vector![0.0, r])?;
        let lift = |c: &symspline::Weighted<f64, SVector<f64, 2>>| {
            symspline::Weighted::new(&vector![c.project()[0], c.project()[1], z], c.weight)
        };
        Spline::new(flat.lifted().space().clone(), flat.lifted().coeffs().iter().map(lift).collect())
    };
    let skin = Skin::through(&[quarter(1.0, 0.0)?, quarter(3.0, 1.0)?])?.surface(1)?;
    let cone: NurbsSurface<f64, 3> = Rational::from_lifted(skin)?;
    for (u, v) in [(0.1, 0.2), (0.7, 0.5), (1.0, 1.0)] {
        let (a, b) = cone.u().domain();
        let p = cone.at(&(a + (b - a) * u), &v)?;
        assert!((p[0].hypot(p[1]) - 1.0 - 2.0 * v).abs() < 1e-14 && (p[2] - v).abs() < 1e-14);
    }
    Ok(())
}

#[test]
fn what_makes_no_skin_is_refused() -> symspline::Result<()> {
    let section = |power: usize, b: f64| Function::monomial(power, 0.0, b);
    let (two, three) =
        ([section(1, 1.0)?, section(2, 1.0)?], [section(1, 1.0)?, section(2, 1.0)?, section(0, 1.0)?]);
    for count in [0, 1] {
        let few: Error = SkinError::TooFewSections { expected: 2, found: count }.into();
        assert_eq!(Skin::through(&two[..count]).unwrap_err(), few);
        assert_eq!(Skin::closed_through(&two[..count]).unwrap_err(), few);
    }
    let skin = || Skin::through(&three);
    let few: Error = SkinError::TooFewSections { expected: 6, found: 3 }.into();
    assert_eq!(skin()?.surface(5).unwrap_err(), few);
    assert_eq!(
        skin()?.surface(usize::MAX).unwrap_err(),
        SkinError::TooFewSections { expected: usize::MAX, found: 3 }.into()
    );
    assert_eq!(
        skin()?.with_parameters(&[0.0, 1.0]).unwrap_err(),
        Error::CoefficientCount { expected: 3, found: 2 }
    );
    assert_eq!(
        skin()?.with_parameters(&[0.0, f64::NAN, 1.0]).unwrap_err(),
        Error::NotFinite { what: "parameter", index: 1 }
    );
    for v in [[0.0, 0.0, 1.0], [0.0, 1.0, 0.5], [1.0, 0.0, 2.0]] {
        let refused = skin()?.with_parameters(&v).unwrap_err();
        assert!(matches!(refused, Error::Skin(SkinError::NotAfter { .. })), "{refused}");
    }
    let near = skin()?.with_parameters(&[0.0, 5e-324, 1e-323])?.surface(2);
    assert!(matches!(near, Err(Error::SpanOutOfRange { .. })), "{near:?}");
    let narrow = SplineSpace::bezier(2, 0.0, 0.75)?;
    assert!(matches!(skin()?.surface_in(&narrow), Err(Error::OutsideDomain { .. })));
    let wide = SplineSpace::bezier(3, 0.0, 1.0)?;
    assert_eq!(skin()?.surface_in(&wide).unwrap_err(), Error::TooFewPoints { expected: 4, found: 3 });
    let late = SplineSpace::clamped(1, [0.0, 0.1, 1.0])?;
    assert_eq!(
        skin()?.with_parameters(&[0.2, 0.5, 0.7])?.surface_in(&late).unwrap_err(),
        Error::Undetermined { index: 0 }
    );

    let closed = || Skin::closed_through(&three);
    assert_eq!(closed()?.start_tangents(&two[0]).unwrap_err(), SkinError::ClosedHasNoEnds.into());
    assert_eq!(closed()?.end_tangents(&two[0]).unwrap_err(), SkinError::ClosedHasNoEnds.into());
    assert_eq!(closed()?.surface_in(&narrow).unwrap_err(), SkinError::SpaceNotClosed.into());
    assert_eq!(
        skin()?.start_tangents(&two[0])?.surface(1).unwrap_err(),
        Error::DegreeTooLow { degree: 1, needed: 2 }
    );

    // Knots that fall together when the second section is moved to the domain of the first.
    let fine = Function::new(SplineSpace::clamped(0, [0.0, 1e-300, 1e8])?, vec![1.0, 2.0])?;
    match Skin::through(&[section(1, 1e-20)?, fine]) {
        Err(Error::Skin(SkinError::Section { index: 1, .. })) => {}
        other => panic!("{other:?}"),
    }
    let surface = Skin::through(&two)?.surface(1)?;
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Skin::through(&two)?.continuing(&surface, &factor, &1.0).unwrap_err();
        assert!(matches!(refused, Error::Ratio { .. }));
    }
    let refused = Skin::through(&two)?.continuing(&surface, &1.0, &f64::NAN).unwrap_err();
    assert!(matches!(refused, Error::BadTolerance { .. }));
    Ok(())
}

#[test]
fn lengths_that_vanish_or_overflow_are_refused() -> symspline::Result<()> {
    let line = |x: f64| Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![x, 0.0], vector![x, 1.0]]);
    let skin = |x: [f64; 3]| Skin::through(&[line(x[0])?, line(x[1])?, line(x[2])?]);
    assert_eq!(skin([1.0; 3])?.by_chord_length().unwrap_err(), Error::NoLength);
    let same = skin([1.0, 1.0, 2.0])?.by_chord_length().unwrap_err();
    assert!(matches!(same, Error::Skin(SkinError::NotAfter { index: 1, .. })), "{same}");
    assert!(matches!(skin([-1e308, 1e308, -1e308])?.by_chord_length(), Err(Error::NotFinite { .. })));
    assert_eq!(skin([0.0, 1e300, 3e300])?.by_chord_length()?.parameters(), [0.0, 1.0 / 3.0, 1.0]);
    assert_eq!(skin([0.0, 1e-300, 2e-300])?.centripetal()?.parameters(), [0.0, 0.5, 1.0]);
    let tall = skin([0.0, 1e300, -1e300])?.surface(2)?;
    assert_eq!(tall.isocurve(U, &0.0)?.at(&0.5)?, vector![1e300, 0.0]);
    Ok(())
}
