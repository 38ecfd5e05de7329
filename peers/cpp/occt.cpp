// Times of Open CASCADE (modules FoundationClasses and ModelingData) without bindings between.

#include "bench.hpp"

#include <BSplCLib.hxx>
#include <BSplCLib_EvaluatorFunction.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColGeom_Array1OfBezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <memory>
#include <type_traits>

using namespace bench;
using CurveHandle = Handle(Geom_BSplineCurve);
using SurfaceHandle = Handle(Geom_BSplineSurface);

namespace {

TColStd_Array1OfReal array(const Numbers &numbers) {
    TColStd_Array1OfReal result(1, int(numbers.size()));
    for (int i = 0; i < int(numbers.size()); ++i) result(i + 1) = numbers[i];
    return result;
}

TColStd_Array1OfInteger clamped_multiplicities(int spans) {
    TColStd_Array1OfInteger result(1, spans + 1);
    result.Init(1);
    result(1) = result(spans + 1) = DEGREE + 1;
    return result;
}

gp_Pnt control(int k) { return {wave(3 * k), wave(3 * k + 1), wave(3 * k + 2)}; }

TColgp_Array1OfPnt controls(int count) {
    TColgp_Array1OfPnt poles(1, count);
    for (int k = 0; k < count; ++k) poles(k + 1) = control(k);
    return poles;
}

CurveHandle make_curve() {
    return new Geom_BSplineCurve(controls(CONTROLS), array(breaks(SPANS)), clamped_multiplicities(SPANS), DEGREE);
}

SurfaceHandle make_surface() {
    TColgp_Array2OfPnt poles(1, SURFACE_CONTROLS, 1, SURFACE_CONTROLS);
    for (int k = 0; k < SURFACE_CONTROLS * SURFACE_CONTROLS; ++k)
        poles(k / SURFACE_CONTROLS + 1, k % SURFACE_CONTROLS + 1) = control(k);
    TColStd_Array1OfReal knots = array(breaks(SURFACE_SPANS));
    TColStd_Array1OfInteger multiplicities = clamped_multiplicities(SURFACE_SPANS);
    return new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, DEGREE, DEGREE);
}

CurveHandle copy(const CurveHandle &curve) { return CurveHandle::DownCast(curve->Copy()); }

Numbers row(const gp_XYZ &xyz) { return {xyz.X(), xyz.Y(), xyz.Z()}; }

Numbers flat(const TColgp_Array1OfPnt &poles) {
    Numbers result;
    for (int k = poles.Lower(); k <= poles.Upper(); ++k)
        for (int axis = 1; axis <= 3; ++axis) result.push_back(poles(k).Coord(axis));
    return result;
}

std::string answer_curve(const CurveHandle &curve) {
    const TColStd_Array1OfReal &knots = curve->KnotSequence();
    return spline_answer(curve->Degree(), Numbers(knots.begin(), knots.end()), flat(curve->Poles()));
}

struct Jet {
    gp_Pnt point;
    gp_Vec first, second;
};

Numbers derivative(const gp_Pnt &point, int) { return row(point.XYZ()); }
Numbers derivative(const Jet &jet, int k) { return row(k == 0 ? jet.point.XYZ() : k == 1 ? jet.first.XYZ() : jet.second.XYZ()); }

// Where values are asked for: `arguments` numbers a point.
struct Where {
    int size, arguments;
    const Numbers &xs;
};

// `at` fills a value, a gp_Pnt or a Jet, at one parameter.
template <class Value, class At> Way point_way(std::string question, std::string how, Where where, At at) {
    const auto &[size, arguments, xs] = where;
    auto values = std::make_shared<std::vector<Value>>(xs.size() / arguments);
    auto run = [&xs = xs, arguments = arguments, values, at] {
        const double *x = xs.data();
        for (Value &value : *values) {
            at(x, value);
            x += arguments;
        }
        keep(values->front());
    };
    const int orders = std::is_same_v<Value, Jet> ? 3 : 1;
    auto answer = [&xs = xs, arguments = arguments, values] {
        return points_answer(xs, arguments, orders, [values](int k, int i) { return derivative((*values)[i], k); });
    };
    return {std::move(question), std::move(how), size, int(values->size()), run, answer};
}

