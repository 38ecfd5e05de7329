//! OBJ files: what is written is read again bit by bit, and no text does harm.

use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::io::obj;
use symspline::{ControlMesh, Error, Result};

type Mesh = ControlMesh<f64, 3>;

const FILES: [(&str, usize, usize, bool); 5] = [
    ("cube", 8, 6, true),
    ("pyramid", 5, 5, true),
    ("torus", 32, 32, true),
    ("pawn", 601, 588, false),
    ("helmet", 72, 58, false),
];

fn path(name: &str) -> String {
    format!("{}/../data/subd_{name}.obj", env!("CARGO_MANIFEST_DIR"))
}

/// The same mesh, zeros with their signs.
fn same(one: &Mesh, other: &Mesh) -> bool {
    let bits = |mesh: &Mesh| mesh.points().iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    one.topology() == other.topology() && bits(one) == bits(other)
}

fn again(mesh: &Mesh) -> Result<Mesh> {
    let mut text = Vec::new();
    obj::write(mesh, &mut text)?;
    obj::read(text.as_slice())
}

#[test]
fn the_files_of_the_repository_are_read() -> Result<()> {
    for (name, vertices, faces, closed) in FILES {
        let mesh = obj::read_file(path(name))?;
        let topology = mesh.topology();
        assert_eq!((topology.vertex_count(), topology.face_count()), (vertices, faces), "{name}");
        assert_eq!(topology.is_closed(), closed, "{name}");
        assert!(same(&again(&mesh)?, &mesh), "{name}");
        let folder = std::env::temp_dir().join(format!("symspline-obj-{}", std::process::id()));
        let file = folder.join("new").join(name);
        obj::write_file(&mesh, &file)?;
        assert!(same(&obj::read_file(&file)?, &mesh), "{name}");
        std::fs::remove_dir_all(folder).expect("the folder is there");
    }
    assert!(matches!(obj::read_file(path("none")), Err(Error::Io { path: at, .. }) if at == path("none")));
    Ok(())
}

/// Groups do not tear a mesh, and corners may tell more.
#[test]
fn groups_share_their_vertices() -> Result<()> {
    let text = std::fs::read_to_string(path("cube")).expect("a text");
    let mut face = 0;
    let grouped: Vec<String> = text
        .lines()
        .map(|line| match line.strip_prefix("f ") {
            None => line.to_string(),
            Some(corners) => {
                face += 1;
                let corners: Vec<_> = corners.split(' ').map(|v| format!("{v}/{face}/1")).collect();
                format!("g side{face}\nusemtl m{face}\nf {}", corners.join(" \\\n"))
            }
        })
        .collect();
    assert!(same(&obj::read(grouped.join("\n").as_bytes())?, &obj::read(text.as_bytes())?));
    Ok(())
}

/// A grid of squares, one cut in two triangles, over any coordinates.
fn meshes() -> impl Strategy<Value = Mesh> {
    let finite = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
    let coordinate =
        prop_oneof![finite, (-99_i32..99).prop_map(f64::from), select(vec![-0.0, 0.1, 5e-324, f64::MAX])];
    (1_usize..4, 1_usize..4).prop_flat_map(move |(m, n)| {
        vec(coordinate.clone(), 3 * (m + 1) * (n + 1)).prop_map(move |numbers| {
            let points: Vec<SVector<f64, 3>> = numbers.chunks(3).map(|p| vector![p[0], p[1], p[2]]).collect();
            let at = |i: usize, j: usize| i * (n + 1) + j;
            let square = |i: usize, j: usize| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let mut faces: Vec<Vec<usize>> = (0..m).flat_map(|i| (0..n).map(move |j| square(i, j))).collect();
            let first = faces.remove(0);
            faces.extend([vec![first[2], first[0], first[1]], vec![first[3], first[0], first[2]]]);
            Mesh::new(points, faces).expect("a grid")
        })
    })
}

/// Texts that are nearly files.
fn texts() -> impl Strategy<Value = String> {
    let word = select(vec![
        "v",
        "f",
        "v 0 1 2",
        "f 1 2 3",
        "f -1 -2 -3 -4",
        "vt",
        "g",
        "#",
        "\\\n",
        "\n",
        "\r\n",
        " ",
        "\t",
        "0",
        "1",
        "-1",
        "1/2/3",
        "//",
        "nan",
        "inf",
        "1e400",
        "99999999999999999999",
        "-9223372036854775808",
        "9223372036854775807",
        "\u{0}",
        "\u{feff}",
        "é",
        ".",
        "-",
        "+",
        "e",
        "curv",
    ]);
    vec(word, 0..60).prop_map(|words| words.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_is_written_is_read(mesh in meshes()) {
        prop_assert!(same(&again(&mesh)?, &mesh));
    }

    #[test]
    fn no_bytes_do_harm(bytes in vec(any::<u8>(), 0..400), text in texts()) {
        for bytes in [bytes.as_slice(), text.as_bytes()] {
            if let Ok(mesh) = obj::read(bytes) {
                prop_assert!(same(&again(&mesh)?, &mesh));
            }
        }
    }

    /// Files cut short, with bytes changed, and with lines in another order.
    #[test]
    fn no_change_of_a_file_does_harm(
        file in select(vec!["cube", "pyramid", "torus", "helmet"]),
        end in any::<Index>(),
        cut in any::<bool>(),
        changes in vec((any::<Index>(), select(b"vf0123456789/-.# \n\\e\xff\0".to_vec())), 0..6),
        swaps in vec((any::<Index>(), any::<Index>()), 0..3),
    ) {
        let mut bytes = std::fs::read(path(file)).expect("a file");
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
        for (one, other) in swaps {
            let (one, other) = (one.index(lines.len()), other.index(lines.len()));
            lines.swap(one, other);
        }
        let mut bytes = lines.join(&b'\n');
        if cut {
            bytes.truncate(end.index(bytes.len()));
        }
        match obj::read(bytes.as_slice()) {
            Ok(mesh) => prop_assert!(same(&again(&mesh)?, &mesh)),
            Err(error) => prop_assert!(matches!(error, Error::Mesh(_)), "{}", error),
        }
    }
}
