//! Exact spline algebra and fine tuning of curves and surfaces on the command line.

fn main() {}
