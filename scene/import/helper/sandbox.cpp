#include "scene/import/helper/sandbox.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

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

/// System calls that fail from now on.
class Filter {
public:
    Filter() : filter_(seccomp_init(SCMP_ACT_ALLOW)), complete_(filter_ != nullptr) {}

    /// Calls by their names, with spaces between.
    void forbid(const char* names) {
        std::istringstream words(names);
        for (std::string name; words >> name;) {
            forbid_if(name, {});
        }
    }
    /// A name that the library doesn't know is of a call with a high number; see forbid_unknown().
    void forbid_if(const std::string& name, const std::vector<scmp_arg_cmp>& conditions, int error = EPERM) {
        if (const int number = seccomp_syscall_resolve_name(name.c_str()); number >= 0) {
            add(number, conditions, error);
        }
    }
    /// Those that are newer than the lists here.
    void forbid_unknown() {
        constexpr int kFirst = 451;  // cachestat; the numbers are the same on all processors
        constexpr int kLast = 1023;
        for (int number = kFirst; number <= kLast; ++number) {
            add(number, {}, ENOSYS);
        }
    }

    bool apply() const { return complete_ && seccomp_load(filter_.get()) == 0; }

private:
    void add(int number, const std::vector<scmp_arg_cmp>& conditions, int error) {
        const int failure =
            seccomp_rule_add_array(filter_.get(), SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), number,
                                   static_cast<unsigned>(conditions.size()), conditions.data());
        complete_ = complete_ && (failure == 0 || failure == -EEXIST);
    }

    std::unique_ptr<void, ReleaseFilter> filter_;
    bool complete_;
};

scmp_arg_cmp has_bits(unsigned argument, std::uint64_t mask, std::uint64_t bits) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, bits};
}

void forbid_writing_files(Filter& filter) {
    for (const auto& [name, flags] : {std::pair{"open", 1U}, std::pair{"openat", 2U}}) {
        filter.forbid_if(name, {has_bits(flags, O_ACCMODE, O_WRONLY)});
        filter.forbid_if(name, {has_bits(flags, O_ACCMODE, O_RDWR)});
        filter.forbid_if(name, {has_bits(flags, O_ACCMODE, O_ACCMODE)});
        filter.forbid_if(name, {has_bits(flags, O_CREAT, O_CREAT)});
        filter.forbid_if(name, {has_bits(flags, O_TRUNC, O_TRUNC)});
    }
    filter.forbid_if("openat2", {}, ENOSYS);  // its flags are in memory, which no filter sees
    filter.forbid(
        "creat fchmod fchown fsetxattr removexattr lremovexattr fremovexattr truncate rename "
        "renameat renameat2 unlink unlinkat mkdir mkdirat rmdir link linkat symlink symlinkat "
        "mknod mknodat chmod fchmodat chown lchown fchownat setxattr lsetxattr utime utimes "
        "utimensat futimesat name_to_handle_at open_by_handle_at");
}

void forbid_processes(Filter& filter) {
    filter.forbid_if("clone", {has_bits(0, CLONE_THREAD, 0)});
    filter.forbid_if("clone3", {}, ENOSYS);  // likewise; the C library then starts threads by clone
    filter.forbid(
        "fork vfork execve execveat ptrace process_vm_readv process_vm_writev pidfd_open "
        "pidfd_getfd pidfd_send_signal tkill sched_setaffinity ioprio_set rt_sigqueueinfo "
        "rt_tgsigqueueinfo kcmp setpriority sched_setscheduler sched_setparam sched_setattr "
        "setpgid setsid");
    const auto self = static_cast<std::uint64_t>(getpid());
    for (const char* name : {"kill", "tgkill"}) {  // abort() signals itself
        filter.forbid_if(name, {{0, SCMP_CMP_NE, self, 0}});
    }
    filter.forbid_if("prlimit64", {{0, SCMP_CMP_NE, 0, 0}});
    // A descriptor can be made to send a signal to any process.
    constexpr int kSetOwnEx = 15;  // F_SETOWN_EX and F_SETSIG are extensions of GNU
    constexpr int kSetSignal = 10;
    for (const int command : {F_SETOWN, kSetOwnEx, kSetSignal}) {
        filter.forbid_if("fcntl", {{1, SCMP_CMP_EQ, static_cast<std::uint64_t>(command), 0}});
    }
}

void forbid_the_rest(Filter& filter) {
    filter.forbid(
        "socket socketpair connect bind listen accept accept4 sendto sendmsg sendmmsg "
        "io_uring_setup io_uring_enter io_uring_register bpf perf_event_open userfaultfd keyctl "
        "add_key request_key unshare setns mount umount2 move_mount open_tree fsopen fsmount "
        "fsconfig mount_setattr pivot_root chroot quotactl swapon swapoff reboot init_module "
        "finit_module delete_module kexec_load kexec_file_load acct settimeofday clock_settime "
        "adjtimex clock_adjtime sethostname setdomainname personality setuid setgid setreuid "
        "setregid setresuid setresgid setgroups capset mq_open mq_unlink shmget shmctl shmdt "
        "msgctl msgrcv semctl semop semtimedop ioctl shmat msgget msgsnd semget memfd_create "
        "memfd_secret fanotify_init inotify_init inotify_init1 syslog vhangup");
}

bool restrict_calls() {
    Filter filter;
    forbid_writing_files(filter);
    forbid_processes(filter);
    forbid_the_rest(filter);
    filter.forbid_unknown();
    return filter.apply();
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
    if ((has_landlock && !restrict_files(readable)) || (has_filters && !restrict_calls())) {
        throw std::runtime_error("the sandbox can't be entered");
    }
}

}  // namespace campuswalk::scene
