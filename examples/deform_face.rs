//! A face sculpted out of a plane by forces, in five steps [Vassilev, Fig. 6].
//!
//! The whole plane bends under forces on an area; a line of growing forces raises the nose; forces along curves make brows
//! and lids, narrow ones the mouth; forces on areas round forehead, chin and cheeks, and a closed curve trims the outcome. The
//! hardness of the material tells how narrow a step is, and knots are inserted where the resolution is short.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::{SVector, vector};
use std::collections::BTreeSet;
use std::time::{Duration, Instant};
use support::solid::Sheet;
use support::{Outcome, Plane, Point, target};
use symspline::plot::{Color, Figure, Mesh, Panel, Scene, View, write_glb};
use symspline::{
    Breadth, Cells, Controlled, Direction, Elastic, Forces, Material, NurbsCurve, SplineSpace, ellipse,
};

/// Towards the eye: the plane is that of `x` and `z`.
const OUT: SVector<f64, 3> = SVector::<f64, 3>::new(0.0, -1.0, 0.0);
const SIZE: (f64, f64) = (1.0, 1.28);
const CELLS: Cells<f64> = Cells::Spacing(0.008);
const WHOLE: (f64, f64) = (0.0, 1.0);

type Load<'a, 'b> = &'a mut Forces<'b, f64, Sheet>;
type Step = fn(&mut Face) -> Outcome<()>;
/// The number of single forces.
type Pushed = symspline::Result<usize>;

fn main() -> Outcome<()> {
    let mut face = Face::plane(32)?;
    let steps: [(&str, Step); 5] = [
        ("a. area: head", head),
        ("b. line: nose", nose),
        ("c. curves: brows, lids", brows),
        ("d. narrow: mouth", mouth),
        ("e. areas, trimmed", cheeks),
    ];
    println!("step                     forces  control points    moved      ms    energy");
    let mut states = Vec::new();
    for (name, sculpt) in steps {
        face.begin();
        sculpt(&mut face)?;
        let (ms, moved) = (face.time.as_secs_f64() * 1e3, face.moved.len());
        let points = face.sheet.coeffs().len();
        println!("{name:<22} {:>8} {points:>15} {moved:>8} {ms:>7.1} {:>9.1e}", face.forces, face.energy);
        states.push((name, face.sheet.clone()));
    }
    draw(&states)
}

/// A surface at work, and what a step did to it.
struct Face {
    sheet: Sheet,
    /// The number of single forces.
    forces: usize,
    moved: BTreeSet<usize>,
    time: Duration,
    energy: f64,
}

/// Where control points may move, and how far a force is felt along `u` and along `v`.
struct Tool {
    u: (f64, f64),
    v: (f64, f64),
    felt: (f64, f64),
}

impl Tool {
    /// A material of hardness 1 that bends back within a distance.
    fn material(felt: f64) -> symspline::Result<Material<f64>> {
        Material::new(felt.powi(2), felt.powi(4))?.with_hardness(1.0)
    }

    fn on(&self, sheet: &Sheet) -> symspline::Result<Elastic<f64>> {
        let knot = |direction: Direction, x: f64| {
            let knots = sheet.space(direction).knots().iter().copied();
            knots.reduce(|t, s| if (s - x).abs() < (t - x).abs() { s } else { t }).unwrap_or(x)
        };
        let breadth = |(from, to): (f64, f64), direction: Direction| match (from, to) {
            WHOLE => Breadth::BetweenEnds(1),
            _ => Breadth::Within(knot(direction, from), knot(direction, to)),
        };
        let materials = [Self::material(self.felt.0)?, Self::material(self.felt.1)?];
        let breadths = [breadth(self.u, Direction::U), breadth(self.v, Direction::V)];
        Elastic::with_materials(sheet, &materials, &breadths)
    }
}

