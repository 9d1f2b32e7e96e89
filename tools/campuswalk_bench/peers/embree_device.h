#pragma once

#include <embree3/rtcore.h>

#include <stdexcept>
#include <string>

namespace campuswalk::tools::bench {

/// Embree on one thread, for as long as this lives: scenes are released before it.
struct EmbreeDevice {
    EmbreeDevice() : device(rtcNewDevice("threads=1,set_affinity=0")) {
        if (device == nullptr) {
            throw std::runtime_error("no Embree device: error " + std::to_string(rtcGetDeviceError(nullptr)));
        }
    }
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;
    ~EmbreeDevice() { rtcReleaseDevice(device); }

    RTCDevice device = nullptr;
};

}  // namespace campuswalk::tools::bench
