#include "tools/campuswalk/cluster/slurm_program.h"

#include <unistd.h>

#include <array>
#include <span>
#include <system_error>

#include "scene/process/child_process.h"
#include "scene/process/pipe.h"

namespace campuswalk::tools {

SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment) {
    constexpr int kNotFound = 127;
    constexpr int kSignalled = 128;
    std::vector<std::string> variables = environment;
    for (char** variable = environ; !environment.empty() && *variable != nullptr; ++variable) {
        variables.emplace_back(*variable);
    }
    SlurmAnswer answer;
    try {
        scene::Pipe pipe = scene::make_pipe();
        const scene::Descriptor nothing = scene::open_null_device();
        scene::ChildProcess process = scene::start_program({.program = program,
                                                            .arguments = arguments,
                                                            .environment = variables,
                                                            .input = nothing.number(),
                                                            .output = pipe.writing.number(),
                                                            .error = pipe.writing.number(),
                                                            .detached = true});
        pipe.writing.close();
        std::array<char, 4096> buffer{};
        while (const std::size_t count =
                   scene::read_some(pipe.reading.number(), std::as_writable_bytes(std::span(buffer)))) {
            answer.text.append(buffer.data(), count);
        }
        const scene::ExitStatus end = process.wait();
        answer.exit_code = end.signal == 0 ? end.exit_code : kSignalled + end.signal;
    } catch (const std::system_error& error) {
        answer = {kNotFound, error.code().message()};
    }
    return answer;
}

}  // namespace campuswalk::tools
