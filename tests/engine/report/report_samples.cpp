// Writes every reporter's reports on some runs: report_samples FOLDER. Libraries of other languages read them
// in tests/tools/reports_test.py.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/engine/report/some_results.h"

int main(int argc, char** argv) {
    using namespace campuswalk::engine;
    if (argc != 2) {
        std::fprintf(stderr, "usage: report_samples FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const std::map<std::string, RunReport> runs = {
        {"empty", {}}, {"full", {{full_result()}}}, {"hostile", hostile_report()}, {"mixed", mixed_report()}};
    for (const auto& [name, report] : runs) {
        for (const std::string& reporter : reporters_of_results()) {
            std::filesystem::path file = folder / name;
            file += "." + reporter;
            std::ofstream(file, std::ios::binary) << written(reporter, report);
        }
    }
    return 0;
}
