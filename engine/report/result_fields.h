#pragma once

#include "engine/events/reason_fields.h"
#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// Marks a number that is written like the hashes in logs.
template <typename Number>
struct Hash {
    explicit Hash(Number& number) : value(number) {}
    Number& value;
};

// The fields of a result and of a plan in JSON, with their names and in their order. Writing and reading use
// the same lists, so that neither can miss a field. `Fields` is called as (name, member). Names of angles end
// in their unit. What is given to if_any is left out where it is empty, false, 0 or none.

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<FailureScene> auto& scene) {
    fields("tick", scene.tick);
    fields("time", scene.time);
    fields("position", scene.position);
    fields("yaw_rad", scene.yaw);
    fields("pitch_rad", scene.pitch);
    fields("building", scene.building);
    fields("nearest", scene.nearest);
    fields("nearest_distance", scene.nearest_distance);
    fields("contact", scene.contact);
    fields("last_events", scene.last_events);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<RouteHint> auto& hint) {
    fields("to", hint.to);
    fields("length", hint.length);
    fields("by", hint.by);
    fields("turns_again", hint.turns_again);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<Failure> auto& failure) {
    fields("code", failure.code);
    fields("message", failure.message);
    fields("file", failure.mark.file);
    fields("line", failure.mark.line);
    fields("column", failure.mark.column);
    fields("scene", failure.scene);
    fields.if_any("reason", failure.reason);
    fields.if_any("object", failure.object);
    fields.if_any("route", failure.route);
    fields.if_any("actual", failure.actual);
    fields.if_any("expected", failure.expected);
}

/// All are errors.
template <typename Fields>
void list_fields(Fields& fields, MaybeConst<scene::Diagnostic> auto& diagnostic) {
    fields("code", diagnostic.code);
    fields("message", diagnostic.message);
    fields("file", diagnostic.mark.file);
    fields("line", diagnostic.mark.line);
    fields("column", diagnostic.mark.column);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<Artifact> auto& artifact) {
    fields("name", artifact.name);
    fields("path", artifact.path);
    fields("media_type", artifact.media_type);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<WalkResult> auto& result) {
    fields("id", result.id);
    fields("file", result.file);
    fields("name", result.name);
    fields("project", result.project);
    fields("config", result.config);
    fields("repetition", result.repetition);
    fields("tags", result.tags);
    fields("status_reason", result.status_reason);
    fields("expected_to_fail", result.expected_to_fail);
    fields("outcome", result.outcome);
    fields("failures", result.failures);
    fields("complaints", result.diagnostics);
    fields("campus", result.campus);
    fields("ticks_per_second", result.ticks_per_second);
    fields("timeout", result.timeout);
    fields("ticks", result.ticks);
    fields("events", result.events);
    fields("distance", result.distance);
    fields("not_evaluated", result.not_evaluated);
    fields("hash", Hash(result.hash));
    fields("artifacts", result.artifacts);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<RunFingerprint> auto& fingerprint) {
    fields("program", fingerprint.program);
    fields("options", fingerprint.options);
    fields("files", fingerprint.files);
}

template <typename Fields>
void list_fields(Fields& fields, MaybeConst<RunPlan> auto& plan) {
    fields("cases", plan.cases);
    fields("shard", plan.shard);
    fields("shards", plan.shards);
    fields("all_cases", plan.all_cases);
    fields("contents", plan.contents);
    fields("division", plan.division);
    fields("fingerprint", plan.fingerprint);
    fields("start", plan.start);
}

}  // namespace campuswalk::engine
