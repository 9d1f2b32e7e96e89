#include "tools/campuswalk_bench/measure/write_csv.h"

#include "engine/events/decimals.h"
#include "scene/base/atomic_file.h"

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
    std::string text = "case,pairs,engine,query,us_min,us_median,nv,np,set_equal\n";
    for (const Row& row : rows) {
        text += line(row);
    }
    scene::write_file_atomically(file, text);
}

}  // namespace campuswalk::tools::bench
