#include "tools/campuswalk/run/html/compared_run.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tools/campuswalk/base/read_below.h"
#include "tools/campuswalk/run/results/result_file.h"
#include "tools/campuswalk/run/results/run_key.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct ResultIndex {
    struct Place {
        std::size_t file = 0;
        std::uintmax_t offset = 0;
    };
    std::vector<ResultFile> files;
    std::unordered_map<std::string, Place> places;  ///< by id
};

}  // namespace

engine::ComparedRun open_compared_run(const fs::path& input, const fs::path& output) {
    const auto index = std::make_shared<ResultIndex>();
    index->files = open_result_files({input}, shared_run_key(environment_variable));
    for (std::size_t i = 0; i < index->files.size(); ++i) {
        index->files[i].for_each_located([&](std::uintmax_t offset, const engine::WalkResult& result) {
            index->places.try_emplace(result.id, ResultIndex::Place{i, offset});
        });
    }
    engine::ComparedRun run;
    run.name = title_of_inputs({input});
    run.find = [index](const std::string& id) -> std::optional<engine::WalkResult> {
        const auto found = index->places.find(id);
        return found == index->places.end()
                   ? std::nullopt
                   : std::optional(index->files[found->second.file].read_at(found->second.offset));
    };
    run.for_each = [index](const std::function<void(const engine::WalkResult&)>& visit) {
        for (const ResultFile& file : index->files) {
            file.for_each([&](engine::WalkResult&& result) { visit(result); });
        }
    };
    run.read_artifact = [output](const std::string& path) { return read_below(output, path); };
    return run;
}

}  // namespace campuswalk::tools
