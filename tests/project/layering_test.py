#!/usr/bin/env python3
"""Plants violations in a small tree of its own and sees that layering.py names each of them."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import layering

PAGE = """
| folder | may include |
|---|---|
| engine/base | - |
| engine/mesh | engine/base |
| kernels/* | engine |
| tests | engine, kernels, tests |

| library | known by | may be named in |
|---|---|---|
| oneTBB | `tbb::`, `<tbb/`, `TBB::` | engine/base |
"""


class Layering(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.write("docs/architecture.md", PAGE)
        self.write("engine/base/CMakeLists.txt", "quarry_library(engine_base LINKS TBB::tbb)\n")
        self.write("engine/mesh/CMakeLists.txt", "quarry_library(engine_mesh LINKS quarry::engine_base)\n")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def assert_one_violation(self, *parts):
        found = list(layering.violations(self.root))
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])

    def test_accepts_what_the_table_allows(self):
        self.write("engine/base/id.cpp", '#include "engine/base/id.hpp"\n#include <tbb/info.h>\n')
        self.write("kernels/local/flip.hpp", '#include "engine/mesh/mesh.hpp"\n// tbb:: is named elsewhere\n')
        self.write("tests/kernels/local/flip_test.cpp", '#include "kernels/local/flip.hpp"\n')
        self.assertEqual(list(layering.violations(self.root)), [])

    def test_names_a_forbidden_include_with_file_and_line(self):
        self.write("engine/base/id.hpp", '#pragma once\n#include "engine/mesh/mesh.hpp"\n')
        self.assert_one_violation("engine/base/id.hpp:2:", "engine/mesh/mesh.hpp")

    def test_keeps_neighbours_apart(self):
        self.write("kernels/front/front.cpp", '#include "kernels/deferred/insert.hpp"\n')
        self.assert_one_violation("kernels/front/front.cpp:1:", "kernels/deferred")

    def test_names_a_forbidden_link(self):
        self.write("engine/base/CMakeLists.txt", "quarry_library(engine_base\n  LINKS quarry::engine_mesh)\n")
        self.assert_one_violation("engine/base/CMakeLists.txt:2:", "quarry::engine_mesh")

    def test_names_a_library_outside_its_folder(self):
        self.write("engine/mesh/mesh.cpp", "void f() {\n  tbb::parallel_invoke();\n}\n")
        self.assert_one_violation("engine/mesh/mesh.cpp:2:", "oneTBB")

    def test_names_a_folder_without_a_row(self):
        self.write("io/lines/reader.cpp", "\n")
        self.assert_one_violation("io/lines/reader.cpp:1:", "no row")

    def test_names_an_include_that_does_not_start_at_the_root(self):
        self.write("engine/mesh/mesh.cpp", '#include "mesh.hpp"\n')
        self.assert_one_violation("engine/mesh/mesh.cpp:1:", "from the root")


if __name__ == "__main__":
    unittest.main()
