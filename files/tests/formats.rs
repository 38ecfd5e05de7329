//! What files say, checked against numbers found without this project.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;
use symspline::{Q, Scalar, SplineSpace};
use symspline_dynamic::{AnyRational, AnySpline, AnySurface, Coords, Over, Value};
use symspline_files::{Entry, FileError, Format, Place, Problem, from_bytes, read, to_bytes, write};

fn one(text: &str, format: Format) -> Value {
    let entries = from_bytes(text.as_bytes(), format).unwrap();
    assert_eq!(entries.len(), 1, "{entries:?}");
    entries[0].value.clone()
}

fn wrong(text: &str, format: Format) -> FileError {
    from_bytes(text.as_bytes(), format).unwrap_err()
}

fn svg(body: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{body}</svg>")
}

/// Values at equal parameters.
fn values(value: &Value, steps: u32) -> Vec<Vec<f64>> {
    let sample = |a: f64, b: f64| {
        Coords::Float((0..=steps).map(|i| a + (b - a) * f64::from(i) / f64::from(steps)).collect())
    };
    let found = match value {
        Value::Spline(s) => match s.domain() {
            (Over::Float(a), Over::Float(b)) => s.eval(&sample(a, b)).unwrap(),
            _ => panic!(),
        },
        Value::Rational(s) => match s.domain() {
            (Over::Float(a), Over::Float(b)) => s.eval(&sample(a, b)).unwrap(),
            _ => panic!(),
        },
        _ => panic!(),
    };
    let Coords::Float(all) = found else { panic!() };
    all.chunks(value.dim()).map(<[f64]>::to_vec).collect()
}

