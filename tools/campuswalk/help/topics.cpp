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
           "\nAn origin's keys:\n\n" + key_table("campus.schema.json#/definitions/origin") +
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

std::string lights() {
    return "NAME.light.yaml says how pictures are lit. Profiles are looked for in 'lights' and "
           "'config/lights' "
           "beside\nthe walk and above it, then with the program: day, overcast, night. What is left out is "
           "as by "
           "day.\n\n" +
           key_table("light.schema.json") +
           "\nIn a walk: 'light: night', or 'light: {profile: night, anti_aliasing: fxaa}'.\n";
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

std::string popups() {
    return "The window of a building opens when the visitor meets the first of its colliders, and closes "
           "when the "
           "last\nis left; a collider with 'popup: false' has no part in it. Of a building:\n\n" +
           key_table("campus.schema.json#/definitions/building") +
           "\n'popup' may be a map, for all colliders of a building or for one of them:\n\n" +
           key_table("campus.schema.json#/definitions/popup/anyOf/1") + R"(
Titles and texts may hold variables:

  {id} {kind} {hours} {floors}   what the building's keys say
  {title}                        in its text: the title as it is shown
  {visits}                       how often the window has opened, this time included
  {time}                         when, in simulated time: mm:ss
  {NAME}                         a field of 'info'
  {{ }}                          braces

  buildings:
    - {id: kiosk, title: "Kiosk of {owner}", text: "{title}, visit {visits} at {time}.", info: {owner: Ada}}

A variable that nothing stands for is an error with its line and column. Walks ask for windows so:

  expect:
    - popup: kiosk                                      it opens
    - popup: {building: kiosk, body: "*visit 2 at *"}   and says this; globs
    - sequence: [popup.open kiosk, popup.close kiosk]
)";
}

std::string reports() {
    return R"('campuswalk run --reporter NAME' or '--reporter NAME=FILE', several times; one at most without a file.

  list     a line a walk; below a failure where it was, what was near, the last events, its pictures
  dot      a character a walk
  junit    XML: a suite a walk file, a case a walk; times are simulated seconds
  tap      TAP version 14
  json     all results and their sum; config/schema/report.schema.json says what each key means
  jsonl    a result a line, as soon as it is known: what merge-reports and replay read
  github   annotations in GitHub's pull requests
  log      the events, a line each; what a single walk prints without --reporter

The bytes are the same whatever the number of workers, and there is no clock and no absolute path in them.

  campuswalk run --shard=1/2 --reporter jsonl=1.jsonl      on one machine
  campuswalk run --shard=2/2 --reporter jsonl=2.jsonl      on another
  campuswalk merge-reports 1.jsonl 2.jsonl --reporter junit=junit.xml

gives what one run would have reported. 'campuswalk replay 1.jsonl --verify' walks again what a report
tells, with the projects and time-outs of then, and compares hashes.

Pictures go to DIR of '--output DIR' (out): WALK/SNAPSHOT.png, and of a failure WALK/failure-eyes.png and
failure-above.png. 'expect: [log: {golden: true}]' compares a walk's log with the one that is kept in
NAME.walk.yaml-snapshots/log.jsonl: the first run writes it, 'run -u' writes it anew, but never of a walk
that fails and never where CI is set.
)";
}

constexpr std::array kTopics = {
    Topic{"walks", "What NAME.walk.yaml may say", walks},
    Topic{"steps", "What the visitor does", steps},
    Topic{"expectations", "What must happen", expectations},
    Topic{"events", "What the log tells, and how expectations name it", events},
    Topic{"campus", "What NAME.campus.yaml may say", campus},
    Topic{"popups", "Information windows: when they open and what they say", popups},
    Topic{"avatars", "Who walks: NAME.avatar.yaml", avatars},
    Topic{"lights", "Sun, sky and air of pictures: NAME.light.yaml", lights},
    Topic{"projects", "walks.config.yaml: one walk for several avatars, campuses or spawns", projects},
    Topic{"reports", "What is told of a run, to whom, and how runs are compared", reports},
    Topic{"exit-codes", "What the program ends with", exit_codes},
};

}  // namespace

std::span<const Topic> topics() {
    return kTopics;
}

}  // namespace campuswalk::tools::help
