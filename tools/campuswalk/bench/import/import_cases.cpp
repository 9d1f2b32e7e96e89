#include "tools/campuswalk/bench/import/import_cases.h"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/campus_description.h"
#include "scene/model.h"
#include "scene/procedural/walkable_campus.h"
#include "tools/campuswalk/bench/import/write_glb.h"
#include "tools/campuswalk/bench/peer_engines.h"
#include "tools/campuswalk/bench/shuffled_runs.h"
#include "tools/campuswalk/model_importer.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

namespace {

/// A folder that is gone afterwards.
class ScratchFolder {
public:
    ScratchFolder() : path_(fs::temp_directory_path() / ("campuswalk-bench-" + std::to_string(getpid()))) {
        fs::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Who imports, and how many triangles that gives.
struct Reader {
    std::string name;
    std::function<std::size_t()> read;
};

std::size_t import_by_helper(const fs::path& path) {
    scene::SceneFile file;
    file.file = path.filename().string();
    file.path = path;
    return scene::count_triangles(model_importer()(file, scene::EmptyModel::refuse).model);
}

std::vector<Reader> readers_of(const fs::path& file, bool join) {
    std::vector<Reader> readers = {{"helper", [=] { return import_by_helper(file); }}};
    try {
        const auto peer = reinterpret_cast<ImportWithPeer>(find_in_peer("assimp", kImportWithPeer));
        readers.push_back({"assimp", [=] { return std::size_t{peer(file.c_str(), join)}; }});
    } catch (const std::exception& error) {
        std::printf("  absent: assimp: %s\n", error.what());
    }
    return readers;
}

void time_readers(const std::string& query, const fs::path& file, bool join, std::size_t triangles,
                  int rounds, CaseResult& result) {
    const std::vector<Reader> readers = readers_of(file, join);
    const auto spreads = shuffled_runs(readers.size(), rounds, [&](std::size_t i) {
        std::size_t found = 0;
        const double microseconds = microseconds_of([&] { found = readers[i].read(); });
        if (found != triangles) {
            std::printf("  %s gives %zu triangles instead of %zu\n", readers[i].name.c_str(), found,
                        triangles);
            result.ours_right = result.ours_right && i != 0;
        }
        return microseconds;
    });
    std::printf("%s, milliseconds\n%12s%10s%10s\n", query.c_str(), "", "least", "median");
    for (std::size_t i = 0; i < readers.size(); ++i) {
        std::printf("%12s%10.1f%10.1f\n", readers[i].name.c_str(), spreads[i].least / 1000.0,
                    spreads[i].median / 1000.0);
        Row row;
        row.case_name = "import";
        row.engine = readers[i].name;
        row.query = query;
        row.least = spreads[i].least / static_cast<double>(triangles);
        row.median = spreads[i].median / static_cast<double>(triangles);
        result.rows.push_back(row);
    }
}

}  // namespace

CaseResult run_import_cases(int lots, int rounds) {
    const ScratchFolder folder;
    const collision::TriangleMesh mesh = scene::walkable_campus(lots).mesh;
    const std::size_t triangles = mesh.triangles.size();
    std::printf("GLB files of %zu triangles, into a model of ours and into assimp's scene; times of %d.\n",
                triangles, rounds);
    const fs::path with = folder.path() / "with-normals.glb";
    const fs::path without = folder.path() / "without-normals.glb";
    write_glb(with, mesh, smooth_normals(mesh));
    write_glb(without, mesh, {});
    CaseResult result;
    time_readers("glb", with, false, triangles, rounds, result);
    time_readers("glb_without_normals", without, true, triangles, rounds, result);
    return result;
}

}  // namespace campuswalk::tools::bench
