#include "engine/render/gl/dynamic_library.h"

#include <dlfcn.h>

#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {

DynamicLibrary::DynamicLibrary(std::initializer_list<const char*> names, const std::string& missing) {
    std::string reason;
    for (const char* name : names) {
        library_ = dlopen(name, RTLD_LOCAL | RTLD_NOW);
        if (library_ != nullptr) {
            name_ = name;
            return;
        }
        if (reason.empty()) {
            reason = dlerror();
        }
    }
    throw RenderError(missing + " (" + reason + ")");
}

void* DynamicLibrary::find(const char* symbol, const char* advice) const {
    void* found = dlsym(library_, symbol);
    if (found == nullptr) {
        throw RenderError(name_ + " has no " + symbol + ": " + advice);
    }
    return found;
}

}  // namespace campuswalk::engine::render
