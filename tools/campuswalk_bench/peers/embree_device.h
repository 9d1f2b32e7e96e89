#pragma once

#include <embree3/rtcore.h>

#include <stdexcept>
#include <string>

namespace campuswalk::tools::bench {

/// Embree on one thread. Scenes must be released before the device.
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
