#pragma once

#include <initializer_list>
#include <string>

namespace campuswalk::engine::render {

/// A library opened at run time: linking a GL driver would load 100 MB at every start. Never closed, as
/// LLVM's threads and exit handlers outlive any context.
class DynamicLibrary {
public:
    /// Opens the first of `names` that exists. Throws RenderError with `missing` and the system's reason.
    DynamicLibrary(std::initializer_list<const char*> names, const std::string& missing);

    /// Throws RenderError with the symbol's name and `advice` if the library lacks it.
    template <typename Function>
    void load(const char* symbol, Function& function, const char* advice) const {
        function = reinterpret_cast<Function>(find(symbol, advice));
    }

private:
    void* find(const char* symbol, const char* advice) const;

    std::string name_;
    void* library_ = nullptr;
};

}  // namespace campuswalk::engine::render
