#include "document/scene_schema.h"
#include "poinsot/rendering.h"

namespace poinsot {

std::string answer_schema() {
  return std::string(R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Answer document of poinsot",
  "description": "Everything that one run on one problem file found. `poinsot solve --json` writes one per line.",
  "type": "object",
  "required": ["poinsot", "title", "solutions", "warnings"],
  "properties": {
    "poinsot": {"type": "string", "pattern": "^[0-9]+[.][0-9]+[.][0-9]+$", "description": "version of the program"},
    "file": {"type": "string", "description": "the problem file as named on the command line; - for standard input"},
    "title": {"type": "string"},
    "solutions": {
      "type": "array",
      "description": "one per root in the range, ascending by the first unknown",
      "items": {"$ref": "#/$defs/solution"}
    },
    "warnings": {"type": "array", "items": {"type": "string"}},
    "constants": {
      "type": "object",
      "description": "numbers of nature that stand in formulas, by the names that people give them, such as g",
      "additionalProperties": {
        "type": "object",
        "required": ["digits", "unit"],
        "properties": {
          "digits": {"type": "string", "description": "as they stand in the formulas"},
          "unit": {"type": "string", "description": "SI base units"}
        }
      }
    },
    "ended": {
      "enum": ["deadline", "interrupted"],
      "description": "present if the search was ended from outside: the document holds what was found until then"
    }
  },
  "$defs": {)json") +
         document::scene_definitions() +
         R"json(    "solution": {
      "type": "object",
      "required": ["unknowns", "answers", "checks"],
      "properties": {
        "unknowns": {
          "type": "object",
          "description": "what the file lists under find, by name",
          "additionalProperties": {"$ref": "#/$defs/unknown"}
        },
        "answers": {
          "type": "object",
          "description": "by the name of the question, in the order of the file",
          "additionalProperties": {"$ref": "#/$defs/answer"}
        },
        "checks": {
          "type": "object",
          "description": "relative residuals; quantities: what was told against bodies as particles; constraints: of loops, contacts and cords; response: to what shakes against all bodies by themselves; roots: how far from those of a scan; formulas: held against numbers where they are said to hold; energy_drift and motion_error: of a motion; course: of a motion against the equations of single instants; scan: of extremes, periods and times against looks at other times; null: could not be formed",
          "additionalProperties": {"type": ["number", "null"], "minimum": 0}
        },
        "assumptions": {
          "type": "array",
          "description": "what the formulas rest on",
          "items": {"type": "string"}
        },
        "conditions": {
          "type": "array",
          "description": "of assumptions that are words: what they are as formulas, in SI base units and the letters",
          "items": {
            "type": "object",
            "required": ["words", "formula"],
            "properties": {
              "words": {"type": "string", "description": "as among the assumptions"},
              "formula": {"type": "string", "description": "an inequality such as g*m - F > 0"}
            }
          }
        },
        "notes": {
          "type": "array",
          "description": "what else was found: stability of a steady motion, what happened during a motion",
          "items": {"type": "string"}
        },
        "explanation": {"type": "string", "description": "with --explain: the worked solution, Markdown with TeX"},
        "scene": {"$ref": "#/$defs/scene", "description": "with --scene"},
        "other_scenes": {
          "type": "array",
          "items": {"$ref": "#/$defs/scene"},
          "description": "with --scene: those of the other situations"
        }
      }
    },
    "unknown": {
      "type": "object",
      "required": ["value", "unit", "si"],
      "properties": {
        "value": {"anyOf": [{"$ref": "#/$defs/datum"}, {"type": "null"}], "description": "null: letters remain in it"},
        "unit": {"type": "string"},
        "si": {"anyOf": [{"$ref": "#/$defs/datum"}, {"type": "null"}]},
        "formula": {"$ref": "#/$defs/formula"}
      }
    },
    "answer": {
      "type": "object",
      "required": ["ask"],
      "properties": {
        "ask": {"type": "string", "description": "the question as written"},
        "words": {"type": "string", "description": "what is given: quantity, body, point, axes, sense of a reaction"},
        "value": {"anyOf": [{"$ref": "#/$defs/datum"}, {"type": "null"}], "description": "in unit"},
        "unit": {"type": "string", "description": "of value; empty for pure numbers, truth values and texts"},
        "si": {
          "anyOf": [{"$ref": "#/$defs/datum"}, {"type": "null"}],
          "description": "value in SI base units, angles in radians"
        },
        "axes": {"type": "array", "items": {"type": "string"}, "description": "the axes of a vector's components"},
        "heads": {
          "type": "array",
          "items": {"type": "string"},
          "description": "the names of the columns of a table in letters, whose rows are lists of formulas"
        },
        "letters": {
          "type": "array",
          "items": {"type": "string"},
          "minItems": 1,
          "description": "the letters without value that the answer depends on; value and si are then null"
        },
        "table": {"$ref": "#/$defs/table"},
        "determined": {"const": false, "description": "the statement does not fix the answer; reason says why"},
        "refused": {"const": true, "description": "an answer was found and failed its check; reason says which"},
        "reason": {"type": "string"},
        "formula": {
          "$ref": "#/$defs/formula",
          "description": "where letters were left open: the answer in SI base units and the letters"
        },
        "formulas": {
          "type": "array",
          "minItems": 2,
          "description": "where the answer has several formulas, each at other letters: all of them, `formula` first",
          "items": {
            "type": "object",
            "required": ["formula", "where"],
            "properties": {
              "formula": {"$ref": "#/$defs/formula"},
              "where": {
                "type": "array",
                "items": {"type": "string"},
                "minItems": 1,
                "description": "inequalities such as L - 2*a > 0, all of which hold"
              }
            }
          }
        },
        "no_formula": {"type": "string", "description": "why there is no formula where letters were left open"},
        "holds": {"type": "boolean", "description": "of a claim; value and si are the same"},
        "how": {"enum": ["proved", "sampled"], "description": "of a claim that holds"},
        "counterexample": {"$ref": "#/$defs/counterexample", "description": "of a claim that does not hold"},
        "assumptions": {"type": "array", "items": {"type": "string"}, "description": "under which a claim is made"}
      },
      "oneOf": [
        {
          "title": "found",
          "required": ["value", "unit", "si"],
          "properties": {"value": {"$ref": "#/$defs/datum"}, "si": {"$ref": "#/$defs/datum"}}
        },
        {
          "title": "needs letters",
          "required": ["value", "unit", "si", "letters"],
          "properties": {"value": {"type": "null"}, "si": {"type": "null"}}
        },
        {"title": "table", "required": ["table"], "not": {"required": ["value"]}},
        {"title": "not determined", "required": ["determined", "reason"], "not": {"required": ["value"]}},
        {"title": "refused", "required": ["refused", "reason"], "not": {"required": ["value"]}}
      ]
    },
    "counterexample": {
      "type": "object",
      "required": ["letters"],
      "properties": {
        "letters": {
          "type": "object",
          "description": "letters, and what the statement leaves open, for which the claim does not hold",
          "additionalProperties": {
            "type": "object",
            "required": ["value", "unit", "si"],
            "properties": {"value": {"type": "number"}, "unit": {"type": "string"}, "si": {"type": "number"}}
          }
        },
        "left": {"type": "number", "description": "the left side there, in unit"},
        "right": {"type": "number"},
        "difference": {"type": "number", "description": "left less right, exactly, where rounding hides it"},
        "unit": {"type": "string"}
      }
    },
    "table": {
      "type": "object",
      "required": ["columns"],
      "properties": {
        "columns": {"type": "array", "minItems": 1, "items": {"$ref": "#/$defs/column"}},
        "over": {
          "$ref": "#/$defs/column",
          "description": "what the table runs over, row by row, if none of its columns shows that"
        }
      }
    },
    "column": {
      "type": "object",
      "required": ["name", "unit", "value", "si"],
      "properties": {
        "name": {"type": "string"},
        "unit": {"type": "string"},
        "value": {"type": "array", "items": {"type": "number"}, "description": "in unit"},
        "si": {"type": "array", "items": {"type": "number"}, "description": "in SI base units"}
      }
    },
    "formula": {
      "description": "infix text with + - * / ^ ( ), functions, pi and the letters; a list of such for a vector",
      "anyOf": [{"type": "string"}, {"type": "array", "items": {"$ref": "#/$defs/formula"}}]
    },
    "datum": {
      "description": "a number, truth value, text, or a list of such (a vector is a list, a matrix a list of rows)",
      "anyOf": [
        {"type": ["number", "boolean", "string"]},
        {"type": "array", "items": {"$ref": "#/$defs/datum"}}
      ]
    }
  }
}
)json";
}

}  // namespace poinsot