void curve_points(std::vector<Way> &ways, const CurveHandle &curve, const Numbers &sorted, const Numbers &random) {
    auto adaptor = std::make_shared<GeomAdaptor_Curve>(curve);
    auto direct = [curve](const double *x, gp_Pnt &p) { curve->D0(*x, p); };
    auto cached = [adaptor](const double *x, gp_Pnt &p) { adaptor->D0(*x, p); };
    auto direct2 = [curve](const double *x, Jet &j) { curve->D2(*x, j.point, j.first, j.second); };
    auto cached2 = [adaptor](const double *x, Jet &j) { adaptor->D2(*x, j.point, j.first, j.second); };
    for (bool in_order : {true, false}) {
        std::string order = in_order ? "sorted" : "random";
        Where where{CONTROLS, 1, in_order ? sorted : random};
        ways.push_back(point_way<gp_Pnt>("curve point, single, " + order, "Geom_BSplineCurve::D0", where, direct));
        for (std::string manner : {"single", "batch"})
            ways.push_back(point_way<gp_Pnt>("curve point, " + manner + ", " + order, "GeomAdaptor_Curve::D0", where, cached));
    }
    std::string single = "curve point and 2 derivatives, single, random", batch = "curve point and 2 derivatives, batch, sorted";
    ways.push_back(point_way<Jet>(single, "Geom_BSplineCurve::D2", {CONTROLS, 1, random}, direct2));
    ways.push_back(point_way<Jet>(single, "GeomAdaptor_Curve::D2", {CONTROLS, 1, random}, cached2));
    ways.push_back(point_way<Jet>(batch, "GeomAdaptor_Curve::D2", {CONTROLS, 1, sorted}, cached2));
}

// The cache of the adaptor holds one patch: the grid goes along its 1000 parameters first.
void surface_points(std::vector<Way> &ways, const SurfaceHandle &surface, const Numbers &pairs, const Numbers &grid) {
    auto adaptor = std::make_shared<GeomAdaptor_Surface>(surface);
    auto direct = [surface](const double *uv, gp_Pnt &p) { surface->D0(uv[0], uv[1], p); };
    auto cached = [adaptor](const double *uv, gp_Pnt &p) { adaptor->D0(uv[0], uv[1], p); };
    auto direct1 = [surface](const double *uv, Jet &j) { surface->D1(uv[0], uv[1], j.point, j.first, j.second); };
    auto cached1 = [adaptor](const double *uv, Jet &j) { adaptor->D1(uv[0], uv[1], j.point, j.first, j.second); };
    Where at_pairs{SURFACE_CONTROLS, 2, pairs}, on_grid{SURFACE_CONTROLS, 2, grid};
    for (std::string manner : {"single", "batch"}) {
        std::string question = "surface point, " + manner + ", random";
        ways.push_back(point_way<gp_Pnt>(question, "Geom_BSplineSurface::D0", at_pairs, direct));
        ways.push_back(point_way<gp_Pnt>(question, "GeomAdaptor_Surface::D0", at_pairs, cached));
    }
    std::string tangents = "surface point and first derivatives, random";
    ways.push_back(point_way<gp_Pnt>("surface grid", "GeomAdaptor_Surface::D0", on_grid, cached));
    ways.push_back(point_way<Jet>(tangents, "Geom_BSplineSurface::D1", at_pairs, direct1));
    ways.push_back(point_way<Jet>(tangents, "GeomAdaptor_Surface::D1", at_pairs, cached1));
}

// An operation from one curve to another.
template <class Run> Way curve_way(std::string question, std::string how, Run run) {
    auto result = std::make_shared<CurveHandle>();
    return {std::move(question), std::move(how), CONTROLS, 1, [result, run] { *result = run(); },
            [result] { return answer_curve(*result); }};
}

CurveHandle refined(const CurveHandle &curve, const TColStd_Array1OfReal &knots) {
    TColStd_Array1OfInteger once(1, knots.Length());
    once.Init(1);
    CurveHandle fine = copy(curve);
    fine->InsertKnots(knots, once);
    return fine;
}

// The inserted knots have even indices.
CurveHandle thinned(const CurveHandle &fine) {
    CurveHandle curve = copy(fine);
    for (int index = 2 * SPANS; index > 1; index -= 2) curve->RemoveKnot(index, 0, 1e-9);
    return curve;
}

void operations(std::vector<Way> &ways, const CurveHandle &curve) {
    auto knots = std::make_shared<TColStd_Array1OfReal>(array(middles()));
    CurveHandle fine = refined(curve, *knots);
    ways.push_back(curve_way("refine every span", "Geom_BSplineCurve::InsertKnots on a copy",
                             [curve, knots] { return refined(curve, *knots); }));
    ways.push_back(curve_way("elevate by one", "Geom_BSplineCurve::IncreaseDegree on a copy", [curve] {
        CurveHandle result = copy(curve);
        result->IncreaseDegree(DEGREE + 1);
        return result;
    }));
    ways.push_back(curve_way("remove inserted knots", "Geom_BSplineCurve::RemoveKnot, knot by knot, on a copy",
                             [fine] { return thinned(fine); }));
}

