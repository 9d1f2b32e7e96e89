#include "scene/import/helper/sandbox.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <linux/sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <limits>
#include <memory>
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
    return prctl(PR_SET_SECCOMP, 2 /* SECCOMP_MODE_FILTER */, nullptr) != 0 && errno == EFAULT;
}

/// All kinds of access that this version can restrict.
std::uint64_t restricted_access(int version) {
    const unsigned kinds = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    return (std::uint64_t{1} << kinds) - 1;
}

bool restrict_files(const std::vector<std::filesystem::path>& folders) {
    const int version = landlock_version();
    if (version == 0) {
        return false;
    }
    const std::uint64_t access = restricted_access(version);
    const Descriptor rules(
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &access, sizeof access, std::uint32_t{0})));
    if (!rules.open()) {
        return false;
    }
    for (const std::filesystem::path& folder : folders) {
        const Descriptor root(open(folder.c_str(), O_PATH | O_CLOEXEC));
        if (!root.open()) {
            continue;  // it doesn't exist
        }
        landlock_path_beneath_attr rule{};
        rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
        rule.parent_fd = root.number();
        if (syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &rule,
                    std::uint32_t{0}) != 0) {
            return false;
        }
    }
    return syscall(SYS_landlock_restrict_self, rules.number(), std::uint32_t{0}) == 0;
}

struct ReleaseFilter {
    void operator()(void* filter) const { seccomp_release(filter); }
};

/// System calls that fail from now on. Adding a call that the processor's architecture lacks is no error.
class Filter {
public:
    Filter() : filter_(seccomp_init(SCMP_ACT_ALLOW)) {}

    void forbid(std::initializer_list<const char*> names) {
        for (const char* name : names) {
            forbid_if(name, {});
        }
    }
    void forbid_if(const char* name, const std::vector<scmp_arg_cmp>& conditions, int error = EPERM) {
        const int number = seccomp_syscall_resolve_name(name);
        if (filter_ && number != __NR_SCMP_ERROR) {
            seccomp_rule_add_array(filter_.get(), SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), number,
                                   static_cast<unsigned>(conditions.size()), conditions.data());
        }
    }

    bool apply() const { return filter_ && seccomp_load(filter_.get()) == 0; }

private:
    std::unique_ptr<void, ReleaseFilter> filter_;
};

scmp_arg_cmp has_bits(unsigned argument, std::uint64_t mask, std::uint64_t bits) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, bits};
}

void forbid_writing_files(Filter& filter) {
    for (const auto& [name, flags] : {std::pair{"open", 1U}, std::pair{"openat", 2U}}) {
        filter.forbid_if(name, {has_bits(flags, O_ACCMODE, O_WRONLY)});
        filter.forbid_if(name, {has_bits(flags, O_ACCMODE, O_RDWR)});
        filter.forbid_if(name, {has_bits(flags, O_CREAT, O_CREAT)});
        filter.forbid_if(name, {has_bits(flags, O_TRUNC, O_TRUNC)});
    }
    filter.forbid_if("openat2", {}, ENOSYS);  // its flags are in memory, which no filter sees
    filter.forbid({"creat",   "truncate",  "rename",    "renameat",          "renameat2",
                   "unlink",  "unlinkat",  "mkdir",     "mkdirat",           "rmdir",
                   "link",    "linkat",    "symlink",   "symlinkat",         "mknod",
                   "mknodat", "chmod",     "fchmodat",  "fchmodat2",         "chown",
                   "lchown",  "fchownat",  "setxattr",  "lsetxattr",         "utime",
                   "utimes",  "utimensat", "futimesat", "name_to_handle_at", "open_by_handle_at"});
}

void forbid_processes(Filter& filter) {
    filter.forbid_if("clone", {has_bits(0, CLONE_THREAD, 0)});
    filter.forbid_if("clone3", {}, ENOSYS);  // likewise; the C library then starts threads by clone
    filter.forbid({"fork",
                   "vfork",
                   "execve",
                   "execveat",
                   "ptrace",
                   "process_vm_readv",
                   "process_vm_writev",
                   "pidfd_open",
                   "pidfd_getfd",
                   "pidfd_send_signal",
                   "tkill",
                   "rt_sigqueueinfo",
                   "rt_tgsigqueueinfo",
                   "kcmp",
                   "setpriority",
                   "sched_setscheduler",
                   "sched_setparam",
                   "sched_setattr",
                   "setpgid",
                   "setsid"});
    const auto self = static_cast<std::uint64_t>(getpid());
    for (const char* name : {"kill", "tgkill"}) {  // abort() signals itself
        filter.forbid_if(name, {{0, SCMP_CMP_NE, self, 0}});
    }
    filter.forbid_if("prlimit64", {{0, SCMP_CMP_NE, 0, 0}});
}

void forbid_the_rest(Filter& filter) {
    filter.forbid({"socket",
                   "socketpair",
                   "connect",
                   "bind",
                   "listen",
                   "accept",
                   "accept4",
                   "sendto",
                   "sendmsg",
                   "sendmmsg",
                   "io_uring_setup",
                   "io_uring_enter",
                   "io_uring_register",
                   "bpf",
                   "perf_event_open",
                   "userfaultfd",
                   "keyctl",
                   "add_key",
                   "request_key",
                   "unshare",
                   "setns",
                   "mount",
                   "umount2",
                   "move_mount",
                   "open_tree",
                   "fsopen",
                   "fsmount",
                   "fsconfig",
                   "mount_setattr",
                   "pivot_root",
                   "chroot",
                   "quotactl",
                   "swapon",
                   "swapoff",
                   "reboot",
                   "init_module",
                   "finit_module",
                   "delete_module",
                   "kexec_load",
                   "kexec_file_load",
                   "acct",
                   "settimeofday",
                   "clock_settime",
                   "adjtimex",
                   "clock_adjtime",
                   "sethostname",
                   "setdomainname",
                   "personality",
                   "setuid",
                   "setgid",
                   "setreuid",
                   "setregid",
                   "setresuid",
                   "setresgid",
                   "setgroups",
                   "capset",
                   "mq_open",
                   "mq_unlink",
                   "shmget",
                   "shmat",
                   "msgget",
                   "msgsnd",
                   "semget",
                   "memfd_create",
                   "memfd_secret",
                   "fanotify_init",
                   "inotify_init",
                   "inotify_init1",
                   "syslog",
                   "vhangup"});
}

bool restrict_calls() {
    Filter filter;
    forbid_writing_files(filter);
    forbid_processes(filter);
    forbid_the_rest(filter);
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

void enter_sandbox(const std::vector<std::filesystem::path>& folders, SandboxMode mode) {
    syscall(SYS_close_range, STDERR_FILENO + 1, std::numeric_limits<unsigned>::max(), 0);
    if (mode == SandboxMode::off) {
        return;
    }
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    const bool files = restrict_files(folders);
    const bool calls = restrict_calls();
    if (mode == SandboxMode::require && !(files && calls)) {
        throw std::runtime_error("the kernel lacks what the sandbox needs");
    }
}

}  // namespace campuswalk::scene
