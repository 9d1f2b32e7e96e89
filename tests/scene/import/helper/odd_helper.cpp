// An import helper that misbehaves as its argument says, for import_process_test.cpp.

#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "scene/import/helper/helper_streams.h"
#include "scene/import/helper/image_process.h"
#include "scene/import/helper/import_protocol.h"
#include "scene/import/helper/sandbox.h"
#include "scene/import/helper/serve_import.h"
#include "scene/import/source/scene_folder.h"

using namespace campuswalk::scene;

namespace {

constexpr int kDone = 77;
constexpr int kLeaked = 50;  // a descriptor that the test leaves open

bool can_open(const std::string& file, int flags) {
    const int descriptor = open(file.c_str(), flags, 0600);
    if (descriptor >= 0) {
        close(descriptor);
    }
    return descriptor >= 0;
}

bool ends_well(pid_t process) {
    int status = 0;
    return process > 0 && waitpid(process, &status, 0) == process && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

/// Any in any of its sets. (The bounding set can't be emptied by a process without CAP_SETPCAP.)
bool has_capabilities() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
    syscall(SYS_capget, &header, sets.data());
    bool any = false;
    for (const __user_cap_data_struct& set : sets) {
        any = any || (set.effective | set.permitted | set.inheritable) != 0;
    }
    for (int capability = 0; any && capability < 64; ++capability) {
        any = any || prctl(PR_CAPBSET_READ, capability, 0, 0, 0) == 1;
    }
    return any;
}

/// Whether a helper that a model has taken over can do this. `folder` is the model's.
bool can_do(std::string_view what, const std::string& folder) {
    if (what == "read-inside") {
        return can_open(folder + "/box.obj", O_RDONLY);
    }
    if (what == "read") {
        return can_open("/etc/passwd", O_RDONLY);
    }
    if (what == "write") {
        return can_open(folder + "/box.obj", O_RDWR);
    }
    if (what == "create") {
        return can_open(folder + "/created", O_WRONLY | O_CREAT);
    }
    if (what == "remove") {
        return unlink((folder + "/box.obj").c_str()) == 0;
    }
    if (what == "connect") {
        return socket(AF_INET, SOCK_STREAM, 0) >= 0 || socket(AF_UNIX, SOCK_STREAM, 0) >= 0;
    }
    if (what == "fork") {
        const pid_t child = fork();
        if (child == 0) {
            _exit(0);
        }
        return ends_well(child);
    }
    if (what == "exec") {
        execl("/bin/sh", "sh", "-c", "exit 77", nullptr);
        return false;
    }
    if (what == "trace") {
        return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0;
    }
    if (what == "signal") {
        return kill(getppid(), 0) == 0;
    }
    if (what == "signal-by-descriptor") {
        return fcntl(STDOUT_FILENO, F_SETOWN, getppid()) == 0;
    }
    if (what == "change-mode") {
        const int descriptor = open((folder + "/box.obj").c_str(), O_RDONLY);
        return fchmod(descriptor, 0700) == 0;
    }
    if (what == "affinity") {
        cpu_set_t processors;
        return sched_getaffinity(0, sizeof processors, &processors) == 0 &&
               sched_setaffinity(getppid(), sizeof processors, &processors) == 0;
    }
    if (what == "read-repository") {
        return can_open(folder + "/.git/config", O_RDONLY);
    }
    if (what == "read-nested-repository") {
        return can_open(folder + "/sub/deep/.git/config", O_RDONLY);
    }
    if (what == "read-nested-secret") {
        return can_open(folder + "/sub/.env", O_RDONLY);
    }
    if (what == "read-beside-secret") {
        return can_open(folder + "/sub/texture.txt", O_RDONLY) &&
               can_open(folder + "/sub/deep/texture.txt", O_RDONLY) &&
               can_open(folder + "/plain/deep/texture.txt", O_RDONLY);
    }
    if (what == "capabilities") {
        return has_capabilities();
    }
    if (what == "other-call") {
        return syscall(SYS_getpriority, PRIO_PROCESS, 0) >= 0;
    }
    if (what == "run-memory") {
        return mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
    }
    if (what == "thread") {
        bool ran = false;
        std::thread([&] { ran = true; }).join();
        return ran;
    }
    if (what == "descriptor") {
        return fcntl(kLeaked, F_GETFD) >= 0;
    }
    return what == "environment" && std::getenv("HELPER_TEST_SECRET") != nullptr;
}

std::vector<std::byte> standard_input() {
    std::vector<std::byte> bytes;
    std::byte byte{};
    while (read(STDIN_FILENO, &byte, 1) == 1) {
        bytes.push_back(byte);
    }
    return bytes;
}

/// Exit code 77 if it can be done in the sandbox that the request asks for, else 0.
[[noreturn]] void attempt(std::string_view what) {
    const ImportRequest request = read_request(standard_input());
    const std::filesystem::path folder = request.file.path.parent_path();
    enter_sandbox(SceneFolder(request.file).readable_paths(), request.sandbox);
    _exit(can_do(what, folder.string()) ? kDone : 0);  // a leak check at the end would start a process
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view behaviour = argc > 1 ? argv[1] : "";
    if (behaviour == "serve") {
        return serve_import();
    }
    if (behaviour == "images") {
        return serve_images();
    }
    if (behaviour == "attempt" && argc > 2) {
        attempt(argv[2]);
    }
    if (behaviour == "crash") {
        std::raise(SIGSEGV);
    }
    if (behaviour == "abort") {
        std::abort();
    }
    if (behaviour == "sleep") {
        sleep(1000);
    }
    if (behaviour == "spin") {
        ImportLimits limits;
        limits.cpu = 1;
        limit_process(limits);
        for (std::atomic<unsigned int> i = 0;; ++i) {
        }
    }
    if (behaviour == "garbage") {
        constexpr std::string_view kGarbage =
            "not a model, but longer than the header of one, so that its contents are looked at";
        return write(STDOUT_FILENO, kGarbage.data(), kGarbage.size()) > 0 ? 0 : 1;
    }
    return behaviour == "nothing" ? 0 : 3;
}
