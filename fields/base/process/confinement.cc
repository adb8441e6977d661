#include "fields/base/process/confinement.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "fields/base/error.h"

// What calls are let through is what the C library, threads, netCDF, HDF5, ecCodes and UDUNITS ask
// for to read files and write others, and their fellows on other machines. All else fails with
// EPERM, which they take for "not here": a process that is killed for a call cannot say what it
// found.

namespace slackwater {
namespace {

// Of Landlock's third version, which headers of Linux 6.1 do not know yet.
constexpr std::uint64_t truncate_right = 1U << 14U;

// Of its fourth (TCP: bind, connect) and sixth (sockets without a place, signals to others).
constexpr std::uint64_t of_network = 3, of_others = 3;
/// What is taken away, as versions up to the sixth have it.
struct Handled {
  std::uint64_t files = 0, network = 0, others = 0;
};

constexpr std::uint64_t of_reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t of_files = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                   LANDLOCK_ACCESS_FS_EXECUTE | truncate_right;

/// Always let through.
constexpr std::array free_calls{
    // bytes of files that are open
    SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(preadv), SCMP_SYS(write),
    SCMP_SYS(writev), SCMP_SYS(pwrite64), SCMP_SYS(pwritev), SCMP_SYS(lseek), SCMP_SYS(close),
    SCMP_SYS(fsync), SCMP_SYS(fdatasync), SCMP_SYS(ftruncate), SCMP_SYS(fallocate),
    SCMP_SYS(fadvise64), SCMP_SYS(sync_file_range), SCMP_SYS(dup), SCMP_SYS(poll), SCMP_SYS(ppoll),
    SCMP_SYS(flock), SCMP_SYS(getdents64),
    // names, which Landlock bounds
    SCMP_SYS(open), SCMP_SYS(openat), SCMP_SYS(fstat), SCMP_SYS(stat), SCMP_SYS(lstat),
    SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(statfs), SCMP_SYS(fstatfs), SCMP_SYS(access),
    SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink), SCMP_SYS(readlinkat),
    SCMP_SYS(getcwd), SCMP_SYS(mkdir), SCMP_SYS(mkdirat), SCMP_SYS(rmdir), SCMP_SYS(unlink),
    SCMP_SYS(unlinkat), SCMP_SYS(rename), SCMP_SYS(renameat), SCMP_SYS(renameat2),
    // memory
    SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(msync),
    // threads of its own
    SCMP_SYS(futex), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(getcpu),
    SCMP_SYS(set_robust_list), SCMP_SYS(set_tid_address), SCMP_SYS(rseq), SCMP_SYS(exit),
    SCMP_SYS(exit_group), SCMP_SYS(restart_syscall), SCMP_SYS(arch_prctl),
    // time, chance, and who and where it is
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep),
    SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(getrandom), SCMP_SYS(uname), SCMP_SYS(sysinfo),
    SCMP_SYS(getrusage), SCMP_SYS(times), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(getppid),
    SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getrlimit),
    // its own signals
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack)};

using Filter = std::unique_ptr<void, void (*)(scmp_filter_ctx)>;

void expect_taken(int result) {
  if (result < 0 && result != -EDOM)  // EDOM: this machine has no such call
    throw Error(ErrorKind::unavailable, "cannot confine what reads a file: " +
                                            std::string(std::strerror(-result)) + "; try again");
}

/// Of the arguments of a call, from 0.
scmp_arg_cmp is(unsigned argument, scmp_datum_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }
scmp_arg_cmp has(unsigned argument, scmp_datum_t mask, scmp_datum_t bits) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, bits};
}

void allow(const Filter& filter, int call, std::initializer_list<scmp_arg_cmp> when = {}) {
  expect_taken(::seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call,
                                        static_cast<unsigned>(when.size()),
                                        when.size() == 0 ? nullptr : std::data(when)));
}

void allow_memory(const Filter& filter, bool runs_code) {
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
    if (runs_code)
      allow(filter, call);
    else
      allow(filter, call, {has(2, PROT_EXEC, 0)});
  }
}

