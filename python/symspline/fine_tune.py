"""Fine tuning: the derivative multiplied by a function, and so the curvature divided by it."""

from ._symspline import (
    Approximation,
    FineTuner,
    HeldCurve,
    HeldSurface,
    LocallyTuned,
    NearestScale,
    Relaxed,
    dragged,
    fine_tuned,
    fine_tuned_closed,
    fine_tuned_from,
    fine_tuned_holding,
    fine_tuned_on,
    fine_tuned_on_by_nearest,
    fine_tuned_within,
    path_gap,
    scale_for_curvature_ratio,
    scale_moments,
)