void pieces(std::vector<Way> &ways, const CurveHandle &curve) {
    auto arcs = std::make_shared<TColGeom_Array1OfBezierCurve>(1, SPANS);
    auto run = [curve, arcs] { GeomConvert_BSplineCurveToBezierCurve(curve).Arcs(*arcs); };
    auto answer = [arcs] {
        std::string text = "\"pieces\":[";
        for (int i = 1; i <= SPANS; ++i) text += (i > 1 ? "," : "") + json_rows(flat((*arcs)(i)->Poles()), 3);
        return text + "]";
    };
    ways.push_back({"Bezier pieces", "GeomConvert_BSplineCurveToBezierCurve", CONTROLS, 1, run, answer});
}

void interpolation(std::vector<Way> &ways) {
    auto knots = std::make_shared<TColStd_Array1OfReal>(array(interpolation_knots()));
    auto parameters = std::make_shared<TColStd_Array1OfReal>(array(breaks(CONTROLS - 1)));
    auto contacts = std::make_shared<TColStd_Array1OfInteger>(1, CONTROLS);
    contacts->Init(0);
    auto data = std::make_shared<TColgp_Array1OfPnt>(controls(CONTROLS));
    auto poles = std::make_shared<TColgp_Array1OfPnt>(1, CONTROLS);
    auto run = [=] {
        int problem = 0;
        *poles = *data;
        BSplCLib::Interpolate(DEGREE, *knots, *parameters, *contacts, *poles, problem);
        if (problem) std::abort();
    };
    auto answer = [poles] {
        return "\"interpolant\":{\"parameters\":" + json(breaks(CONTROLS - 1)) +
               ",\"spline\":" + json_spline(DEGREE, interpolation_knots(), flat(*poles), 3) + "}";
    };
    ways.push_back({"interpolate 1000 points", "BSplCLib::Interpolate with given parameters and knots", CONTROLS, 1,
                    run, answer});
}

struct Factor : BSplCLib_EvaluatorFunction {
    int degree;
    TColStd_Array1OfReal knots, coeffs;

    Factor(int p, int spans) : degree(p), knots(array(clamped(p, spans))), coeffs(array(waves(spans + p))) {}

    void Evaluate(const int order, const double *, const double x, double &value, int &status) const override {
        int extrapolation[2] = {degree, degree};
        double &first = const_cast<double &>(coeffs(1));
        BSplCLib::Eval(x, false, order, extrapolation[0], degree, knots, 1, first, value);
        status = 0;
    }
};

void products(std::vector<Way> &ways) {
    for (int degree : {3, 2})
        for (int spans : PRODUCT_SPANS) {
            auto factor = std::make_shared<Factor>(degree, spans);
            auto flat_knots = std::make_shared<Numbers>(clamped(2 * degree, spans, degree + 1));
            auto knots = std::make_shared<TColStd_Array1OfReal>(array(*flat_knots));
            auto product = std::make_shared<TColStd_Array1OfReal>(1, knots->Length() - 2 * degree - 1);
            auto run = [=] {
                int status = 0;
                BSplCLib::FunctionMultiply(*factor, degree, factor->knots, factor->coeffs, *knots, 2 * degree, *product,
                                           status);
                if (status) std::abort();
            };
            auto answer = [=] {
                return spline_answer(2 * degree, *flat_knots, Numbers(product->begin(), product->end()), 1);
            };
            std::string name = "product " + std::to_string(degree) + "x" + std::to_string(degree);
            ways.push_back({name, "BSplCLib::FunctionMultiply, the factor through BSplCLib::Eval", spans, 1, run, answer});
        }
}

} // namespace

int main(int argc, char **argv) {
    CurveHandle curve = make_curve();
    SurfaceHandle surface = make_surface();
    Numbers sorted = even(break_at(SPANS), COUNT), random = random_numbers(break_at(SPANS), COUNT);
    double end = break_at(SURFACE_SPANS);
    Numbers pairs = random_numbers(end, 2 * COUNT), grid;
    for (double v : even(end, GRID_V))
        for (double u : even(end, GRID_U)) grid.insert(grid.end(), {u, v});
    std::vector<Way> ways;
    curve_points(ways, curve, sorted, random);
    surface_points(ways, surface, pairs, grid);
    operations(ways, curve);
    products(ways);
    interpolation(ways);
    pieces(ways, curve);
    return report(ways, argc, argv);
}
