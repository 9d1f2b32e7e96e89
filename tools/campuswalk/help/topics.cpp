#include "tools/campuswalk/help/topics.h"

#include <array>

#include "tools/campuswalk/help/key_table.h"

namespace campuswalk::tools::help {

namespace {

std::string walks() {
    return "NAME.walk.yaml says where somebody walks and what must happen. Its keys:\n\n" +
           key_table("walk.schema.json") + R"(
  # yaml-language-server: $schema=schema/walk.schema.json
  campus: school.campus.yaml
  avatar: adult
  steps:
    - spawn: gate
    - walk_to: desk
  expect:
    - sequence: [trigger.enter library/door, popup.open library]
    - reaches: desk

Lengths are metres, angles degrees, times simulated seconds; +Y is up; yaw 0 looks along -Z and grows
to the left. See: campuswalk help steps, help expectations, help events.
)";
}

std::string steps() {
    return "Entries of 'steps' have one key each; the first is 'spawn'.\n\n" +
           key_table("walk.schema.json#/definitions/step") + R"(
A place is a name of the campus, [x, z] or [x, y, z]. One with a height is reached within 0.5 m of it.
'run', 'speed', 'crouch', 'enable', 'disable' and 'snapshot' take no time. Steps that several walks
share go into a NAME.steps.yaml with the only key 'steps'.
)";
}

std::string expectations() {
    return "Entries of 'expect' have one key each. All are looked at when the walk has ended; one that "
           "doesn't hold\nmakes the exit code 1.\n\n" +
           key_table("walk.schema.json#/definitions/single_expectation") + R"(
Four of them can stand alone: '- grounded', '- no_penetration', '- stuck', '- fell'; so can what follows
'not': '- not: fell'. As a step, 'expect' judges all that has been so far and ends the walk if it isn't so.

  status: xfail                                      the walk must fail
  status: {is: xfail, because: TEXT, failures: [blocked]}    and with just these failures

Events are written KIND OBJECT, globs in both; an object that is left out is any: see campuswalk help
events. An event that can't happen on the campus is an error (exit code 2), so that a slip of the pen in a
'never' is told and not passed.
)";
}

std::string events() {
    return R"(A line of the log is an event: tick, seconds, kind, object, details.

  collision.enter .stay .exit     the body touches a solid object that it doesn't stand on
  trigger.enter .stay .exit       the body is inside a trigger volume
  ray.enter .stay .exit           the visitor looks at an object, nothing solid in between
  popup.open .close               a building's first contact has begun, its last one has ended
  avatar.spawn .teleport          it was put down
  avatar.arrive .blocked          a walk_to or follow has ended
  avatar.stuck                    for a second it wanted to go on and came no 10 cm farther
  avatar.jump .crouch .stand      the script has it done
  avatar.landed .fell             a jump or fall has ended, or never will
  avatar.depenetrated             it was put down inside something and pushed out
  object.enable .disable          the script has made an object one that can be met, or none
  snapshot.take                   a picture was asked for
  expect.fail                     something was not as expected
  walk.start .end                 the walk

Patterns have globs: 'collision.* bench/*', 'popup.open library', 'avatar.fell'.
)";
}

std::string campus() {
    return "NAME.campus.yaml describes a campus. Its keys:\n\n" + key_table("campus.schema.json") +
           "\nA collider's keys, by its shape:\n\nmesh:\n" +
           key_table("campus.schema.json#/definitions/mesh") + "\nbox, too:\n" + R"(  center, size, yaw_deg
sphere, too:
  center, radius
capsule, too:
  base, radius, height
wheel, too:
  center, radius, width, axis

'campuswalk info MODEL' tells which nodes a model has; 'campuswalk snapshot CAMPUS -o map.png' draws a plan.
)";
}

std::string avatars() {
    return "NAME.avatar.yaml says who walks. Profiles are looked for in 'avatars' and 'config/avatars' "
           "beside the\nwalk and above it, then in those that come with the program (adult, child, "
           "delivery-robot).\n\n" +
           key_table("avatar.schema.json") +
           "\nIn a walk: 'avatar: adult', or 'avatar: {profile: adult, speed: 1.8}'.\n";
}

std::string exit_codes() {
    return R"(0    every walk passed; of 'collide': apart; of 'validate': all hold
1    an expectation failed, or the visitor was blocked, fell or waited in vain; of 'collide': overlapping
2    bad usage or input, told as FILE:LINE:COLUMN: error CODE: MESSAGE before that walk runs
3    something failed while running: disk full, no OpenGL
5    nothing was selected
130  interrupted
)";
}

std::string projects() {
    return "walks.config.yaml says how 'campuswalk run' runs the walks of its folder and below; the command "
           "line "
           "goes\nfirst.\n\n" +
           key_table("walks-config.schema.json") + R"(
  projects:
    adult: {}
    robot: {avatar: robot, tags: [ramps]}

plays every walk as an adult, and those with the tag 'ramps' as a robot, too; '--project robot' chooses.
)";
}

constexpr std::array kTopics = {
    Topic{"walks", "What NAME.walk.yaml may say", walks},
    Topic{"steps", "What the visitor does", steps},
    Topic{"expectations", "What must happen", expectations},
    Topic{"events", "What the log tells, and how expectations name it", events},
    Topic{"campus", "What NAME.campus.yaml may say", campus},
    Topic{"avatars", "Who walks: NAME.avatar.yaml", avatars},
    Topic{"projects", "walks.config.yaml: one walk for several avatars, campuses or spawns", projects},
    Topic{"exit-codes", "What the program ends with", exit_codes},
};

}  // namespace

std::span<const Topic> topics() {
    return kTopics;
}

}  // namespace campuswalk::tools::help
