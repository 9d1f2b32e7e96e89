#include "engine/render/snapshot/renderer_store.h"

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

/// A store that counts the renderers it creates in `made`.
RendererStore counting_store(std::size_t& made) {
    return RendererStore([&made](const scene::Campus&) {
        ++made;
        SnapshotSettings settings;
        settings.light = quick_settings();
        return settings;
    });
}

TEST(RendererStore, CachesOnePerCampusAndLight) {
    const scene::Campus tower = campus_of(tower_scene());
    const scene::Campus other = campus_of(SceneBuilder().colored(kRed).ground(10.0).model());
    std::size_t made = 0;
    RendererStore store = counting_store(made);
    LightSettings no_shadows;
    no_shadows.shadows = false;
    for (int i = 0; i < 3; ++i) {
        store.of(tower, {});
        store.of(tower, no_shadows);
        store.of(other, {});
    }
    EXPECT_EQ(made, 3U);
}

TEST(RendererStore, EvictsWhenFull) {
    const scene::Campus tower = campus_of(tower_scene());
    std::size_t made = 0;
    RendererStore store = counting_store(made);
    for (int i = 0; i < 6; ++i) {
        LightSettings light;
        light.fog_distance = 100.0 + i;
        store.of(tower, light);
    }
    EXPECT_EQ(made, 6U);
    store.of(tower, {});
    store.of(tower, {});
    EXPECT_EQ(made, 7U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
