// utf8proc isn't there for this processor. Of it the core asks only whether characters of the packed walks'
// words are seen; here all are letters. The logs are compared with the native ones, so that a character for
// which that is wrong shows. Whatever calls the rest ends the test.

#include <cstdlib>

#include <utf8proc.h>

extern "C" {

utf8proc_category_t utf8proc_category(utf8proc_int32_t /*point*/) {
    return UTF8PROC_CATEGORY_LL;
}
const utf8proc_property_t* utf8proc_get_property(utf8proc_int32_t /*point*/) {
    static const utf8proc_property_t letter{};
    return &letter;
}
utf8proc_uint8_t* utf8proc_NFC(const utf8proc_uint8_t* /*text*/) {
    std::abort();
}
utf8proc_ssize_t utf8proc_encode_char(utf8proc_int32_t /*point*/, utf8proc_uint8_t* /*bytes*/) {
    std::abort();
}
utf8proc_ssize_t utf8proc_iterate(const utf8proc_uint8_t* /*text*/, utf8proc_ssize_t /*bytes*/,
                                  utf8proc_int32_t* /*point*/) {
    std::abort();
}
utf8proc_int32_t utf8proc_tolower(utf8proc_int32_t /*point*/) {
    std::abort();
}
}
