#include "tools/campuswalk_bench/measure/measurement.h"

#include <cmath>

namespace campuswalk::tools::bench {

const Measurement* Results::find(std::size_t placement, const std::string& engine, Query query) const {
    for (const Measurement& m : measurements) {
        if (m.placement == placement && m.query == query && engines[m.engine].name == engine) {
            return &m;
        }
    }
    return nullptr;
}

std::vector<double> Results::least_times(const std::string& engine, Query query) const {
    std::vector<double> times;
    for (std::size_t placement = 0; placement < pairs.size(); ++placement) {
        if (const Measurement* m = find(placement, engine, query)) {
            times.push_back(m->us_min);
        }
    }
    return times;
}

std::vector<Row> rows_of(const Results& results) {
    std::vector<Row> rows;
    for (const Measurement& m : results.measurements) {
        rows.push_back({results.case_name, results.pairs[m.placement], results.engines[m.engine].name,
                        m.query == Query::all ? "all" : "first", m.us_min, m.us_median, m.work,
                        m.difference});
    }
    return rows;
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += std::log(value);
    }
    return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace campuswalk::tools::bench
