// Timing by interleaved repetitions. In a repetition the contestants run in turn for several short rounds, and each
// keeps its fastest round, the one that nothing else on the machine disturbed. A machine that slows down for a while
// slows all of them, so that the ratio of two times of the same repetition means more than either time.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

inline double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

struct Contestant {
    std::string name;
    double calls;  // per pass
    std::function<void()> pass;
};

struct Spread {
    double median, least, most;
};

inline Spread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values.front(), values.back()};
}

struct Schedule {
    int repetitions, rounds;
    double round_seconds;  // of one contestant; at least one pass
};

class Interleaved {
public:
    Interleaved(std::vector<Contestant> contestants, const Schedule &schedule)
        : contestants_(std::move(contestants)), seconds_(contestants_.size()) {
        std::vector<int> passes;
        for (const Contestant &contestant : contestants_)
            passes.push_back(passes_within(contestant, schedule.round_seconds));
        for (int repetition = 0; repetition < schedule.repetitions; ++repetition) {
            std::vector<double> fastest(contestants_.size(), HUGE_VAL);
            for (int round = 0; round < schedule.rounds; ++round)
                for (size_t c = 0; c < contestants_.size(); ++c)
                    fastest[c] = std::min(fastest[c], seconds_per_call(contestants_[c], passes[c]));
            for (size_t c = 0; c < contestants_.size(); ++c) seconds_[c].push_back(fastest[c]);
        }
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const Contestant &contestant : contestants_) names.push_back(contestant.name);
        return names;
    }

    // Seconds per call.
    Spread seconds(const std::string &name) const { return spread_of(seconds_[index(name)]); }

    // Time per call over that of another contestant, each repetition by itself.
    Spread ratio(const std::string &name, const std::string &other) const {
        const std::vector<double> &a = seconds_[index(name)], &b = seconds_[index(other)];
        std::vector<double> ratios(a.size());
        std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), [](double x, double y) { return x / y; });
        return spread_of(ratios);
    }

private:
    static double seconds_per_call(const Contestant &contestant, int passes) {
        const double start = now();
        for (int i = 0; i < passes; ++i) contestant.pass();
        return (now() - start) / (passes * contestant.calls);
    }

    // Also the warm-up.
    static int passes_within(const Contestant &contestant, double round_seconds) {
        contestant.pass();
        const double start = now();
        int passes = 0;
        while (now() - start < round_seconds) {
            contestant.pass();
            ++passes;
        }
        return std::max(passes, 1);
    }

    size_t index(const std::string &name) const {
        for (size_t c = 0; c < contestants_.size(); ++c)
            if (contestants_[c].name == name) return c;
        throw std::out_of_range("no contestant " + name);
    }

    std::vector<Contestant> contestants_;
    std::vector<std::vector<double>> seconds_;
};
