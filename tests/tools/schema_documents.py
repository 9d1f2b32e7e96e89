"""Documents made from a JSON Schema: one for every value it describes, wrapped into a minimal file."""

import json
import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "config", "schema")
UNKNOWN_KEY = "no-such-key-here"  # similar to no known key, so that the loader lists them all


# A snapshot's keys, each with a view that uses it (for overlays: the grid). The view may also be that of the walk,
# which no schema can say.
VIEWS = {"height_above": "top", "overlays": "top", "distance": "orbit", "around": "orbit", "position": "fixed",
         "look_at": "fixed", "yaw_deg": "fixed", "pitch_deg": "fixed"}


def load_all():
    """The schemas by file name."""
    found = {}
    for name in sorted(os.listdir(FOLDER)):
        if name.endswith(".schema.json"):
            with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
                found[name] = json.load(file)
    return found


class Node:
    """A place in a schema, and how a value for it becomes a whole document."""

    def __init__(self, file, trail, schema, wrap, is_property=False):
        self.file = file
        self.trail = trail
        self.schema = schema
        self.wrap = wrap
        self.is_property = is_property


class Documents:
    """The documents that one schema file describes."""

    def __init__(self, schemas, name, base):
        """`base` is a valid document; its keys are added to those under test."""
        self.schemas = schemas
        self.name = name
        self.base = base

    def nodes(self):
        """Every value, with each alternative on its own; recursive schemas are entered once."""
        return list(self._below(self.name, self.schemas[self.name], (), lambda value: value, ()))

    def resolve(self, name, schema):
        """Follows $ref; a description beside it takes precedence."""
        while "$ref" in schema:
            file, _, pointer = schema["$ref"].partition("#")
            name = file or name
            target = self.schemas[name]
            for part in filter(None, pointer.split("/")):
                target = target[part]
            schema = {**target, **{key: value for key, value in schema.items() if key == "description"}}
        return name, schema

    def minimal(self, name, schema):
        """A valid value."""
        name, schema = self.resolve(name, schema)
        for key in ("examples", "enum"):
            if key in schema:
                return schema[key][0]
        if "const" in schema:
            return schema["const"]
        for key in ("anyOf", "oneOf"):
            if key in schema and "properties" not in schema:
                return self.minimal(name, schema[key][0])
        if schema.get("type") == "object":
            properties = schema.get("properties", {})
            keys = schema.get("required", list(properties)[:schema.get("minProperties", 0)])
            return {key: self.minimal(name, properties[key]) for key in keys}
        if schema.get("type") == "array":
            return [self.minimal(name, schema["items"]) for _ in range(schema.get("minItems", 0))]
        if schema.get("type") == "null":
            return None
        raise ValueError("%s: give an example of %s" % (name, json.dumps(schema)))

    def _below(self, name, schema, trail, wrap, entered, is_property=False):
        if schema.get("$ref") in entered:
            return
        entered += (schema["$ref"],) if "$ref" in schema else ()
        name, schema = self.resolve(name, schema)
        yield Node(name, "/".join(trail) or "the file", schema, wrap, is_property)
        for key in ("anyOf", "oneOf"):
            if "properties" not in schema:
                for i, alternative in enumerate(schema.get(key, [])):
                    yield from self._below(name, alternative, trail + ("(%d)" % (i + 1),), wrap, entered)
        if schema.get("type") == "object":
            yield from self._in_object(name, schema, trail, wrap, entered)
        if schema.get("type") == "array":
            rest = [self.minimal(name, schema["items"]) for _ in range(schema.get("minItems", 0) - 1)]
            yield from self._below(name, schema["items"], trail + ("-",), lambda value: wrap([value] + rest), entered)

    def _in_object(self, name, schema, trail, wrap, entered):
        for key, value in schema.get("properties", {}).items():
            yield from self._below(name, value, trail + (key,), self._wrapper(name, schema, key, trail, wrap), entered,
                                   is_property=True)
        if isinstance(schema.get("additionalProperties"), dict):
            key = schema.get("propertyNames", {}).get("enum", ["gate"])[0]
            yield from self._below(name, schema["additionalProperties"], trail + ("NAME",),
                                   lambda value: wrap({key: value}), entered)

    def _wrapper(self, name, schema, key, trail, wrap):
        if not trail:
            return lambda value: wrap({**self.base, key: self._with_first_step(key, value)})
        beside = {} if schema.get("maxProperties") == 1 else self.minimal(name, schema)
        for other in schema.get("dependencies", {}).get(key, []):
            beside[other] = self.minimal(name, schema["properties"][other])
        if key in VIEWS and "view" in schema["properties"]:
            beside["view"] = VIEWS[key]
        return lambda value: wrap({**beside, key: value})

    def _with_first_step(self, key, value):
        """A walk's other steps come after a spawn."""
        is_late = key == "steps" and isinstance(value, list) and value and value != [{"spawn": "gate"}]
        if is_late and self.name.startswith("walk") and not (isinstance(value[0], dict) and "spawn" in value[0]):
            return [{"spawn": "gate"}] + value
        return value

    def with_unknown_key(self, node):
        """The document with an unknown key in this object."""
        beside = {} if node.schema.get("maxProperties") == 1 else self.minimal(node.file, node.schema)
        if node.trail == "the file":
            beside = self.base
        return node.wrap({**beside, UNKNOWN_KEY: 1})


def accepted(schema):
    """Valid values of a leaf: its examples and its words."""
    values = list(schema.get("examples", [])) + list(schema.get("enum", []))
    return values + ([schema["const"]] if "const" in schema else [])


def limits(schema):
    return [schema[key] for key in ("minimum", "maximum") if key in schema]


def suspects(schema):
    """Values that some schemas refuse."""
    values = [{UNKNOWN_KEY: 1}, [[[]]], "no such word", 0.4999, 1e300, -1e300, None, True]
    if "minimum" in schema:
        values.append(schema["minimum"] - 0.001 * abs(schema["minimum"]) - 0.0001)
    if "exclusiveMinimum" in schema:
        values.append(schema["exclusiveMinimum"])
    if "maximum" in schema:
        values.append(schema["maximum"] * 1.001)
    return values
