# %% [markdown]
# # Fine tuning a car body profile
#
# A scanned profile is fitted by a cubic, and its derivative is multiplied by a scale function: with the end free; with both ends held by
# a rotation and scaling; and by the nearest scale with which the end stays by itself. Run it as a script or cell by cell.

# %%
import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from symspline import Space, Spline
from symspline.analysis import CurvatureProfile, curvature, curvature_comb
from symspline.fine_tune import NearestScale, fine_tuned, fine_tuned_holding

ROOT = Path(__file__).resolve().parents[2] if "__file__" in globals() else Path.cwd()
parser = argparse.ArgumentParser(description="Draws the figure of a fine-tuned car profile.")
parser.add_argument("--output", type=Path, default=ROOT / "target" / "car_figure.png")
arguments, _ = parser.parse_known_args()  # a notebook has arguments of its own


# %%
# Parameters by lengths of chords; the side view has y and z.
points = np.loadtxt(ROOT / "data" / "car_prius_profile_3.csv", delimiter=",", skiprows=1)[:, -2:]
lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
parameters = np.minimum(lengths / lengths[-1], 1)
curve = Spline.least_squares(Space.uniform(3, 69, 0.0, 1.0), parameters, points, ends="held")
alpha = Spline(Space.uniform(2, 4, 0.0, 1.0), [1.0, 1.0, 0.5, 2.0, 1.0, 1.0])

# %% [markdown]
# The three ways to tune. With the ends held by a similarity of scale `s` the curvature is `κ / (α s)`.

# %%
free = fine_tuned(curve, alpha)
held = fine_tuned_holding(curve, alpha, "points")
scale = np.sqrt(held.squared_scale)
nearest = NearestScale(curve, alpha.space, ["end"]).to(alpha)
tuned = [
    ("end free", "#0072B2", free, alpha, 1.0),
    ("ends held", "#D55E00", held.curve, alpha, scale),
    ("nearest scale", "#009E73", fine_tuned(curve, nearest), nearest, 1.0),
]

at = np.linspace(0, 1, 1400)[1:-1]
kappa = curvature(curve, at)
print(f"{len(points)} points")
for name, _, d, a, s in tuned:
    off = np.abs(curvature(d, at) * a(at) * s - kappa).max() / np.abs(kappa).max()
    moved = np.linalg.norm(d.coeffs[-1] - curve.coeffs[-1])
    print(f"{name:<14} degree {d.space.degree}, s {s:.4f}, |κ_D α s - κ| / |κ|max {off:.1e}, end moved {moved:.3f} mm")

# %%
figure, (plane, scales, profiles) = plt.subplots(3, 1, figsize=(11, 12), layout="constrained", height_ratios=[3, 3, 4])
chord = np.linalg.norm(curve.coeffs[-1] - curve.coeffs[0])
comb = CurvatureProfile(curve).comb_scale(0.08 * chord)
for name, color, d in [("original", "#888888", curve)] + [(name, color, d) for name, color, d, _, _ in tuned]:
    path, teeth = d(at), np.linspace(0, 1, 280)[1:-1]
    tips, feet = curvature_comb(d, teeth, comb), d(teeth)
    plane.plot(np.array([feet[:, 0], tips[:, 0]]), np.array([feet[:, 1], tips[:, 1]]), color=color, lw=0.4)
    plane.plot(tips[:, 0], tips[:, 1], color=color, lw=0.6)
    plane.plot(path[:, 0], path[:, 1], color=color, lw=2.2, label=name)
    profiles.plot(*CurvatureProfile(d).samples[:2], color=color, lw=1.2, label=name)
profiles.plot(at, kappa / alpha(at), "k:", lw=1, label="κ / α of the original")
for name, color, _, a, s in tuned:
    if s == 1.0:
        scales.plot(at, a(at), color=color, lw=2, label=f"α, {name}")
        scales.plot(a.space.greville, a.coeffs, "o-", color=color, lw=0.6, mfc="none")
plane.set(title="Profile with curvature combs", xlabel="y [mm]", ylabel="z [mm]", aspect="equal")
scales.set(title="Scale functions", ylabel="α")
profiles.set(title="Curvature", xlabel="parameter", ylabel="κ [1/mm]")
for panel in [plane, scales, profiles]:
    panel.legend(loc="best", fontsize=8)
arguments.output.parent.mkdir(parents=True, exist_ok=True)
figure.savefig(arguments.output, dpi=110)
print(f"wrote {arguments.output}")
