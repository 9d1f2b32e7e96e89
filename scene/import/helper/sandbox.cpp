#include "scene/import/helper/sandbox.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "scene/process/pipe.h"

namespace campuswalk::scene {

namespace {

/// The version of Landlock's interface; 0 if the kernel has none, or doesn't let us use it.
int landlock_version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, std::size_t{0}, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? static_cast<int>(version) : 0;
}

bool has_seccomp() {
    // Without it, EINVAL; with it, EFAULT because of the null pointer.
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) != 0 && errno == EFAULT;
}

/// As in the kernel's interface; this version of its header may lack the later fields.
struct Restricted {
    std::uint64_t file_access = 0;
    std::uint64_t network_access = 0;  ///< since version 4
    std::uint64_t scopes = 0;          ///< since version 6: abstract sockets, signals
};

/// Everything that this version can restrict.
Restricted restricted_by(int version) {
    const unsigned kinds = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    constexpr std::uint64_t kBoth = 3;
    return {(std::uint64_t{1} << kinds) - 1, version >= 4 ? kBoth : 0, version >= 6 ? kBoth : 0};
}

std::size_t size_for(int version) {
    return version >= 6   ? sizeof(Restricted)
           : version >= 4 ? 2 * sizeof(std::uint64_t)
                          : sizeof(std::uint64_t);
}

/// Lets a file be read, or all files below a folder. A symbolic link lets nothing be read: what it leads to
/// has a rule of its own, or none.
void allow_reading(const Descriptor& rules, const std::filesystem::path& path) {
    const Descriptor root(open(path.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW));
    struct stat status {};
    if (!root.open() || fstat(root.number(), &status) != 0 || S_ISLNK(status.st_mode)) {
        return;
    }
    landlock_path_beneath_attr rule{};
    rule.allowed_access =
        LANDLOCK_ACCESS_FS_READ_FILE | (S_ISDIR(status.st_mode) ? LANDLOCK_ACCESS_FS_READ_DIR : 0U);
    rule.parent_fd = root.number();
    syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, std::uint32_t{0});
}

bool restrict_files(const std::vector<std::filesystem::path>& readable) {
    const int version = landlock_version();
    const Restricted restricted = restricted_by(version);
    const Descriptor rules(static_cast<int>(
        syscall(SYS_landlock_create_ruleset, &restricted, size_for(version), std::uint32_t{0})));
    if (!rules.open()) {
        return false;
    }
    for (const std::filesystem::path& path : readable) {
        allow_reading(rules, path);
    }
    return syscall(SYS_landlock_restrict_self, rules.number(), std::uint32_t{0}) == 0;
}

struct ReleaseFilter {
    void operator()(void* filter) const { seccomp_release(filter); }
};

scmp_arg_cmp is(unsigned argument, std::uint64_t value) {
    return {argument, SCMP_CMP_EQ, value, 0};
}

scmp_arg_cmp has_bits(unsigned argument, std::uint64_t mask, std::uint64_t bits) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, bits};
}

/// The system calls that are left. All others fail with ENOSYS, as on a kernel that lacks them: then the C
/// library does without newer ones, such as clone3, whose flags are in memory, which no filter sees.
class Filter {
public:
    Filter() : filter_(seccomp_init(SCMP_ACT_ERRNO(ENOSYS))), complete_(filter_ != nullptr) {}

    /// Calls by their names, with spaces between.
    void allow(const char* names) {
        std::istringstream words(names);
        for (std::string name; words >> name;) {
            allow_if(name, {});
        }
    }
    /// Leaves out what this kind of processor doesn't have, such as `open` next to `openat`.
    void allow_if(const std::string& name, const std::vector<scmp_arg_cmp>& conditions) {
        const int number = seccomp_syscall_resolve_name(name.c_str());
        if (number >= 0) {
            const int failure =
                seccomp_rule_add_array(filter_.get(), SCMP_ACT_ALLOW, number,
                                       static_cast<unsigned>(conditions.size()), conditions.data());
            complete_ = complete_ && failure == 0;
        }
    }

