"""Tables of the keys of JSON files, from their schemas."""

import json

_TYPES = {"integer": "whole number", "number": "number", "string": "text", "boolean": "`true`, `false`",
          "null": "`null`", "object": "map", "array": "list"}


class Place:
    """A schema with what its references lead to."""

    def __init__(self, schemas, file, schema):
        self.schemas, self.file, self.schema = schemas, file, schema

    def at(self, pointer):
        schema = self.schema
        for part in filter(None, pointer.split("/")):
            schema = schema[int(part) if isinstance(schema, list) else part]
        return Place(self.schemas, self.file, schema)

    def target(self):
        """The schema that it refers to in the end, with its own words first."""
        if "$ref" not in self.schema:
            return self
        file, _, pointer = self.schema["$ref"].partition("#")
        file = file or self.file
        there = Place(self.schemas, file, self.schemas[file]).at(pointer).target()
        merged = {**there.schema, **{word: value for word, value in self.schema.items() if word != "$ref"}}
        return Place(self.schemas, there.file, merged)

    def forms(self):
        """What it may be."""
        schema = self.target()
        lists = next((schema.schema[word] for word in ("anyOf", "oneOf") if word in schema.schema), None)
        if lists is None:
            return [schema]
        return [form for each in lists for form in Place(self.schemas, schema.file, each).forms()]

    def names(self):
        """Its value in words."""
        words = []
        for form in self.forms():
            schema = form.schema
            if "enum" in schema or "const" in schema:
                words += ["`%s`" % (value if isinstance(value, str) else json.dumps(value))
                          for value in schema.get("enum", [schema.get("const")])]
                continue
            types = schema.get("type", [])
            words += [_TYPES[name] for name in ([types] if isinstance(types, str) else types)]
        return ", ".join(dict.fromkeys(words))

    def maps(self):
        """The maps with known keys that it or its items may be."""
        found = []
        for form in self.forms():
            if "properties" in form.schema:
                found.append(form)
            for word in ("items", "additionalProperties"):
                if isinstance(form.schema.get(word), dict):
                    found += Place(self.schemas, form.file, form.schema[word]).maps()
        return found


def rows(schemas, file, pointer=""):
    """(key, value, meaning) of the map there, and of those in it."""
    return _rows(Place(schemas, file, schemas[file]).at(pointer).target(), 0, ())


def _rows(place, depth, above):
    found = []
    for key in place.schema["properties"]:
        inner = Place(place.schemas, place.file, place.schema["properties"][key])
        meaning = inner.target().schema.get("description", "").replace("|", "\\|").replace("<", "&lt;")
        found.append(("%s`%s`" % ("· " * depth, key), inner.names(), meaning))
        for each in inner.maps():
            if id(each.schema["properties"]) not in above:
                found += _rows(each, depth + 1, (*above, id(each.schema["properties"])))
    return found
