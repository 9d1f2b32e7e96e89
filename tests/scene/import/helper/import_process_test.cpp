#include "scene/import/helper/import_process.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "scene/base/binary_archive.h"
#include "scene/base/checksum.h"
#include "tests/scene/model_files.h"
#include "tests/support/effort.h"

namespace campuswalk::scene {
namespace {

class ImportProcess : public testing::Test {
protected:
    void SetUp() override { folder_.write("box.obj", test::obj_box("box", {0, 0, 0}, {1, 2, 3})); }

    ImportedModel import(const char* behaviour, const std::string& name = "box.obj",
                         const ImportLimits& limits = {}) {
        return import_in_process({ODD_IMPORT_HELPER, {behaviour}}, limits)(test::scene_file(folder_, name),
                                                                           EmptyModel::refuse);
    }
    std::string refusal(const char* behaviour, const std::string& name = "box.obj",
                        const ImportLimits& limits = {}) {
        const auto errors = test::errors_of([&] { import(behaviour, name, limits); });
        EXPECT_EQ(errors.size(), 1U);
        EXPECT_TRUE(test::has_code(errors, "bad-model"));
        return test::text_of(errors);
    }

    test::TemporaryFolder folder_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(ImportProcess, AgreesWithAnImportInThisProcess) {
    folder_.write("lines.obj", "mtllib gone.mtl\n" + test::obj_box("box", {0, 0, 0}, {1, 2, 3}) + "l 1 2\n");
    const ImportedModel here = import_model(test::scene_file(folder_, "lines.obj"));
    ASSERT_EQ(here.warnings.size(), 2U);
    EXPECT_EQ(write_model_file(import("serve", "lines.obj")), write_model_file(here));
}

TEST_F(ImportProcess, ThrowsTheErrorsOfTheHelper) {
    const auto errors_of = [&](const Importer& importer, const std::string& name) {
        return test::text_of(
            test::errors_of([&] { importer(test::scene_file(folder_, name), EmptyModel::refuse); }));
    };
    folder_.write("nan.obj", "o a\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 inf 0\nf 2 3 4\n");
    const Importer in_helper = import_in_process({ODD_IMPORT_HELPER, {"serve"}});
    for (const char* name : {"nan.obj", "gone.glb", "box.ifc"}) {
        EXPECT_EQ(errors_of(in_helper, name), errors_of(import_model, name));
        EXPECT_NE(errors_of(in_helper, name), "");
    }
}

TEST_F(ImportProcess, ReportsACrash) {
    // A sanitizer catches this one and exits.
    EXPECT_TRUE(contains(refusal("crash"), support::kSanitized ? "exit code 1" : "crashed (signal 11)"));
    EXPECT_TRUE(contains(refusal("abort"), "crashed (signal 6)"));
    EXPECT_TRUE(contains(refusal("fail"), "exit code 3"));
}

TEST_F(ImportProcess, RejectsAnInvalidResponse) {
    EXPECT_TRUE(contains(refusal("garbage"), "another kind of file"));
    EXPECT_TRUE(contains(refusal("nothing"), "truncated"));
}

TEST_F(ImportProcess, KillsAHelperThatExceedsItsTime) {
    const auto start = std::chrono::steady_clock::now();
    ImportLimits limits;
    limits.cpu = 1;
    limits.waiting = 0;
    EXPECT_TRUE(contains(refusal("sleep", "box.obj", limits), "after 1 s"));
    limits.waiting = 60;
    EXPECT_TRUE(contains(refusal("spin", "box.obj", limits), "1 s of CPU"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(50));
}

TEST_F(ImportProcess, LimitsTheSizeOfTheResponse) {
    ImportLimits limits;
    limits.response = 100;
    EXPECT_TRUE(contains(refusal("serve", "box.obj", limits), "0 MB"));
}

TEST_F(ImportProcess, LimitsTheMemory) {
    if (support::kSanitized) {
        GTEST_SKIP() << "memory can't be limited under the address sanitizer";
    }
    folder_.write("zeros.gltf",
                  R"({"asset":{"version":"2.0"},"accessors":[{"count":9999999,"type":"VEC3",)"
                  R"("componentType":5126}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})");
    ImportLimits limits;
    limits.memory = std::uint64_t{150} << 20U;
    EXPECT_TRUE(contains(refusal("serve", "zeros.gltf", limits), "memory"));
}

/// What a helper can do that a model has taken over, from odd_helper.cpp.
class Sandbox : public ImportProcess {
protected:
    bool can(const char* what, SandboxMode mode) {
        const Importer importer = import_in_process({ODD_IMPORT_HELPER, {"attempt", what}}, {}, mode);
        const std::string text = test::text_of(
            test::errors_of([&] { importer(test::scene_file(folder_, "box.obj"), EmptyModel::refuse); }));
        EXPECT_TRUE(contains(text, "exit code 77") || contains(text, "truncated")) << what << ": " << text;
        folder_.write("box.obj", test::obj_box("box", {0, 0, 0}, {1, 2, 3}));
        return contains(text, "exit code 77");
    }
    static bool kernel_has(const char* feature) {
        const std::vector<std::string> missing = missing_sandbox_features();
        return std::ranges::find(missing, feature) == missing.end();
    }
};

TEST_F(Sandbox, LeavesReadingAndComputing) {
    if (!kernel_has("seccomp")) {
        GTEST_SKIP() << "this kernel has no seccomp";
    }
    for (const char* what : {"read-inside", "thread"}) {
        EXPECT_TRUE(can(what, SandboxMode::automatic)) << what;
    }
}

TEST_F(Sandbox, ForbidsFilesOutsideTheModelsFolders) {
    if (!kernel_has("Landlock")) {
        GTEST_SKIP() << "this kernel has no Landlock";
    }
    folder_.write(".git/config", "token");
    for (const char* what : {"read", "read-repository"}) {
        EXPECT_TRUE(can(what, SandboxMode::off)) << what;
        EXPECT_FALSE(can(what, SandboxMode::automatic)) << what;
    }
}

/// Also where there is something hidden far below, other files can be read.
TEST_F(Sandbox, HidesHiddenFilesAtAnyDepth) {
    if (!kernel_has("Landlock")) {
        GTEST_SKIP() << "this kernel has no Landlock";
    }
    folder_.write("sub/deep/.git/config", "token");
    folder_.write("sub/.env", "password");
    folder_.write("sub/texture.txt", "");
    folder_.write("sub/deep/texture.txt", "");
    folder_.write("plain/deep/texture.txt", "");
    for (const char* what : {"read-nested-repository", "read-nested-secret"}) {
        EXPECT_TRUE(can(what, SandboxMode::off)) << what;
        EXPECT_FALSE(can(what, SandboxMode::automatic)) << what;
    }
    EXPECT_TRUE(can("read-beside-secret", SandboxMode::automatic));
}

TEST_F(Sandbox, HasNoCapabilities) {
    if (geteuid() == 0) {
        EXPECT_TRUE(can("capabilities", SandboxMode::off));
    }
    EXPECT_FALSE(can("capabilities", SandboxMode::automatic));
}

/// What a checkout may contain beside a model to get more than its folders.
TEST_F(Sandbox, ForbidsFilesOutsideWhateverIsBesideTheModel) {
    if (!kernel_has("Landlock")) {
        GTEST_SKIP() << "this kernel has no Landlock";
    }
    folder_.write("models/box.obj", test::obj_box("box", {0, 0, 0}, {1, 2, 3}));
    const auto can_read = [&] {
        const Importer importer = import_in_process({ODD_IMPORT_HELPER, {"attempt", "read"}});
        return contains(test::text_of(test::errors_of([&] {
                            importer(test::scene_file(folder_, "models/box.obj"), EmptyModel::refuse);
                        })),
                        "exit code 77");
    };
    folder_.write("textures", "a file, not a folder");
    EXPECT_FALSE(can_read());
    std::filesystem::remove(folder_.path() / "textures");
    std::filesystem::create_directory_symlink("/", folder_.path() / "textures");
    std::filesystem::create_directory_symlink("/", folder_.path() / "models" / "maps");
    EXPECT_FALSE(can_read());
}

TEST_F(Sandbox, ForbidsWritesConnectionsAndProcesses) {
    if (!kernel_has("seccomp")) {
        GTEST_SKIP() << "this kernel has no seccomp";
    }
    for (const char* what : {"write", "create", "remove", "change-mode", "connect", "fork", "exec", "trace",
                             "signal", "signal-by-descriptor", "affinity", "other-call", "run-memory"}) {
        EXPECT_TRUE(can(what, SandboxMode::off)) << what;
        EXPECT_FALSE(can(what, SandboxMode::automatic)) << what;
    }
}

TEST_F(Sandbox, HasNoSecretsOfOurs) {
    constexpr int kLeaked = 50;
    ASSERT_EQ(dup2(STDERR_FILENO, kLeaked), kLeaked);
    ASSERT_EQ(setenv("HELPER_TEST_SECRET", "secret", 1), 0);
    for (const SandboxMode mode : {SandboxMode::off, SandboxMode::automatic}) {
        EXPECT_FALSE(can("descriptor", mode));
        EXPECT_FALSE(can("environment", mode));
    }
    unsetenv("HELPER_TEST_SECRET");
    close(kLeaked);
}

TEST_F(Sandbox, CanBeRequired) {
    const Importer importer = import_in_process({ODD_IMPORT_HELPER, {"serve"}}, {}, SandboxMode::require);
    const auto import = [&] { return importer(test::scene_file(folder_, "box.obj"), EmptyModel::refuse); };
    if (missing_sandbox_features().empty()) {
        EXPECT_EQ(import().model.meshes.size(), 1U);
    } else {
        EXPECT_EQ(test::errors_of(import).size(), 1U);
    }
}

TEST_F(ImportProcess, ThrowsIfTheHelperCannotBeStarted) {
    const Importer importer = import_in_process({folder_.path() / "nobody", {}});
    EXPECT_THROW(importer(test::scene_file(folder_, "box.obj"), EmptyModel::refuse), std::runtime_error);
}

TEST(ImportRequest, RoundTrips) {
    ImportRequest request;
    request.file = {{"a.campus.yaml", 3, 7}, "a.glb", "models/a.glb", UpAxis::z, 0.01, 2.0, {1, 2, 3}};
    request.if_empty = EmptyModel::accept;
    request.limits.waiting = 7;
    const ImportRequest back = read_request(write_request(request));
    EXPECT_EQ(back.file.mark.file, "a.campus.yaml");
    EXPECT_EQ(back.file.mark.line, 3);
    EXPECT_EQ(back.file.path, "models/a.glb");
    EXPECT_EQ(back.file.up, UpAxis::z);
    EXPECT_EQ(back.file.position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(back.if_empty, EmptyModel::accept);
    EXPECT_EQ(back.limits.waiting, 7U);
}

/// Corrects the checksum, as a forger would.
void fix_header(std::vector<std::byte>& bytes) {
    constexpr std::size_t kChecksumAt = 24;
    const std::uint64_t checksum =
        checksum_of(std::span<const std::byte>(bytes).subspan(kArchiveHeaderBytes));
    std::memcpy(bytes.data() + kChecksumAt, &checksum, sizeof checksum);
}

/// Calls with each byte of the payload changed in nine ways, with and without a valid checksum, and with each
/// truncation.
template <typename Call>
void with_forgeries(const std::vector<std::byte>& whole, const Call& call) {
    for (std::size_t at = kArchiveHeaderBytes; at < whole.size(); ++at) {
        for (const int value : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xFF}) {
            std::vector<std::byte> bytes = whole;
            bytes[at] ^= static_cast<std::byte>(value);
            call(std::span<const std::byte>(bytes));  // with a wrong checksum
            fix_header(bytes);
            call(std::span<const std::byte>(bytes));
        }
        call(std::span(whole).first(at));
    }
}

TEST(ImportRequest, IsRejectedOrValidWhenForged) {
    ImportRequest request;
    request.file = {{"a.campus.yaml", 3, 7}, "a.glb", "models/a.glb", UpAxis::z, 0.01, 2.0, {1, 2, 3}};
    int refused = 0;
    int read = 0;
    with_forgeries(write_request(request), [&](std::span<const std::byte> bytes) {
        try {
            const ImportRequest back = read_request(bytes);
            EXPECT_LE(static_cast<int>(back.file.up), 1);
            EXPECT_LE(static_cast<int>(back.if_empty), 1);
            ++read;
        } catch (const DamagedFile&) {
            ++refused;
        }
    });
    EXPECT_GT(refused, 1500);
    EXPECT_GT(read, 100);
}

TEST(ImportResponse, IsRejectedOrValidWhenForged) {
    ImportedModel response;
    response.model.nodes.resize(2);
    response.warnings = {{Severity::warning, {"a.glb", 0, 0}, "mirrored-node", "a warning"}};
    int refused = 0;
    int thrown = 0;
    with_forgeries(write_model_file(response), [&](std::span<const std::byte> bytes) {
        try {
            read_response(bytes);
        } catch (const DamagedFile&) {
            ++refused;
        } catch (const InputError& error) {  // a warning changed to an error
            ++thrown;
            EXPECT_EQ(error.diagnostics().size(), 1U);
        }
    });
    EXPECT_GT(refused, 1500);
    EXPECT_GT(thrown, 0);
}

}  // namespace
}  // namespace campuswalk::scene
