#pragma once

namespace campuswalk::collision {

/// A reference to something callable, valid as long as that lives.
template <typename Signature>
class FunctionRef;

template <typename Result, typename... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    template <typename Function>
    FunctionRef(const Function& function)
        : function_(&function), call_([](const void* to, Arguments... arguments) -> Result {
              return (*static_cast<const Function*>(to))(arguments...);
          }) {}

    Result operator()(Arguments... arguments) const { return call_(function_, arguments...); }

private:
    const void* function_;
    Result (*call_)(const void*, Arguments...);
};

}  // namespace campuswalk::collision