impl Face {
    fn plane(spans: usize) -> Outcome<Self> {
        let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
        let nodes = space.greville();
        let point = |u: &f64, v: &f64| vector![SIZE.0 * u, 0.0, SIZE.1 * v];
        let points = nodes.iter().flat_map(|u| nodes.iter().map(move |v| point(u, v))).collect();
        let sheet = Sheet::new(space.clone(), space, points)?;
        Ok(Self { sheet, forces: 0, moved: BTreeSet::new(), time: Duration::ZERO, energy: 0.0 })
    }

    fn begin(&mut self) {
        self.moved.clear();
        (self.forces, self.time, self.energy) = (0, Duration::ZERO, 0.0);
    }

    /// Halves the spans between two parameters.
    fn refine(&mut self, direction: Direction, from: f64, to: f64) -> Outcome<()> {
        let breaks: Vec<f64> = self.sheet.space(direction).breaks().into_iter().map(|(t, _)| t).collect();
        let middles = breaks.windows(2).map(|ends| (ends[0] + ends[1]) / 2.0);
        let knots: Vec<f64> = middles.filter(|t| (from..=to).contains(t)).collect();
        self.sheet = self.sheet.inserted(direction, &knots)?;
        Ok(())
    }

    /// Forces so strong that the point `at` moves out by `by`, as in [Vassilev, (32)]; their work is the energy `Dᵀ K D`.
    fn push(
        &mut self,
        tool: &Tool,
        at: (f64, f64),
        by: f64,
        load: impl Fn(Load<'_, '_>) -> Pushed,
    ) -> Outcome<()> {
        let start = Instant::now();
        let elastic = tool.on(&self.sheet)?;
        let mut forces = Forces::new(&elastic, &self.sheet)?;
        self.forces += load(&mut forces)?;
        let (loads, mut moves) = (forces.load()?, forces.displacements()?);
        let mut trial = self.sheet.clone();
        trial.move_points(&moves)?;
        let strength = by / (trial.at(&at.0, &at.1)? - self.sheet.at(&at.0, &at.1)?).dot(&OUT);
        let work: f64 = moves.iter().map(|(i, d)| loads[*i].dot(d)).sum();
        moves.iter_mut().for_each(|(_, d)| *d *= strength);
        self.sheet.move_points(&moves)?;
        self.time += start.elapsed();
        self.energy += work * strength.powi(2);
        self.moved.extend(moves.iter().map(|(i, _)| *i));
        Ok(())
    }

    /// The same on both sides of the face.
    fn push_both(
        &mut self,
        tool: &Tool,
        at: (f64, f64),
        by: f64,
        load: impl Fn(Load<'_, '_>, &dyn Fn(f64) -> f64) -> Pushed,
    ) -> Outcome<()> {
        self.push(tool, at, by, |forces| load(forces, &|u| u))?;
        let mirrored = Tool { u: (1.0 - tool.u.1, 1.0 - tool.u.0), ..*tool };
        self.push(&mirrored, (1.0 - at.0, at.1), by, |forces| load(forces, &|u| 1.0 - u))
    }
}

fn head(face: &mut Face) -> Outcome<()> {
    let tool = Tool { u: WHOLE, v: WHOLE, felt: (0.05, 0.05) };
    let outline = outline()?;
    face.push(&tool, (0.5, 0.5), 0.34, |forces| {
        let mut count = 0;
        forces.over(&outline, &CELLS, |(u, v)| {
            count += 1;
            let (x, y) = ((u - 0.5) / 0.4, (v - 0.5) / 0.5);
            Ok(OUT * (1.0 - x.powi(2) - y.powi(4)).max(0.0).powf(0.4))
        })?;
        Ok(count)
    })
}

fn nose(face: &mut Face) -> Outcome<()> {
    face.refine(Direction::U, 0.24, 0.76)?;
    face.refine(Direction::V, 0.36, 0.64)?;
    let tool = Tool { u: (0.36, 0.64), v: (0.32, 0.72), felt: (0.033, 0.016) };
    face.push(&tool, (0.5, 0.43), 0.11, |forces| along(forces, &[(0.5, 0.63), (0.5, 0.425)], |t| 0.1 + t))?;
    let tip = Tool { u: (0.4, 0.6), v: (0.36, 0.5), felt: (0.016, 0.014) };
    face.push(&tip, (0.5, 0.435), 0.016, |forces| over(forces, (0.5, 0.435), (0.03, 0.022)))?;
    let wing = Tool { u: (0.36, 0.50), v: (0.34, 0.5), felt: (0.014, 0.014) };
    face.push_both(&wing, (0.45, 0.425), 0.032, |forces, side| {
        forces.at(&(side(0.45), 0.425), OUT)?;
        Ok(1)
    })
}

