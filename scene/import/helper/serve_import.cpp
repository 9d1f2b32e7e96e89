#include "scene/import/helper/serve_import.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <exception>

#include "scene/import/helper/import_protocol.h"
#include "scene/import/helper/limit_process.h"
#include "scene/model/model_file.h"
#include "scene/process/pipe.h"

namespace campuswalk::scene {
namespace {

std::vector<std::byte> read_all(int from) {
    std::vector<std::byte> bytes;
    std::array<std::byte, 4096> part;
    while (const std::size_t got = read_some(from, part)) {
        bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(got));
    }
    return bytes;
}

bool write_answer(int to, const ImportedModel& answer) {
    ArchiveWriter file = archive_model(answer);
    for (const std::span<const std::byte> part : file.finish()) {
        if (!write_all(to, part)) {
            return false;
        }
    }
    return true;
}

ImportedModel answer_to(const ImportRequest& request) {
    try {
        return import_model(request.file, request.if_empty);
    } catch (const InputError& error) {
        return refusal_of(error);
    }
}

}  // namespace

int serve_import() {
    struct stat status {};
    if (fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) {
        return 2;  // started by hand: nobody is going to ask
    }
    try {
        const ImportRequest request = read_request(read_all(STDIN_FILENO));
        limit_process(request.limits);
        _exit(write_answer(STDOUT_FILENO, answer_to(request)) ? 0 : 1);  // nobody needs the memory given back
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace campuswalk::scene
