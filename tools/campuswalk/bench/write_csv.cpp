#include "tools/campuswalk/bench/write_csv.h"

#include <fstream>
#include <stdexcept>

#include "engine/decimals.h"

namespace campuswalk::tools::bench {

void write_csv(const Results& results, const std::filesystem::path& file) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    std::ofstream out(file, std::ios::binary);
    out << "case,pairs,engine,query,us_min,us_median,nv,np,set_equal\n";
    for (const Measurement& m : results.measurements) {
        out << "table1," << std::to_string(results.pairs[m.placement]) << ','
            << results.engines[m.engine].name << ',' << (m.query == Query::all ? "all" : "first") << ','
            << engine::fixed(m.us_min, 3) << ',' << engine::fixed(m.us_median, 3) << ',';
        if (m.work) {
            out << std::to_string(m.work->nv) << ',' << std::to_string(m.work->np) << ',';
        } else {
            out << ",,";
        }
        out << (m.difference.none() ? "yes" : to_string(m.difference)) << '\n';
    }
    out.close();
    if (!out) {
        throw std::runtime_error("'" + file.string() + "' couldn't be written");
    }
}

}  // namespace campuswalk::tools::bench