/// How far a point of the plane is from a polyline.
fn distance(p: &[f64], corners: &[Vec<f64>]) -> f64 {
    let to = |pair: &[Vec<f64>]| {
        let [x, y] = [0, 1].map(|k| pair[1][k] - pair[0][k]);
        let [a, b] = [0, 1].map(|k| p[k] - pair[0][k]);
        let t = ((a * x + b * y) / (x * x + y * y)).clamp(0.0, 1.0);
        (a - t * x).hypot(b - t * y)
    };
    corners.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

fn points(value: &Value) -> Vec<f64> {
    let Value::Spline(s) = value else { panic!("{value}") };
    let Coords::Float(all) = s.coords().unwrap() else { panic!() };
    all
}

#[test]
fn circles_ellipses_and_arcs_are_exact() {
    let circle = one(&svg("<circle cx='3' cy='-2' r='5'/>"), Format::Svg);
    for p in values(&circle, 40) {
        assert!(((p[0] - 3.0).hypot(p[1] + 2.0) - 5.0).abs() < 1e-14);
    }
    // The large arc that turns with the angle, of the unit circle around (1, 1) from (2, 1) to (1, 0): from the right over (1, 2), (0, 1).
    let arc = one(&svg("<path d='M2 1A1 1 0 1 1 1 0'/>"), Format::Svg);
    let points = values(&arc, 24);
    assert!(points.iter().all(|p| ((p[0] - 1.0).hypot(p[1] - 1.0) - 1.0).abs() < 1e-14));
    assert!(points.iter().any(|p| (p[0] - 1.0).abs() + (p[1] - 2.0).abs() < 1e-12));
    assert_eq!(points[24], [1.0, 0.0]);
    // Radii that are too small grow until they reach: a half circle around (2, 0).
    let grown = values(&one(&svg("<path d='M0 0a1 1 30 0 0 4 0'/>"), Format::Svg), 8);
    assert!(grown.iter().all(|p| ((p[0] - 2.0).hypot(p[1]) - 2.0).abs() < 1e-14) && grown[4][1] > 1.9);
    // x²/4 + y²/9 = 1, turned by 90° and moved.
    let ellipse = one(&svg("<ellipse rx='2' ry='3' transform='translate(5 0) rotate(90)'/>"), Format::Svg);
    for p in values(&ellipse, 40) {
        assert!(((p[0] - 5.0).powi(2) / 9.0 + p[1].powi(2) / 4.0 - 1.0).abs() < 1e-14);
    }
}

#[test]
fn commands_of_paths_mean_what_they_should() {
    let closed = one(&svg("<path d='m1 2 3 0v4z'/>"), Format::Svg);
    assert_eq!(points(&closed), [1.0, 2.0, 4.0, 2.0, 4.0, 6.0, 1.0, 2.0]);
    let smooth = one(&svg("<path d='M0 0C0 1 2 3 4 4S7 7 8 4'/>"), Format::Svg);
    assert_eq!(points(&smooth)[8..], [6.0, 5.0, 7.0, 7.0, 8.0, 4.0]);
    let thrice =
        from_bytes(svg("<path id='a' d='M0 0L1 1M2 2H3ZM4 4Q5 5 6 4T8 4'/>").as_bytes(), Format::Svg)
            .unwrap();
    assert_eq!(thrice.len(), 3);
    assert!(thrice.iter().all(|entry| entry.name.as_deref() == Some("a")));
    assert_eq!(points(&thrice[2].value)[6..], [7.0, 3.0, 8.0, 4.0]);
    let matrix =
        one(&svg("<g transform='scale(2)'><path transform='translate(1,3)' d='M0 0L1 1'/></g>"), Format::Svg);
    assert_eq!(points(&matrix), [2.0, 6.0, 4.0, 8.0]);
    let used = one(&svg("<defs><path id='p' d='M0 0L1 1'/></defs><use href='#p' x='4' y='5'/>"), Format::Svg);
    assert_eq!(points(&used), [4.0, 5.0, 5.0, 6.0]);
}

#[test]
fn drawings_that_cannot_be_read_say_where() {
    let line = |body: &str| wrong(&svg(body), Format::Svg);
    assert_eq!(line("<path d='M0 0L1'/>").place, Place::Line { line: 2, column: 1 });
    for body in [
        "<path d='L0 0'/>",
        "<circle r='-1'/>",
        "<circle r='1em'/>",
        "<polyline points='1 2 3'/>",
        "<g id='g'><use href='#g'/></g>",
        "<use href='#nothing'/>",
        "<svg/>",
        "<path transform='turn(3)' d='M0 0L1 1'/>",
        "<path d='M0 0L1e999 0'/>",
    ] {
        assert!(matches!(line(body).place, Place::Line { line: 2, .. }), "{body}");
    }
    assert!(matches!(*wrong("<svg>", Format::Svg).problem, Problem::Syntax(_)));
    assert!(matches!(*wrong("<html/>", Format::Svg).problem, Problem::Syntax(_)));
}

/// What is used again costs as often: a file of a megabyte must not make gigabytes.
#[test]
fn long_elements_are_not_drawn_without_end() {
    let note = "x".repeat(1 << 16);
    let uses = |count: usize| {
        svg(&format!("<path id='a' class='{note}' d='M0 0L1 1'/>{}", "<use href='#a'/>".repeat(count)))
    };
    assert_eq!(from_bytes(uses(9).as_bytes(), Format::Svg).unwrap().len(), 10);
    assert!(wrong(&uses(600), Format::Svg).to_string().contains("drawn more often than is read"));
}

#[test]
fn circles_are_written_as_cubics_near_them() {
    let circle = symspline::circle(&nalgebra::vector![0.0, 0.0], &100.0).unwrap();
    let text = to_bytes(&[AnyRational::from(circle).into()], Format::Svg).unwrap();
    let back = from_bytes(&text, Format::Svg).unwrap();
    let Value::Spline(_) = &back[0].value else { panic!() };
    for p in values(&back[0].value, 1000) {
        assert!((p[0].hypot(p[1]) - 100.0).abs() < 200.0 * symspline_files::svg::TOLERANCE);
    }
    // A quintic, and a cubic with smooth knots that is exact.
    let space = SplineSpace::bezier(5, 0.0, 1.0).unwrap();
    let quintic =
        AnySpline::new(space.into(), 2, Over::Float(vec![0., 0., 1., 3., 2., -2., 3., 5., 4., 1., 6., 0.]))
            .unwrap();
    let text = to_bytes(&[quintic.clone().into()], Format::Svg).unwrap();
    let near = values(&from_bytes(&text, Format::Svg).unwrap()[0].value, 20_000);
    assert_eq!(near[20_000], [6.0, 0.0]);
    let worst = values(&quintic.into(), 100).iter().map(|p| distance(p, &near)).fold(0.0, f64::max);
    assert!(worst < 7.0 * symspline_files::svg::TOLERANCE, "{worst}");
    let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0]).unwrap();
    let cubic = Value::from(
        AnySpline::new(space.into(), 2, Over::Float(vec![0., 0., 1., 3., 2., -2., 3., 5., 4., 1.])).unwrap(),
    );
    let same = from_bytes(&to_bytes(&[cubic.clone().into()], Format::Svg).unwrap(), Format::Svg).unwrap();
    for (p, q) in values(&same[0].value, 10).iter().zip(values(&cubic, 10)) {
        assert!((p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 1e-14);
    }
}

