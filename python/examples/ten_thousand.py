"""Fine-tunes ten thousand curves over a local Dask cluster, and checks that the results are those of one process."""

import argparse
import time

import numpy as np
from dask.distributed import Client, LocalCluster, as_completed
from symspline import Space, Spline
from symspline.fine_tune import fine_tuned_holding
from tqdm import tqdm

SPACE = Space.uniform(3, 60, 0.0, 1.0)
ALPHA = Spline(Space.uniform(2, 4, 0.0, 1.0), [1.0, 1.0, 0.5, 2.0, 1.0, 1.0])


def curves(count, seed=1):
    """Wavy curves in the plane, each with 63 control points."""
    random = np.random.default_rng(seed)
    x = np.linspace(0, 10, SPACE.dim)
    for _ in range(count):
        y = np.cumsum(random.normal(size=SPACE.dim)) / 8
        yield Spline(SPACE, np.column_stack([x, y]))


def tune(curve):
    """The curve with its derivative scaled and its end tangents held."""
    return fine_tuned_holding(curve, ALPHA, "tangents").curve


def tune_all(chunk):
    """All curves of a chunk, tuned."""
    return [tune(curve) for curve in chunk]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000, help="how many curves")
    parser.add_argument("--workers", type=int, default=2, help="how many processes")
    parser.add_argument("--chunk", type=int, default=250, help="how many curves go to a process at once")
    arguments = parser.parse_args()
    if min(arguments.count, arguments.workers, arguments.chunk) < 1:
        parser.error("counts are at least 1")

    every = list(curves(arguments.count))
    chunks = [every[i : i + arguments.chunk] for i in range(0, len(every), arguments.chunk)]
    start = time.perf_counter()
    serial = tune_all(every)
    alone = time.perf_counter() - start

    with LocalCluster(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            start = time.perf_counter()
            futures = {client.submit(tune_all, chunk, pure=False): i for i, chunk in enumerate(chunks)}
            found = {}
            with tqdm(total=len(every), unit="curve") as bar:
                for future, tuned in as_completed(futures, with_results=True):
                    found[futures[future]] = tuned
                    bar.update(len(tuned))
            spread = time.perf_counter() - start

    together = [curve for i in range(len(chunks)) for curve in found[i]]
    if together != serial:
        raise SystemExit("the cluster found other curves than one process")
    print(f"{len(every)} curves, the same from {arguments.workers} processes as from one, bit by bit")
    print(f"one process {alone:.2f} s, the cluster {spread:.2f} s with sending and receiving")


if __name__ == "__main__":
    main()
