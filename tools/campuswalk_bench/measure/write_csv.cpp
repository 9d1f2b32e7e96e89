#include "tools/campuswalk_bench/measure/write_csv.h"

#include <fstream>
#include <stdexcept>

#include "engine/events/decimals.h"

namespace campuswalk::tools::bench {

namespace {

std::string line(const Row& row) {
    std::string text = row.case_name + ',' + (row.pairs ? std::to_string(*row.pairs) : "") + ',' +
                       row.engine + ',' + row.query + ',' + engine::fixed(row.least, 3) + ',' +
                       engine::fixed(row.median, 3) + ',';
    if (row.work) {
        text +=
            std::to_string(row.work->volume_tests) + ',' + std::to_string(row.work->primitive_tests) + ',';
    } else {
        text += ",,";
    }
    if (row.difference) {
        text += row.difference->none() ? "yes" : to_string(*row.difference);
    }
    return text + '\n';
}

}  // namespace

void write_csv(const std::vector<Row>& rows, const std::filesystem::path& file) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    std::ofstream out(file, std::ios::binary);
    out << "case,pairs,engine,query,us_min,us_median,nv,np,set_equal\n";
    for (const Row& row : rows) {
        out << line(row);
    }
    out.close();
    if (!out) {
        throw std::runtime_error("'" + file.string() + "' couldn't be written");
    }
}

}  // namespace campuswalk::tools::bench