#[test]
fn names_come_back_from_drawings() {
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let line = AnySpline::new(space.into(), 2, Over::Float(vec![0.0, -0.0, 1e-7, 1e300])).unwrap();
    let names = ["a", "a", "", "two words", "<&\">\n'é"];
    let mut entries: Vec<Entry> = names.iter().map(|name| Entry::named(*name, line.clone())).collect();
    entries.push(line.clone().into());
    let text = to_bytes(&entries, Format::Svg).unwrap();
    assert_eq!(format!("{:?}", from_bytes(&text, Format::Svg).unwrap()), format!("{entries:?}"));
    // Identifiers are unique and words.
    let text = String::from_utf8(text).unwrap();
    assert_eq!((text.matches(" id=\"a\"").count(), text.matches(" id=").count()), (1, 1), "{text}");
    assert!(to_bytes(&[Entry::named("\0", line)], Format::Svg).is_err());
}

const SURFACE: &str = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 7\nv 2 1 0\ncstype bspline\ndeg 2 1\n\
    surf 0 1 0 1 1 2 3 4 5 6\nparm u 0 0 0 1 1 1\nparm v 0 0 1 1\nend\n";

#[test]
fn the_index_of_u_runs_first_in_obj() {
    let Value::Surface(surface) = one(SURFACE, Format::Obj) else { panic!() };
    let at = |u: f64, v: f64| surface.at(&Over::Float(u), &Over::Float(v)).unwrap();
    assert_eq!(at(1.0, 0.0), Over::Float(vec![2.0, 0.0, 0.0]));
    assert_eq!(at(0.0, 1.0), Over::Float(vec![0.0, 1.0, 0.0]));
    // Half of the middle point of the far side counts.
    assert_eq!(at(0.5, 1.0), Over::Float(vec![1.0, 1.0, 3.5]));
    let text = String::from_utf8(to_bytes(&[Value::from(surface).into()], Format::Obj).unwrap()).unwrap();
    assert!(text.contains("surf 0.0 1.0 0.0 1.0 1 3 5 2 4 6\n"), "{text}");
}

#[test]
fn weights_in_obj_stand_beside_the_points() {
    let text = "v 1 0 0 1\nv 1 1 0 1\nv 0 1 0 2\ncstype rat bspline\ndeg 2\ncurv 0 1 -3 -2 -1\nparm u 0 0 0 1 1 1\nend\n";
    let quarter = one(text, Format::Obj);
    for p in values(&quarter, 16) {
        assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-15 && p[2] == 0.0);
    }
    let polynomial = one(&text.replace("rat ", ""), Format::Obj);
    assert_eq!(values(&polynomial, 2)[1], [0.75, 0.75, 0.0]);
    let part = one(&text.replace("rat ", "").replace("curv 0 1", "curv 0 0.5"), Format::Obj);
    assert_eq!(values(&part, 2)[2], [0.75, 0.75, 0.0]);
    let bezier =
        "vp 0 0\nvp 1 2\nvp 2 0\nvp 3 -2\nvp 4 0\ncstype bezier\ndeg 2\ncurv2 1 2 3 4 5\nparm u 0 1 3\nend\n";
    assert_eq!(values(&one(bezier, Format::Obj), 3), [[0.0, 0.0], [2.0, 0.0], [3.0, -1.0], [4.0, 0.0]]);
}