    bool apply() const { return complete_ && seccomp_load(filter_.get()) == 0; }

private:
    std::unique_ptr<void, ReleaseFilter> filter_;
    bool complete_;
};

void allow_reading_files(Filter& filter) {
    constexpr std::uint64_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC;
    filter.allow_if("open", {has_bits(1, kWriting, O_RDONLY)});
    filter.allow_if("openat", {has_bits(2, kWriting, O_RDONLY)});
    filter.allow(
        "read readv pread64 lseek close fadvise64 stat fstat lstat newfstatat statx access faccessat "
        "faccessat2 readlink readlinkat getdents64 getcwd");
    for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD_CLOEXEC}) {
        filter.allow_if("fcntl", {is(1, static_cast<std::uint64_t>(command))});
    }
    filter.allow("write writev");  // what is open for writing is the answer, and standard error
    // A pipe of its own lets this process reach nobody else; UBSan tries through one whether memory can be
    // read.
    filter.allow("pipe pipe2");
}

void allow_computing(Filter& filter) {
    filter.allow("brk munmap mremap madvise");
    for (const char* name : {"mmap", "mprotect"}) {
        filter.allow_if(name, {has_bits(2, PROT_EXEC, 0)});
    }
    filter.allow_if("clone", {has_bits(0, CLONE_THREAD, CLONE_THREAD)});
    filter.allow("futex set_robust_list rseq sched_yield sched_getaffinity exit exit_group");
    filter.allow_if("prctl", {is(0, PR_SET_NAME)});  // of a thread
    filter.allow("rt_sigaction rt_sigprocmask rt_sigreturn sigaltstack restart_syscall");
    const auto self = static_cast<std::uint64_t>(getpid());
    for (const char* name : {"kill", "tgkill"}) {  // abort() signals itself
        filter.allow_if(name, {is(0, self)});
    }
    filter.allow("getpid gettid getuid geteuid getgid getegid uname getrandom getrusage");
    filter.allow_if("prlimit64", {is(0, 0), is(2, 0)});  // asks for limits, and sets none
    filter.allow(
        "clock_gettime clock_getres clock_nanosleep nanosleep gettimeofday time poll ppoll "
        "getrlimit");
}

bool restrict_calls() {
    Filter filter;
    allow_reading_files(filter);
    allow_computing(filter);
    return filter.apply();
}

/// What root may do and others may not. Also gone are those that a program that is started would get.
bool drop_capabilities() {
    constexpr int kMost = 64;  // the kernel has 41, and refuses to drop others
    for (int capability = 0; capability < kMost; ++capability) {
        prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
    }
    prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
    return syscall(SYS_capset, &header, none.data()) == 0;
}

}  // namespace

std::vector<std::string> missing_sandbox_features() {
    std::vector<std::string> missing;
    if (landlock_version() == 0) {
        missing.emplace_back("Landlock");
    }
    if (!has_seccomp()) {
        missing.emplace_back("seccomp");
    }
    return missing;
}

void enter_sandbox(const std::vector<std::filesystem::path>& readable, SandboxMode mode) {
    syscall(SYS_close_range, STDERR_FILENO + 1, std::numeric_limits<unsigned>::max(), 0);
    if (mode == SandboxMode::off) {
        return;
    }
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    const bool has_landlock = landlock_version() > 0;
    const bool has_filters = has_seccomp();
    if (mode == SandboxMode::require && !(has_landlock && has_filters)) {
        throw std::runtime_error("the kernel lacks what the sandbox needs");
    }
    // What the kernel has must work, whatever is in the model's folder.
    if (!drop_capabilities() || (has_landlock && !restrict_files(readable)) ||
        (has_filters && !restrict_calls())) {
        throw std::runtime_error("the sandbox can't be entered");
    }
}

}  // namespace campuswalk::scene
