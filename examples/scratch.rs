#![allow(clippy::all, clippy::pedantic, clippy::print_stdout, clippy::unwrap_used)]
use nalgebra::vector;
use std::time::Instant;
use symspline::*;
fn main() {
    let text = std::fs::read_to_string("data/car_prius_profile_3.csv").unwrap();
    let pts: Vec<_> = text
        .lines()
        .skip(1)
        .filter_map(|l| {
            let v: Vec<f64> = l.split(',').filter_map(|x| x.trim().parse().ok()).collect();
            if v.len() >= 2 { Some(vector![v[v.len() - 2], v[v.len() - 1]]) } else { None }
        })
        .collect();
    let par = chord_length(&pts).unwrap();
    let space = SplineSpace::uniform(3, 69, 0.0, 1.0).unwrap();
    let c = Curve::least_squares(&space, &par, &pts, Ends::Held).unwrap();
    let alpha =
        Function::new(SplineSpace::uniform(2, 4, 0.0, 1.0).unwrap(), vec![1.0, 1.0, 0.5, 2.0, 1.0, 1.0])
            .unwrap();
    let d = c.fine_tuned(&alpha).unwrap();
    for (name, c) in [("car", &c), ("tuned", &d)] {
        for _ in 0..2 {
            let t = Instant::now();
            let p = c.profile().unwrap();
            println!(
                "{name} f64 {:?} events {} infl {} max {} min {} jump {}",
                t.elapsed(),
                p.events().len(),
                p.count(EventKind::Inflection),
                p.count(EventKind::Maximum),
                p.count(EventKind::Minimum),
                p.count(EventKind::Jump)
            );
            let w = p
                .events()
                .iter()
                .map(|e| {
                    let (a, b) = e.place.bounds();
                    b - a
                })
                .fold(0.0, f64::max);
            let k = p
                .events()
                .iter()
                .map(|e| {
                    e.curvature.iter().map(|b| b.high - b.low).fold(0.0, f64::max)
                        / e.curvature[0].middle().abs().max(1e-3)
                })
                .fold(0.0, f64::max);
            println!("  widest place {w:e} curvature {k:e}");
        }
        let q = c.to_exact().unwrap();
        let t = Instant::now();
        let p = q.profile().unwrap();
        println!(
            "{name} Q {:?} events {} infl {} max {} min {}",
            t.elapsed(),
            p.events().len(),
            p.count(EventKind::Inflection),
            p.count(EventKind::Maximum),
            p.count(EventKind::Minimum)
        );
    }
    // 1000-span cubic
    let s = SplineSpace::uniform(3, 1000, 0.0, 1.0).unwrap();
    let f = Function::new(s.clone(), (0..s.dim()).map(|i| (i as f64 * 1.7).sin()).collect()).unwrap();
    for _ in 0..2 {
        let t = Instant::now();
        let z = f.zeros().unwrap();
        println!("zeros f64 {:?} {}", t.elapsed(), z.len());
        let w = z
            .iter()
            .map(|e| {
                let (a, b) = e.place.bounds();
                b - a
            })
            .fold(0.0, f64::max);
        println!("widest {w:e}");
    }
    let q = f.to_exact().unwrap();
    let t = Instant::now();
    let z = q.zeros().unwrap();
    println!("zeros Q {:?} {}", t.elapsed(), z.len());
    let e = ellipse(&vector![0.0, 0.0], &vector![3.0, 0.0], &vector![0.0, 1.0]).unwrap();
    let t = Instant::now();
    let p = e.profile().unwrap();
    println!("{:?}", t.elapsed());
    for e in p.events() {
        println!("{:?} {:?} {:?}", e.kind, e.place, e.curvature);
    }
}