fn brows(face: &mut Face) -> Outcome<()> {
    face.refine(Direction::V, 0.56, 0.62)?;
    let socket = Tool { u: (0.16, 0.5), v: (0.44, 0.72), felt: (0.034, 0.03) };
    face.push_both(&socket, (0.36, 0.585), -0.06, |forces, side| {
        over(forces, (side(0.365), 0.585), (0.09, 0.05))
    })?;
    let brow = Tool { u: (0.16, 0.5), v: (0.54, 0.76), felt: (0.02, 0.016) };
    face.push_both(&brow, (0.36, 0.652), 0.032, |forces, side| {
        let arch = [(side(0.455), 0.622), (side(0.39), 0.69), (side(0.235), 0.61)];
        along(forces, &arch, |t| 0.2 + t * (1.0 - t))
    })?;
    let lid = Tool { u: (0.25, 0.47), v: (0.5, 0.66), felt: (0.016, 0.012) };
    face.push_both(&lid, (0.36, 0.577), 0.034, |forces, side| {
        over(forces, (side(0.36), 0.577), (0.058, 0.028))
    })?;
    let slit = Tool { u: (0.28, 0.45), v: (0.53, 0.61), felt: (0.012, 0.005) };
    face.push_both(&slit, (0.36, 0.564), -0.013, |forces, side| {
        along(forces, &[(side(0.305), 0.575), (side(0.36), 0.553), (side(0.415), 0.573)], |_| 1.0)
    })
}

fn mouth(face: &mut Face) -> Outcome<()> {
    face.refine(Direction::V, 0.2, 0.36)?;
    let lips = Tool { u: (0.34, 0.66), v: (0.2, 0.38), felt: (0.03, 0.012) };
    face.push(&lips, (0.5, 0.305), 0.034, |forces| {
        let upper = [(0.40, 0.287), (0.47, 0.34), (0.5, 0.28), (0.53, 0.34), (0.60, 0.287)];
        let lower = [(0.41, 0.28), (0.46, 0.242), (0.54, 0.242), (0.59, 0.28)];
        Ok(along(forces, &upper, |_| 1.0)? + along(forces, &lower, |_| 1.0)?)
    })?;
    let slit = Tool { u: (0.34, 0.66), v: (0.22, 0.34), felt: (0.012, 0.005) };
    face.push(&slit, (0.5, 0.285), -0.028, |forces| {
        let between = [(0.393, 0.283), (0.46, 0.289), (0.5, 0.280), (0.54, 0.289), (0.607, 0.283)];
        along(forces, &between, |_| 1.0)
    })
}

fn cheeks(face: &mut Face) -> Outcome<()> {
    let broad = Tool { u: WHOLE, v: WHOLE, felt: (0.045, 0.04) };
    face.push(&broad, (0.5, 0.77), 0.03, |forces| over(forces, (0.5, 0.78), (0.24, 0.12)))?;
    face.push(&broad, (0.5, 0.175), 0.06, |forces| over(forces, (0.5, 0.175), (0.085, 0.04)))?;
    let cheek = Tool { u: (0.1, 0.5), v: (0.22, 0.6), felt: (0.045, 0.04) };
    face.push_both(&cheek, (0.29, 0.44), 0.018, |forces, side| over(forces, (side(0.29), 0.44), (0.09, 0.06)))
}