/// geomdl leaves weights out, or writes ones; what is called rational is.
#[test]
fn rational_shapes_of_geomdl_have_weights_of_one_unless_told() {
    let text = r#"{"shape": {"type": "curve", "data": [{"rational": true, "degree": 1, "knotvector": [0, 0, 1, 1],
        "control_points": {"points": [[1, 2], [3, 4]]}}]}}"#;
    let Value::Rational(line) = one(text, Format::Geomdl) else { panic!() };
    assert_eq!(line.weights(), Some(Over::Float(vec![1.0, 1.0])));
    assert!(matches!(one(&text.replace("true", "false"), Format::Geomdl), Value::Spline(_)));
    for (old, new, told) in [
        ("\"curve\"", "\"surface\"", "shape 0: \"degree_u\" is missing"),
        ("\"curve\"", "\"volume\"", "shapes of type \"volume\" are not read"),
        ("\"data\"", "\"count\": 2, \"data\"", "\"count\" is 2, but there are 1 shapes"),
        ("\"degree\"", "\"dimension\": 3, \"degree\"", "shape 0: \"dimension\" is 3, but points have 2"),
        ("[1, 2]", "[1, 2, 3]", "shape 0: "),
        ("[0, 0, 1, 1]", "[0, 0, 1]", "shape 0: "),
        ("\"degree\": 1", "\"degree\": 99999999", "shape 0: "),
    ] {
        let error = wrong(&text.replace(old, new), Format::Geomdl).to_string();
        assert!(error.contains(told), "{error} does not tell {told}");
    }
}

#[test]
fn faces_make_a_mesh_beside_curves() {
    let text = include_str!("corpus/obj/mixed.obj");
    let entries = from_bytes(text.as_bytes(), Format::Obj).unwrap();
    assert_eq!((entries.len(), entries[1].name.as_deref()), (2, Some("square")));
    let Value::Mesh(Over::Float(mesh)) = &entries[1].value else { panic!() };
    assert_eq!(mesh.topology().faces().collect::<Vec<_>>(), [vec![0, 1, 2, 3], vec![1, 0, 4]]);
    assert_eq!(mesh.points()[4], nalgebra::vector![5.0, 5.0, 5.0]);
}

#[test]
fn wrong_obj_files_say_where() {
    let line = |text: &str, line: usize| {
        assert_eq!(wrong(text, Format::Obj).place, Place::Line { line, column: 0 }, "{text}");
    };
    line(&SURFACE.replace("1 2 3 4 5 6", "1 2 3 4 5"), 9);
    line(&SURFACE.replace("1 2 3 4 5 6", "1 2 3 4 5 7"), 9);
    line(&SURFACE.replace("deg 2 1", "deg 2 99999999999"), 9);
    line(&SURFACE.replace("end", "trim 0 1 1"), 12);
    line(&SURFACE.replace("end\n", ""), 9);
    line(&SURFACE.replace("cstype bspline", "cstype taylor"), 7);
    line(&SURFACE.replace("v 1 1 7", "v 1 \\\n1 nan"), 5);
    line("v 0 0 0\n\ncurv 0 1 1", 3);
}

