#include <cyclone/check.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace cyclone {
namespace detail {

namespace {

std::string numberText(real value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string rejectionText(const char *function, const char *rule, std::initializer_list<real> values) {
    std::string text = std::string(function) + ": " + rule;
    if (values.size() == 0) return text;
    std::string list;
    for (real value : values) list += (list.empty() ? "" : ", ") + numberText(value);
    if (values.size() > 1) list = "(" + list + ")";
    return text + ", not " + list;
}

}  // namespace

void reject(const char *function, const char *rule, std::initializer_list<real> values) {
    const std::string text = rejectionText(function, rule, values);
#ifdef __cpp_exceptions
    throw std::invalid_argument(text);
#else
    std::fprintf(stderr, "%s\n", text.c_str());
    std::abort();
#endif
}

}  // namespace detail
}  // namespace cyclone
