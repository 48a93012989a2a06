// What a solver would do without the library: interpolate the friction force in a table of its own. The cubic one is given as many
// knots as it takes for an accuracy, found by doubling.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using Law = std::function<double(double)>;

// Knots and loads are spaced evenly in the logarithm of load.
inline double load_at(double lightest, double heaviest, double part) {
    return lightest * std::exp(part * std::log(heaviest / lightest));
}

// What a good engineer writes: knots evenly spaced in ln(load), found from log without a search, cubic Hermite
// interpolation of F with the slopes that the library gives.
class EvenCubic {
public:
    using Slope = std::function<double(double)>;

    EvenCubic(const Law &law, const Slope &slope, double lightest, double heaviest, size_t knots)
        : lightest_(std::log(lightest)), per_step_(double(knots - 1) / std::log(heaviest / lightest)), row_(knots - 1) {
        double force[2] = {law(lightest), 0.0}, rate[2] = {lightest * slope(lightest) / per_step_, 0.0};
        for (size_t i = 0; i + 1 < knots; ++i) {
            const double load = load_at(lightest, heaviest, double(i + 1) / double(knots - 1));
            force[1] = law(load);
            rate[1] = load * slope(load) / per_step_;
            const double rise = force[1] - force[0];
            row_[i] = {force[0], rate[0], 3.0 * rise - 2.0 * rate[0] - rate[1], rate[0] + rate[1] - 2.0 * rise};
            force[0] = force[1];
            rate[0] = rate[1];
        }
    }

    double operator()(double load) const { return at(std::log(load)); }

    // Logarithms first, so that a compiler may vectorise what follows.
    void batch(const std::vector<double> &load, std::vector<double> &force) const {
        for (size_t i = 0; i < load.size(); ++i) force[i] = std::log(load[i]);
        for (double &value : force) value = at(value);
    }
    size_t knots() const { return row_.size() + 1; }

private:
    struct Row {
        double c[4];
    };
    double at(double log_load) const {
        const double place = (log_load - lightest_) * per_step_;
        const int i = std::min(std::max(int(place), 0), int(row_.size()) - 1);
        const double t = place - i;
        const double *c = row_[size_t(i)].c;
        return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    }

    double lightest_, per_step_;
    std::vector<Row> row_;
};

// Piecewise linear in load, the interval found by bisection.
class LinearTable {
public:
    LinearTable(const Law &law, double lightest, double heaviest, size_t knots) : load_(knots), force_(knots) {
        for (size_t i = 0; i < knots; ++i) {
            load_[i] = load_at(lightest, heaviest, double(i) / double(knots - 1));
            force_[i] = law(load_[i]);
        }
    }

    double operator()(double load) const {
        const auto right = std::lower_bound(load_.begin() + 1, load_.end() - 1, load);
        const size_t i = size_t(right - load_.begin());
        const double part = (load - load_[i - 1]) / (load_[i] - load_[i - 1]);
        return force_[i - 1] + part * (force_[i] - force_[i - 1]);
    }
    size_t knots() const { return load_.size(); }

private:
    std::vector<double> load_, force_;
};

// Largest relative error, at points that fall between the knots.
template <class Rival>
double error_of(const Rival &rival, const Law &law, double lightest, double heaviest) {
    const size_t points = 5 * rival.knots() + 3;
    double worst = 0.0;
    for (size_t i = 0; i < points; ++i) {
        const double load = load_at(lightest, heaviest, (double(i) + 0.5) / double(points));
        worst = std::max(worst, std::fabs(rival(load) / law(load) - 1.0));
    }
    return worst;
}

// The first of twice as many knots, and twice again, that is accurate enough.
template <class Make>
auto accurate(Make make, const Law &law, double lightest, double heaviest, size_t knots, double tolerance) {
    auto rival = make(knots);
    while (error_of(rival, law, lightest, heaviest) > tolerance) rival = make(knots *= 2);
    return rival;
}