#[test]
fn exact_and_periodic_values_are_written_rounded_and_open() {
    let ring = SplineSpace::periodic(2, [0, 1, 2].map(Q::int), Q::int(3)).unwrap();
    let coords = [0, 0, 3, 0, 0, 3].map(|n| Q::frac(n, 7)).to_vec();
    let ring = AnySpline::new(ring.into(), 2, Over::Exact(coords)).unwrap();
    for format in [Format::Obj, Format::Geomdl] {
        let back = from_bytes(&to_bytes(&[ring.clone().into()], format).unwrap(), format).unwrap();
        for (i, p) in values(&back[0].value, 12).iter().enumerate() {
            let expected = ring.at(&Over::Exact(Q::frac(i as i64, 4))).unwrap().to_float().unwrap();
            let Coords::Float(q) = expected else { panic!() };
            assert!((p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 1e-15);
        }
    }
}

fn patch() -> Entry {
    let line = SplineSpace::bezier(1, 0.0, 2.0).unwrap();
    let corners = vec![0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 3.0, 0.0, 0.0, 3.0, 2.0, 0.0];
    AnySurface::new(line.clone().into(), line.into(), 3, Over::Float(corners)).unwrap().into()
}

/// A rectangle of 3 by 2: the areas of all triangles add up, and their normals point up.
#[test]
fn surfaces_become_faces() {
    let stl = to_bytes(&[patch()], Format::Stl).unwrap();
    let count = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert_eq!((count, stl.len()), (2 * 48 * 48, 84 + 50 * count));
    let mut area = 0.0;
    for triangle in stl[84..].chunks_exact(50) {
        let x: Vec<f64> = triangle[..48]
            .chunks_exact(4)
            .map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap())))
            .collect();
        assert_eq!(x[..3], [0.0, 0.0, 1.0]);
        area += ((x[6] - x[3]) * (x[10] - x[4]) - (x[7] - x[4]) * (x[9] - x[3])) / 2.0;
    }
    assert!((area - 6.0).abs() < 1e-5, "{area}");
    let ply = to_bytes(&[patch()], Format::Ply).unwrap();
    let header =
        String::from_utf8_lossy(&ply).split("end_header\n").next().unwrap().to_owned() + "end_header\n";
    assert!(header.contains("element vertex 2401\n") && header.contains("element face 2304\n"), "{header}");
    assert_eq!(ply.len(), header.len() + 2401 * 48 + 2304 * 17);
    let last: Vec<f64> = ply[header.len() + 2400 * 48..][..48]
        .chunks_exact(8)
        .map(|b| f64::from_le_bytes(b.try_into().unwrap()))
        .collect();
    assert_eq!(last, [3.0, 2.0, 0.0, 0.0, 0.0, 1.0]);
    assert!(to_bytes(&[patch()], Format::Gltf).unwrap().starts_with(b"glTF"));
    let mesh = from_bytes(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", Format::Obj).unwrap();
    assert_eq!(to_bytes(&mesh, Format::Stl).unwrap().len(), 84 + 2 * 50);
}

#[test]
fn formats_have_no_room_for_everything() {
    let (number, patch) = (Entry::from(Value::from(Over::Float(1.0))), patch());
    for format in Format::all().filter(|format| format.is_written() && *format != Format::Json) {
        let refused = to_bytes(std::slice::from_ref(&number), format).unwrap_err();
        assert!(matches!(*refused.problem, Problem::NoRoom { .. }), "{format:?}: {refused}");
        assert_eq!(refused.place, Place::Entry("item 0".into()));
    }
    assert!(to_bytes(&[patch], Format::Svg).is_err());
    assert!(matches!(*from_bytes(b"", Format::Ply).unwrap_err().problem, Problem::OneWay { .. }));
    assert!(matches!(*from_bytes(b"", Format::Font).unwrap_err().problem, Problem::NoText));
}

#[test]
fn names_of_files_tell_the_format() {
    let of = |name: &str| Format::of(Path::new(name)).unwrap();
    assert_eq!(
        (of("a.json"), of("b/A.GEOMDL.JSON"), of("json.svg")),
        (Format::Json, Format::Geomdl, Format::Svg)
    );
    for name in ["json", "a.txt", ".", "a.json.gz"] {
        assert!(Format::of(Path::new(name)).is_err(), "{name}");
    }
    // A file `.json` may be of either form.
    let folder = std::env::temp_dir().join(format!("symspline-files-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("curve.json");
    std::fs::write(&path, include_str!("corpus/geomdl/curves.geomdl.json")).unwrap();
    let entries = read(&path).unwrap();
    assert_eq!((entries.len(), entries[1].name.as_deref()), (2, Some("arc")));
    write(&path, &entries).unwrap();
    assert_eq!(read(&path).unwrap(), entries);
    std::fs::write(&path, "{\"format\": 1}").unwrap();
    assert!(
        read(&path)
            .unwrap_err()
            .to_string()
            .ends_with("curve.json:1:12: invalid type: integer `1`, expected a string")
    );
    std::fs::remove_dir_all(&folder).unwrap();
}