/// A force along a Bezier curve of the parameter plane, as strong as `strength` says.
fn along(forces: Load<'_, '_>, points: &[(f64, f64)], strength: impl Fn(f64) -> f64) -> Pushed {
    let samples = 200;
    let points: Vec<Point> = points.iter().map(|(u, v)| vector![*u, *v]).collect();
    let path = Plane::new(SplineSpace::bezier(points.len() - 1, 0.0, 1.0)?, points)?;
    forces.along_by(&path, samples, |t, _| Ok(OUT * strength(*t)))?;
    Ok(samples)
}

/// A force over an ellipse, strongest in the middle.
fn over(forces: Load<'_, '_>, (u, v): (f64, f64), (a, b): (f64, f64)) -> Pushed {
    let area: NurbsCurve<f64, 2> = ellipse(&vector![u, v], &vector![a, 0.0], &vector![0.0, b])?;
    let mut count = 0;
    forces.over(&area, &CELLS, |(x, y)| {
        count += 1;
        Ok(OUT * (1.0 - ((x - u) / a).powi(2) - ((y - v) / b).powi(2)).max(0.0).sqrt())
    })?;
    Ok(count)
}

/// The outline of the head: a closed curve in the parameter plane.
fn outline() -> symspline::Result<Plane> {
    let left = [(0.5, 0.02), (0.32, 0.06), (0.14, 0.30), (0.10, 0.62), (0.2, 0.93), (0.5, 1.0)];
    let right = left[1..5].iter().rev().map(|(u, v)| (1.0 - u, *v));
    let points: Vec<Point> = left.into_iter().chain(right).map(|(u, v)| vector![u, v]).collect();
    Plane::new(SplineSpace::uniform_periodic(3, points.len(), 0.0, 1.0)?, points)
}

/// The part of the face inside the outline, as rings about its middle.
fn trimmed(sheet: &Sheet) -> Outcome<Mesh> {
    let (rings, steps) = (160, 360);
    let (outline, middle) = (outline()?, vector![0.5, 0.45]);
    let mut positions = vec![sheet.at(&middle[0], &middle[1])?];
    for k in 1..=rings {
        for i in 0..steps {
            let edge = outline.at(&(f64::from(i) / f64::from(steps)))?;
            let place = middle + (edge - middle) * (f64::from(k) / f64::from(rings));
            positions.push(sheet.at(&place[0], &place[1])?);
        }
    }
    let at = |k: i32, i: i32| if k == 0 { 0 } else { (1 + (k - 1) * steps + i % steps) as usize };
    let faces = (0..rings).flat_map(|k| (0..steps).map(move |i| (k, i))).map(|(k, i)| match k {
        0 => vec![0, at(1, i), at(1, i + 1)],
        _ => vec![at(k, i), at(k + 1, i), at(k + 1, i + 1), at(k, i + 1)],
    });
    Ok(Mesh::new(positions, faces)?)
}

fn draw(states: &[(&str, Sheet)]) -> Outcome<()> {
    let (last, before) = states.split_last().ok_or("there are states")?;
    let mut meshes: Vec<Mesh> =
        before.iter().map(|(_, sheet)| Mesh::of(sheet, 240, 300)).collect::<Result<_, _>>()?;
    meshes.push(trimmed(&last.1)?);
    let clay = Color::new(226, 188, 160);
    let mut figure = Figure::new(1500.0).title("A face sculpted out of a plane by forces [Vassilev, Fig. 6]");
    for view in [View::new(-74.0, 6.0), View::new(-20.0, 5.0)] {
        let view = view.framing(&meshes.iter().collect::<Vec<_>>())?;
        let mut panel = Panel::new();
        for (mesh, (name, _)) in meshes.iter().zip(states) {
            panel = panel.picture(*name, Scene::new().mesh(mesh, clay).image(&view, 560, 700)?);
        }
        figure = figure.panel(panel);
    }
    let path = target("deform_face");
    figure.write_svg(path.with_extension("svg"))?;
    figure.write_png(path.with_extension("png"), 1.5)?;
    write_glb(path.with_extension("glb"), &[(&meshes[states.len() - 1], clay.into())])?;
    println!("wrote {} as SVG and PNG, and the last state as glb", path.display());
    Ok(())
}
