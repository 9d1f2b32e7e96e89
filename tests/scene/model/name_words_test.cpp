#include "scene/model/name_words.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

using Words = std::vector<std::string>;

TEST(NameWords, SplitsNamesIntoWords) {
    EXPECT_EQ(words_of("FrontDoor_01"), (Words{"front", "door"}));
    EXPECT_EQ(words_of("DOOR.002"), (Words{"door"}));
    EXPECT_EQ(words_of("TÜR_Ost"), (Words{"tür", "ost"}));
    EXPECT_EQ(words_of("42"), Words{});
}

TEST(NameWords, RecognizesDoorsButNotTheirParts) {
    for (const char* door :
         {"door", "Door_01", "FrontDoor", "front_doors", "Haustür", "TÜR_3", "Eingangstuer", "porte.001",
          "puerta", "voordeur", "ドア2", "library/door_main"}) {
        EXPECT_TRUE(is_door_name(door)) << door;
    }
    for (const char* other : {"outdoor_campus", "IndoorPlants", "door_frame", "DoorHandle.L", "Türgriff",
                              "doorway_arch", "doormat", "Doric column", "trapdoor", "portal", "dorm"}) {
        EXPECT_FALSE(is_door_name(other)) << other;
    }
}

TEST(NameWords, RecognizesStairs) {
    for (const char* stairs : {"stairs", "Main_Staircase", "Kellertreppe", "escalier-2", "library_steps"}) {
        EXPECT_TRUE(is_stairs_name(stairs)) << stairs;
    }
    for (const char* other : {"upstairs_room", "step_counter", "scale", "Trap"}) {
        EXPECT_FALSE(is_stairs_name(other)) << other;
    }
}

TEST(NameWords, RecognizesIdentifiers) {
    for (const char* id : {"b31bcc29d-00ba-11e6-b420-2bdcc4ab5d7f", "{6F9619FF-8B86-D011-B42D-00CF4FC964FF}",
                           "2O2Fr$t4X7Zf8NOew3FLOH", "1234", "9f4ce64aa98b7f01"}) {
        EXPECT_TRUE(is_identifier(id)) << id;
    }
    for (const char* name : {"Hut_1", "library", "collider_223", "AdministrationBuilding", "", "deadbeef",
                             "Administration_Building"}) {
        EXPECT_FALSE(is_identifier(name)) << name;
    }
}

TEST(NameWords, RecognizesSurroundings) {
    EXPECT_TRUE(is_surroundings_name("hedge_04"));
    EXPECT_TRUE(is_surroundings_name("StreetLamp"));
    EXPECT_TRUE(is_surroundings_name("樟树_3"));
    EXPECT_FALSE(is_surroundings_name("wall_0"));
    EXPECT_FALSE(is_surroundings_name("Lake House"));
    EXPECT_FALSE(is_surroundings_name("bus station"));
    EXPECT_FALSE(is_surroundings_name("greenhouse"));
}

TEST(NameWords, RecognizesPartsOfBuildings) {
    EXPECT_TRUE(is_building_part_name("Library_wall_2"));
    EXPECT_TRUE(is_building_part_name("Haustür"));
    EXPECT_TRUE(is_building_part_name("room 17"));
    EXPECT_FALSE(is_building_part_name("Wallace_Hall"));
    EXPECT_FALSE(is_building_part_name("Library"));
}

TEST(NameWords, RecognizesNamesThatSayNothing) {
    for (const char* name :
         {"Cube", "Cube.012", "Mesh_4", "Group 7", "polySurface12", "SketchUp", "Sketchfab_model", "3", ""}) {
        EXPECT_TRUE(is_default_name(name)) << name;
    }
    EXPECT_FALSE(is_default_name("Library"));
    EXPECT_FALSE(is_default_name("Library mesh"));
}

TEST(NameWords, RecognizesNamesThatImportersGenerate) {
    for (const char* name : {"", "nodes[12]", "$ColladaAutoName$_3", "<MD2Root>", "defaultobject"}) {
        EXPECT_TRUE(is_generated_name(name)) << name;
    }
    EXPECT_FALSE(is_generated_name("nodes"));
    EXPECT_FALSE(is_generated_name("Library"));
}

}  // namespace
}  // namespace campuswalk::scene
