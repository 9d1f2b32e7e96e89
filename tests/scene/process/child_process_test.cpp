#include "scene/process/child_process.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

#include "scene/process/pipe.h"

namespace campuswalk::scene {
namespace {

using std::chrono::milliseconds;

ProgramStart shell(const std::string& script) {
    return {.program = "sh", .arguments = {"-c", script}, .environment = {}};
}

std::string read_to_end(const Descriptor& from) {
    std::string text;
    std::array<char, 16> piece{};
    while (const std::size_t got = read_some(from.number(), std::as_writable_bytes(std::span(piece)))) {
        text.append(piece.data(), got);
    }
    return text;
}

TEST(StartProgram, HasItsStreamsArgumentsAndEnvironment) {
    Pipe in = make_pipe();
    Pipe out = make_pipe();
    ProgramStart start = shell("cat; echo $WORD; echo lost >&2");
    start.environment = {"WORD=hello", "PATH=/usr/bin:/bin"};
    start.input = in.reading.number();
    start.output = out.writing.number();
    const Descriptor nowhere = open_null_device();
    start.error = nowhere.number();
    ChildProcess process = start_program(start);
    in.reading.close();
    out.writing.close();
    EXPECT_TRUE(write_all(in.writing.number(), "what comes in\n"));
    in.writing.close();
    EXPECT_EQ(read_to_end(out.reading), "what comes in\nhello\n");
    EXPECT_TRUE(process.wait().success());
}

TEST(StartProgram, ThrowsWhenThereIsNoSuchProgram) {
    EXPECT_THROW(start_program({.program = "/no/such/program", .arguments = {}, .environment = {}}),
                 std::system_error);
}

TEST(StartProgram, InheritsNoPipe) {
    const Pipe pipe = make_pipe();
    ChildProcess process =
        start_program(shell("test -e /proc/self/fd/" + std::to_string(pipe.writing.number())));
    EXPECT_EQ(process.wait().exit_code, 1);
}

TEST(ChildProcess, ReportsHowItEnded) {
    const ExitStatus code = start_program(shell("exit 7")).wait();
    EXPECT_EQ(code.exit_code, 7);
    EXPECT_FALSE(code.success());
    EXPECT_NE(to_string(code).find("code 7"), std::string::npos) << to_string(code);
    const ExitStatus killed = start_program(shell("kill -SEGV $$")).wait();
    EXPECT_EQ(killed.signal, SIGSEGV);
    EXPECT_FALSE(killed.success());
    EXPECT_NE(to_string(killed).find("signal 11 (Segmentation fault)"), std::string::npos)
        << to_string(killed);
}

TEST(ChildProcess, IsWaitedForNoLongerThanTheTimeout) {
    ChildProcess process = start_program(shell("exec sleep 60"));
    EXPECT_FALSE(process.ends_within(milliseconds(20)));
    EXPECT_TRUE(process.running());
    process.send_signal(SIGKILL);
    EXPECT_TRUE(process.ends_within(milliseconds(60'000)));
    EXPECT_EQ(process.wait().signal, SIGKILL);
    EXPECT_FALSE(process.running());
}

TEST(ForkProcess, RunsAFunctionInACopyOfThisProcess) {
    Pipe pipe = make_pipe();
    int changed = 1;
    ChildProcess child = fork_process([&] {
        changed = 2;
        write_all(pipe.writing.number(), "changed to " + std::to_string(changed));
    });
    pipe.writing.close();
    EXPECT_EQ(read_to_end(pipe.reading), "changed to 2");
    EXPECT_TRUE(child.wait().success());
    EXPECT_EQ(changed, 1);
}

void ignore(int) {}

TEST(Pipe, ASignalInterruptsNeitherReadingNorWriting) {
    struct sigaction action {};
    action.sa_handler = ignore;  // without SA_RESTART: system calls return EINTR
    struct sigaction before {};
    sigaction(SIGUSR1, &action, &before);
    Pipe there = make_pipe();
    const pid_t parent = getpid();
    ChildProcess child = fork_process([&] {
        there.reading.close();
        for (int i = 0; i < 20; ++i) {
            usleep(2000);
            kill(parent, SIGUSR1);
        }
        write_all(there.writing.number(), "at last");
    });
    there.writing.close();
    EXPECT_EQ(read_to_end(there.reading), "at last");
    child.wait();
    sigaction(SIGUSR1, &before, nullptr);
}

}  // namespace
}  // namespace campuswalk::scene
