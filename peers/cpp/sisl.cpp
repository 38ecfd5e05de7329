// Times of SISL. It has neither products nor degree reduction nor antiderivatives.

#include "bench.hpp"

#include <memory>
#include <sisl.h>

using namespace bench;

namespace {

using CurveHandle = std::shared_ptr<SISLCurve>;
using SurfaceHandle = std::shared_ptr<SISLSurf>;

CurveHandle own(SISLCurve *curve) { return CurveHandle(curve, [](SISLCurve *c) { if (c) freeCurve(c); }); }

void check(int status, const char *routine) {
    if (status >= 0) return;
    std::fprintf(stderr, "%s fails with status %d\n", routine, status);
    std::exit(1);
}

CurveHandle make_curve() {
    Numbers knots = clamped(DEGREE, SPANS), coeffs = waves(3 * CONTROLS);
    return own(newCurve(CONTROLS, DEGREE + 1, knots.data(), coeffs.data(), 1, 3, 1));
}

// The first index of its coefficients runs fastest.
SurfaceHandle make_surface() {
    Numbers knots = clamped(DEGREE, SURFACE_SPANS), coeffs;
    for (int j = 0; j < SURFACE_CONTROLS; ++j)
        for (int i = 0; i < SURFACE_CONTROLS; ++i)
            for (int axis = 0; axis < 3; ++axis) coeffs.push_back(wave(3 * (i * SURFACE_CONTROLS + j) + axis));
    SISLSurf *surface = newSurf(SURFACE_CONTROLS, SURFACE_CONTROLS, DEGREE + 1, DEGREE + 1, knots.data(), knots.data(),
                                coeffs.data(), 1, 3, 1);
    return SurfaceHandle(surface, freeSurf);
}

std::string spline_json(const CurveHandle &c) {
    Numbers knots(c->et, c->et + c->in + c->ik), coeffs(c->ecoef, c->ecoef + c->in * c->idim);
    return json_spline(c->ik - 1, knots, coeffs, c->idim);
}

// Values with `orders` rows of three numbers each; `at` fills them at one parameter.
template <class At>
Way point_way(std::string question, std::string how, int size, const Numbers &xs, int arguments, int orders, At at) {
    const int count = int(xs.size()) / arguments;
    auto values = std::make_shared<Numbers>(std::size_t(count) * 3 * orders);
    auto run = [=, &xs] {
        int hints[2] = {0, 0};
        for (int i = 0; i < count; ++i) at(&xs[std::size_t(arguments) * i], hints, &(*values)[std::size_t(3) * orders * i]);
        keep(values->front());
    };
    auto answer = [=, &xs] {
        return points_answer(xs, arguments, orders, [=](int k, int i) {
            const double *row = &(*values)[std::size_t(3) * (orders * i + k)];
            return Numbers(row, row + 3);
        });
    };
    return {std::move(question), std::move(how), size, count, run, answer};
}

void curve_points(std::vector<Way> &ways, const CurveHandle &curve, const Numbers &sorted, const Numbers &random) {
    auto at = [curve](int orders) {
        return [curve, orders](const double *x, int *hints, double *row) {
            int status = 0;
            s1227(curve.get(), orders, *x, hints, row, &status);
            check(status, "s1227");
        };
    };
    ways.push_back(point_way("curve point, single, sorted", "s1227", CONTROLS, sorted, 1, 1, at(0)));
    ways.push_back(point_way("curve point, single, random", "s1227", CONTROLS, random, 1, 1, at(0)));
    ways.push_back(
        point_way("curve point and 2 derivatives, single, random", "s1227", CONTROLS, random, 1, 3, at(2)));
    ways.push_back(
        point_way("curve point and 2 derivatives, batch, sorted", "a loop of s1227", CONTROLS, sorted, 1, 3, at(2)));
    for (bool in_order : {true, false}) {
        const Numbers &xs = in_order ? sorted : random;
        std::string question = std::string("curve point, batch, ") + (in_order ? "sorted" : "random");
        auto values = std::make_shared<Numbers>(3 * xs.size());
        auto run = [=, &xs] {
            int status = 0;
            s1542(curve.get(), int(xs.size()), const_cast<double *>(xs.data()), values->data(), &status);
            check(status, "s1542");
        };
        auto answer = [=, &xs] {
            return points_answer(xs, 1, 1, [=](int, int i) { return Numbers(&(*values)[3 * i], &(*values)[3 * i] + 3); });
        };
        ways.push_back({question, "s1542", CONTROLS, COUNT, run, answer});
        ways.push_back(point_way(question, "a loop of s1227", CONTROLS, xs, 1, 1, at(0)));
    }
}

void surface_grid(std::vector<Way> &ways, const SurfaceHandle &surface, const Numbers &us, const Numbers &vs) {
    auto values = std::make_shared<Numbers>(3 * us.size() * vs.size()), normals = std::make_shared<Numbers>(*values);
    auto parameters = std::make_shared<Numbers>();
    for (double v : vs)
        for (double u : us) parameters->insert(parameters->end(), {u, v});
    auto run = [=, &us, &vs] {
        int status = 0;
        s1506(surface.get(), 0, int(us.size()), const_cast<double *>(us.data()), int(vs.size()),
              const_cast<double *>(vs.data()), values->data(), normals->data(), &status);
        check(status, "s1506");
    };
    auto answer = [=] {
        return points_answer(*parameters, 2, 1, [=](int, int i) { return Numbers(&(*values)[3 * i], &(*values)[3 * i] + 3); });
    };
    ways.push_back({"surface grid", "s1506", SURFACE_CONTROLS, GRID_U * GRID_V, run, answer});
}

void surface_points(std::vector<Way> &ways, const SurfaceHandle &surface, const Numbers &pairs) {
    auto at = [surface](int orders) {
        return [surface, orders](const double *uv, int *hints, double *rows) {
            int status = 0;
            double all[12];
            s1424(surface.get(), orders, orders, const_cast<double *>(uv), hints, hints + 1, orders ? all : rows, &status);
            check(status, "s1424");
            if (orders) std::copy(all, all + 9, rows);
        };
    };
    const int size = SURFACE_CONTROLS;
    ways.push_back(point_way("surface point, single, random", "s1424", size, pairs, 2, 1, at(0)));
    ways.push_back(point_way("surface point, batch, random", "a loop of s1424", size, pairs, 2, 1, at(0)));
    ways.push_back(
        point_way("surface point and first derivatives, random", "s1424, with the mixed derivative", size, pairs, 2, 3, at(1)));
}

// An operation from one curve to another: `run(result, status)`.
template <class Run> Way curve_way(std::string question, std::string how, Run run) {
    auto result = std::make_shared<CurveHandle>();
    auto timed = [=] {
        SISLCurve *found = nullptr;
        int status = 0;
        run(&found, &status);
        check(status, how.c_str());
        *result = own(found);
    };
    return {std::move(question), how, CONTROLS, 1, timed, [result] { return "\"spline\":" + spline_json(*result); }};
}

void operations(std::vector<Way> &ways, const CurveHandle &curve) {
    auto knots = std::make_shared<Numbers>(middles());
    auto refine = [=](SISLCurve **result, int *status) { s1018(curve.get(), knots->data(), SPANS, result, status); };
    SISLCurve *refined = nullptr;
    int status = 0;
    refine(&refined, &status);
    check(status, "s1018");
    CurveHandle fine = own(refined);
    ways.push_back(curve_way("refine every span", "s1018", refine));
    ways.push_back(curve_way("elevate by one", "s1750", [=](SISLCurve **result, int *status) {
        s1750(curve.get(), DEGREE + 2, result, status);
    }));
    ways.push_back(curve_way("remove inserted knots", "s1940", [=](SISLCurve **result, int *status) {
        double accuracy[3] = {1e-9, 1e-9, 1e-9}, errors[3];
        s1940(fine.get(), accuracy, 1, 1, 1, 10, result, errors, status);
    }));
    ways.push_back(curve_way("derivative", "s1720", [=](SISLCurve **result, int *status) {
        s1720(curve.get(), 1, result, status);
    }));
}

void pieces(std::vector<Way> &ways, const CurveHandle &curve) {
    auto result = std::make_shared<CurveHandle>();
    auto run = [=] {
        SISLCurve *found = nullptr;
        int status = 0;
        s1730(curve.get(), &found, &status);
        check(status, "s1730");
        *result = own(found);
    };
    // Every piece has its own control points.
    auto answer = [result] {
        const CurveHandle &c = *result;
        std::string text = "\"pieces\":[";
        for (int i = 0; i < c->in / c->ik; ++i) {
            const double *first = c->ecoef + 3 * c->ik * i;
            text += (i ? "," : "") + json_rows(Numbers(first, first + 3 * c->ik), 3);
        }
        return text + "]";
    };
    ways.push_back({"Bezier pieces", "s1730", CONTROLS, 1, run, answer});
}

void interpolation(std::vector<Way> &ways) {
    auto data = std::make_shared<Numbers>(waves(3 * CONTROLS));
    auto parameters = std::make_shared<Numbers>(breaks(CONTROLS - 1));
    auto kinds = std::make_shared<std::vector<int>>(CONTROLS, 1);
    auto result = std::make_shared<CurveHandle>();
    auto run = [=] {
        SISLCurve *found = nullptr;
        double end = 0, *own_parameters = nullptr;
        int count = 0, status = 0;
        s1357(data->data(), CONTROLS, 3, kinds->data(), parameters->data(), 0, 0, 1, DEGREE + 1, 0.0, &end, &found,
              &own_parameters, &count, &status);
        check(status, "s1357");
        std::free(own_parameters);
        *result = own(found);
    };
    auto answer = [=] {
        return "\"interpolant\":{\"parameters\":" + json(*parameters) + ",\"spline\":" + spline_json(*result) + "}";
    };
    ways.push_back({"interpolate 1000 points", "s1357 with given parameters", CONTROLS, 1, run, answer});
}

} // namespace

int main(int argc, char **argv) {
    CurveHandle curve = make_curve();
    SurfaceHandle surface = make_surface();
    Numbers sorted = even(break_at(SPANS), COUNT), random = random_numbers(break_at(SPANS), COUNT);
    double end = break_at(SURFACE_SPANS);
    Numbers pairs = random_numbers(end, 2 * COUNT), us = even(end, GRID_U), vs = even(end, GRID_V);
    std::vector<Way> ways;
    curve_points(ways, curve, sorted, random);
    surface_points(ways, surface, pairs);
    surface_grid(ways, surface, us, vs);
    operations(ways, curve);
    interpolation(ways);
    pieces(ways, curve);
    return report(ways, argc, argv);
}
