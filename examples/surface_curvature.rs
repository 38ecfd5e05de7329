//! Gaussian and mean curvature as colours on the Utah teapot and on the Wigley hull: pictures, and files for viewers.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use std::time::Instant;
use support::solid::{Sheet, hull, mirrored, teapot};
use support::{Outcome, target};
use symspline::plot::{Color, ColorScale, Figure, Mesh, Panel, Scene, View, knot_lines, write_glb};

fn main() -> Outcome<()> {
    let pot = Solid {
        name: "teapot",
        patches: teapot()?,
        steps: (24, 24),
        views: [View::new(-62.0, 24.0), View::new(-150.0, 38.0)],
        size: (1000, 640),
        unit: "unit",
        captions: ["from the spout", "from the handle"],
    };
    pot.report("The Utah teapot, 32 bicubic patches", 0.9)?;
    let half = hull()?;
    let ship = Solid {
        name: "hull",
        patches: vec![mirrored(&half)?, half],
        steps: (120, 60),
        views: [View::new(-48.0, 24.0), View::new(-48.0, -18.0)],
        size: (1000, 480),
        unit: "m",
        captions: ["from above", "from below"],
    };
    ship.report("The Wigley hull, biquadratic", 0.98)
}

struct Solid {
    name: &'static str,
    patches: Vec<Sheet>,
    steps: (usize, usize),
    views: [View; 2],
    size: (usize, usize),
    unit: &'static str,
    captions: [&'static str; 2],
}

impl Solid {
    /// The whole solid, with a value of its patches at each vertex.
    fn mesh(&self, value: impl Fn(&Sheet, &f64, &f64) -> symspline::Result<f64>) -> symspline::Result<Mesh> {
        let sampled = |patch: &Sheet| Mesh::sampled(patch, self.steps.0, self.steps.1, &value);
        let meshes = self.patches.iter().map(sampled).collect::<symspline::Result<Vec<_>>>()?;
        Mesh::joined(&meshes)
    }

    fn report(&self, title: &str, share: f64) -> Outcome<()> {
        let start = Instant::now();
        let (gaussian, mean) =
            (self.mesh(Sheet::gaussian_curvature_at)?, self.mesh(Sheet::mean_curvature_at)?);
        println!(
            "{}: {} triangles, two meshes in {:.1?}",
            self.name,
            mean.triangles().count(),
            start.elapsed()
        );
        let labels =
            [format!("Gaussian curvature [1/{}²]", self.unit), format!("mean curvature [1/{}]", self.unit)];
        let mut figure = Figure::new(1000.0).title(title);
        for (mesh, label) in [gaussian, mean].iter().zip(labels) {
            let scale = ColorScale::about_zero(&[mesh], share)?;
            let mut panel = Panel::new().color_bar(&scale, &label);
            for (view, caption) in self.views.iter().zip(self.captions) {
                let start = Instant::now();
                let mut scene = Scene::new().mesh(mesh, &scale);
                for patch in &self.patches {
                    scene = scene.lines(knot_lines(patch, 60)?, Color::new(60, 60, 60), 1.2);
                }
                let image = scene.image(view, self.size.0, self.size.1)?;
                println!(
                    "  a picture of {} x {} px in {:.1?}",
                    image.width(),
                    image.height(),
                    start.elapsed()
                );
                panel = panel.picture(caption, image);
            }
            figure = figure.panel(panel);
            let name = label.split(' ').next().unwrap_or_default().to_lowercase();
            let path = target(&format!("{}_{name}.glb", self.name));
            write_glb(&path, &[(mesh, (&scale).into())])?;
            println!("  wrote {}", path.display());
        }
        let path = target(&format!("surface_curvature_{}", self.name));
        figure.write_svg(path.with_extension("svg"))?;
        figure.write_png(path.with_extension("png"), 2.0)?;
        println!("  wrote {} as SVG and PNG", path.display());
        Ok(())
    }
}