/// What was allowed, as the kernel takes it.
std::vector<sock_filter> program_of(const Filter& filter) {
  const Descriptor file(::memfd_create("calls", MFD_CLOEXEC));
  if (!file.is_open()) expect_taken(-errno);
  expect_taken(::seccomp_export_bpf(filter.get(), file.value()));
  struct stat about {};
  if (::fstat(file.value(), &about) != 0) expect_taken(-errno);
  std::vector<sock_filter> program(static_cast<std::size_t>(about.st_size) / sizeof(sock_filter));
  const std::size_t bytes = program.size() * sizeof(sock_filter);
  if (::pread(file.value(), program.data(), bytes, 0) != static_cast<ssize_t>(bytes))
    expect_taken(-EIO);
  return program;
}

std::vector<sock_filter> calls_for(const Reach& reach) {
  const Filter filter(::seccomp_init(SCMP_ACT_ERRNO(EPERM)), ::seccomp_release);
  if (!filter) expect_taken(-ENOMEM);
  for (const int call : free_calls) allow(filter, call);
  const bool runs_programs = !reach.programs.empty();
  allow_memory(filter, runs_programs);
  // Threads, no processes; the newer call for both holds its flags where a filter cannot see them.
  allow(filter, SCMP_SYS(clone), {has(0, CLONE_THREAD, CLONE_THREAD)});
  expect_taken(::seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0));
  // Flags and locks of its files, not who is signalled of them.
  for (const int of : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_GETLK, F_SETLK,
                       F_SETLKW, F_OFD_GETLK, F_OFD_SETLK, F_OFD_SETLKW})
    allow(filter, SCMP_SYS(fcntl), {is(1, static_cast<scmp_datum_t>(of))});
  // Limits are read, not set.
  allow(filter, SCMP_SYS(prlimit64), {is(0, 0), is(2, 0)});
  // Signals go to itself.
  if (runs_programs) {
    allow(filter, SCMP_SYS(execve));
  } else {
    const auto self = static_cast<scmp_datum_t>(::getpid());
    allow(filter, SCMP_SYS(tgkill), {is(0, self)});
  }
  return program_of(filter);
}

long landlock_version() noexcept {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

/// Every right that this kernel can take away.
std::uint64_t rights_of(long version) noexcept {
  std::uint64_t rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;  // of the first
  if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= 3) rights |= truncate_right;
  return rights;
}

void let_reach(const Descriptor& rules, const std::filesystem::path& path, std::uint64_t rights) {
  const Descriptor file(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat about {};
  if (!file.is_open() || ::fstat(file.value(), &about) != 0) return;
  landlock_path_beneath_attr beneath{};
  beneath.allowed_access = S_ISDIR(about.st_mode) ? rights : rights & of_files;
  beneath.parent_fd = file.value();
  // A file without a place (of memory alone) cannot be within reach.
  const bool is_added =
      ::syscall(SYS_landlock_add_rule, rules.value(), LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) == 0;
  if (!is_added && errno != EBADFD) expect_taken(-errno);
}

Descriptor files_for(const Reach& reach) {
  const long version = landlock_version();
  if (version < 1) return Descriptor();
  const Handled all{rights_of(version), version >= 4 ? of_network : 0,
                    version >= 6 ? of_others : 0};
  const std::size_t known_bytes = version >= 6 ? 24 : version >= 4 ? 16 : 8;
  Descriptor rules(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, known_bytes, 0)));
  if (!rules.is_open()) expect_taken(-errno);
  const std::uint64_t of_writing =
      (of_reading | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_MAKE_REG |
       LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
       LANDLOCK_ACCESS_FS_REMOVE_DIR | truncate_right) &
      all.files;
  for (const auto& path : reach.readable) let_reach(rules, path, of_reading);
  for (const auto& path : reach.writable) let_reach(rules, path, of_writing);
  for (const auto& path : reach.programs)
    let_reach(rules, path, of_reading | LANDLOCK_ACCESS_FS_EXECUTE);
  return rules;
}

}  // namespace

ConfinementOfSystem confinement_of_system() noexcept {
  ConfinementOfSystem system;
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  system.calls = ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
  system.files = landlock_version() >= 1;
  return system;
}

Confinement::Confinement(const Reach& reach) : files_(files_for(reach)) {
  if (confinement_of_system().calls) calls_ = calls_for(reach);
}

Confinement::~Confinement() = default;

bool Confinement::apply() const noexcept {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  if (files_.is_open() && ::syscall(SYS_landlock_restrict_self, files_.value(), 0) != 0)
    return false;
  if (calls_.empty()) return true;
  sock_fprog program{};
  program.len = static_cast<unsigned short>(calls_.size());
  program.filter = const_cast<sock_filter*>(calls_.data());  // the kernel's own signature
  return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

}  // namespace slackwater
