#include "document/scene_schema.h"

#include "problem/scene/scene_words.h"

namespace poinsot::document {
namespace {

// ["path", "polhode"]
template <class Kind>
std::string words_json() {
  std::string list;
  for (const std::string_view word : problem::words_of(Kind{}))
    list += (list.empty() ? "[\"" : ", \"") + std::string(word) + "\"";
  return list + "]";
}

}  // namespace

std::string scene_definitions() {
  return std::string(R"json(
    "scene": {
      "type": "object",
      "description": "what a picture shows, in SI units; places are on the axes of a body as drawn, vectors of arrows on those of the ground",
      "required": ["situation", "axes", "up", "gravity", "length", "bodies", "points", "symbols", "links", "diagrams", "dimensions", "curves", "cones", "drawn_letters", "notes"],
      "additionalProperties": false,
      "properties": {
        "situation": {"type": "string", "description": "empty if the file states only one"},
        "axes": {"type": "array", "items": {"type": "string"}, "minItems": 3, "maxItems": 3},
        "up": {"$ref": "#/$defs/vector"},
        "viewer": {
          "$ref": "#/$defs/vector",
          "description": "the direction from which to look at it, if the statement gives one"
        },
        "gravity": {"type": "boolean"},
        "length": {"type": "number", "exclusiveMinimum": 0, "description": "the size of what is drawn"},
        "bodies": {"type": "array", "items": {"$ref": "#/$defs/scene_body"}},
        "points": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["name", "place"],
            "properties": {"name": {"type": "string"}, "place": {"$ref": "#/$defs/place"}}
          }
        },
        "symbols": {"type": "array", "items": {"$ref": "#/$defs/scene_symbol"}},
        "links": {"type": "array", "items": {"$ref": "#/$defs/scene_link"}},
        "wraps": {
          "type": "array",
          "description": "where cords and belts lie on wheels, between two of their straight parts",
          "items": {
            "type": "object",
            "required": ["name", "comes", "leaves", "center", "axis"],
            "additionalProperties": false,
            "properties": {
              "name": {"type": "string", "description": "of the cord"},
              "comes": {"type": "integer", "minimum": 0, "description": "the link at whose `from` it begins"},
              "leaves": {"type": "integer", "minimum": 0, "description": "the link at whose `to` it ends"},
              "center": {"$ref": "#/$defs/place"},
              "axis": {"$ref": "#/$defs/vector", "description": "it goes round right-handed; on the axes of the body"}
            }
          }
        },
        "diagrams": {
          "type": "array",
          "items": {"$ref": "#/$defs/diagram"},
          "description": "the first is that of the model; those of one group are one equation in their order"
        },
        "dimensions": {"type": "array", "items": {"$ref": "#/$defs/scene_dimension"}},
        "curves": {"type": "array", "items": {"$ref": "#/$defs/curve"}},
        "cones": {"type": "array", "items": {"$ref": "#/$defs/cone"}},
        "motion": {"$ref": "#/$defs/scene_motion"},
        "drawn_letters": {
          "type": "array",
          "description": "letters without value, and the values with which the scene is drawn",
          "items": {
            "type": "object",
            "required": ["name", "unit", "value"],
            "properties": {
              "name": {"type": "string"},
              "unit": {"type": "string"},
              "value": {"type": "number"},
              "only_grows": {"type": "boolean", "description": "whether another value makes the figure larger or smaller at most, and no other"}
            }
          }
        },
        "notes": {"type": "array", "items": {"type": "string"}, "description": "what is left out, and why"}
      }
    },
    "vector": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
    "place": {
      "type": "object",
      "required": ["body", "at"],
      "additionalProperties": false,
      "properties": {"body": {"$ref": "#/$defs/body_number"}, "at": {"$ref": "#/$defs/vector"}}
    },
    "quantity": {
      "enum": )json") +
         words_json<scene::Quantity>() + R"json(
    },
    "body_number": {"type": "integer", "minimum": -1, "description": "the place in bodies; -1 is the ground"},
    "pose": {
      "type": "object",
      "description": "a point at x on the axes of the body is at R x + p on those of the ground; R row by row",
      "required": ["R", "p"],
      "additionalProperties": false,
      "properties": {
        "R": {"type": "array", "items": {"type": "number"}, "minItems": 9, "maxItems": 9},
        "p": {"$ref": "#/$defs/vector"}
      }
    },
    "scene_body": {
      "type": "object",
      "required": ["name", "frame", "massless", "mass", "center", "shapes", "pose"],
      "additionalProperties": false,
      "properties": {
        "name": {"type": "string"},
        "frame": {"type": "boolean", "description": "a frame of reference: it has axes and no shape"},
        "massless": {"type": "boolean"},
        "mass": {"type": "number", "minimum": 0},
        "center": {"$ref": "#/$defs/vector"},
        "shapes": {"type": "array", "items": {"$ref": "#/$defs/scene_shape"}},
        "pose": {"$ref": "#/$defs/pose"}
      }
    },
    "scene_shape": {
      "type": "object",
      "required": ["kind", "part", "extent", "hole", "added", "stand_in", "vertices", "triangles", "normals", "edges"],
      "additionalProperties": false,
      "properties": {
        "kind": {"type": "string", "description": "the key in the language"},
        "part": {"type": "string", "description": "empty for a body of one shape"},
        "extent": {"enum": )json" +
         words_json<scene::Extent>() + R"json(},
        "hole": {"type": "boolean"},
        "added": {"type": "boolean"},
        "stand_in": {
          "type": "boolean",
          "description": "of a body of which the moments of inertia are given and no shape: a solid that has them"
        },
        "vertices": {"type": "array", "items": {"$ref": "#/$defs/vector"}},
        "triangles": {
          "type": "array",
          "items": {"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 3, "maxItems": 3}
        },
        "normals": {
          "type": "array",
          "description": "of the true surface at each corner of each triangle",
          "items": {"type": "array", "items": {"$ref": "#/$defs/vector"}, "minItems": 3, "maxItems": 3}
        },
        "edges": {"type": "array", "items": {"type": "array", "items": {"type": "integer", "minimum": 0}}}
      }
    },
    "scene_symbol": {
      "type": "object",
      "required": ["kind", "name", "from", "to", "place", "axis", "second_axis"],
      "additionalProperties": false,
      "properties": {
        "kind": {
          "enum": )json" +
         words_json<scene::SymbolKind>() + R"json(
        },
        "name": {"type": "string"},
        "from": {"$ref": "#/$defs/body_number"},
        "to": {"$ref": "#/$defs/body_number"},
        "place": {"$ref": "#/$defs/place"},
        "axis": {"$ref": "#/$defs/vector", "description": "on the axes of `to`; zero if it has none"},
        "second_axis": {"$ref": "#/$defs/vector"}
      }
    },
    "scene_link": {
      "type": "object",
      "required": ["kind", "name", "from", "to", "far", "slack"],
      "additionalProperties": false,
      "properties": {
        "kind": {"enum": )json" +
         words_json<scene::LinkKind>() + R"json(},
        "name": {"type": "string"},
        "from": {"$ref": "#/$defs/place"},
        "to": {"$ref": "#/$defs/place"},
        "far": {"type": "boolean", "description": "only its direction counts: `to` is a place on the way"},
        "slack": {"type": "boolean"},
        "symbol": {"type": "string", "description": "TeX, of a part whose tension is asked for"}
      }
    },
    "diagram": {
      "type": "object",
      "required": ["kind", "title", "group", "bodies", "arrows"],
      "additionalProperties": false,
      "properties": {
        "kind": {
          "enum": )json" +
         words_json<scene::DiagramKind>() + R"json(
        },
        "title": {"type": "string"},
        "group": {"type": "integer"},
        "bodies": {"type": "array", "items": {"$ref": "#/$defs/body_number"}},
        "arrows": {"type": "array", "items": {"$ref": "#/$defs/arrow"}}
      }
    },
    "arrow": {
      "type": "object",
      "required": ["quantity", "name", "body", "at", "vector", "symbol", "text", "known"],
      "additionalProperties": false,
      "properties": {
        "quantity": {"$ref": "#/$defs/quantity"},
        "name": {"type": "string", "description": "of what it belongs to: a support, a load, a spring, an answer"},
        "body": {"$ref": "#/$defs/body_number"},
        "at": {"$ref": "#/$defs/place"},
        "vector": {"$ref": "#/$defs/vector", "description": "on ground axes; never zero"},
        "symbol": {"type": "string", "description": "TeX"},
        "text": {"type": "string", "description": "the symbol as plain text with _ before an index"},
        "value": {"type": "number", "description": "the size, or the component where the symbol stands for one, in unit; left out with its unit where it is open"},
        "unit": {"type": "string"},
        "formula": {"type": "string", "description": "of value in SI units, if letters have no value"},
        "known": {"type": "boolean", "description": "whether the statement gives it"},
        "swings": {"type": "boolean", "description": "whether it is an amplitude"},
        "open": {"type": "boolean", "description": "whether the equations leave its size open: vector is then a unit vector in the sense that counts as positive"}
      }
    },
    "scene_dimension": {
      "type": "object",
      "required": ["name", "text", "angle", "from", "to"],
      "additionalProperties": false,
      "properties": {
        "name": {"type": "string"},
        "text": {"type": "string"},
        "angle": {"type": "boolean"},
        "from": {"$ref": "#/$defs/place"},
        "to": {"$ref": "#/$defs/place", "description": "the same as from, if the datum is a number of what is touched there"},
        "corner": {"$ref": "#/$defs/place", "description": "of an angle: it is between the directions to the places"},
        "axis": {"$ref": "#/$defs/vector", "description": "of a radius, on the axes of the body of `from`: it may be drawn in any direction across this"}
      }
    },
    "curve": {
      "type": "object",
      "required": ["kind", "name", "body", "closed", "points"],
      "additionalProperties": false,
      "properties": {
        "kind": {"enum": )json" +
         words_json<scene::CurveKind>() + R"json(},
        "name": {"type": "string"},
        "body": {"$ref": "#/$defs/body_number"},
        "closed": {"type": "boolean"},
        "points": {"type": "array", "items": {"$ref": "#/$defs/vector"}}
      }
    },
    "cone": {
      "type": "object",
      "required": ["name", "body", "apex", "axis", "half_angle", "touching_line"],
      "additionalProperties": false,
      "properties": {
        "name": {"type": "string"},
        "body": {"$ref": "#/$defs/body_number"},
        "apex": {"$ref": "#/$defs/vector"},
        "axis": {"$ref": "#/$defs/vector"},
        "half_angle": {"type": "number", "minimum": 0},
        "touching_line": {"$ref": "#/$defs/vector"}
      }
    },
    "scene_motion": {
      "type": "object",
      "required": ["times", "bodies", "plots", "arrows", "events", "complete"],
      "additionalProperties": false,
      "properties": {
        "times": {"type": "array", "items": {"type": "number"}, "description": "s, ascending"},
        "bodies": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["position", "orientation"],
            "additionalProperties": false,
            "properties": {
              "position": {"type": "array", "items": {"type": "number"}, "description": "p at each time, flat"},
              "orientation": {
                "type": "array",
                "items": {"type": "number"},
                "description": "R at each time as a quaternion w, x, y, z, flat"
              }
            }
          }
        },
        "plots": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["name", "words", "unit", "labels", "values"],
            "additionalProperties": false,
            "properties": {
              "name": {"type": "string"},
              "words": {"type": "string"},
              "unit": {"type": "string"},
              "labels": {"type": "array", "items": {"type": "string"}},
              "values": {
                "type": "array",
                "items": {"type": "array", "items": {"type": ["number", "null"]}},
                "description": "for each line, over the times"
              }
            }
          }
        },
        "arrows": {
          "type": "array",
          "description": "vectors that change",
          "items": {
            "type": "object",
            "required": ["quantity", "name", "at", "symbol", "text", "unit", "factor", "vectors"],
            "additionalProperties": false,
            "properties": {
              "quantity": {"$ref": "#/$defs/quantity"},
              "name": {"type": "string", "description": "of its body, or of the question"},
              "at": {"$ref": "#/$defs/place"},
              "symbol": {"type": "string", "description": "TeX"},
              "text": {"type": "string"},
              "unit": {"type": "string"},
              "factor": {"type": "number", "exclusiveMinimum": 0, "description": "SI of one of the unit"},
              "vectors": {
                "type": "array",
                "items": {"type": "number"},
                "description": "on ground axes at each time, in SI, flat"
              }
            }
          }
        },
        "links": {
          "type": "array",
          "description": "links whose ends do not ride on their bodies: cords between wheels",
          "items": {
            "type": "object",
            "required": ["link", "from", "to"],
            "additionalProperties": false,
            "properties": {
              "link": {"type": "integer", "minimum": 0, "description": "its place among the links of the scene"},
              "from": {"type": "array", "items": {"type": "number"}, "description": "on ground axes at each time, flat"},
              "to": {"type": "array", "items": {"type": "number"}}
            }
          }
        },
        "events": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["time", "words"],
            "properties": {"time": {"type": "number"}, "words": {"type": "string"}}
          }
        },
        "complete": {"type": "boolean"},
        "stopped": {"type": "string", "description": "if it is not complete: why"}
      }
    },
)json";
}

}  // namespace poinsot::document
