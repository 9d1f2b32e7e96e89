// Imports a map once and prints, as JSON, what that took and how much of it was spent in GEOS: `map-bench
// FILE`. A program of its own, as the linker puts the functions below between the importer and GEOS (--wrap).

#include <cstdio>
#include <ctime>
#include <exception>

#include <geos_c.h>
#include <sys/resource.h>

#include "scene/osm/import_map.h"

namespace {

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double in_geos = 0.0;

/// Adds its lifetime to the time in GEOS.
class Timer {
public:
    Timer() : start_(cpu_seconds()) {}
    ~Timer() { in_geos += cpu_seconds() - start_; }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

private:
    double start_;
};

}  // namespace

// What costs time; the rest builds geometries and takes them apart.
#define TIME_CALL(result, name, parameters, arguments) \
    extern "C" result __real_##name parameters;        \
    extern "C" result __wrap_##name parameters;        \
    extern "C" result __wrap_##name parameters {       \
        const Timer timer;                             \
        return __real_##name arguments;                \
    }

#define CONTEXT GEOSContextHandle_t context
#define GEOMETRY const GEOSGeometry
TIME_CALL(GEOSGeometry*, GEOSBufferWithStyle_r,
          (CONTEXT, GEOMETRY* g, double width, int segments, int cap, int join, double limit),
          (context, g, width, segments, cap, join, limit))
TIME_CALL(GEOSGeometry*, GEOSBufferWithParams_r,
          (CONTEXT, GEOMETRY* g, const GEOSBufferParams* params, double width), (context, g, params, width))
TIME_CALL(GEOSGeometry*, GEOSDifferencePrec_r, (CONTEXT, GEOMETRY* a, GEOMETRY* b, double grid),
          (context, a, b, grid))
TIME_CALL(GEOSGeometry*, GEOSIntersectionPrec_r, (CONTEXT, GEOMETRY* a, GEOMETRY* b, double grid),
          (context, a, b, grid))
TIME_CALL(GEOSGeometry*, GEOSUnaryUnionPrec_r, (CONTEXT, GEOMETRY* a, double grid), (context, a, grid))
TIME_CALL(GEOSGeometry*, GEOSGeom_setPrecision_r, (CONTEXT, GEOMETRY* a, double grid, int flags),
          (context, a, grid, flags))
TIME_CALL(GEOSGeometry*, GEOSConstrainedDelaunayTriangulation_r, (CONTEXT, GEOMETRY* a), (context, a))
TIME_CALL(GEOSGeometry*, GEOSMakeValid_r, (CONTEXT, GEOMETRY* a), (context, a))
TIME_CALL(char, GEOSisValid_r, (CONTEXT, GEOMETRY* a), (context, a))
TIME_CALL(GEOSGeometry*, GEOSBuildArea_r, (CONTEXT, GEOMETRY* a), (context, a))
TIME_CALL(GEOSGeometry*, GEOSNode_r, (CONTEXT, GEOMETRY* a), (context, a))
TIME_CALL(char, GEOSIntersects_r, (CONTEXT, GEOMETRY* a, GEOMETRY* b), (context, a, b))
TIME_CALL(GEOSGeometry*, GEOSMinimumRotatedRectangle_r, (CONTEXT, GEOMETRY* a), (context, a))

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: map-bench MAP.osm\n", stderr);
        return 2;
    }
    try {
        campuswalk::scene::osm::MapRequest request;
        request.file = arguments[1];
        request.mark.file = arguments[1];
        const auto imported = campuswalk::scene::osm::import_map(request);
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);  // with libosmium's threads
        const auto seconds = [](const timeval& time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        std::printf("{\"triangles\": %zu, \"cpu\": %.4f, \"geos\": %.4f, \"megabytes\": %.1f}\n",
                    campuswalk::scene::count_triangles(imported.model),
                    seconds(usage.ru_utime) + seconds(usage.ru_stime), in_geos,
                    static_cast<double>(usage.ru_maxrss) / 1024.0);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
