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
        Row row;
        row.case_name = results.case_name;
        row.pairs = results.pairs[m.placement];
        row.engine = results.engines[m.engine].name;
        row.query = m.query == Query::all ? "all" : "first";
        row.least = m.us_min;
        row.median = m.us_median;
        row.work = m.work;
        row.difference = m.difference;
        rows.push_back(row);
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
