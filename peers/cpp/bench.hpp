// What the C++ peers share: the inputs of the Rust benches, rounds that alternate, and answers as lines of JSON.
//
// Usage of the programs: PROGRAM [rounds of one way at most] [seconds for one way]

#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using Numbers = std::vector<double>;

constexpr int DEGREE = 3, SPANS = 997, CONTROLS = SPANS + DEGREE, COUNT = 100000;
constexpr int SURFACE_SPANS = 47, SURFACE_CONTROLS = SURFACE_SPANS + DEGREE, GRID_U = 1000, GRID_V = 100;
constexpr int SAMPLES = 20;
const std::vector<int> PRODUCT_SPANS = {100, 1000, 10000};

inline double break_at(int i) { return i + 0.3 * std::sin(double(i)); }
inline double wave(int i) { return std::cos(0.7 * i); }

// Inner knots `multiplicity` times, ends `degree + 1` times.
inline Numbers clamped(int degree, int spans, int multiplicity = 1) {
    Numbers knots(degree + 1, break_at(0));
    for (int i = 1; i < spans; ++i) knots.insert(knots.end(), multiplicity, break_at(i));
    knots.insert(knots.end(), degree + 1, break_at(spans));
    return knots;
}

inline Numbers breaks(int spans) {
    Numbers all;
    for (int i = 0; i <= spans; ++i) all.push_back(break_at(i));
    return all;
}

inline Numbers middles(int spans = SPANS) {
    Numbers all;
    for (int i = 0; i < spans; ++i) all.push_back((break_at(i) + break_at(i + 1)) / 2);
    return all;
}

inline Numbers waves(int count) {
    Numbers all;
    for (int i = 0; i < count; ++i) all.push_back(wave(i));
    return all;
}

inline Numbers even(double end, int count) {
    Numbers all;
    for (int i = 0; i < count; ++i) all.push_back(end * i / (count - 1));
    return all;
}

inline Numbers random_numbers(double end, int count) {
    Numbers all;
    std::uint64_t state = 1;
    for (int i = 0; i < count; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        all.push_back(end * (double(state >> 11) / double(std::uint64_t(1) << 53)));
    }
    return all;
}

inline Numbers interpolation_knots() {
    Numbers knots(DEGREE + 1, break_at(0));
    for (int i = 1; i < CONTROLS - DEGREE; ++i)
        knots.push_back((break_at(i) + break_at(i + 1) + break_at(i + 2)) / 3);
    knots.insert(knots.end(), DEGREE + 1, break_at(CONTROLS - 1));
    return knots;
}

// The optimiser has to assume that the value is looked at.
template <class T> inline void keep(const T &value) { asm volatile("" : : "g"(&value) : "memory"); }

inline std::string json(const double *numbers, std::size_t count) {
    std::string text = "[";
    char digits[40];
    for (std::size_t i = 0; i < count; ++i) {
        std::snprintf(digits, sizeof digits, "%s%.17g", i ? "," : "", numbers[i]);
        text += digits;
    }
    return text + "]";
}

inline std::string json(const Numbers &numbers) { return json(numbers.data(), numbers.size()); }

// Rows of `dimension` numbers.
inline std::string json_rows(const Numbers &numbers, int dimension) {
    std::string text = "[";
    for (std::size_t i = 0; i < numbers.size(); i += dimension)
        text += (i ? "," : "") + json(&numbers[i], dimension);
    return text + "]";
}

inline std::string json_spline(int degree, const Numbers &knots, const Numbers &coeffs, int dimension) {
    return "{\"degree\":" + std::to_string(degree) + ",\"knots\":" + json(knots) + ",\"coeffs\":" +
           json_rows(coeffs, dimension) + "}";
}

inline std::string spline_answer(int degree, const Numbers &knots, const Numbers &coeffs, int dimension = 3) {
    return "\"spline\":" + json_spline(degree, knots, coeffs, dimension);
}

// `rows(k, i)` is derivative k at sample i.
inline std::string points_answer(const Numbers &parameters, int arguments, int orders,
                                 const std::function<Numbers(int, int)> &rows) {
    int count = int(parameters.size()) / arguments;
    Numbers chosen;
    std::vector<Numbers> values(orders);
    for (int s = 0; s < SAMPLES; ++s) {
        int i = int(std::int64_t(s) * (count - 1) / (SAMPLES - 1));
        chosen.insert(chosen.end(), &parameters[std::size_t(arguments) * i], &parameters[std::size_t(arguments) * i] + arguments);
        for (int k = 0; k < orders; ++k) {
            Numbers row = rows(k, i);
            values[k].insert(values[k].end(), row.begin(), row.end());
        }
    }
    std::string text = "\"points\":{\"parameters\":" +
                       (arguments == 1 ? json(chosen) : json_rows(chosen, arguments)) + ",\"values\":[";
    for (int k = 0; k < orders; ++k) text += (k ? "," : "") + json_rows(values[k], 3);
    return text + "]}";
}

struct Way {
    std::string question, how;
    int size, count;
    std::function<void()> run;
    // Called once, after a run.
    std::function<std::string()> answer;
};

inline double seconds(const std::function<void()> &run) {
    auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Times all ways round by round and prints a line of JSON for each.
inline int report(const std::vector<Way> &ways, int argc, char **argv) {
    int rounds = argc > 1 ? std::atoi(argv[1]) : 200;
    double budget = argc > 2 ? std::atof(argv[2]) : 1.0;
    std::vector<double> best, spent;
    std::vector<std::string> answers;
    for (const Way &way : ways) {
        best.push_back(seconds(way.run));
        spent.push_back(best.back());
        answers.push_back(way.answer());
    }
    for (int round = 1; round < rounds; ++round) {
        for (std::size_t w = 0; w < ways.size(); ++w) {
            if (spent[w] + best[w] > budget && round >= 3) continue;
            double time = seconds(ways[w].run);
            best[w] = std::min(best[w], time);
            spent[w] += time;
        }
    }
    for (std::size_t w = 0; w < ways.size(); ++w)
        std::printf("{\"question\":\"%s\",\"size\":%d,\"how\":\"%s\",\"count\":%d,\"seconds\":%.17g,%s}\n",
                    ways[w].question.c_str(), ways[w].size, ways[w].how.c_str(), ways[w].count, best[w],
                    answers[w].c_str());
    return 0;
}

} // namespace bench
